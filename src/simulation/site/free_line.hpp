#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "src/motion/collision/base/bounds.hpp"
#include "src/motion/robot/robot_model.hpp"

namespace rubicon::site {

/// A line in the space of a robot's parameters, some steps long, whose swept volume was found free
/// of everything that stands, of the robot's own bodies and of zones. A step on it sweeps a part of
/// that volume, so it is free of them, too, and need not be tested. One for each robot.
///
/// A step that goes on where the last one ended, by the same amount, is a reason to look further
/// ahead: 4 steps, then twice as many each time it helps. docs/collision.md, Steps ahead.
class FreeLine {
 public:
  /// Whether the step lies on the line, and what was looked at then is as it was. `version`: of all
  /// that the line was tested against, and of what hangs on the robot.
  bool covers(std::span<const double> q_from, std::span<const double> q_to,
              std::uint64_t version) const;
  /// The box around all that is swept along the line (world, m).
  const collision::Bounds& bounds() const { return bounds_; }

  /// Told of each step that is not on the line, before it is tested: where a line from `q_from`
  /// worth a test would end; empty: the step alone is to be tested. It lies within the limits of
  /// the parameters.
  std::vector<double> ahead(const robot::RobotModel& model, std::span<const double> q_from,
                            std::span<const double> q_to);
  /// The line that `ahead` proposed is free.
  void found_free(std::span<const double> q_from, std::vector<double> q_end, std::uint64_t version,
                  const collision::Bounds& bounds);
  /// It is not, or nobody knows.
  void found_blocked();

 private:
  bool has(std::span<const double> q) const;

  std::vector<double> q_from_;
  std::vector<double> way_;  ///< from its start to its end; empty: there is no line
  std::size_t longest_ = 0;  ///< the parameter with the longest way
  std::uint64_t version_ = 0;
  collision::Bounds bounds_;

  std::vector<double> last_to_;    ///< where the last step ended that was tested
  std::vector<double> last_step_;  ///< its change of each parameter
  int steps_ = 4;                  ///< to look ahead next time
  int pause_ = 0;                  ///< steps to test alone before
};

}  // namespace rubicon::site
