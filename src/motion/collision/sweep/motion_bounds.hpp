#pragma once

#include "src/motion/collision/base/placement.hpp"
#include "src/motion/geometry/motion.hpp"

namespace rubicon::collision {

using geometry::Motion;

/// What the motion bounds need of a body. Its own coordinates are relative to `centre`.
struct BodyExtent {
  Vec3 centre = Vec3::Zero();  ///< in the frame of the shapes (the frame the motions place)
  double radius = 0;           ///< m, greatest distance of a core point from the centre
  double reach = 0;            ///< m, greatest distance of a core point from the frame's origin
};

/// The screw of a motion, or null.
const geometry::ScrewMotion* screw_of(const Motion& motion);
/// The general motion of a motion, or null.
const geometry::GeneralMotion* general_of(const Motion& motion);

/// Throws std::invalid_argument unless X is finite and its rotation orthonormal and right-handed to
/// 1e-6; `what` names it.
void require_rigid(const Pose& X, const char* what);

/// Throws std::invalid_argument for motions that are not finite, poses that are not rigid, axes
/// that are not unit vectors and slides across their axis.
void require_valid(const Motion& motion);

/// 1 - cos(half of the angle): how far an arc of unit radius deviates from the chord between its
/// ends; also at equal parameter, docs/collision.md. Never more than the diameter.
double unit_sagitta_of(double angle_deg);

/// Bounds for one body on one interval, all against the chord between the interval's ends (m).
struct ChordDeviation {
  double points = 0;  ///< of any core point
  double centre = 0;  ///< of the body's centre
};
ChordDeviation chord_deviation_of(const Motion& motion, const BodyExtent& extent, double s0,
                                  double s1);

/// Where the centred coordinates of a body are at s.
Placement centred(const Motion& motion, const BodyExtent& extent, double s);

}  // namespace rubicon::collision
