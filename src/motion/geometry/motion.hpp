#pragma once

#include <memory>
#include <variant>

#include "src/motion/math/pose.hpp"

namespace rubicon::geometry {

using math::Pose;
using math::Vec3;

/// X(s) = translation by s*slide, after rotation by s*angle about the line through `point` along
/// `axis`, of X0. angle = 0 is a pure translation by `slide` (which may then have any direction);
/// otherwise slide is parallel to axis.
struct ScrewMotion {
  Pose X0 = Pose::Identity();
  Vec3 axis = Vec3::UnitZ();  ///< unit vector, world
  Vec3 point = Vec3::Zero();  ///< a point of the axis, world
  double angle_deg = 0;
  Vec3 slide = Vec3::Zero();  ///< m, world
};

/// A motion that is neither: poses by s, and a rigorous bound of how far points deviate from the
/// straight chord.
class GeneralMotion {
 public:
  virtual ~GeneralMotion() = default;
  virtual Pose pose(double s) const = 0;
  /// Upper bound over s in [s0, s1] of |x(s) - chord(s)| for every point within `reach` metres of
  /// the body's origin, where chord(s) is the straight line between x(s0) and x(s1). Goes to 0 with
  /// the square of s1 - s0.
  virtual double chord_deviation(double s0, double s1, double reach) const = 0;
};

/// The rigid motion of one body over one step, s in [0, 1].
struct Motion {
  std::variant<ScrewMotion, std::shared_ptr<const GeneralMotion>> kind = ScrewMotion{};

  bool moves() const;
  Pose pose(double s) const;
};

/// A body standing still at X.
Motion stationary(const Pose& X);
/// A pure translation by d (world) from X0.
Motion translating(const Pose& X0, const Vec3& d);

}  // namespace rubicon::geometry
