#pragma once

#include <vector>

#include "src/results/verify/input/record.hpp"

namespace rubicon::verify {

/// One task as the trace tells it.
struct TaskRun {
  int run = -1;    ///< index into Trace::runs: its name
  int task = -1;   ///< index into Scene::tasks; -1: the plan has none of this name (`park`)
  int robot = -1;  ///< -1: crew work
  TaskResult result = TaskResult::not_reached;
  bool ended = false;
  bool started = false;
  Ticks start = 0;
  Ticks end = 0;
  int start_line = 0;
  int end_line = 0;
  /// What its records tell happened: it is done. A refused task is undone, but for the one motion
  /// of a short plan.
  bool happened = false;
  std::vector<int> records;  ///< indices into Trace::records, in order, with start and end
};

/// Where a run that parks its robot takes it: what the run says of a vehicle that gives way, else
/// the park of the robot.
std::vector<std::pair<int, double>> park_of(const Trace& trace, const TaskRun& run);

/// Sorts the records by task, and reports tasks that begin or end twice or not at all, records
/// outside of their task, tasks that were not reached and yet ran, and refusals without a reason.
std::vector<TaskRun> task_runs(const Trace& trace, Faults& faults);

}  // namespace rubicon::verify
