#include "src/results/verify/replay/task_run.hpp"

#include <set>
#include <string_view>
#include <utility>

#include "src/motion/math/index.hpp"

namespace rubicon::verify {

namespace {

using math::at;

class RunSorter {
 public:
  RunSorter(const Trace& trace, Faults& faults)
      : trace_(trace), faults_(faults), latest_(trace.runs.size(), -1) {}

  std::vector<TaskRun> sort() {
    for (std::size_t i = 0; i < trace_.records.size(); ++i) add(static_cast<int>(i));
    for (const TaskRun& run : runs_) {
      if (!run.ended) fault(run, run.start_line, run.start, "the task never ends");
    }
    std::set<std::string_view> there(trace_.runs.begin(), trace_.runs.end());
    for (const SceneTask& task : trace_.scene.tasks) {
      if (there.contains(task.name)) continue;
      faults_.push_back({FaultKind::order, ResultFile::trace, trace_.lines, task.name, -1,
                         "the task is not in the trace"});
    }
    return std::move(runs_);
  }

 private:
  /// The run that a record belongs to. A machine may be asked out of the way several times, each
  /// time in a task of the same name.
  TaskRun& run_of(const Record& record) {
    int& latest = latest_[at(record.run)];
    const auto known = trace_.scene.task_index.find(trace_.runs[at(record.run)]);
    const int task = known == trace_.scene.task_index.end() ? -1 : known->second;
    const bool again = task < 0 && latest >= 0 && runs_[at(latest)].ended &&
                       std::holds_alternative<TaskStart>(record.what);
    if (latest < 0 || again) {
      latest = static_cast<int>(runs_.size());
      TaskRun& run = runs_.emplace_back();
      run.run = record.run;
      run.task = task;
      run.robot = record.robot;
    }
    return runs_[at(latest)];
  }

  void fault(const TaskRun& run, int line, Ticks time, std::string text) {
    faults_.push_back({FaultKind::order, ResultFile::trace, line, trace_.runs[at(run.run)], time,
                       std::move(text)});
  }

  void add(int index) {
    const Record& record = trace_.records[at(index)];
    TaskRun& run = run_of(record);
    const auto wrong = [&](std::string text) {
      fault(run, record.line, record.time, std::move(text));
    };
    if (run.ended) wrong("a record after the end of the task");
    if (std::holds_alternative<TaskStart>(record.what)) {
      if (run.started) wrong("the task starts twice");
      begin(run, record);
    } else if (const auto* end = std::get_if<TaskEnd>(&record.what)) {
      finish(run, record, *end);
    } else if (!run.started) {
      wrong("a record before the start of the task");
    }
    if (record.robot != run.robot) wrong("another robot than in the record before it");
    run.records.push_back(index);
  }

  void begin(TaskRun& run, const Record& record) {
    run.started = true;
    run.start = record.time;
    run.start_line = record.line;
    if (record.time < 0) fault(run, record.line, record.time, "the task starts before the plan");
    if (run.task < 0) {
      // A machine that is asked out of the way makes a task of its own.
      if (!trace_.runs[at(run.run)].starts_with("park ")) {
        fault(run, record.line, record.time, "the plan has no such task");
      }
    } else if (trace_.scene.tasks[at(run.task)].robot != record.robot) {
      fault(run, record.line, record.time, "the robot is not the one of the plan");
    }
  }

  void finish(TaskRun& run, const Record& record, const TaskEnd& end) {
    run.ended = true;
    run.end = record.time;
    run.end_line = record.line;
    run.result = end.result;
    run.happened = run.started && (end.result == TaskResult::done || trace_.scene.short_form);
    if (end.result == TaskResult::ended_short && !trace_.scene.short_form) {
      fault(run, record.line, record.time, "only the motion of a short plan ends short");
    }
    if (end.result == TaskResult::not_reached) {
      if (run.started) fault(run, record.line, record.time, "it ran and is told as not reached");
    } else if (end.result == TaskResult::done && !run.started) {
      fault(run, record.line, record.time, "the task ends and never starts");
    }
    if (end.result != TaskResult::done && end.reason.empty()) {
      fault(run, record.line, record.time, "no reason is given why it was not done");
    }
  }

  const Trace& trace_;
  Faults& faults_;
  std::vector<TaskRun> runs_;
  std::vector<int> latest_;  ///< by name: the last run of it
};

}  // namespace

std::vector<std::pair<int, double>> park_of(const Trace& trace, const TaskRun& run) {
  std::vector<std::pair<int, double>> park = trace.scene.robots[at(run.robot)].park;
  for (const int index : run.records) {
    const auto* start = std::get_if<TaskStart>(&trace.records[at(index)].what);
    if (start == nullptr) continue;
    for (std::size_t i = 0; i < park.size() && i < start->to.size(); ++i) {
      park[i].second = start->to[i];
    }
    break;
  }
  return park;
}

std::vector<TaskRun> task_runs(const Trace& trace, Faults& faults) {
  return RunSorter(trace, faults).sort();
}

}  // namespace rubicon::verify
