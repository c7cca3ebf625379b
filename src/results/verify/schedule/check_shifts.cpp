#include "src/results/verify/schedule/check_shifts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/schedule/check_lifts.hpp"
#include "src/results/verify/schedule/task_clock.hpp"

namespace rubicon::verify {

namespace {

using math::at;

class ShiftCheck {
 public:
  ShiftCheck(const Trace& trace, const TaskRun& run, const WorkingHours& hours, Faults& faults)
      : trace_(trace), run_(run), hours_(hours), faults_(faults) {
    if (run.robot >= 0) add(trace.scene.robots[at(run.robot)].calendar, held_);
    if (run.task < 0) return;
    const SceneTask& task = trace.scene.tasks[at(run.task)];
    for (const int crew : task.crews) add(trace.scene.crews[at(crew)].calendar, held_);
    for (const int robot : task.also_robots) add(trace.scene.robots[at(robot)].calendar, held_);
    if (run.robot >= 0) return;
    for (const SceneWork& work : task.takes) {
      if (work.crew >= 0) add(trace.scene.crews[at(work.crew)].calendar, held_);
    }
  }

  void check() {
    if (run_.task >= 0) lift_ = find_lift(trace_, run_);
    for (const int index : run_.records) {
      record_ = &trace_.records[at(index)];
      std::visit([&](const auto& what) { follow(what); }, record_->what);
      now_ = record_->time;
    }
  }

 private:
  static void add(int calendar, std::vector<int>& list) {
    if (calendar >= 0 && std::find(list.begin(), list.end(), calendar) == list.end()) {
      list.push_back(calendar);
    }
  }

  bool carries_over() const {
    return std::any_of(held_.begin(), held_.end(), [&](int calendar) {
      return trace_.scene.calendars[at(calendar)].carry_over;
    });
  }

  void fault(Ticks time, std::string text) {
    faults_.push_back({FaultKind::shift, ResultFile::trace, record_->line,
                       trace_.runs[at(run_.run)], time, std::move(text)});
  }

  /// Anything but an attempt: the next attempt begins a motion, unless a motion that waited for
  /// another machine is tried again after its end.
  template <typename Other>
  void follow(const Other&) {
    begun_ = false;
  }
  void follow(const Goal&) {}
  void follow(const GuidePlan&) {}
  void follow(const Forbidden&) {}
  void follow(const WayPoint&) {}
  void follow(const Pause&) {}
  void follow(const MotionEnd&) {}
  void follow(const Stop&) {}  // part of the step before it
  void follow(const Try&) { attempt(); }
  void follow(const Wait&) { attempt(); }
  void follow(const Think&) { attempt(); }

  /// Whether at that moment a lift is under way that ends in overtime.
  bool hangs(Ticks time) const {
    return lift_ && lift_->overtime > 0 && lift_->from - kTimeSlack <= time &&
           time <= lift_->to + kTimeSlack;
  }

  void attempt() {
    if (begun_ && !(carries_over() && record_->time > now_)) return;
    if (!hangs(now_) && !hours_.at(held_, now_)) {
      fault(now_, begun_ ? "a step begins out of shift" : "a motion begins out of shift");
    }
    begun_ = true;
  }

  void follow(const Work& work) {
    begun_ = false;
    // Such a lift is judged by check_lifts.
    if (hangs(work.from)) return;
    std::vector<int> calendars = held_;
    if (work.crew >= 0) add(trace_.scene.crews[at(work.crew)].calendar, calendars);
    const Ticks worked = hours_.between(calendars, work.from, record_->time);
    if (std::llabs(worked - work.time) > kTimeSlack) {
      fault(work.from, fmt::format("the work takes {} and there are {} of shifts for it",
                                   clock_text(work.time), clock_text(worked)));
    } else if (work.time > 0 && !hours_.at(calendars, record_->time)) {
      fault(record_->time, "the work ends out of shift");
    }
  }

  const Trace& trace_;
  const TaskRun& run_;
  const WorkingHours& hours_;
  Faults& faults_;
  std::vector<int> held_;  ///< calendars of all that the task holds
  const Record* record_ = nullptr;
  std::optional<Lift> lift_;
  Ticks now_ = 0;
  bool begun_ = false;
};

}  // namespace

void check_shifts(const Trace& trace, const TaskRun& run, const WorkingHours& hours,
                  Faults& faults) {
  if (run.happened) ShiftCheck(trace, run, hours, faults).check();
}

}  // namespace rubicon::verify
