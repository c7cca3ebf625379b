#pragma once

#include "tests/proof/case.hpp"

namespace rubicon::collision::proof {

/// The third voice speaks in one of so many steps of polytopes.
inline constexpr int kThirdVoiceEvery = 16;

/// A motion, what kind it is, and how fast it carries points.
struct Path {
  Motion motion;
  MotionKind kind = MotionKind::kStill;

  Pose pose(double s) const { return motion.pose(s); }
  /// No rotation: the exact axes of a swept solid decide.
  bool translates() const { return kind == MotionKind::kStill || kind == MotionKind::kTranslation; }
  Vec3 displacement() const { return pose(1).translation() - pose(0).translation(); }
  /// Upper bound of the way (m per unit of s) of any point within `reach` of the frame's origin.
  double speed(double reach) const;
};

/// X with its origin moved by so much.
inline Pose shifted(const Pose& X, const Vec3& by) {
  Pose result = X;
  result.translation() += by;
  return result;
}

Path standing(const Pose& X);
Path translating(const Pose& X0, const Vec3& d);
/// A rotation, or with a slide along the axis a screw.
Path turning(const Pose& X0, const Vec3& axis, const Vec3& point, double angle_deg,
             double slide = 0);
/// A crane that slews about z by `angle_deg` while its load runs along `way` (frame of the jib),
/// starting at X0 turned by nothing.
Path crane(const Vec3& place, const Vec3& way, double theta0_deg, double angle_deg);

/// How big the steps of random paths are.
struct PathSizes {
  double travel = 0.5;       ///< m, of a translation, each axis
  double radius = 3;         ///< m, greatest distance of a rotation's axis
  double angle_deg = 15;     ///< greatest
  double slide = 0.2;        ///< m, along the axis of a screw
  bool may_be_tiny = false;  ///< sometimes thousandths of all that
};
/// A path of random kind that passes X at a random moment (a general one: about there).
Path random_path(Random& random, const Pose& X, const PathSizes& sizes);
Path random_path(Random& random, MotionKind kind, const Pose& X, const PathSizes& sizes);

/// Whether a depth that changes by at most `speed` per unit of s exceeds `tolerance` + `band`
/// somewhere on [0, 1], or stays below `tolerance` - `band`. `depth(s, enough)` may return any
/// upper bound that is not more than `enough`, else the exact depth. Branch and bound.
template <typename Depth>
Truth truth_along(const Depth& depth, double speed, double tolerance, double band) {
  const double deep = tolerance + band;
  const double shallow = tolerance - band;
  if (depth(0.0, deep) > deep || depth(1.0, deep) > deep) return Truth::kHit;
  struct Interval {
    double s0, s1;
  };
  std::vector<Interval> open = {{0, 1}};
  bool near = false;
  // Past this many looks the case is too near to call; it bounds the cost of a contact that lasts.
  int looks_left = 8000;
  while (!open.empty()) {
    const auto [s0, s1] = open.back();
    open.pop_back();
    const double middle = 0.5 * (s0 + s1);
    const double travel = speed * 0.5 * (s1 - s0);
    const double here = depth(middle, shallow - travel);
    if (here > deep) return Truth::kHit;
    if (here + travel <= shallow) continue;
    if (travel < 0.25 * band || --looks_left < 0) {
      near = true;
      continue;
    }
    open.push_back({s0, middle});
    open.push_back({middle, s1});
  }
  return near ? Truth::kNearBoundary : Truth::kFree;
}

/// The truth of the whole from that of its parts: one hit is a hit.
Truth worse(Truth first, Truth second);

}  // namespace rubicon::collision::proof
