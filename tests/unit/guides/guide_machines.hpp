#pragma once

#include <functional>
#include <vector>

#include "src/motion/guides/space.hpp"

namespace rubicon::test {

/// Parameters x and y from 0 to 10, 1 a step and a second each.
robot::RobotModel gantry();

/// x along the heading theta, as a tow motor drives; steps of 0.5 m and 10 degrees.
robot::RobotModel vehicle();

/// The same, but it turns while it drives: along the chord of an arc.
robot::RobotModel steered_vehicle();

/// The excavator of PLANNERS 5.1: swing, boom, stick and bucket (inner angles), limits and speeds
/// of the ZX200; the tool is the tip.
robot::RobotModel excavator();

robot::Mounting standing(const robot::RobotModel& model);

/// What is free by a predicate on configurations; straight pieces are sampled very finely.
class PredicateTests : public guides::MotionTests {
 public:
  explicit PredicateTests(std::function<bool(std::span<const double>)> blocked)
      : blocked_(std::move(blocked)) {}
  bool stands(std::span<const double> q) override { return !blocked_(q); }
  bool sweeps_free(std::span<const double> q_from, std::span<const double> q_to) override;

 private:
  std::function<bool(std::span<const double>)> blocked_;
};

}  // namespace rubicon::test
