#include "src/simulation/taskplan/whole_lift.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <variant>

#include "src/simulation/schedule/civil_time.hpp"
#include "src/simulation/schedule/time_text.hpp"
#include "src/simulation/taskplan/plan_calendars.hpp"
#include "src/simulation/taskplan/stage.hpp"

namespace rubicon::taskplan {

namespace {

using schedule::kDay;
using schedule::kHour;
using schedule::kMinute;
using schedule::kSecond;
using schedule::kWeekdayNames;

/// "1 h 5 min", whole seconds, rounded up.
std::string duration_text(Ticks ticks) {
  return schedule::duration_text(-schedule::floor_division(-ticks, kSecond) * kSecond);
}

/// "07:00"; with its weekday where it is not on the day of `beside` or one beside it.
std::string moment_text(const Stage& stage, Ticks time, Ticks beside) {
  const schedule::CivilTime start = start_of(stage.plan);
  const auto day_of = [&](Ticks each) {
    return schedule::days_from_date(schedule::civil_time_at(start, each).date);
  };
  const schedule::CivilTime moment = schedule::civil_time_at(start, time);
  std::string text =
      fmt::format("{:02}:{:02}", moment.minute_of_day / 60, moment.minute_of_day % 60);
  if (std::abs(day_of(time) - day_of(beside)) > 1) {
    text = fmt::format(
        "{} {}", kWeekdayNames[static_cast<std::size_t>(schedule::weekday_of(moment.date))], text);
  }
  return text;
}

/// "Mon 07:00-12:00".
std::string shift_text(const schedule::WorkCalendar::Interval& shift) {
  const auto clock = [](Ticks time) {
    return fmt::format("{:02}:{:02}", time / kHour, time % kHour / kMinute);
  };
  const Ticks first = shift.from / kDay;
  const Ticks last = (shift.to - 1) / kDay;
  return fmt::format(
      "{} {}-{}{}", kWeekdayNames[static_cast<std::size_t>(first % 7)],
      clock(shift.from - first * kDay),
      last == first ? "" : fmt::format("{} ", kWeekdayNames[static_cast<std::size_t>(last % 7)]),
      clock(shift.to - last * kDay));
}

Ticks own_time(const WholeLift& lift, const ActiveTask& task) {
  const TaskOutcome& outcome = task.account.outcome;
  return outcome.motion_time - lift.motion_before + outcome.work_time - lift.work_before;
}

Ticks length(const schedule::WorkCalendar::Interval& shift) { return shift.to - shift.from; }

void reject_too_long(Stage& stage, const WholeLift& lift, const ActiveTask& task,
                     const schedule::WorkCalendar::Interval& longest) {
  const Ticks motion = task.account.outcome.motion_time - lift.motion_before;
  const Ticks work = task.account.outcome.work_time - lift.work_before;
  stage.reject(
      task.task,
      fmt::format("its lift fits into no shift: it takes {} (motion {}, crew work {}), and "
                  "the longest shift of all that it needs, {}, has {}",
                  duration_text(motion + work), duration_text(motion), duration_text(work),
                  shift_text(longest), duration_text(length(longest))));
}

/// How much sooner than `since` a lift of so much must begin to fit into a shift before that; 0 if
/// there is none since the plan began.
Ticks gain_of(const schedule::WorkCalendar& hours, Ticks since, Ticks own) {
  Ticks end = hours.works_at(since) ? hours.shift_end(since) : hours.last_working(since);
  while (end >= own) {
    const Ticks begin = hours.latest_start(end, own);
    if (hours.idle_between(begin, end) == 0) return std::max<Ticks>(since - begin, 0);
    // The shifts between are shorter.
    const Ticks before = hours.shift_end(begin);
    if (before >= end) return 0;
    end = before;
  }
  return 0;
}

/// Now that the lift is over it is known how long it takes: what came before a shift with which it
/// began had to be so much sooner.
void note_gain(Stage& stage, const WholeLift& lift, Ticks own) {
  const std::vector<schedule::MidWait>& waits = stage.links->times(lift.task).mid_waits;
  const auto wait = std::find_if(waits.begin(), waits.end(), [&](const schedule::MidWait& each) {
    return each.held == schedule::Held::shift && each.until == lift.from;
  });
  if (wait == waits.end() || wait->missed) return;
  schedule::TaskTimes times = stage.links->times(lift.task);
  times.mid_waits[static_cast<std::size_t>(wait - waits.begin())].first_gain =
      gain_of(lift_hours(stage, lift.task), wait->since, own);
  stage.links->set_times(lift.task, std::move(times));
}

/// The lift waits for the next shift that is long enough; the run goes back to before its task.
void repeat(Stage& stage, const WholeLift& lift, Ticks own, const std::string& what,
            std::optional<schedule::MissedShift> missed) {
  const schedule::WorkCalendar& hours = lift_hours(stage, lift.task);
  Ticks start = hours.next_working(lift.shift_end);
  while (start < schedule::kEndOfTime && hours.shift_end(start) - start < own) {
    start = hours.next_working(hours.shift_end(start));
  }
  if (start >= schedule::kEndOfTime) {
    stage.reject(lift.task, "there is no shift any more for all that its lift needs");
    return;
  }
  const std::string because = fmt::format("{} {}", what, moment_text(stage, lift.shift_end, start));
  stage.lift_notes.add(lift.task, {start, lift.shift_end, because, 1, own, missed});
  stage.lift_to_repeat = lift.task;
}

/// The crew that a lift waited for last, if it would have been over in time without its waits.
std::optional<schedule::MissedShift> missed_for(const Stage& stage, const WholeLift& lift,
                                                Ticks own) {
  if (lift.from + own > lift.shift_end) return std::nullopt;
  const std::vector<schedule::MidWait>& waits = stage.links->times(lift.task).mid_waits;
  const auto last = std::find_if(waits.rbegin(), waits.rend(), [](const schedule::MidWait& each) {
    return each.held != schedule::Held::shift;
  });
  if (last == waits.rend() || last->until <= lift.from) return std::nullopt;
  if (last->held != schedule::Held::resource || last->task_before < 0) return std::nullopt;
  return schedule::MissedShift{last->until, last->resource, last->task_before,
                               stage.now() - lift.shift_end};
}

/// "23 min do not fit before"; of a lift that waited for others with its load also how long, and
/// for whom last.
std::string misfit(const Stage& stage, Ticks all, Ticks waited,
                   const std::optional<schedule::MissedShift>& missed) {
  std::string text = duration_text(all);
  if (waited > 0) {
    text += fmt::format(", {} of them waiting for others", duration_text(waited));
    if (missed) {
      text += fmt::format(" (last for '{}', which {} had)", stage.allocator->name(missed->resource),
                          stage.spec(missed->task_before).name);
    }
    text += ",";
  }
  return text + " do not fit before";
}

bool is_overdue(const WholeLift& lift, Ticks now) {
  return !lift.fresh && !lift.stays && lift.shift_end < now;
}

}  // namespace

const LiftNote* LiftNotes::of(int task) const {
  const auto found = notes_.find(task);
  return found == notes_.end() ? nullptr : &found->second;
}

void LiftNotes::add(int task, LiftNote note) {
  ++count_[task];
  note.times = ++times_[{task, note.shift_end}];
  notes_[task] = std::move(note);
}

bool LiftNotes::are_enough(int task) const {
  const auto found = count_.find(task);
  return found != count_.end() && found->second >= kMostNotes;
}

bool is_held_whole(const Stage& stage, int task) {
  return interpreter::held_whole(stage.plan, stage.spec(task));
}

std::vector<int> lift_resources(const Stage& stage, int task) {
  std::vector<int> resources = stage.held_by(task);
  for (const int crew : interpreter::crews_of_lift(stage.spec(task))) {
    const int resource = stage.crew_resource(crew);
    if (std::find(resources.begin(), resources.end(), resource) == resources.end()) {
      resources.push_back(resource);
    }
  }
  return resources;
}

int lift_queue(Stage& stage, int task) {
  return std::get<int>(stage.allocator->queue_for({}, lift_resources(stage, task)));
}

const schedule::WorkCalendar& lift_hours(Stage& stage, int task) {
  return stage.allocator->calendar(lift_queue(stage, task));
}

Ticks first_gain_of_lift(Stage& stage, int task, Ticks since, const LiftNote* note) {
  const schedule::WorkCalendar& hours = lift_hours(stage, task);
  return note ? gain_of(hours, since, note->own) : since - hours.last_working(since);
}

const WholeLift* lift_of(const Stage& stage, int task) {
  const auto found = std::find_if(stage.lifts.begin(), stage.lifts.end(),
                                  [&](const WholeLift& lift) { return lift.task == task; });
  return found == stage.lifts.end() ? nullptr : &*found;
}

void begin_lift(ActiveTask& task, Stage& stage, const LiftNote* waited_for) {
  const schedule::WorkCalendar& hours = lift_hours(stage, task.task);
  WholeLift lift;
  lift.task = task.task;
  stage.end_part(task);
  lift.from = stage.now();
  lift.shift_end = hours.shift_end(stage.now());
  lift.fresh = !hours.works_at(stage.now() - 1);
  lift.stays = stage.lift_notes.are_enough(task.task);
  lift.motion_before = task.account.outcome.motion_time;
  lift.work_before = task.account.outcome.work_time;
  lift.over_time_before = task.account.over_time;
  lift.outside_before = task.account.outside;
  if (waited_for) {
    lift.because = waited_for->because;
    lift.before = waited_for->shift_end;
  }
  stage.lifts.push_back(std::move(lift));
}

void forget_lift(Stage& stage, int task) {
  std::erase_if(stage.lifts, [&](const WholeLift& lift) { return lift.task == task; });
}

bool end_lift(ActiveTask& task, Stage& stage) {
  const WholeLift* const found = lift_of(stage, task.task);
  if (!found) return true;
  const WholeLift lift = *found;
  const Ticks now = stage.now();
  const Ticks own = own_time(lift, task);
  const Ticks waited = now - lift.from - own;
  const schedule::WorkCalendar& hours = lift_hours(stage, task.task);
  const bool late = now > lift.shift_end;
  if (late) {
    // A lift that began before this one will be begun again, and this one with it.
    for (std::size_t i = 0; stage.active[i].task != task.task; ++i) {
      const WholeLift* const other = lift_of(stage, stage.active[i].task);
      if (!other || !is_overdue(*other, now)) continue;
      forget_lift(stage, task.task);
      return true;
    }
    const schedule::WorkCalendar::Interval longest = hours.longest_shift();
    if (own > length(longest)) {
      reject_too_long(stage, lift, task, longest);
      return false;
    }
    // One that was held up by others ends in overtime, but nothing hangs until the next shift.
    const bool ends_soon = now <= hours.next_working(lift.shift_end);
    if (!lift.stays && !(lift.fresh && own <= lift.shift_end - lift.from && ends_soon)) {
      const std::optional<schedule::MissedShift> missed = missed_for(stage, lift, own);
      repeat(stage, lift, own, misfit(stage, now - lift.from, waited, missed), missed);
      return false;
    }
  }
  // As long as something hangs all that the task holds is held, waiting or not.
  const std::vector<int>& held = stage.held_by(task.task);
  for (std::size_t i = 0; late && i < held.size(); ++i) {
    task.account.over_time[i] =
        lift.over_time_before[i] + stage.allocator->hours(held[i]).idle_between(lift.from, now);
    task.account.outside[i] =
        lift.outside_before[i] + stage.overtime.out_of_shift(held[i], lift.from, now);
  }
  note_gain(stage, lift, own);
  forget_lift(stage, task.task);
  if (late) {
    stage.end_part(task);
  } else {
    stage.end_part(task, lift_queue(stage, task.task), true);
  }
  if (!late && lift.because.empty()) return true;
  LiftOutcome outcome;
  outcome.from = lift.from;
  outcome.to = now;
  outcome.own = own;
  outcome.overtime = hours.idle_between(lift.from, now);
  if (!lift.because.empty()) {
    outcome.why =
        fmt::format("starts {}: {}", moment_text(stage, lift.from, lift.before), lift.because);
  }
  if (late) {
    outcome.why += fmt::format("{}{} of overtime after {}: its load waited {} for others",
                               outcome.why.empty() ? "" : "; ", duration_text(outcome.overtime),
                               moment_text(stage, lift.shift_end, now), duration_text(waited));
  }
  task.account.outcome.lift = std::move(outcome);
  return true;
}

std::optional<int> overdue_lift(const Stage& stage) {
  if (stage.lifts.empty()) return std::nullopt;
  for (std::size_t i = 0; i < stage.active.size(); ++i) {
    const WholeLift* const lift = lift_of(stage, stage.active[i].task);
    if (lift && is_overdue(*lift, stage.now())) return lift->task;
  }
  return std::nullopt;
}

void repeat_overdue_lift(Stage& stage, int task) {
  const WholeLift lift = *lift_of(stage, task);
  const Ticks own = own_time(lift, *stage.active.look_at(task));
  const schedule::WorkCalendar::Interval longest = lift_hours(stage, task).longest_shift();
  if (own > length(longest)) {
    reject_too_long(stage, lift, *stage.active.look_at(task), longest);
  } else {
    repeat(stage, lift, own, "it would hang on the hook beyond", std::nullopt);
  }
}

}  // namespace rubicon::taskplan
