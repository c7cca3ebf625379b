#pragma once

#include <string>
#include <vector>

#include "interpreter/machine.hpp"
#include "interpreter/plan_model.hpp"
#include "interpreter/world.hpp"

namespace rubicon::taskplan {

using interpreter::Ticks;

enum class TaskResult { done, rejected, not_reached };
/// As tables and traces write it: done, rejected, "not reached".
const char* name_of(TaskResult result);

/// What a motion of a task is for.
enum class MotionPurpose { grip, carry, place, go };

/// One motion of a task and how it ended. One whose goal held already has no tries.
struct MotionOutcome {
  MotionPurpose purpose = MotionPurpose::go;
  Ticks start = 0;
  interpreter::MotionEnd end;
};

/// One task as it went. A rejected task leaves no mark: in a plan with one robot it takes no time.
struct TaskOutcome {
  std::string task;
  std::string robot;               ///< "" for crew work
  std::vector<std::string> crews;  ///< of `by`, then those that hook, adjust, release, in this order
  Ticks start = 0;
  Ticks duration = 0;
  Ticks motion_time = 0;  ///< of the duration, what motions took
  Ticks work_time = 0;    ///< of the duration, what crews took
  int tried = 0;          ///< attempts of all its motions, accepted or not
  int accepted = 0;
  TaskResult result = TaskResult::done;
  std::string reason;  ///< why not done; of a short plan also how it is short of its goal
  std::vector<MotionOutcome> motions;
};

/// The names of all crews that work on a task, each once: those of `by`, then of its works.
std::vector<std::string> crew_names(const interpreter::PlanModel& plan,
                                    const interpreter::TaskSpec& task);

/// A plan as it went, in the order of work.
struct Schedule {
  std::vector<TaskOutcome> tasks;
  Ticks process_time = 0;
  bool feasible = true;  ///< every task is done
};

}  // namespace rubicon::taskplan
