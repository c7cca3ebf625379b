#include "tests/proof/path.hpp"

#include <algorithm>
#include <cmath>

#include "tests/unit/collision/two_joint_motion.hpp"

namespace rubicon::collision::proof {
namespace {

/// The motion about (axis, point) that stands at X when s = `when`.
Path turning_through(const Pose& X, const Vec3& axis, const Vec3& point, double angle_deg,
                     double slide, double when) {
  const Path back = turning(X, axis, point, -angle_deg * when, -slide * when);
  return turning(back.pose(1), axis, point, angle_deg, slide);
}

}  // namespace

double Path::speed(double reach) const {
  if (const auto* screw = std::get_if<geometry::ScrewMotion>(&motion.kind)) {
    if (screw->angle_deg == 0) return screw->slide.norm();
    const double radius = screw->axis.cross(screw->X0.translation() - screw->point).norm() + reach;
    return math::radians(std::fabs(screw->angle_deg)) * radius + screw->slide.norm();
  }
  const auto& general = std::get<std::shared_ptr<const geometry::GeneralMotion>>(motion.kind);
  const auto& joints = dynamic_cast<const test::TwoJointMotion&>(*general);
  return math::radians(std::fabs(joints.theta1 - joints.theta0)) *
             (std::max(joints.place0.norm(), joints.place1.norm()) + reach) +
         (joints.place1 - joints.place0).norm();
}

Path standing(const Pose& X) { return {geometry::stationary(X), MotionKind::kStill}; }

Path translating(const Pose& X0, const Vec3& d) {
  return {geometry::translating(X0, d), MotionKind::kTranslation};
}

Path turning(const Pose& X0, const Vec3& axis, const Vec3& point, double angle_deg, double slide) {
  return {test::turning(X0, axis, point, angle_deg, slide),
          slide == 0 ? MotionKind::kRotation : MotionKind::kScrew};
}

Path crane(const Vec3& place, const Vec3& way, double theta0_deg, double angle_deg) {
  test::TwoJointMotion joints;
  joints.theta0 = theta0_deg;
  joints.theta1 = theta0_deg + angle_deg;
  joints.place0 = place;
  joints.place1 = place + way;
  return {joints.motion(), MotionKind::kGeneral};
}

Path random_path(Random& random, const Pose& X, const PathSizes& sizes) {
  constexpr MotionKind kKinds[] = {MotionKind::kTranslation, MotionKind::kRotation,
                                   MotionKind::kScrew, MotionKind::kGeneral};
  return random_path(random, kKinds[random.below(4)], X, sizes);
}

Path random_path(Random& random, MotionKind kind, const Pose& X, const PathSizes& sizes) {
  const double share = sizes.may_be_tiny && random.below(4) == 0 ? 1e-3 : 1;
  const double when = random.unit();
  switch (kind) {
    case MotionKind::kTranslation: {
      const Vec3 d = random.vector(share * sizes.travel);
      Pose X0 = X;
      X0.translation() -= when * d;
      return translating(X0, d);
    }
    case MotionKind::kRotation:
    case MotionKind::kScrew: {
      const Vec3 axis = random.direction();
      const Vec3 point = X.translation() + random.between(0, sizes.radius) * random.direction();
      const double angle = share * random.between(-sizes.angle_deg, sizes.angle_deg);
      const double slide =
          kind == MotionKind::kScrew ? share * random.between(-sizes.slide, sizes.slide) : 0;
      return turning_through(X, axis, point, angle, slide, when);
    }
    default:
      break;
  }
  // A crane about the world's z axis: general poses come from its place on the jib.
  const double angle = share * random.between(-sizes.angle_deg, sizes.angle_deg);
  const Vec3 way = random.vector(share * sizes.travel);
  return crane(X.translation() - when * way, way, -when * angle, angle);
}

Truth worse(Truth first, Truth second) {
  if (first == Truth::kHit || second == Truth::kHit) return Truth::kHit;
  if (first == Truth::kNearBoundary || second == Truth::kNearBoundary) return Truth::kNearBoundary;
  return Truth::kFree;
}

}  // namespace rubicon::collision::proof
