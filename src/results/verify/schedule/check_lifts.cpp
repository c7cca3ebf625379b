#include "src/results/verify/schedule/check_lifts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/schedule/task_clock.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// Adds up a lift, record by record.
class LiftReader {
 public:
  explicit LiftReader(const Trace& trace) : trace_(trace) {}

  std::optional<Lift> read(const TaskRun& run) {
    const std::optional<SceneWork>& hook = trace_.scene.tasks[at(run.task)].hook;
    hooks_ = hook && hook->time > 0;
    now_ = run.start;
    for (const int index : run.records) {
      record_ = &trace_.records[at(index)];
      std::visit([&](const auto& what) { follow(what); }, record_->what);
      if (done_) return lift_;
      now_ = record_->time;
    }
    return std::nullopt;
  }

 private:
  template <typename Other>
  void follow(const Other&) {}
  void follow(const Try& attempt) {
    if (attempt.ok) lift_.own += record_->time - now_;
  }
  void follow(const Work& work) {
    // Where somebody moved the component meanwhile it is hooked a second time.
    if (work.what == "hook") begin(work.from);
    lift_.own += work.time;
  }
  void follow(const LoadChange& change) {
    if (change.kind == LoadChange::Kind::attach) {
      if (!hooks_) begin(record_->time);
    } else if (change.kind == LoadChange::Kind::detach) {
      lift_.to = record_->time;
      lift_.overtime = change.overtime;
      lift_.line = record_->line;
      done_ = true;
    }
  }
  void begin(Ticks from) {
    lift_.from = from;
    lift_.own = 0;
  }

  const Trace& trace_;
  const Record* record_ = nullptr;
  Lift lift_;
  Ticks now_ = 0;
  bool hooks_ = false;  ///< the lift begins with hook work
  bool done_ = false;
};

class LiftCheck {
 public:
  LiftCheck(const Trace& trace, const TaskRun& run, const WorkingHours& hours, Faults& faults)
      : trace_(trace),
        run_(run),
        hours_(hours),
        faults_(faults),
        calendars_(calendars_of_lift(trace.scene, trace.scene.tasks[at(run.task)])) {}

  void check(const Lift& lift) {
    const Ticks outside = lift.to - lift.from - hours_.between(calendars_, lift.from, lift.to);
    if (std::llabs(outside - lift.overtime) > kTimeSlack) {
      fault(lift.line, lift.to,
            lift.overtime == 0
                ? fmt::format("the load hangs on its hook for {} out of the working time of what "
                              "its lift needs",
                              clock_text(outside))
                : fmt::format("the overtime of the lift is {}, and {} of it is out of working time",
                              clock_text(lift.overtime), clock_text(outside)));
    } else if (lift.overtime > 0) {
      check_overtime(lift);
    }
    for (const int index : run_.records) {
      const Record& record = trace_.records[at(index)];
      const auto* pause = std::get_if<Pause>(&record.what);
      if (pause != nullptr && pause->why == "lift" && !begins_shift(record.time)) {
        fault(record.line, record.time, "a lift waits for a shift, and none begins then");
      }
    }
  }

 private:
  /// Only what began with its shift, would have fitted into it and was held up may last longer.
  void check_overtime(const Lift& lift) {
    if (!begins_shift(lift.from)) {
      fault(lift.line, lift.to, "a lift ends in overtime that did not begin with its shift");
    } else if (hours_.between(calendars_, lift.from, lift.from + lift.own) <
               lift.own - kTimeSlack) {
      fault(lift.line, lift.to,
            fmt::format("a lift of {} ends in overtime and is longer than its shift",
                        clock_text(lift.own)));
    }
  }

  /// Whether all begin to work at that moment.
  bool begins_shift(Ticks time) const {
    return hours_.between(calendars_, time, time + 2 * kTimeSlack) > 0 &&
           hours_.between(calendars_, time - 3 * kTimeSlack, time - kTimeSlack) == 0;
  }

  void fault(int line, Ticks time, std::string text) {
    faults_.push_back({FaultKind::shift, ResultFile::trace, line, trace_.runs[at(run_.run)], time,
                       std::move(text)});
  }

  const Trace& trace_;
  const TaskRun& run_;
  const WorkingHours& hours_;
  Faults& faults_;
  std::vector<int> calendars_;
};

}  // namespace

std::optional<Lift> find_lift(const Trace& trace, const TaskRun& run) {
  if (!run.happened || run.task < 0 || !trace.scene.tasks[at(run.task)].whole) return std::nullopt;
  return LiftReader(trace).read(run);
}

std::vector<int> calendars_of_lift(const Scene& scene, const SceneTask& task) {
  std::vector<int> calendars;
  const auto add = [&](int calendar) {
    if (calendar >= 0 &&
        std::find(calendars.begin(), calendars.end(), calendar) == calendars.end()) {
      calendars.push_back(calendar);
    }
  };
  if (task.robot >= 0) add(scene.robots[at(task.robot)].calendar);
  for (const int crew : task.crews) add(scene.crews[at(crew)].calendar);
  for (const auto& work : {task.hook, task.adjust, task.release}) {
    if (work && work->crew >= 0) add(scene.crews[at(work->crew)].calendar);
  }
  return calendars;
}

void check_lifts(const Trace& trace, const TaskRun& run, const WorkingHours& hours,
                 Faults& faults) {
  if (const std::optional<Lift> lift = find_lift(trace, run)) {
    LiftCheck(trace, run, hours, faults).check(*lift);
  }
}

}  // namespace rubicon::verify
