#include "src/motion/geometry/motion.hpp"

namespace rubicon::geometry {
namespace {

Pose pose_of(const ScrewMotion& screw, double s) {
  Pose X = screw.X0;
  if (screw.angle_deg != 0) {
    const math::Mat3 R = math::rotation_about_deg(screw.axis, s * screw.angle_deg);
    X.linear() = R * screw.X0.linear();
    X.translation() = screw.point + R * (screw.X0.translation() - screw.point);
  }
  X.translation() += s * screw.slide;
  return X;
}

}  // namespace

bool Motion::moves() const {
  if (const auto* screw = std::get_if<ScrewMotion>(&kind)) {
    return screw->angle_deg != 0 || !(screw->slide.array() == 0).all();
  }
  return std::get<std::shared_ptr<const GeneralMotion>>(kind) != nullptr;
}

Pose Motion::pose(double s) const {
  if (const auto* screw = std::get_if<ScrewMotion>(&kind)) return pose_of(*screw, s);
  const auto& general = std::get<std::shared_ptr<const GeneralMotion>>(kind);
  return general ? general->pose(s) : Pose::Identity();
}

Motion stationary(const Pose& X) { return translating(X, Vec3::Zero()); }

Motion translating(const Pose& X0, const Vec3& d) {
  ScrewMotion screw;
  screw.X0 = X0;
  screw.slide = d;
  return Motion{screw};
}

}  // namespace rubicon::geometry
