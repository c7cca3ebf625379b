#pragma once

#include <vector>

#include "src/motion/geometry/motion.hpp"
#include "src/motion/robot/robot_model.hpp"

namespace rubicon::site {

/// The mass (kg) a machine may hold at a radius (m), by its load chart: linear between the points,
/// the first mass nearer in, nothing farther out than the last. Without a chart any mass.
double capacity_at(const std::vector<robot::CapacityPoint>& chart, double radius);

/// The least and the most of capacity_at over the radii from `inner` to `outer` (m, inner <=
/// outer).
double least_capacity(const std::vector<robot::CapacityPoint>& chart, double inner, double outer);
double most_capacity(const std::vector<robot::CapacityPoint>& chart, double inner, double outer);

/// The most that it may hold at a radius as far as that is known: of capacity_at over all radii
/// that are the same to a micrometre. What a chart allows at its last radius does not hang on
/// rounding.
double capacity_near(const std::vector<robot::CapacityPoint>& chart, double radius);

/// Whether a mass (kg) may hang at a radius (m): by capacity_near, to a milligram.
bool may_hang(const std::vector<robot::CapacityPoint>& chart, double mass, double radius);

/// The same at the best radius from `inner` to `outer`.
bool may_hang_between(const std::vector<robot::CapacityPoint>& chart, double mass, double inner,
                      double outer);

/// Radius of a load chart: horizontal distance, in the mounting frame {M}, from its z axis to the
/// tool (m).
double chart_radius(const math::Pose& X_WM, const math::Vec3& p_WT);

/// Whether a load chart lets a machine make a step with a load of a mass (kg): everywhere on the
/// way of its tool, to 1 mm of the radius. A load that is too heavy where it hangs may go where the
/// chart allows more, or nearer in where it allows as much. `X_WT`: the motion of the tool frame.
bool allows_step(const std::vector<robot::CapacityPoint>& chart, double mass,
                 const math::Pose& X_WM, const geometry::Motion& X_WT);

}  // namespace rubicon::site
