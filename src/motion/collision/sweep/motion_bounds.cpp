#include "src/motion/collision/sweep/motion_bounds.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <variant>

#include "src/motion/math/angles.hpp"

namespace rubicon::collision {

using geometry::GeneralMotion;
using geometry::ScrewMotion;

namespace {

/// Rotations and axes given by callers may be this far from orthonormal (rounding of long chains of
/// frames).
constexpr double kRigid = 1e-6;

bool is_rigid(const Pose& X) {
  const auto& M = X.matrix();
  const Vec3 x(M(0, 0), M(1, 0), M(2, 0));
  const Vec3 y(M(0, 1), M(1, 1), M(2, 1));
  const Vec3 z(M(0, 2), M(1, 2), M(2, 2));
  // Two unit columns at right angles, the third their product; written so that "not a number"
  // fails.
  const double dx = x.squaredNorm() - 1;
  const double dy = y.squaredNorm() - 1;
  const double xy = x.dot(y);
  const double off = (dx * dx + dy * dy) + (xy * xy + (x.cross(y) - z).squaredNorm());
  return off <= kRigid * kRigid && std::isfinite(M(0, 3) + M(1, 3) + M(2, 3));
}

}  // namespace

const ScrewMotion* screw_of(const Motion& motion) { return std::get_if<ScrewMotion>(&motion.kind); }

const GeneralMotion* general_of(const Motion& motion) {
  const auto* general = std::get_if<std::shared_ptr<const GeneralMotion>>(&motion.kind);
  return general ? general->get() : nullptr;
}

void require_valid(const Motion& motion) {
  const ScrewMotion* screw = screw_of(motion);
  if (screw == nullptr) {
    require_rigid(motion.pose(0), "the pose at the start of a motion");
    require_rigid(motion.pose(1), "the pose at the end of a motion");
    return;
  }
  if (!is_rigid(screw->X0)) require_rigid(screw->X0, "the pose at the start of a motion");
  // Sums are finite only if all of it is; one that is too great is looked at again.
  const Vec3& slide = screw->slide;
  if (!std::isfinite(slide.x() + slide.y() + slide.z()) && !slide.allFinite()) {
    throw std::invalid_argument("the slide of a motion is not finite");
  }
  if (screw->angle_deg == 0) return;
  const Vec3& point = screw->point;
  if (!std::isfinite(screw->angle_deg + point.x() + point.y() + point.z()) &&
      !(std::isfinite(screw->angle_deg) && point.allFinite())) {
    throw std::invalid_argument("the rotation of a motion is not finite");
  }
  if (!(std::fabs(screw->axis.squaredNorm() - 1) < 2 * kRigid)) {
    throw std::invalid_argument("the axis of a motion is not a unit vector");
  }
  const double length = slide.squaredNorm();
  if (length == 0) return;
  if (screw->axis.cross(slide).squaredNorm() > kRigid * kRigid * length) {
    throw std::invalid_argument("the slide of a rotating motion is not along its axis");
  }
}

double unit_sagitta_of(double angle_deg) {
  const double angle = std::fabs(angle_deg);
  if (angle >= 360) return 2;
  const double sine = math::sin_deg(angle / 4);
  return 2 * sine * sine;
}

void require_rigid(const Pose& X, const char* what) {
  if (is_rigid(X)) return;
  const bool finite = X.linear().allFinite() && X.translation().allFinite();
  throw std::invalid_argument(
      fmt::format("{} is not {}", what, finite ? "a rigid transform" : "finite"));
}

ChordDeviation chord_deviation_of(const Motion& motion, const BodyExtent& extent, double s0,
                                  double s1) {
  if (const ScrewMotion* screw = screw_of(motion)) {
    if (screw->angle_deg == 0) return {};
    const double unit_sagitta = unit_sagitta_of(screw->angle_deg * (s1 - s0));
    const double radius = screw->axis.cross(screw->X0 * extent.centre - screw->point).norm();
    return {unit_sagitta * (radius + extent.radius), unit_sagitta * radius};
  }
  const GeneralMotion* general = general_of(motion);
  if (general == nullptr) return {};
  return {general->chord_deviation(s0, s1, extent.reach),
          general->chord_deviation(s0, s1, extent.centre.norm())};
}

Placement centred(const Motion& motion, const BodyExtent& extent, double s) {
  const ScrewMotion* screw = screw_of(motion);
  if (screw == nullptr) {
    const Pose X = motion.pose(s);
    return {X.linear(), X * extent.centre};
  }
  // Motion::pose(s), without the detour over matrices of four columns.
  Placement start(screw->X0.linear(), screw->X0 * extent.centre);
  if (s == 0) return start;
  if (screw->angle_deg == 0) return {start.R, start.t + s * screw->slide};
  const Mat3 turned = math::rotation_about_deg(screw->axis, s * screw->angle_deg);
  return {turned * start.R, screw->point + turned * (start.t - screw->point) + s * screw->slide};
}

}  // namespace rubicon::collision
