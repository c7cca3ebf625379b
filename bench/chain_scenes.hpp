#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/chain.hpp"
#include "bench/random.hpp"

namespace rubicon::bench {

/// The excavator of four joints that its planners are compared with, and its trench with two pipes
/// and a truck: 18 boxes. `moved`: each box is shifted by up to 0.3 m and turned by up to 15
/// degrees.
Chain digging_excavator();
std::vector<ChainBox> trench_and_truck(Random* moved);
/// From a free pose in the trench to one over the truck; none: not found.
std::optional<ChainProblem> dig_and_dump(const Chain& chain, std::vector<ChainBox> obstacles,
                                         Random& random);

/// An arm of seven joints with the kinematics of the Franka Panda as published; its bodies as
/// boxes.
Chain seven_axis_arm();
/// In the manner of MotionBenchMaker: "shelf", "tall_shelf", "thin_shelf", "box", "cage",
/// "on_table", "under_table".
const std::vector<std::string>& arm_scenes();
/// A problem whose straight way is not free; none: not found with these draws.
std::optional<ChainProblem> arm_problem(const std::string& scene, const Chain& arm, Random& random);

/// So many boxes within the reach of the arm, or far from it.
std::vector<ChainBox> scattered(int near, int far, Random& random);

}  // namespace rubicon::bench
