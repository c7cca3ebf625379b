#pragma once

#include <span>
#include <vector>

#include "interpreter/program/world.hpp"
#include "src/motion/guides/space.hpp"

namespace rubicon::interpreter {

/// The site as a guide asks it, by a robot, without a note of what is met. Both must outlive it.
class WorldTests : public guides::MotionTests {
 public:
  WorldTests(const robot::RobotModel& model, const World& world) : model_(model), world_(world) {}

  bool stands(std::span<const double> q) override;
  bool sweeps_free(std::span<const double> q_from, std::span<const double> q_to) override;
  guides::LegShares look_along(std::span<const double> q_from, std::span<const double> q_to,
                               bool whole, double least) override;
  std::vector<guides::Thing> things() const override;
  guides::Nearness nearest(std::span<const double> q, double range,
                           const guides::PairsLeftOut& left_out) override;

 private:
  bool in_range(std::span<const double> q) const;

  const robot::RobotModel& model_;
  const World& world_;
};

}  // namespace rubicon::interpreter
