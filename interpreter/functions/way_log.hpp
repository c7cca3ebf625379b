#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "src/motion/robot/kinematics.hpp"

namespace rubicon::interpreter {

/// The way of a robot since its script began, step by step: what `here()` and the functions of the
/// places that it gives ask. A place is the number of steps before it. Metres, degrees; points of
/// the tool in the plane z = 0 of the world.
class WayLog {
 public:
  bool begun() const { return !steps_.empty(); }
  void clear();
  /// Where the way begins; `p_WG`: the goal.
  void begin(std::span<const double> q, const math::Vec3& p_WT, const math::Vec3& p_WG);
  /// A step that was made: from q_from to q_to, cyclic angles unwrapped.
  void add(std::span<const double> q_from, std::span<const double> q_to, const math::Vec3& p_WT,
           const math::Vec3& p_WG);

  /// The number of steps so far.
  int here() const { return static_cast<int>(steps_.size()) - 1; }

  /// Back where the robot was at `place`, within half a step of every parameter, whole turns left
  /// aside; and it was elsewhere in between.
  bool is_at(const robot::RobotModel& model, int place) const;
  /// By how much the parameter has changed since then, whole turns counted.
  double changed(int parameter, int place) const;
  /// The value that the parameter had there, whole turns since the beginning counted.
  double value_at(int parameter, int place) const;
  /// By how much the bearing of the goal has turned since then (degrees), whole turns counted.
  double bearing_turned(int place) const;
  /// The last step that moved the tool crossed the straight line from the place to the goal, nearer
  /// to the goal than the place, or ended on it.
  bool crossed(int place, const math::Vec3& p_WG) const;
  /// The last step that moved the tool led back onto the way since the place, within half of that
  /// step: 1 where it encloses an area anticlockwise, -1 clockwise; else 0. Of several returns the
  /// latest that encloses one counts.
  int circled(int place) const;

  /// Of the place, and of all that was gone since, whole turns made before left aside: for the hash
  /// of the state. How many steps lie before it does not count.
  std::uint64_t hash_since(const robot::RobotModel& model, int place) const;
  /// Only of where the place is, to half a step.
  std::uint64_t hash_of(const robot::RobotModel& model, int place) const;

 private:
  struct Step {
    double x = 0;  ///< where the tool is
    double y = 0;
    double bearing = 0;     ///< of the goal, unwrapped (degrees)
    std::uint64_t way = 0;  ///< hash of all steps so far: a polynomial, so that parts of it can be
                            ///< told
  };
  const Step& at(int step) const { return steps_[static_cast<std::size_t>(step)]; }
  std::span<const double> q(int step) const {
    return std::span(q_).subspan(static_cast<std::size_t>(step) * parameters_, parameters_);
  }
  bool is_same(const robot::RobotModel& model, int a, int b) const;
  int last_move(int place) const;
  double distance(int a, int b) const;
  std::uint64_t word_of(int step) const;
  std::uint64_t hash_values(const robot::RobotModel& model, int place, double share) const;

  std::size_t parameters_ = 0;
  std::vector<Step> steps_;  ///< the first: where it began
  std::vector<double> q_;    ///< unwrapped, by step and parameter
};

}  // namespace rubicon::interpreter
