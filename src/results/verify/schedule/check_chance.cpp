#include "src/results/verify/schedule/check_chance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/input/read_times.hpp"
#include "src/results/verify/replay/holds.hpp"
#include "src/results/verify/schedule/check_durations.hpp"
#include "src/results/verify/schedule/check_lifts.hpp"
#include "src/results/verify/schedule/civil_date.hpp"
#include "src/results/verify/schedule/task_clock.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// What a machine did without a pause: a step, a wait of its script, a stop, or work in its task.
struct Doing {
  Ticks from = 0;
  Ticks to = 0;
  Ticks least = 0;         ///< of it surely work of the machine
  Ticks most = 0;          ///< a wait of a script may count, or not
  bool safe = false;       ///< nothing hangs on it when it begins, and no lift is under way
  bool breakable = false;  ///< it can be interrupted
};

class MachineDoings {
 public:
  MachineDoings(const Trace& trace, const TaskRun& run, std::vector<Doing>& doings)
      : trace_(trace), run_(run), doings_(doings), now_(run.start) {
    if (run.task >= 0) lift_ = find_lift(trace, run);
  }

  void follow() {
    for (const int index : run_.records) {
      const Record& record = trace_.records[at(index)];
      time_ = record.time;
      std::visit([&](const auto& what) { add(what); }, record.what);
      now_ = record.time;
    }
  }

 private:
  template <typename Other>
  void add(const Other&) {}
  void add(const Try& attempt) {
    if (attempt.ok) push(now_, time_ - now_, time_ - now_, false);
  }
  void add(const Wait&) { push(now_, 0, time_ - now_, false); }
  void add(const Stop&) {
    push(now_, time_ - now_, time_ - now_, false);
    doings_.back().safe = false;  // it is on its way to rest, whatever for
  }
  void add(const Think&) { push(now_, time_ - now_, time_ - now_, false); }
  void add(const Work& work) { push(work.from, work.time, work.time, work.what == "takes"); }
  void add(const LoadChange& change) {
    if (change.kind == LoadChange::Kind::attach) hangs_ = true;
    if (change.kind == LoadChange::Kind::detach) hangs_ = false;
  }

  void push(Ticks from, Ticks least, Ticks most, bool breakable) {
    const bool lifts = lift_ && from > lift_->from && from < lift_->to;
    doings_.push_back({from, time_, least, most, !hangs_ && !lifts, breakable});
  }

  const Trace& trace_;
  const TaskRun& run_;
  std::vector<Doing>& doings_;
  Ticks now_;
  Ticks time_ = 0;
  bool hangs_ = false;
  std::optional<Lift> lift_;
};

class BreakdownCheck {
 public:
  BreakdownCheck(const Trace& trace, const std::vector<TaskRun>& runs, const WorkingHours& hours,
                 int robot, Faults& faults)
      : trace_(trace), runs_(runs), hours_(hours), robot_(robot), faults_(faults) {
    for (const TaskRun& run : runs) {
      if (run.happened && run.robot == robot) MachineDoings(trace, run, doings_).follow();
    }
    std::stable_sort(doings_.begin(), doings_.end(),
                     [](const Doing& a, const Doing& b) { return a.from < b.from; });
  }

  void check() {
    Ticks last = 0;
    for (const BreakdownRecord& each : trace_.breakdowns) {
      if (each.robot != robot_) continue;
      record_ = &each;
      if (each.from < last) fault("it breaks down while it is repaired");
      check_laws();
      check_repair();
      check_work(last);
      last = each.until;
    }
  }

 private:
  void fault(std::string text) {
    faults_.push_back({FaultKind::schedule, ResultFile::trace, record_->line, record_->during,
                       record_->from,
                       fmt::format("{}: {}", trace_.scene.robots[at(robot_)].name, text)});
  }

  void check_laws() {
    const auto& laws = trace_.scene.robots[at(robot_)].breakdown;
    if (!trace_.scene.sampled || !laws) {
      fault("it breaks down, and nothing says that it does");
      return;
    }
    if (!allows(trace_.scene, laws->first, record_->every) && record_->every != kSecond) {
      fault(fmt::format("it is good for {} of work, which {} does not allow",
                        clock_text(record_->every), laws->first.law));
    }
    if (!allows(trace_.scene, laws->second, record_->repair)) {
      fault(fmt::format("its repair takes {}, which {} does not allow", clock_text(record_->repair),
                        laws->second.law));
    }
  }

  void check_repair() {
    const std::vector<int> calendar = calendar_of_resource(trace_.scene, robot_);
    const Ticks worked = hours_.between(calendar, record_->from, record_->until);
    if (std::llabs(worked - record_->repair) > kTimeSlack) {
      fault(fmt::format("its repair takes {} and there are {} of its hours for it",
                        clock_text(record_->repair), clock_text(worked)));
    }
    for (const Doing& each : doings_) {
      if (each.from < record_->until - kTimeSlack && each.to > record_->from + kTimeSlack) {
        fault(fmt::format("it works at {}, and is under repair until {}", clock_text(each.from),
                          clock_text(record_->until)));
        return;
      }
    }
    for (const TaskRun& run : runs_) {
      const bool begins = run.happened && run.robot == robot_ && run.end > run.start &&
                          run.start > record_->from + kTimeSlack &&
                          run.start < record_->until - kTimeSlack;
      if (begins) fault(fmt::format("{} begins while it is repaired", trace_.runs[at(run.run)]));
    }
  }

