#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "src/motion/robot/kinematics.hpp"

namespace rubicon::robot {

class GoalChain;

/// The straight way of the tool frame from where it is to where it shall be, as `line` makes it:
/// its origin runs along a straight line, its orientation turns evenly with it. At the end of a
/// step the tool is on the line to 1e-9 m and rad; within it, while the parameters run linearly, as
/// near as `deviation` says: as measured at nine moments, plus a bound on what lies between. Steps
/// are as long as that, and the `step` of each parameter, allow. Parameters that have no step of
/// their own, and locked ones, stay. Where more move than the tool's pose needs (three
/// in a plane, six in space), those nearest to the base run evenly to their values at the end, and
/// so do those that are named. Stateless: what is left of a straight way is straight. The robot
/// must outlive it.
class ToolLine {
 public:
  ToolLine(const RobotModel& model, const Mounting& mounting, LineDeviation deviation,
           GoalClauses clauses);

  /// Why the robot can draw no line; empty: it can.
  const std::string& refusal() const { return refusal_; }
  /// Parameters that its steps step where none is locked, ascending.
  const std::vector<int>& stepped() const { return stepped_; }

  struct Step {
    enum class Kind : std::uint8_t {
      made,   ///< `steps` has it
      there,  ///< the tool is at the end
      limit,  ///< the line goes on where `parameter` may not
      none    ///< no configuration near this one leads on along the line
    };
    Kind kind = Kind::none;
    int parameter = -1;
  };
  /// The steps, per parameter, of the next motion step from q towards the tool's pose at q_end.
  /// `named`: parameters that end at their values in q_end.
  Step next_step(std::span<const double> q, std::span<const double> q_end,
                 std::span<const int> named, std::span<double> steps) const;

  bool is_there(std::span<const double> q, std::span<const double> q_end,
                std::span<const int> named) const;

 private:
  class Way;

  Way way_between(std::span<const double> q, std::span<const double> q_end,
                  std::span<const int> named) const;
  std::vector<int> steered(std::span<const int> named) const;

  double share_allowed(std::span<const double> change) const;
  std::vector<double> change_between(std::span<const double> q, std::span<const double> q_to) const;
  int barring(std::span<const double> q, const std::vector<double>& wanted) const;

  const RobotModel& model_;
  Mounting mounting_;
  LineDeviation deviation_;
  GoalClauses clauses_;
  std::string refusal_;
  std::vector<int> stepped_;
  std::vector<int> moved_;  ///< of these the ones that are not locked
  std::shared_ptr<const GoalChain> chain_;
  /// How the tool moves by the variables of the chain, in some configurations that are like any.
  std::vector<std::vector<std::array<double, 6>>> samples_;
};

}  // namespace rubicon::robot
