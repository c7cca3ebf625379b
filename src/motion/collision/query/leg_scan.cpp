#include "src/motion/collision/query/leg_scan.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rubicon::collision {

namespace {

/// m, and share of the coordinates: so much more than what is needed is asked for, so that rounding
/// decides nothing.
constexpr double kMargin = 1e-6;
constexpr double kMarginShare = 1e-12;

/// Intervals in which no box is grown by more than this (m), or of the last depth, are left to the
/// exact test.
constexpr double kShortestPath = 2e-4;
constexpr int kDeepest = 5;
/// After so many exact tests the rest of the leg stays open.
constexpr int kMostExactTests = 24;

/// The longest of the parts 1, 1/2, 1/4 ... of a leg that is shorter than `met`.
double longest_part(double met) {
  double part = 1;
  while (part >= met) part /= 2;
  return part;
}

/// The middles of the four intervals of a part of a leg.
struct Middles {
  double shares[math::kLanes];
  Middles(double from, double to) {
    const double half = (to - from) / (2 * math::kLanes);
    for (int i = 0; i < math::kLanes; ++i) shares[i] = from + (2 * i + 1) * half;
  }
};

double acceleration(const LegQuery::Acceleration& bound, double reach) {
  return bound.origin + bound.turning * reach;
}

StandingBox standing_box(const BodyPart& part, const Placement& X_WC, int obstacle) {
  const Mat3 R = part.aligned ? X_WC.R : Mat3(X_WC.R * part.box.R);
  const Vec3 centre = X_WC * part.box.centre;
  const Vec3 around = R.cwiseAbs() * part.box.half;
  StandingBox box;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) box.R[i][j] = R(i, j);
    box.centre[i] = centre[i];
    box.half[i] = part.box.half[i];
    box.around[i] = around[i];
  }
  box.obstacle = obstacle;
  box.exact = part.is_box;
  return box;
}

}  // namespace

LegScan::LegScan(const LegQuery& query, const LegMotion& motion, const Collect& collect,
                 LegScanRoom& room)
    : query_(query), motion_(motion), collect_(collect), room_(room), kernels_(leg_kernels()) {
  room_.frames.resize(static_cast<std::size_t>(query.frames));
  room_.parts.clear();
  room_.first_part.clear();
  room_.standing.clear();
  room_.pairs.clear();
  room_.obstacles.clear();
  room_.first_standing.assign(1, 0);
  room_.candidates.clear();
}

void LegScan::add_parts() {
  for (int i = 0; i < static_cast<int>(query_.items.size()); ++i) {
    const LegQuery::Item& item = query_.items[static_cast<std::size_t>(i)];
    room_.first_part.push_back(room_.parts.size());
    for (const BodyPart& each : item.body->parts()) {
      LegPart part;
      const Vec3 centre = item.body->extent().centre + each.box.centre;
      for (int k = 0; k < 3; ++k) {
        for (int j = 0; j < 3; ++j) part.R[k][j] = each.box.R(k, j);
        part.centre[k] = centre[k];
        part.half[k] = each.box.half[k];
      }
      part.reach = centre.norm() + each.box.half.norm();
      part.acceleration = acceleration(item.acceleration, part.reach);
      part.item = i;
      part.frame = item.frame;
      part.turned = !each.aligned;
      part.exact = each.is_box;
      room_.parts.push_back(part);
    }
  }
  room_.first_part.push_back(room_.parts.size());
  room_.placed.resize(room_.parts.size());
  room_.placed_in.assign(room_.parts.size(), 0);
}

/// The parts of pairs that come near each other on the whole leg; all are placed in its four
/// intervals.
void LegScan::add_pairs() {
  for (const LegQuery::Pair& pair : query_.pairs) {
    const auto first = static_cast<std::size_t>(pair.first);
    const auto second = static_cast<std::size_t>(pair.second);
    std::optional<std::pair<LegQuery::Acceleration, LegQuery::Acceleration>> seen;
    for (std::size_t a = room_.first_part[first]; a < room_.first_part[first + 1]; ++a) {
      for (std::size_t b = room_.first_part[second]; b < room_.first_part[second + 1]; ++b) {
        if (kernels_.near(room_.placed[a], room_.placed[b]) == 0) continue;
        if (!seen) seen = motion_.seen_from_base(pair);
        const int index = static_cast<int>(room_.pairs.size());
        room_.pairs.push_back({static_cast<int>(a), static_cast<int>(b), pair.base,
                               acceleration(seen->first, room_.parts[a].reach),
                               acceleration(seen->second, room_.parts[b].reach)});
        room_.candidates.push_back({-1, index, kAllIntervals, 0});
      }
    }
  }
}

