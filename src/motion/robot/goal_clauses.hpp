#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "src/motion/math/pose.hpp"

namespace rubicon::robot {

/// The turn that a goal frame leaves as it comes: about one of the tool's own axes, or any.
enum class FreeTurn : std::uint8_t { none, x, y, z, all };

/// What a motion asks beside its goals (EXTENSIONS 3).
struct GoalClauses {
  FreeTurn free = FreeTurn::none;                 ///< of goal frames
  std::vector<std::pair<int, double>> near = {};  ///< parameter, value (file units): of several
                                                  ///< solutions of a frame the one nearest to them
  std::vector<int> locked = {};                   ///< parameters that no step changes, ascending

  bool locks(int parameter) const;
};

/// How far the tool may be beside its straight way.
struct LineDeviation {
  double position = 1e-3;        ///< m
  double orientation_deg = 0.1;  ///< degrees
  bool operator==(const LineDeviation&) const = default;
};

/// The rotation vector (rad, world) of R.
math::Vec3 rotation_vector(const math::Mat3& R);

/// The rotation by a rotation vector (rad, world); the same bits on every machine.
math::Mat3 rotation_by(const math::Vec3& vector);

/// The turn (rotation vector, rad, world) that brings the tool to the goal's orientation; about a
/// free axis the least one that brings this axis to the goal's.
math::Vec3 turn_to_goal(const math::Mat3& R_WT, const math::Mat3& R_WG, FreeTurn free);

/// How far the tool is turned from the goal's orientation, but for what is free; degrees, [0, 180].
double turn_off_deg(const math::Mat3& R_WT, const math::Mat3& R_WG, FreeTurn free);

/// Takes from a rate of turn (world) what is free: an axis of the tool's own, or all.
math::Vec3 turn_that_counts(const math::Vec3& turn, const math::Mat3& R_WT, FreeTurn free);

}  // namespace rubicon::robot
