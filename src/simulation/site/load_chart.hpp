#pragma once

#include <vector>

#include "src/motion/robot/robot_model.hpp"

namespace rubicon::site {

/// The mass (kg) a machine may hold at a radius (m), by its load chart: linear between the points,
/// the first mass nearer in, nothing farther out than the last. Without a chart any mass.
double capacity_at(const std::vector<robot::CapacityPoint>& chart, double radius);

/// Radius of a load chart: horizontal distance, in the mounting frame {M}, from its z axis to the
/// tool (m).
double chart_radius(const math::Pose& X_WM, const math::Vec3& p_WT);

}  // namespace rubicon::site