/// What any item may meet on the whole leg; all parts are placed in its four intervals.
void LegScan::collect_obstacles() {
  for (const LegQuery::Item& item : query_.items) {
    if (!item.moves) continue;
    const auto index = static_cast<std::size_t>(&item - query_.items.data());
    const auto first = static_cast<int>(room_.first_part[index]);
    const auto last = static_cast<int>(room_.first_part[index + 1]);
    Bounds bounds;
    for (int p = first; p < last; ++p) {
      const LanePart& at = room_.placed[static_cast<std::size_t>(p)];
      for (int i = 0; i < 3; ++i) {
        for (int lane = 0; lane < math::kLanes; ++lane) {
          bounds.lower[i] = std::min(bounds.lower[i], at.centre[i].v[lane] - at.around[i].v[lane]);
          bounds.upper[i] = std::max(bounds.upper[i], at.centre[i].v[lane] + at.around[i].v[lane]);
        }
      }
    }
    room_.found.clear();
    collect_(bounds, room_.found);
    for (const ScannedObstacle& each : room_.found) {
      const auto known = std::find(room_.obstacles.begin(), room_.obstacles.end(), each.id);
      const auto obstacle = static_cast<std::size_t>(known - room_.obstacles.begin());
      if (known == room_.obstacles.end()) {
        room_.obstacles.push_back(each.id);
        for (const BodyPart& part : each.body->parts()) {
          room_.standing.push_back(standing_box(part, *each.X_WC, static_cast<int>(obstacle)));
        }
        room_.first_standing.push_back(room_.standing.size());
      }
      for (int p = first; p < last; ++p) {
        for (std::size_t s = room_.first_standing[obstacle]; s < room_.first_standing[obstacle + 1];
             ++s) {
          room_.candidates.push_back({p, static_cast<int>(s), kAllIntervals, 0});
        }
      }
    }
  }
}

/// Begins to look at the four intervals of a part of the leg, whose frames are known.
LegIntervals LegScan::begin_look(double from, double to) {
  ++looks_;
  return {(to - from) / (2 * math::kLanes), margin_, query_.contact_tolerance + margin_,
          room_.frames.data()};
}

LegIntervals LegScan::look_at(double from, double to) {
  motion_.frames(Middles(from, to).shares, room_.frames.data());
  return begin_look(from, to);
}

void LegScan::place(const LegIntervals& intervals, int part) {
  int& in = room_.placed_in[static_cast<std::size_t>(part)];
  if (in == looks_) return;
  in = looks_;
  kernels_.place(intervals, room_.parts[static_cast<std::size_t>(part)],
                 room_.placed[static_cast<std::size_t>(part)]);
}

LegAnswer LegScan::run() {
  add_parts();
  motion_.frames(Middles(0, 1).shares, room_.frames.data());
  double farthest = 0;
  for (const math::LaneFrame& frame : room_.frames) {
    for (const math::Lanes& each : frame.t) {
      for (int lane = 0; lane < math::kLanes; ++lane) {
        farthest = std::max(farthest, std::fabs(each.v[lane]));
      }
    }
  }
  margin_ = kMargin + kMarginShare * farthest;
  const LegIntervals whole = begin_look(0, 1);
  for (int p = 0; p < static_cast<int>(room_.parts.size()); ++p) place(whole, p);
  collect_obstacles();
  add_pairs();
  const std::size_t all = room_.candidates.size();
  double part = 1;
  Outcome outcome = scan(whole, 0, 1, 0, all, 0);
  while (outcome == Outcome::met && !query_.whole) {
    part = longest_part(answer_.met_from);
    if (part <= answer_.free_until || part < query_.least) break;
    outcome = scan(look_at(0, part), 0, part, 0, all, 0);
  }
  return answer_;
}

void LegScan::note_free(double until) { answer_.free_until = std::max(answer_.free_until, until); }

void LegScan::note_met(double share, const LegCandidate& candidate) {
  if (share >= answer_.met_from) return;
  answer_.met_from = share;
  if (candidate.part < 0) {
    const LegPair& pair = room_.pairs[static_cast<std::size_t>(candidate.other)];
    answer_.hit = SweptHit{room_.parts[static_cast<std::size_t>(pair.first)].item,
                           {},
                           room_.parts[static_cast<std::size_t>(pair.second)].item};
    return;
  }
  const StandingBox& box = room_.standing[static_cast<std::size_t>(candidate.other)];
  answer_.hit = SweptHit{room_.parts[static_cast<std::size_t>(candidate.part)].item,
                         room_.obstacles[static_cast<std::size_t>(box.obstacle)],
                         {}};
}

