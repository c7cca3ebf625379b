#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/motion/geometry/shape.hpp"
#include "src/motion/robot/formula.hpp"
#include "src/motion/robot/goal_clauses.hpp"

namespace rubicon::robot {

using math::Vec3;

/// A control parameter of a body, in file units: metres for x, y, z; degrees for psi, phi, theta.
struct Parameter {
  std::string name;          ///< x, y, z, psi, phi or theta
  std::string display_name;  ///< `name` where it is unique in the robot, else body.name
  int body = 0;
  bool rotation = false;
  bool cyclic = false;        ///< an angle in (-180, 180]; nothing else minds a whole turn of it
  bool counts_turns = false;  ///< an angle with a range in which a whole turn changes something
                              ///< else: a screw, a winch; each of its values stands for itself
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double step = 0;          ///< 0: cannot be moved by a command
  double speed = 0;         ///< per second; 0 without step
  double loaded_speed = 0;  ///< per second while an object is attached
  double acceleration = 0;  ///< per second squared; 0: its speed is there at once (trapezoid.hpp)
  double start = 0;
  int prefer = 1;         ///< ties of directions: +1 or -1
  bool derived = false;   ///< computed from others after the rules; never stepped
  Formula derived_value;  ///< for derived
  Formula
      rule;  ///< new value from old values, steps and starts (p <- p + p_s where none was written)
  bool direct = true;  ///< rule is p <- p + p_s and p_s occurs in no other rule
  bool free = true;    ///< some command can change it
  double quantum =
      1;  ///< its step, or the smallest step of its kind in the robot, else 1 m or 1 degree

  bool limited() const {
    return !cyclic && (lower > -std::numeric_limits<double>::infinity() ||
                       upper < std::numeric_limits<double>::infinity());
  }
};

/// An elementary transform of a frame: trans(a, b, c) or a rotation by `a` degrees.
struct FrameElement {
  enum class Kind { trans, rotx, roty, rotz };
  Kind kind = Kind::trans;
  Formula a, b, c;
};
using FrameFormula = std::vector<FrameElement>;

/// A rope, taut and straight, from a point of one body to a point of the body that it is a child
/// of: its length and direction change as the two move.
struct Rope {
  double radius = 0;           ///< m
  int from = 0;                ///< body, never the rope's parent
  Vec3 p_from = Vec3::Zero();  ///< m, in the frame of `from`
  Vec3 p_to = Vec3::Zero();    ///< m, in the frame of the parent
};

struct Body {
  std::string name;
  int parent = -1;  ///< index of the body it stands on, -1: the robot's mounting frame {M}
  std::vector<int> parameters;  ///< indices into RobotModel::parameters, in declaration order
  FrameFormula frame;           ///< X_PB, P the parent
  std::vector<geometry::Shape> shapes;
  double buffer = 0;  ///< m: so far it keeps from all that is not of its robot and not its load
  std::optional<Rope> rope = {};  ///< instead of shapes; the frame is that of the parent
};

/// One point of a load chart: at most `mass` kg at `radius` m.
struct CapacityPoint {
  double radius = 0;
  double mass = 0;
};

/// What the checked robot file says, without its behaviour: bodies, parameters, rules, frames.
/// Frames: {W} world, {M} the robot's mounting frame (placed by the plan, identity by default), {B}
/// each body, {T} the tool.
struct RobotModel {
  std::string name;
  double time_step = 1;               ///< s
  double sensor = 0;                  ///< range of free() in m
  std::vector<Parameter> parameters;  ///< declaration order, bodies from first to last
  std::vector<Body> bodies;           ///< parents come before children
  int tool_body = 0;
  FrameFormula tool_frame;  ///< X_BT, of the tool body
  std::vector<std::pair<int, int>>
      touching;  ///< pairs of bodies that touch by design, besides parent and child
  std::vector<CapacityPoint> capacity;
  LineDeviation deviation;  ///< of `line`

  int find_body(const std::string& name) const;
  std::vector<double> start_values() const;
  /// Smallest translation step of the robot, 1 m if it has none.
  double smallest_translation_step() const;
};

}  // namespace rubicon::robot
