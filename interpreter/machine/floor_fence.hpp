#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "interpreter/check/plan_model.hpp"
#include "src/motion/coverage/free_space.hpp"
#include "src/motion/robot/kinematics.hpp"

namespace rubicon::interpreter {

/// Shafts and columns of an area, which a guide leads the tool of a machine round although nothing
/// may stand there that could be met.
class FloorFence {
 public:
  /// Of a task that covers an area.
  FloorFence(const AreaSpec& area, const CoverSpec& cover);

  /// What a step from one configuration to another leads the tool's point over, in the plan view of
  /// the area; nothing if nothing. Derived parameters of both are up to date.
  std::optional<std::string> crossed(const robot::RobotModel& model,
                                     const robot::Mounting& mounting,
                                     std::span<const double> q_from,
                                     std::span<const double> q_to) const;

 private:
  std::string what_is_at(const coverage::Point& a, const coverage::Point& b) const;

  math::Pose X_AW_;
  std::string area_;
  std::shared_ptr<const coverage::FloorDescription> description_;
  coverage::Floor floor_;
  coverage::FreeSpace space_;
};

}  // namespace rubicon::interpreter
