#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rubicon::taskplan {

/// Something that a task waits for and that only other tasks can bring about.
struct WaitTarget {
  enum class Kind {
    activity,  ///< what its activity waits for; `number` means something to that
               ///< only
    zone,      ///< a machine in its own zone; `number`: the robot
    resource,  ///< a robot or crew that another task holds; `number`: the
               ///< resource
    kept,      ///< a robot or crew that is kept for another task; `number`: the
               ///< resource
    start,     ///< its links do not let it start; `number`: the link
    finish     ///< its links hold its finish; `number`: the link
  };
  Kind kind = Kind::activity;
  int number = -1;
  std::vector<int> by;          ///< the tasks any of which may bring it about; empty: nobody will
  bool idle = false;            ///< a robot that nobody has: `by` are those who would move
                                ///< it some day
  bool machine = false;         ///< a machine that a task has, in the way
  std::vector<int> gives = {};  ///< to each of `by` the people of a crew that it gives back; empty:
                                ///< any of `by` is enough
  int missing = 0;              ///< so many people of those are needed
  int choice = -1;  ///< the way of going on that needs it, where there are several; -1: it is
                    ///< one by itself
};

/// All that a task waits for; nothing, if it goes on by itself.
struct WaitSet {
  std::vector<WaitTarget> targets;
  /// It goes on as soon as one of them comes, or all of one `choice`, which stand together; else
  /// it needs all.
  bool any = false;
};

/// What a task waits for; nothing for one that is over.
using WaitsOf = std::function<std::optional<WaitSet>(int task)>;

/// Tasks that can never go on, and what they wait for.
using Deadlocked = std::map<int, WaitSet>;

/// A task of a cycle of waiting, and what it waits for: the next of the cycle.
struct WaitLink {
  int task = -1;
  WaitTarget target;
};
using WaitCycle = std::vector<WaitLink>;

/// So many tasks are looked at for a deadlock; what waits for more is left until nothing else
/// happens. Reason: in a plan of 100,000 tasks each that begins to wait may hang on all the others.
inline constexpr std::size_t kMostLookedAt = 10'000;

/// Of the tasks that `roots` wait for, directly or not, and of themselves: those that wait for each
/// other so that nobody outside could help. From any of them a cycle is reached.
Deadlocked deadlocked_from(std::vector<int> roots, const WaitsOf& waits_of);

/// One cycle of tasks each of which waits for the next, the last for the first; it begins with the
/// least number. `deadlocked` must not be empty.
WaitCycle cycle_in(const Deadlocked& deadlocked);

/// Where following the waits of `task`, each time the first that somebody may bring about, leads.
struct WaitWalk {
  std::vector<int> tasks;  ///< all on the way; where there is no cycle the last
                           ///< waits for nobody
  WaitCycle cycle;         ///< may be empty
};
WaitWalk walk_from(int task, const WaitsOf& waits_of);

/// "machines wait for each other: a, b" or "tasks wait for each other: a; b": `text_of` each link.
std::string text_of(const WaitCycle& cycle,
                    const std::function<std::string(const WaitLink&)>& text_of_link);

/// The tasks of a cycle without one of which the task before it could go on; all if there are none:
/// a robot that nobody has stays where it is without those who would have moved it.
std::vector<int> helpful_in(const WaitCycle& cycle);
std::vector<int> tasks_of(const WaitCycle& cycle);

}  // namespace rubicon::taskplan
