#include "src/motion/collision/query/leg_scan.hpp"

#include <algorithm>
#include <cmath>

namespace rubicon::collision {

namespace {

/// m: so much more than what is needed is asked for, so that rounding decides nothing.
constexpr double kScanMargin = 1e-6;

/// Intervals in which nothing moves farther than this (m), or of the last depth, are left to the
/// exact test.
constexpr double kShortestPath = 4e-3;
constexpr int kDeepest = 7;
/// After so many exact tests the rest of the leg stays open.
constexpr int kMostExactTests = 3;

/// Cross products of unit vectors shorter than this have no direction left.
constexpr double kParallelEdges = 1e-4;

/// No less than the square root of 1/2.
constexpr double kRootOfHalf = 0.70710678118655;

/// How two boxes lie to each other.
struct BoxGap {
  double apart = 0;  ///< m: they are at least so far apart; 0 if that is not known
  double depth = 0;  ///< m: they overlap so deep along every axis; negative: along one they do not
};

/// Stops where they are known to be farther apart than `enough`.
BoxGap box_gap(const OrientedBox& a, const OrientedBox& b, double enough) {
  const Mat3 R = a.R.transpose() * b.R;
  const Mat3 R_abs = R.cwiseAbs();
  const Vec3 t = a.R.transpose() * (b.centre - a.centre);
  const Vec3 of_a = t.cwiseAbs() - a.half - R_abs * b.half;
  const double apart_a = of_a.cwiseMax(0.0).norm();
  if (apart_a > enough) return {apart_a, -1};
  const Vec3 u = R.transpose() * t;
  const Vec3 of_b = u.cwiseAbs() - b.half - R_abs.transpose() * a.half;
  const double apart_b = of_b.cwiseMax(0.0).norm();
  BoxGap gap{std::max(apart_a, apart_b), -std::max(of_a.maxCoeff(), of_b.maxCoeff())};
  if (gap.apart > enough) return gap;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3;
    const int i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const double square = 1 - R(i, j) * R(i, j);
      if (square < kParallelEdges) continue;
      const int j1 = (j + 1) % 3;
      const int j2 = (j + 2) % 3;
      const double reach = a.half[i1] * R_abs(i2, j) + a.half[i2] * R_abs(i1, j) +
                           b.half[j1] * R_abs(i, j2) + b.half[j2] * R_abs(i, j1);
      const double off = std::fabs(t[i2] * R(i1, j) - t[i1] * R(i2, j)) - reach;
      const double along = off / std::sqrt(square);
      gap.depth = std::min(gap.depth, -along);
      gap.apart = std::max(gap.apart, along);
      if (gap.apart > enough) return gap;
    }
  }
  return gap;
}

double farthest(const LegQuery::Speed& speed, const Body& body) {
  return speed.origin + speed.turning * body.extent().reach;
}

/// The longest of the parts 1, 1/2, 1/4 ... of a leg that is shorter than `met`.
double longest_part(double met) {
  double part = 1;
  while (part >= met) part /= 2;
  return part;
}

}  // namespace

LegScan::LegScan(const LegQuery& query, const LegMotion& motion, const Collect& collect)
    : query_(query), motion_(motion), collect_(collect) {
  for (const LegQuery::Item& item : query_.items) {
    first_box_.push_back(items_.size());
    items_.resize(items_.size() + item.body->parts().size());
  }
}

void LegScan::place(const Body& body, const Placement& X_WC, std::vector<PartBox>& boxes,
                    std::size_t at) {
  for (const BodyPart& part : body.parts()) {
    const OrientedBox box = placed(part.box, X_WC);
    boxes[at++] = {box, box.R.cwiseAbs() * box.half, part.is_box};
  }
}

void LegScan::find_places(double share, ItemPlaces& places) {
  motion_.poses(share, X_WB_);
  places.resize(query_.items.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Placement X_WB(X_WB_[i]);
    places[i] = {X_WB.R, X_WB * query_.items[i].body->extent().centre};
  }
}

void LegScan::place_items(const ItemPlaces& places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    place(*query_.items[i].body, places[i], items_, first_box_[i]);
  }
}

/// Between two places a point is no farther from the one than the other is, and what it deviates
/// from the straight way.
void LegScan::find_ways(const ItemPlaces& from, const ItemPlaces& middle, const ItemPlaces& to,
                        double half) {
  ways_.resize(middle.size());
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const LegQuery::Item& item = query_.items[i];
    const double by_speed = half * farthest(item.speed, *item.body);
    const double deviation = half * half / 8 * farthest(item.acceleration, *item.body);
    if (deviation >= by_speed) {
      ways_[i] = by_speed;
      continue;
    }
    const double radius = item.body->extent().radius;
    const auto way = [&](const Placement& X) {
      // The norm of a difference of rotations is that of its columns by the root of two.
      return (X.t - middle[i].t).norm() + (X.R - middle[i].R).norm() * kRootOfHalf * radius;
    };
    ways_[i] = std::min(by_speed, std::max(way(from[i]), way(to[i])) + deviation);
  }
}

