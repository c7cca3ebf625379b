#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "src/motion/robot/robot_model.hpp"

namespace rubicon::site {

/// A line in the space of a robot's parameters, some steps long, whose swept volume was found free
/// of everything that stands, of the robot's own bodies and of zones. A step on it sweeps a part of
/// that volume, so it is free of them, too, and need not be tested. One for each robot.
///
/// A step is taken for the first of a run of equal ones, and 4 of them are looked at; then twice as
/// many each time it helps. Where steps never go on by the same amount nothing is looked at.
/// docs/collision.md, Steps ahead.
class FreeLine {
 public:
  /// Whether the step lies on the line, and what was looked at then is as it was. `version`: of all
  /// that the line was tested against, and of what hangs on the robot.
  bool covers(std::span<const double> q_from, std::span<const double> q_to, std::uint64_t version);
  /// The share of the line at which q, that is on it, lies.
  double share(std::span<const double> q) const {
    return (q[longest_] - q_from_[longest_]) / way_[longest_];
  }

  /// Told of each step that is not on the line, before it is tested: where a line from `q_from`
  /// worth a test would end; empty: the step alone is to be tested. It lies within the limits of
  /// the parameters.
  std::vector<double> ahead(const robot::RobotModel& model, std::span<const double> q_from,
                            std::span<const double> q_to);
  /// The line that `ahead` proposed is free.
  void found_free(std::span<const double> q_from, std::vector<double> q_end, std::uint64_t version);
  /// It is not, or nobody knows.
  void found_blocked();

 private:
  bool has(std::span<const double> q) const;
  bool goes_on(std::span<const double> q_from, std::span<const double> q_to) const;

  std::vector<double> q_from_;
  std::vector<double> way_;  ///< from its start to its end; empty: there is no line
  std::size_t longest_ = 0;  ///< the parameter with the longest way
  std::uint64_t version_ = 0;

  /// The last step that was not on a line.
  std::vector<double> last_from_;
  std::vector<double> last_to_;
  bool is_first_ = false;  ///< it did not go on where another ended
  bool is_used_ = false;   ///< since then a step was on the line
  bool is_eager_ = true;   ///< whether lines from first steps have been of use
  int steps_ = 0;          ///< to look ahead next time
  int pause_ = 0;          ///< steps to test alone before
};

}  // namespace rubicon::site
