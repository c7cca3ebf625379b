#include "src/motion/guides/space.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/math/index.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::guides {

namespace {

constexpr double kWeightOfMetre = 10;

/// The mean of a beta distribution is kept so far from the ends of a range, where its shapes would
/// be infinite.
constexpr double kEdgeShare = 0.02;

/// A leg is followed in so many steps at most: more are a mistake in the robot's steps.
constexpr int kMostSteps = 1'000'000;

/// m or degrees by which a sum that is kept may be beyond its bound: rounding.
constexpr double kKeepSlack = 1e-6;
/// Bounds that are not met are met one after the other so many times at most.
constexpr int kKeepRounds = 4;

using math::at;

}  // namespace

Space::Space(const robot::RobotModel& model, const robot::Mounting& mounting,
             std::span<const double> q, const GuideSpec& spec, MotionTests& tests,
             const robot::GoalClauses& clauses)
    : model_(model),
      mounting_(mounting),
      q_(q.begin(), q.end()),
      spec_(spec),
      tests_(tests),
      leg_(model, mounting, clauses, spec.turn_radius) {
  for (std::size_t i = 0; i < size(); ++i) {
    double weight = parameter(i).rotation ? 1 : kWeightOfMetre;
    for (const auto& [index, value] : spec.weights) {
      if (index == leg_.parameters()[i]) weight = value;
    }
    weights_.push_back(weight);
  }
}

Point Space::point(std::span<const double> q) const {
  Point result;
  for (const int i : leg_.parameters()) result.push_back(q[at(i)]);
  return result;
}

std::vector<double> Space::configuration(std::span<const double> point) const {
  std::vector<double> q = q_;
  for (std::size_t i = 0; i < size(); ++i) {
    q[at(leg_.parameters()[i])] = robot::reduced(parameter(i), point[i]);
  }
  robot::update_derived(model_, mounting_, q);
  return q;
}

double Space::offset(std::span<const double> a, std::span<const double> b, std::size_t i) const {
  return robot::way_between(parameter(i), a[i], b[i]) * weights_[i];
}

double Space::distance(std::span<const double> a, std::span<const double> b) const {
  double sum = 0;
  if (leg_.steers()) {
    const double driven = leg_.driven(configuration(a), configuration(b)) * kWeightOfMetre;
    sum = driven * driven;
  }
  for (std::size_t i = 0; i < size(); ++i) {
    const int index = leg_.parameters()[i];
    const auto place = leg_.place();
    const bool steered = index == leg_.heading() || index == place[0] || index == place[1];
    if (leg_.steers() && steered) continue;
    const double off = offset(a, b, i);
    sum += off * off;
  }
  return std::sqrt(sum);
}

Point Space::towards(std::span<const double> a, std::span<const double> b, double length) const {
  const double whole = distance(a, b);
  if (whole <= length) return {b.begin(), b.end()};
  if (leg_.steers()) {
    return point(leg_.partway(configuration(a), configuration(b), length / whole));
  }
  Point result(size());
  for (std::size_t i = 0; i < size(); ++i) {
    const double off = robot::way_between(parameter(i), a[i], b[i]);
    result[i] = robot::reduced(parameter(i), a[i] + off * (length / whole));
  }
  return result;
}

Point Space::moved(std::span<const double> a, std::span<const double> offsets) const {
  Point result(size());
  for (std::size_t i = 0; i < size(); ++i) {
    double value = a[i] + offsets[i] / weights_[i];
    if (!parameter(i).cyclic) value = std::clamp(value, lower(i), upper(i));
    result[i] = robot::reduced(parameter(i), value);
  }
  make_kept(result);
  return result;
}

double Space::heading_along(std::span<const double> q, const Eigen::Vector2d& direction_W) const {
  return leg_.heading_along(q, direction_W);
}

double Space::lower(std::size_t i) const { return parameter(i).cyclic ? -180 : parameter(i).lower; }
double Space::upper(std::size_t i) const { return parameter(i).cyclic ? 180 : parameter(i).upper; }

Point Space::sample(Random& random) const {
  Point result;
  sample(random, result);
  return result;
}

void Space::sample(Random& random, Point& point) const {
  point.resize(size());
  for (std::size_t i = 0; i < size(); ++i) point[i] = random.between(lower(i), upper(i));
  make_kept(point);
}

Point Space::sample_about(std::span<const double> goal, double concentration,
                          Random& random) const {
  Point result(size());
  for (std::size_t i = 0; i < size(); ++i) {
    const double range = upper(i) - lower(i);
    if (!(range > 0)) {
      result[i] = lower(i);
      continue;
    }
    // Of a cyclic angle the range is turned so that the goal lies in its middle.
    const double mean = parameter(i).cyclic
                            ? 0.5
                            : std::clamp((goal[i] - lower(i)) / range, kEdgeShare, 1 - kEdgeShare);
    const double a = mean < 0.5 ? 1 : mean / (1 - mean);
    const double b = mean < 0.5 ? (1 - mean) / mean : 1;
    const double share = random.beta(a * concentration, b * concentration);
    result[i] = parameter(i).cyclic ? robot::reduced(parameter(i), goal[i] + (share - 0.5) * range)
                                    : lower(i) + share * range;
  }
  make_kept(result);
  return result;
}

