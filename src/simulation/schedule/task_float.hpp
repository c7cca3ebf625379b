#pragma once

#include <vector>

#include "src/simulation/schedule/link.hpp"
#include "src/simulation/schedule/ticks.hpp"
#include "src/simulation/schedule/work_calendar.hpp"

namespace rubicon::schedule {

/// Part of a task: so much working time by a calendar of its own.
struct TaskPart {
  Ticks work = 0;
  const WorkCalendar* calendar = nullptr;
  bool whole = false;  ///< a lift: it stays in one shift
};

/// A task as it went.
struct TimedTask {
  Ticks start = 0;
  Ticks finish = 0;
  const WorkCalendar* calendar = nullptr;  ///< hours that all it holds have in common
  bool milestone = false;                  ///< it needs no shift
  std::vector<TaskPart> parts = {};        ///< one after the other; none: it is one, by `calendar`
};

/// An event of one task keeps another from coming sooner than `gap` after it: a link with its lag,
/// or a crew or machine that the one gives back and the other takes. Where the machine is repaired
/// between them, the gap begins with so much working time.
struct Precedence {
  int before = -1;
  TaskEnd from = TaskEnd::finish;
  int after = -1;
  TaskEnd to = TaskEnd::start;
  Ticks gap = 0;
  Ticks repair = 0;
  const WorkCalendar* hours = nullptr;  ///< in which it is repaired; null: it is not
};

/// How much later a task could have been. Total float: without the whole becoming later; free
/// float: without any other task becoming later. Both in working time of the task, of a milestone
/// in elapsed time. Critical path method, backward pass: Kelley and Walker, "Critical-path planning
/// and scheduling", 1959; here each task counts by its own calendar.
struct TaskFloat {
  Ticks latest_start = 0;
  Ticks latest_finish = 0;
  Ticks total = 0;
  Ticks free = 0;
};

/// The floats of tasks that went as `tasks` say, of a whole that ends at `end`: who comes after
/// whom stays as it was, and each takes as long as it took. Where a latest start falls just on the
/// end of a shift it is a second sooner. Precedences may lead in rings.
std::vector<TaskFloat> floats_of(const std::vector<TimedTask>& tasks,
                                 const std::vector<Precedence>& precedences, Ticks end);

}  // namespace rubicon::schedule
