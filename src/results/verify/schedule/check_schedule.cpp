#include "src/results/verify/schedule/check_schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/schedule/check_accounts.hpp"
#include "src/results/verify/schedule/task_clock.hpp"

namespace rubicon::verify {

namespace {

using math::at;

const char* name_of(TaskResult result) {
  switch (result) {
    case TaskResult::done:
      return "done";
    case TaskResult::ended_short:
      return "short";
    case TaskResult::rejected:
      return "rejected";
    case TaskResult::not_reached:
      return "not reached";
  }
  return "";
}

class RowCheck {
 public:
  RowCheck(const Trace& trace, const std::vector<TaskRun>& runs,
           const std::vector<TaskAccount>& accounts, const Costs& costs, const WaitCheck& waits,
           ResultFile file, Faults& faults)
      : trace_(trace),
        runs_(runs),
        accounts_(accounts),
        costs_(costs),
        waits_(waits),
        file_(file),
        faults_(faults) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      runs_of_[trace.runs[at(runs[i].run)]].push_back(static_cast<int>(i));
    }
  }

  void check(const std::vector<ScheduleRow>& rows) {
    for (const ScheduleRow& row : rows) {
      const int run = take_run(row);
      if (run < 0) {
        fault(row, "the trace has no such task");
      } else {
        compare(row, runs_[at(run)]);
        check_split(runs_[at(run)], accounts_[at(run)], row, file_, faults_);
        check_cost(row, costs_.of_run[at(run)]);
        waits_.check_start(run, accounts_[at(run)], row, file_, faults_);
      }
    }
    for (const auto& [name, left] : runs_of_) {
      for (std::size_t i = 0; i < left.size(); ++i) {
        faults_.push_back({FaultKind::schedule, file_, 0, name, -1,
                           "the task of the trace is not in the schedule"});
      }
    }
  }

 private:
  void fault(const ScheduleRow& row, std::string text) {
    faults_.push_back({FaultKind::schedule, file_, row.line, row.task, row.start, std::move(text)});
  }

  void check_cost(const ScheduleRow& row, long double exact) {
    if (!row.cost || is_rounded(*row.cost, exact)) return;
    fault(row, fmt::format("the cost is {}, by the trace {:.4f}", *row.cost,
                           static_cast<double>(exact)));
  }

  /// The run that the row is about. A machine may be asked out of the way several times, and each
  /// has a row: of these the one that starts nearest to the row is taken.
  int take_run(const ScheduleRow& row) {
    const auto found = runs_of_.find(row.task);
    if (found == runs_of_.end() || found->second.empty()) return -1;
    std::vector<int>& left = found->second;
    const auto off = [&](int run) {
      return std::pair(runs_[at(run)].started && runs_[at(run)].result == TaskResult::done ? 0 : 1,
                       std::llabs(runs_[at(run)].start - row.start));
    };
    const bool done = row.result == "done";
    const auto nearest = std::min_element(left.begin(), left.end(), [&](int a, int b) {
      return done ? off(a) < off(b) : off(a).second < off(b).second;
    });
    const int run = *nearest;
    left.erase(nearest);
    return run;
  }

  template <typename T>
  void expect(const ScheduleRow& row, const char* what, const T& found, const T& expected) {
    if (found == expected) return;
    fault(row, fmt::format("{} is '{}', in the trace '{}'", what, found, expected));
  }

  void expect_time(const ScheduleRow& row, const char* what, Ticks found, Ticks expected) {
    if (std::llabs(found - expected) <= kTimeSlack) return;
    fault(row,
          fmt::format("{} is {}, in the trace {}", what, clock_text(found), clock_text(expected)));
  }

  void compare(const ScheduleRow& row, const TaskRun& run) {
    expect<std::string>(row, "the result", row.result, name_of(run.result));
    expect<std::string>(row, "the robot", row.robot,
                        run.robot < 0 ? "" : trace_.scene.robots[at(run.robot)].name);
    if (run.task >= 0) expect(row, "the crew", row.crew, crews_of(run));
    expect_time(row, "the start", row.start, run.started ? run.start : run.end);
    const Ticks duration = run.happened ? run.end - run.start : 0;
    expect_time(row, "the duration", row.duration, duration);
    if (const auto* end = std::get_if<TaskEnd>(&trace_.records[at(run.records.back())].what)) {
      expect(row, "the reason", row.reason, end->reason);
    }
    // A run that began anew without a task has lost what that task tried.
    if (run.result == TaskResult::rejected && !run.started) return;
    int tried = 0;
    int accepted = 0;
    count(run, tried, accepted);
    expect(row, "the number of attempts", row.tried, tried);
    expect(row, "the number of accepted ones", row.accepted, accepted);
  }

  void count(const TaskRun& run, int& tried, int& accepted) const {
    for (const int index : run.records) {
      const auto& what = trace_.records[at(index)].what;
      const auto* attempt = std::get_if<Try>(&what);
      const bool waited = std::holds_alternative<Wait>(what);
      if (attempt != nullptr || waited) ++tried;
      if (waited || (attempt != nullptr && attempt->ok)) ++accepted;
    }
  }

  /// The crews of `by`, then of the works, each once.
  std::string crews_of(const TaskRun& run) const {
    const SceneTask& task = trace_.scene.tasks[at(run.task)];
    std::vector<int> crews;
    const auto add = [&](int crew) {
      if (crew >= 0 && std::find(crews.begin(), crews.end(), crew) == crews.end()) {
        crews.push_back(crew);
      }
    };
    for (const int crew : task.crews) add(crew);
    for (const auto& work : {task.hook, task.adjust, task.release}) {
      if (work) add(work->crew);
    }
    for (const SceneWork& work : task.takes) add(work.crew);
    std::string text;
    for (const int crew : crews) {
      if (!text.empty()) text += ", ";
      text += trace_.scene.crews[at(crew)].name;
    }
    return text;
  }

  const Trace& trace_;
  const std::vector<TaskRun>& runs_;
  const std::vector<TaskAccount>& accounts_;
  const Costs& costs_;
  const WaitCheck& waits_;
  const ResultFile file_;
  Faults& faults_;
  std::map<std::string, std::vector<int>> runs_of_;
};

}  // namespace

void check_rows(const Trace& trace, const std::vector<TaskRun>& runs,
                const std::vector<TaskAccount>& accounts, const Costs& costs,
                const WaitCheck& waits, const std::vector<ScheduleRow>& rows, ResultFile file,
                Faults& faults) {
  RowCheck(trace, runs, accounts, costs, waits, file, faults).check(rows);
}

void check_process_time(const std::vector<TaskRun>& runs, Ticks process_time, Faults& faults) {
  Ticks last = 0;
  for (const TaskRun& run : runs) {
    if (run.happened && run.task >= 0) last = std::max(last, run.end);
  }
  if (std::llabs(last - process_time) <= kTimeSlack) return;
  faults.push_back({FaultKind::schedule, ResultFile::schedule_json, 0, "", process_time,
                    fmt::format("the process time is {}, the last task of the trace ends at {}",
                                clock_text(process_time), clock_text(last))});
}

}  // namespace rubicon::verify