/// What any item may meet on the whole leg.
void LegScan::collect_obstacles(const ItemPlaces& middle) {
  std::vector<ScannedObstacle> found;
  std::vector<std::pair<ObstacleId, std::size_t>> known;  // with its first box
  for (int i = 0; i < static_cast<int>(query_.items.size()); ++i) {
    const LegQuery::Item& item = query_.items[static_cast<std::size_t>(i)];
    const double speed = farthest(item.speed, *item.body);
    if (!(speed > 0)) continue;
    Bounds bounds = placed(item.body->bounds(), middle[static_cast<std::size_t>(i)]);
    bounds.grow(Vec3::Constant(ways_[static_cast<std::size_t>(i)] + kScanMargin));
    found.clear();
    collect_(bounds, found);
    for (const ScannedObstacle& each : found) {
      const auto same = [&](const auto& other) { return other.first == each.id; };
      auto place_of = std::find_if(known.begin(), known.end(), same);
      if (place_of == known.end()) {
        known.emplace_back(each.id, standing_.size());
        place_of = known.end() - 1;
        standing_.resize(standing_.size() + each.body->parts().size());
        place(*each.body, *each.X_WC, standing_, place_of->second);
        obstacle_ids_.push_back(each.id);
      }
      const int met = static_cast<int>(place_of - known.begin());
      for (std::size_t p = 0; p < item.body->parts().size(); ++p) {
        for (std::size_t o = 0; o < each.body->parts().size(); ++o) {
          candidates_.push_back({i, static_cast<int>(first_box_[static_cast<std::size_t>(i)] + p),
                                 static_cast<int>(place_of->second + o), met, false, speed});
        }
      }
    }
  }
}

void LegScan::add_pairs() {
  for (const LegQuery::Pair& pair : query_.pairs) {
    const auto first = static_cast<std::size_t>(pair.first);
    const auto second = static_cast<std::size_t>(pair.second);
    const double speed = farthest(pair.of_first, *query_.items[first].body) +
                         farthest(pair.of_second, *query_.items[second].body);
    for (std::size_t p = 0; p < query_.items[first].body->parts().size(); ++p) {
      for (std::size_t o = 0; o < query_.items[second].body->parts().size(); ++o) {
        candidates_.push_back({pair.first, static_cast<int>(first_box_[first] + p),
                               static_cast<int>(first_box_[second] + o), pair.second, true, speed});
      }
    }
  }
}

LegAnswer LegScan::run() {
  constexpr double kMiddle = 0.5;
  middles_.resize(kDeepest + 1);
  ItemPlaces at_start;
  ItemPlaces at_end;
  find_places(0, at_start);
  find_places(1, at_end);
  find_places(kMiddle, middles_[0]);
  find_ways(at_start, middles_[0], at_end, kMiddle);
  collect_obstacles(middles_[0]);
  add_pairs();
  for (const LegQuery::Item& item : query_.items) {
    fastest_ = std::max(fastest_, farthest(item.speed, *item.body));
  }
  scan(0, 1, at_start, at_end, 0, candidates_.size(), 0, false);
  return answer_;
}

bool LegScan::is_answered() const {
  if (query_.whole) return answer_.met_from <= 1;
  const double part = longest_part(answer_.met_from);
  return part <= answer_.free_until || part < query_.least;
}

/// Looks at an interval, all before which is free. False: there is no need to go on, or no way.
/// The items stand where the interval is halved, if it is the whole.
bool LegScan::scan(double from, double to, const ItemPlaces& at_from, const ItemPlaces& at_to,
                   std::size_t begin, std::size_t end, int depth, bool met_at_end) {
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  ItemPlaces& at_middle = middles_[static_cast<std::size_t>(depth)];
  if (depth > 0) {
    find_places(middle, at_middle);
    find_ways(at_from, at_middle, at_to, half);
  }
  place_items(at_middle);
  bool met = false;
  for (std::size_t k = begin; k < end; ++k) {
    const Candidate each = candidates_[k];
    const PartBox& a = items_[static_cast<std::size_t>(each.part)];
    const PartBox& b = (each.own ? items_ : standing_)[static_cast<std::size_t>(each.other)];
    const double way = each.own ? half * each.speed : ways_[static_cast<std::size_t>(each.item)];
    const double enough = way + kScanMargin;
    const Vec3 off = (a.box.centre - b.box.centre).cwiseAbs() - (a.half_W + b.half_W);
    if (off.cwiseMax(0.0).squaredNorm() > enough * enough) continue;
    const BoxGap gap = box_gap(a.box, b.box, enough);
    if (gap.apart > enough) continue;
    candidates_.push_back(each);
    const bool deep = a.exact && b.exact && gap.depth > query_.contact_tolerance + kScanMargin;
    if (!deep || met) continue;
    met = true;
    answer_.met_from = middle;
    answer_.hit = SweptHit{each.item, {}, {}};
    if (each.own) {
      answer_.hit->other_item = each.met;
    } else {
      answer_.hit->obstacle = obstacle_ids_[static_cast<std::size_t>(each.met)];
    }
    if (query_.whole) return false;
  }
  const std::size_t last = candidates_.size();
  bool go_on = !met || !is_answered();
  if (go_on && last == end) {
    answer_.free_until = to;
  } else if (go_on && (depth == kDeepest || half * fastest_ < kShortestPath)) {
    go_on = !met && !met_at_end && exact_tests_ < kMostExactTests;
    if (go_on) {
      ++exact_tests_;
      go_on = motion_.is_free(from, to);
      if (go_on) {
        answer_.free_until = to;
      } else if (to < answer_.met_from) {
        answer_.met_from = to;
        answer_.hit.reset();
      }
    }
  } else if (go_on) {
    go_on = scan(from, middle, at_from, at_middle, end, last, depth + 1, met) && !met &&
            !is_answered() && scan(middle, to, at_middle, at_to, end, last, depth + 1, met_at_end);
  }
  candidates_.resize(end);
  return go_on;
}

}  // namespace rubicon::collision