/// Whether what is left moves so little in each interval that halving it is of no use.
bool LegScan::is_short(std::size_t begin, std::size_t end) const {
  const auto grows = [&](int part) {
    const auto p = static_cast<std::size_t>(part);
    double most = 0;
    for (int i = 0; i < 3; ++i) {
      for (int lane = 0; lane < math::kLanes; ++lane) {
        most = std::max(most, room_.placed[p].grown[i].v[lane] - room_.parts[p].half[i]);
      }
    }
    return most;
  };
  for (std::size_t k = begin; k < end; ++k) {
    const LegCandidate& each = room_.candidates[k];
    if (each.part >= 0) {
      if (grows(each.part) > kShortestPath) return false;
      continue;
    }
    const LegPair& pair = room_.pairs[static_cast<std::size_t>(each.other)];
    if (std::max(grows(pair.first), grows(pair.second)) > kShortestPath) return false;
  }
  return true;
}

LegScan::Outcome LegScan::test_exactly(double from, double to) {
  if (exact_tests_ == kMostExactTests) return Outcome::open;
  ++exact_tests_;
  if (motion_.is_free(from, to)) {
    note_free(to);
    return Outcome::free;
  }
  if (to < answer_.met_from) {
    answer_.met_from = to;
    answer_.hit.reset();
  }
  return Outcome::met;
}

/// Looks at a part of the leg, all before which is free, and at the candidates there. Ends at the
/// first contact that is seen.
LegScan::Outcome LegScan::scan(const LegIntervals& intervals, double from, double to,
                               std::size_t begin, std::size_t end, int depth) {
  std::vector<LegCandidate>& candidates = room_.candidates;
  for (std::size_t k = begin; k < end; ++k) {
    const LegCandidate each = candidates[k];
    if (each.part >= 0) {
      place(intervals, each.part);
    } else {
      const LegPair& pair = room_.pairs[static_cast<std::size_t>(each.other)];
      place(intervals, pair.first);
      place(intervals, pair.second);
    }
    candidates.push_back({each.part, each.other, kAllIntervals, 0});
  }
  const int kept =
      kernels_.look(intervals, room_.parts.data(), room_.placed.data(), room_.standing.data(),
                    room_.pairs.data(), candidates.data() + end, static_cast<int>(end - begin));
  const std::size_t last = end + static_cast<std::size_t>(kept);
  candidates.resize(last);
  unsigned open = 0;
  unsigned met = 0;
  for (std::size_t k = end; k < last; ++k) {
    open |= candidates[k].open;
    met |= candidates[k].met;
  }
  const auto end_of = [&](int interval) {
    return interval + 1 == math::kLanes ? to : from + 2 * (interval + 1) * intervals.half;
  };
  Outcome outcome = Outcome::free;
  if (met != 0) {
    const int first = std::countr_zero(met);
    const auto meets = [&](const LegCandidate& each) { return (each.met >> first & 1U) != 0; };
    const auto by = std::find_if(candidates.begin() + static_cast<std::ptrdiff_t>(end),
                                 candidates.end(), meets);
    note_met(from + (2 * first + 1) * intervals.half, *by);
    outcome = Outcome::met;
  }
  // What is free before the first open interval is known in any case.
  if ((open & 1U) == 0) note_free(open == 0 ? to : end_of(std::countr_zero(open) - 1));
  const bool is_last = depth == kDeepest || is_short(end, last);
  for (int interval = 0; interval < math::kLanes && outcome == Outcome::free; ++interval) {
    const double begins = interval == 0 ? from : end_of(interval - 1);
    if ((open >> interval & 1U) == 0) {
      note_free(end_of(interval));
    } else if (is_last) {
      outcome = test_exactly(begins, end_of(interval));
    } else {
      const std::size_t first = candidates.size();
      for (std::size_t k = end; k < last; ++k) {
        if ((candidates[k].open >> interval & 1U) != 0) candidates.push_back(candidates[k]);
      }
      outcome = scan(look_at(begins, end_of(interval)), begins, end_of(interval), first,
                     candidates.size(), depth + 1);
      candidates.resize(last);
    }
  }
  candidates.resize(end);
  return outcome;
}

}  // namespace rubicon::collision