  /// What it did since it was repaired last.
  void check_work(Ticks since) {
    Ticks least = 0, most = 0;
    for (const Doing& each : doings_) {
      if (each.from < since - kTimeSlack || each.from >= record_->from - kTimeSlack) continue;
      const bool due = least >= record_->every + kTimeSlack;
      if (due && each.safe) {
        fault(fmt::format("it works on at {}, when it has to be repaired", clock_text(each.from)));
        return;
      }
      least += each.least;
      most += each.most;
      if (each.breakable && least > record_->every + kTimeSlack && !due) {
        fault("its work is not interrupted where it breaks down");
        return;
      }
    }
    if (record_->worked < least - kTimeSlack || record_->worked > most + kTimeSlack) {
      fault(fmt::format("it has worked for {}, by the trace {}", clock_text(record_->worked),
                        clock_text(least)));
    } else if (record_->worked < record_->every - kTimeSlack) {
      fault(fmt::format("it breaks down after {} of work, and is good for {}",
                        clock_text(record_->worked), clock_text(record_->every)));
    }
  }

  const Trace& trace_;
  const std::vector<TaskRun>& runs_;
  const WorkingHours& hours_;
  const int robot_;
  Faults& faults_;
  std::vector<Doing> doings_;
  const BreakdownRecord* record_ = nullptr;
};

}  // namespace

void check_breakdowns(const Trace& trace, const std::vector<TaskRun>& runs,
                      const WorkingHours& hours, Faults& faults) {
  for (std::size_t i = 0; i < trace.scene.robots.size(); ++i) {
    const auto its = [&](const BreakdownRecord& each) { return each.robot == static_cast<int>(i); };
    if (std::none_of(trace.breakdowns.begin(), trace.breakdowns.end(), its)) continue;
    BreakdownCheck(trace, runs, hours, static_cast<int>(i), faults).check();
  }
}

void check_lost_days(const Trace& trace, const std::vector<TaskRun>& runs,
                     const WorkingHours& hours, Faults& faults) {
  Ticks end = 0;
  for (const TaskRun& run : runs) {
    if (run.happened) end = std::max(end, run.end);
  }
  std::size_t next = 0;
  const auto fault = [&](int line, std::string text) {
    faults.push_back({FaultKind::shift, ResultFile::trace, line, "", -1, std::move(text)});
  };
  for (std::size_t i = 0; i < trace.scene.calendars.size(); ++i) {
    const SceneCalendar& calendar = trace.scene.calendars[i];
    if (calendar.lost.empty() || !trace.scene.sampled || trace.scene.short_form) continue;
    if (next == trace.lost_days.size()) {
      fault(trace.lines, fmt::format("it does not tell what calendar {} lost", calendar.name));
      return;
    }
    const LostDaysRecord& record = trace.lost_days[next++];
    const LostDates lost = hours.lost_until(static_cast<int>(i), end);
    std::vector<std::int64_t> told;
    for (const std::string& day : record.days) told.push_back(day_number(day));
    if (record.calendar != calendar.name) {
      fault(record.line, fmt::format("expected what calendar {} lost", calendar.name));
    } else if (told != lost.days || record.of != lost.working_days) {
      fault(record.line,
            fmt::format("calendar {} lost {} of {} days, by the weather {} of {}", calendar.name,
                        told.size(), record.of, lost.days.size(), lost.working_days));
    }
  }
  if (next < trace.lost_days.size()) {
    fault(trace.lost_days[next].line, "it tells of lost days, and nothing says that any are");
  }
}

void check_chance(const Trace& trace, const ScheduleJson& schedule, Faults& faults) {
  const auto fault = [&](const char* what) {
    faults.push_back({FaultKind::schedule, ResultFile::schedule_json, 0, "", -1,
                      fmt::format("its {} are not those of the trace", what)});
  };
  bool same = schedule.lost_days.size() == trace.lost_days.size();
  for (std::size_t i = 0; same && i < trace.lost_days.size(); ++i) {
    const LostDaysRecord& told = trace.lost_days[i];
    const LostDaysRecord& row = schedule.lost_days[i];
    same = row.calendar == told.calendar && row.of == told.of && row.days == told.days;
  }
  if (!same) fault("lost days");
  same = schedule.breakdowns.size() == trace.breakdowns.size();
  for (std::size_t i = 0; same && i < trace.breakdowns.size(); ++i) {
    const BreakdownRecord& told = trace.breakdowns[i];
    const BreakdownRow& row = schedule.breakdowns[i];
    same = row.robot == trace.scene.robots[at(told.robot)].name && row.during == told.during &&
           row.from == told.from && row.to == told.until && row.worked == told.worked &&
           row.repair == told.repair;
  }
  if (!same) fault("breakdowns");
}

}  // namespace rubicon::verify
