#include "src/results/verify/schedule/task_clock.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <utility>

#include "src/motion/math/index.hpp"

namespace rubicon::verify {

namespace {

using math::at;

std::string seconds_text(Ticks time) {
  return fmt::format("{:g} s", static_cast<double>(time) / static_cast<double>(kSecond));
}

/// Follows one task along the clock.
class ClockCheck {
 public:
  ClockCheck(const Trace& trace, const TaskRun& run, Faults& faults)
      : trace_(trace), run_(run), faults_(faults) {}

  void check() {
    for (const int index : run_.records) {
      record_ = &trace_.records[at(index)];
      std::visit([&](const auto& what) { follow(what); }, record_->what);
    }
  }

 private:
  void fault(std::string text) {
    faults_.push_back({FaultKind::clock, ResultFile::trace, record_->line,
                       trace_.runs[at(run_.run)], now_, std::move(text)});
  }

  /// What begins now begins where the record before it ended.
  void begins_at(Ticks from) {
    if (std::llabs(from - now_) <= kTimeSlack) return;
    fault(from > now_ ? fmt::format("{} are not accounted for", seconds_text(from - now_))
                      : fmt::format("it begins {} before what comes before it is over",
                                    seconds_text(now_ - from)));
  }

  void lasts_until(Ticks time) {
    if (time < now_ - kTimeSlack) fault("the clock runs backwards");
    now_ = time;
  }

  void takes_no_time() {
    begins_at(record_->time);
    now_ = record_->time;
  }

  void number(int n) {
    if (n != ++numbered_) fault(fmt::format("attempt {} follows attempt {}", n, numbered_ - 1));
    numbered_ = n;
    ++tries_;
  }

  void follow(const TaskStart&) { now_ = record_->time; }

  void follow(const Goal&) {}
  void follow(const WayPoint&) {}
  void follow(const GuidePlan&) { takes_no_time(); }

  void follow(const Try& attempt) {
    number(attempt.n);
    if (attempt.ok) {
      ++accepted_;
      lasts_until(record_->time);
    } else {
      takes_no_time();
    }
  }

  void follow(const Wait& wait) {
    number(wait.n);
    ++accepted_;
    const Ticks before = now_;
    lasts_until(record_->time);
    if (run_.robot < 0) return;
    const double step = trace_.scene.robots[at(run_.robot)].time_step;
    const auto expected = static_cast<Ticks>(std::llround(step * static_cast<double>(kSecond)));
    if (std::llabs(now_ - before - expected) > kTimeSlack) {
      fault(fmt::format("a wait of {} instead of {}", seconds_text(now_ - before),
                        seconds_text(expected)));
    }
  }

  void follow(const Stop&) { lasts_until(record_->time); }
  void follow(const Think&) { lasts_until(record_->time); }

  void follow(const Work& work) {
    begins_at(work.from);
    lasts_until(record_->time);
  }

  void follow(const Pause& pause) {
    begins_at(pause.from);
    lasts_until(record_->time);
  }

  void follow(const LoadChange&) { takes_no_time(); }
  void follow(const LoadTurn&) { takes_no_time(); }
  void follow(const ColdJoint&) { takes_no_time(); }
  void follow(const SoilTaken&) { takes_no_time(); }
  void follow(const Forbidden&) { takes_no_time(); }
  void follow(const Foreseen&) { takes_no_time(); }

  void follow(const MotionEnd& end) {
    takes_no_time();
    if (end.tries != tries_ || end.accepted != accepted_ ||
        end.refused != end.tries - end.accepted) {
      fault(
          fmt::format("the motion counts {} attempts, {} accepted, {} refused; there are {}, {} "
                      "and {}",
                      end.tries, end.accepted, end.refused, tries_, accepted_, tries_ - accepted_));
    }
    tries_ = 0;
    accepted_ = 0;
  }

  void follow(const TaskEnd&) { takes_no_time(); }

  const Trace& trace_;
  const TaskRun& run_;
  Faults& faults_;
  const Record* record_ = nullptr;
  Ticks now_ = 0;
  int numbered_ = 0;
  int tries_ = 0;
  int accepted_ = 0;
};

}  // namespace

std::string clock_text(Ticks time) {
  const Ticks milliseconds = (time + kSecond / 2000) / (kSecond / 1000);
  const Ticks seconds = milliseconds / 1000;
  std::string text = fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
  if (milliseconds % 1000 != 0) text += fmt::format(".{:03}", milliseconds % 1000);
  return text;
}

void check_clock(const Trace& trace, const TaskRun& run, Faults& faults) {
  if (run.happened) {
    ClockCheck(trace, run, faults).check();
  } else if (run.started && run.result == TaskResult::rejected &&
             std::llabs(run.end - run.start) > kTimeSlack) {
    faults.push_back({FaultKind::clock, ResultFile::trace, run.end_line, trace.runs[at(run.run)],
                      run.end, "a task that is undone ends when it started"});
  }
}

}  // namespace rubicon::verify
