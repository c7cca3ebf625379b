#include "tests/proof/convex_truth.hpp"

#include <algorithm>
#include <cmath>

#include "tests/proof/icosphere.hpp"

namespace rubicon::collision::proof {
namespace {

/// Pieces of a way that carry no point farther than this from its place in the middle (m) are not
/// divided further.
constexpr double kFinest = 0.25 * kBand;
/// Looks at single poses that one case is worth; more is near the boundary.
constexpr int kLooksACase = 500;
/// The same for each shift that is tried on a translation.
constexpr int kLooksAShift = 40;

class FclTruth {
 public:
  FclTruth(const Solid& a, const Path& path, const Solid& b, const Pose& X_WB, double tolerance)
      : a_(a),
        path_(path),
        X_WB_(X_WB),
        tolerance_(tolerance),
        speed_(path.speed(a.reach())),
        as_it_is_(a.fcl()),
        smaller_(a.fcl(-(tolerance + kBand))),
        b_(b.fcl()) {}

  Truth answer() {
    if (path_.translates()) {
      const Truth first = look(true);
      if (first != Truth::kNearBoundary) return first;
      const double room = tolerance_ - kBand;
      if (room <= 0) return Truth::kNearBoundary;
      for (const Vec3& direction : directions()) {
        if (all_clear(room * direction)) return Truth::kFree;
      }
      return Truth::kNearBoundary;
    }
    return look(false);
  }

 private:
  struct Interval {
    double s0, s1;
  };
  static const std::vector<Vec3>& directions() { return icosphere42().vertices; }

  bool meets(const FclGeometry& a, const Pose& X) const {
    return a != nullptr && fcl_collide(a, X, b_, X_WB_);
  }
  double travel(const Interval& interval) const {
    return 0.5 * speed_ * (interval.s1 - interval.s0);
  }

  /// Branch and bound over the way.
  Truth look(bool one_shift_for_all) {
    if (is_deep(path_.pose(0), 0) || is_deep(path_.pose(1), 0)) return Truth::kHit;
    std::vector<Interval> open = {{0, 1}};
    bool near = false;
    int looks_left = kLooksACase;
    while (!open.empty()) {
      const Interval interval = open.back();
      open.pop_back();
      const Pose X = path_.pose(0.5 * (interval.s0 + interval.s1));
      const double loose = travel(interval);
      if (!meets(a_.fcl(loose), X)) continue;
      if (is_deep(X, loose)) return Truth::kHit;
      if (!one_shift_for_all && is_shallow(X, loose)) continue;
      if (loose < kFinest || --looks_left < 0) {
        near = true;
        continue;
      }
      const double middle = 0.5 * (interval.s0 + interval.s1);
      open.push_back({middle, interval.s1});
      open.push_back({interval.s0, middle});
    }
    return near ? Truth::kNearBoundary : Truth::kFree;
  }

  /// The ball of all shifts lies in the hull of some few; the sum of convex solids is convex.
  bool is_deep(const Pose& X, double loose) const {
    if (meets(smaller_, X)) return true;
    if (loose > tolerance_ + kBand || !meets(as_it_is_, X)) return false;
    const double shift = (tolerance_ + kBand) / icosphere42_inner_radius();
    return std::all_of(directions().begin(), directions().end(), [&](const Vec3& direction) {
      return meets(as_it_is_, shifted(X, shift * direction));
    });
  }

  bool is_shallow(const Pose& X, double loose) {
    const double room = tolerance_ - kBand;
    if (loose > 0.5 * room) return false;
    const FclGeometry larger = a_.fcl(loose);
    const auto helps = [&](std::size_t i) {
      return !meets(larger, shifted(X, room * directions()[i]));
    };
    if (helps(last_shift_)) return true;
    for (std::size_t i = 0; i < directions().size(); ++i) {
      if (helps(i)) {
        last_shift_ = i;
        return true;
      }
    }
    return false;
  }

  bool all_clear(const Vec3& shift) const {
    std::vector<Interval> open = {{0, 1}};
    for (int look = 0; look < kLooksAShift; ++look) {
      if (open.empty()) return true;
      const Interval interval = open.back();
      open.pop_back();
      const double middle = 0.5 * (interval.s0 + interval.s1);
      const Pose X = shifted(path_.pose(middle), shift);
      if (!meets(a_.fcl(travel(interval)), X)) continue;
      if (meets(as_it_is_, X)) return false;
      open.push_back({interval.s0, middle});
      open.push_back({middle, interval.s1});
    }
    return false;
  }

  const Solid& a_;
  const Path& path_;
  const Pose& X_WB_;
  double tolerance_;
  double speed_;
  FclGeometry as_it_is_;
  FclGeometry smaller_;
  FclGeometry b_;
  std::size_t last_shift_ = 0;
};

}  // namespace

Truth polytopes_truth(const Polytope& a, const Path& path_a, const Polytope& b, const Path& path_b,
                      double contact_tolerance) {
  const double tolerance = pair_tolerance(contact_tolerance, a.width, b.width);
  if (path_a.translates() && path_b.translates()) {
    const Pose X_BW = path_b.pose(0).inverse();
    const Vec3 d = X_BW.linear() * (path_a.displacement() - path_b.displacement());
    const double least =
        swept_depth(placed(a, X_BW * path_a.pose(0)), d, b, tolerance - 2 * kExactBand);
    if (std::fabs(least - tolerance) < kExactBand) return Truth::kNearBoundary;
    return least > tolerance ? Truth::kHit : Truth::kFree;
  }
  Polytope moved;
  const auto depth_at = [&](double s, double enough) {
    place(a, path_b.pose(s).inverse() * path_a.pose(s), moved);
    return depth(moved, b, enough);
  };
  const double speed = path_a.speed(reach_of(a)) + path_b.speed(reach_of(b));
  return truth_along(depth_at, speed, tolerance, kBand);
}

Truth fcl_truth(const Solid& a, const Path& path, const Solid& b, const Pose& X_WB,
                double contact_tolerance) {
  const double tolerance = pair_tolerance(contact_tolerance, a.width(), b.width());
  return FclTruth(a, path, b, X_WB, tolerance).answer();
}

}  // namespace rubicon::collision::proof
