#pragma once

#include <vector>

namespace rubicon::taskplan {

/// Something that a task waits for.
struct Awaited {
  enum class Kind {
    way,       ///< a machine or people in the way of its motion; `number`: its blocker
    zone,      ///< a machine in its own zone; `number`: the robot
    resource,  ///< a robot or crew that another task holds; `number`: the resource
    start,     ///< its links do not let it start; `number`: the link
    finish     ///< its links hold its finish; `number`: the link
  };
  Kind kind = Kind::way;
  int number = -1;
  /// The tasks any of which may bring it about; empty: nobody will.
  std::vector<int> by;
  bool idle = false;  ///< a robot that nobody has: `by` are those who would move it some day
};

/// All that a task waits for; nothing, if it goes on by itself.
struct Waits {
  std::vector<Awaited> awaited;
  bool for_any = false;  ///< it goes on as soon as one of them comes; else it needs all
};

}  // namespace rubicon::taskplan
