#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "src/results/verify/input/scene.hpp"

namespace rubicon::verify {

/// A robot that one parameter drives along an angle, as its rules tell.
struct VehicleRules {
  std::size_t drive = 0, heading = 0;
  std::size_t x = 0, y = 0;    ///< what driving changes
  double drift_deg = 0;        ///< the direction that it drives in at heading 0
  bool turns_driving = false;  ///< a step of both leads along the chord of the arc
};

/// By what the rules make of one step of each parameter; none: it is no vehicle.
std::optional<VehicleRules> find_vehicle(const SceneRobot& robot);

/// What steps change, from values on; of the body of the first parameter stepped.
std::vector<double> change_by(const SceneRobot& robot, std::span<const double> q,
                              std::span<const double> steps, int body);

/// How far it is from one value to another: of a cyclic angle the short way round.
double short_way(const SceneParameter& parameter, double from, double to);

}  // namespace rubicon::verify
