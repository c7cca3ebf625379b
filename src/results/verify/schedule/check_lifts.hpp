#pragma once

#include <optional>
#include <vector>

#include "src/results/verify/replay/task_run.hpp"
#include "src/results/verify/schedule/working_hours.hpp"

namespace rubicon::verify {

/// A lift that is held whole, as the trace tells it.
struct Lift {
  Ticks from = 0;      ///< its hook work began, or it was picked up
  Ticks to = 0;        ///< it was put down
  Ticks own = 0;       ///< of that steps and crew work
  Ticks overtime = 0;  ///< as the trace tells it
  int line = 0;        ///< where it is put down
};

/// The lift of a task that happened and is to be held whole; nothing for any other.
std::optional<Lift> find_lift(const Trace& trace, const TaskRun& run);

/// The calendars of all that the lift of a task needs: of its robot, the crews of `by`, and those
/// of hook, adjust and release.
std::vector<int> calendars_of_lift(const Scene& scene, const SceneTask& task);

/// Whether nothing hangs on the hook out of working time but for overtime that is told, and that
/// only for a lift that began with its shift and was held up by others. Whether a lift that waited
/// for a shift begins with one.
void check_lifts(const Trace& trace, const TaskRun& run, const WorkingHours& hours, Faults& faults);

}  // namespace rubicon::verify
