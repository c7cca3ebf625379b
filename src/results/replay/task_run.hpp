#pragma once

#include <string>
#include <variant>
#include <vector>

#include "interpreter/program/world.hpp"
#include "src/motion/math/pose.hpp"

namespace rubicon::replay {

using interpreter::Ticks;

/// An accepted attempt.
struct Step {
  std::vector<int> moved;  ///< parameters of the command
  std::vector<double> q;   ///< every parameter after it, m or degrees
};

/// A component is picked up, set down or removed.
struct LoadChange {
  enum class Kind { attach, detach, remove };
  Kind kind = Kind::attach;
  int component = -1;
  math::Pose X = math::Pose::Identity();  ///< attach: X_TO; detach: X_WO
};

/// People turned what hangs on the tool about the vertical through its origin, since `from`.
struct LoadTurn {
  double angle_deg = 0;
  math::Pose X_TO = math::Pose::Identity();  ///< how it hangs after it
  Ticks from = 0;
};

/// What a record says of where things are.
struct Event {
  Ticks time = 0;  ///< when it is over
  int line = 0;    ///< of the trace
  /// Nothing: time passes and all stand still.
  std::variant<std::monostate, Step, LoadChange, LoadTurn> what;
  bool refused = false;  ///< an attempt that met something, or a limit
};

/// A robot stood still for another machine.
struct MachineWait {
  std::string whom;
  Ticks from = 0;
  Ticks to = 0;
};

/// One task as the trace tells it, with the events of its records.
struct TaskRun {
  int task = -1;   ///< index into the header's tasks; -1: it has none of this name (`park`)
  int robot = -1;  ///< -1: crew work
  bool started = false;
  bool ended = false;
  /// What it did stays: it is done. A refused task is undone, but for the one motion of a short
  /// plan.
  bool happened = false;
  Ticks start = 0;
  Ticks end = 0;
  std::vector<Event> events;
  std::vector<MachineWait> waits;
};

}  // namespace rubicon::replay