bool Space::keeps(std::span<const double> q) const {
  return std::all_of(spec_.keep.begin(), spec_.keep.end(), [&](const KeptBound& bound) {
    double sum = 0;
    for (const auto& [index, factor] : bound.terms) sum += factor * q[at(index)];
    return sum <= bound.most + kKeepSlack;
  });
}

/// Moves a point to where all bounds hold, each time the shortest way to the next of them; where
/// they cannot hold within the ranges, tests refuse it.
void Space::make_kept(Point& point) const {
  for (int round = 0; round < kKeepRounds && !spec_.keep.empty(); ++round) {
    bool moved = false;
    for (const KeptBound& bound : spec_.keep) {
      double off = -bound.most;
      double square = 0;
      for (std::size_t i = 0; i < size(); ++i) {
        for (const auto& [index, factor] : bound.terms) {
          if (index != leg_.parameters()[i]) continue;
          off += factor * point[i];
          square += factor * factor / (weights_[i] * weights_[i]);
        }
      }
      if (off <= 0 || !(square > 0)) continue;
      moved = true;
      for (std::size_t i = 0; i < size(); ++i) {
        for (const auto& [index, factor] : bound.terms) {
          if (index != leg_.parameters()[i]) continue;
          point[i] -= off * factor / (weights_[i] * weights_[i] * square);
          point[i] = std::clamp(point[i], lower(i), upper(i));
        }
      }
    }
    if (!moved) return;
  }
}

/// A sum that is kept at both ends of a straight piece is kept all along it.
bool Space::sweeps_free(std::span<const double> q_from, std::span<const double> q_to) {
  return keeps(q_to) && tests_.sweeps_free(q_from, q_to);
}

bool Space::stands(std::span<const double> point) {
  ++checks_;
  const bool free = tests_.stands(configuration(point));
  if (!free) ++refused_;
  return free;
}

bool Space::leg_is_free(std::span<const double> a, std::span<const double> b) {
  std::vector<double> q = configuration(a);
  const std::vector<double> target = configuration(b);
  if (by_steps_) {
    const bool free = follow_is_free(q, target);
    if (!free) ++refused_;
    return free;
  }
  if (const auto end = end_of_straight(q, target)) {
    const LegShares looked = tests_.look_along(q, *end, true, 1);
    if (looked.free_until >= 1 || looked.met_from <= 1) {
      ++checks_;
      if (looked.free_until >= 1) return true;
      ++refused_;
      return false;
    }
  }
  for (const std::vector<double>& corner : leg_.corners(q, target)) {
    ++checks_;
    if (!sweeps_free(q, corner)) {
      ++refused_;
      return false;
    }
    q = corner;
    robot::normalise(model_, q);
  }
  return true;
}

/// Where a leg ends, if it is one straight piece between values in their ranges that the guide
/// keeps: what can be looked along.
std::optional<std::vector<double>> Space::end_of_straight(std::span<const double> q,
                                                          std::span<const double> target) const {
  if (leg_.drive() >= 0 || !keeps(q) || !keeps(target)) return std::nullopt;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const robot::Parameter& p = model_.parameters[i];
    if (!p.cyclic && (target[i] < p.lower || target[i] > p.upper)) return std::nullopt;
  }
  std::vector<std::vector<double>> corners = leg_.corners(q, target);
  if (corners.size() != 1) return std::nullopt;
  return std::move(corners.front());
}

std::optional<double> Space::free_share(std::span<const double> a, std::span<const double> b,
                                        double least) {
  if (by_steps_) return std::nullopt;
  const std::vector<double> q = configuration(a);
  const auto end = end_of_straight(q, configuration(b));
  if (!end) return std::nullopt;
  const LegShares looked = tests_.look_along(q, *end, false, least);
  const bool free = looked.free_until >= std::min(least, 1.0);
  if (!free && looked.met_from > 1) return std::nullopt;
  ++checks_;
  if (!free) ++refused_;
  return free ? looked.free_until : 0;
}

/// Goes from q to the target as `follow` does; q is then where that leads.
bool Space::follow_is_free(std::vector<double>& q, std::span<const double> target) {
  // What is proved free of the whole leg needs no proof for its steps.
  const auto end = by_steps_ ? std::nullopt : end_of_straight(q, target);
  const bool proved = end && tests_.look_along(q, *end, true, 1).free_until >= 1;
  std::vector<double> steps(q.size());
  std::vector<double> next(q.size());
  for (int n = 0; n < kMostSteps && leg_.next_step(q, target, steps); ++n) {
    robot::apply_rules(model_, mounting_, q, steps, next);
    ++checks_;
    if (!proved && !sweeps_free(q, next)) return false;
    q = next;
    robot::normalise(model_, q);
  }
  return leg_.is_there(q, target);
}

std::vector<Point> Space::with_chords(const std::vector<Point>& way) const {
  if (!leg_.steers()) return way;
  std::vector<Point> result{way.front()};
  for (std::size_t k = 0; k + 1 < way.size(); ++k) {
    for (std::vector<double>& q : leg_.stops(configuration(way[k]), configuration(way[k + 1]))) {
      robot::normalise(model_, q);
      result.push_back(point(q));
    }
  }
  return result;
}

bool Space::steps_are_free(std::span<const double> q, const std::vector<Point>& way) {
  std::vector<double> now(q.begin(), q.end());
  return std::all_of(way.begin(), way.end(),
                     [&](const Point& point) { return follow_is_free(now, configuration(point)); });
}

}  // namespace rubicon::guides
