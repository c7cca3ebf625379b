#include "src/results/verify/schedule/check_plan_dates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <variant>

#include "src/motion/math/index.hpp"
#include "src/results/verify/replay/holds.hpp"
#include "src/results/verify/schedule/check_lifts.hpp"
#include "src/results/verify/schedule/task_clock.hpp"

namespace rubicon::verify {

namespace {

using math::at;

bool differ(Ticks a, Ticks b) { return std::llabs(a - b) > kTimeSlack; }

class PlanDateCheck {
 public:
  PlanDateCheck(const Trace& trace, const std::vector<TaskRun>& runs, const WorkingHours& hours,
                const std::vector<ScheduleRow>& rows, ResultFile file, Ticks ends, Faults& faults)
      : trace_(trace),
        runs_(runs),
        hours_(hours),
        rows_(rows),
        file_(file),
        ends_(ends),
        faults_(faults),
        place_of_(trace.scene.tasks.size()) {}

  void check() {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      if (runs_[i].task >= 0) place_of_[at(runs_[i].task)].run = static_cast<int>(i);
    }
    for (const ScheduleRow& row : rows_) {
      const auto task = trace_.scene.task_index.find(row.task);
      if (task == trace_.scene.task_index.end()) continue;
      place_of_[at(task->second)].row = &row;
    }
    for (std::size_t task = 0; task < place_of_.size(); ++task) {
      if (place_of_[task].row == nullptr || place_of_[task].run < 0) continue;
      check_said(trace_.scene.tasks[task], place_of_[task]);
      if (has_floats(static_cast<int>(task))) check_floats(static_cast<int>(task));
    }
    check_handovers();
  }

 private:
  struct Place {
    const ScheduleRow* row = nullptr;
    int run = -1;
  };

  void fault(const ScheduleRow& row, std::string text) {
    faults_.push_back({FaultKind::schedule, file_, row.line, row.task, row.start, std::move(text)});
  }

  const TaskRun& run(const Place& place) const { return runs_[at(place.run)]; }

  /// What the plan says, and the lateness that follows.
  void check_said(const SceneTask& task, const Place& place) {
    const ScheduleRow& row = *place.row;
    const auto same = [](const std::optional<Ticks>& a, const std::optional<Ticks>& b) {
      return a.has_value() == b.has_value() && (!a || !differ(*a, *b));
    };
    if (!same(row.due, task.due)) fault(row, "it is due at another time in the trace");
    std::optional<Ticks> late;
    if (task.due && run(place).happened) late = std::max<Ticks>(run(place).end - *task.due, 0);
    if (!same(row.late, late)) {
      fault(row, fmt::format("it is late by {}, by the trace by {}",
                             row.late ? clock_text(*row.late) : "nothing",
                             late ? clock_text(*late) : "nothing"));
    }
    if (row.baseline.has_value() != task.baseline.has_value() ||
        (row.baseline && (differ(row.baseline->first, task.baseline->first) ||
                          differ(row.baseline->second, task.baseline->second)))) {
      fault(row, "its baseline is another in the trace");
    }
  }

  bool has_floats(int task) const {
    const Place& place = place_of_[at(task)];
    return place.row != nullptr && place.run >= 0 && run(place).happened && place.row->floats;
  }

  bool has_room(int task) const {
    const Place& place = place_of_[at(task)];
    return differ(place.row->floats->latest_finish, run(place).end);
  }

  Ticks latest(int task, bool of_start) const {
    const RowFloat& floats = *place_of_[at(task)].row->floats;
    return of_start ? floats.latest_start : floats.latest_finish;
  }

  void check_floats(int task) {
    const Place& place = place_of_[at(task)];
    const ScheduleRow& row = *place.row;
    const RowFloat& floats = *row.floats;
    if (floats.free < 0 || floats.total < floats.free) {
      fault(row, "its free float is below 0 or above its total float");
    }
    if (file_ == ResultFile::schedule_csv) return;  // without the latest dates
    if (floats.latest_start < run(place).start - kTimeSlack ||
        floats.latest_finish < run(place).end - kTimeSlack ||
        floats.latest_finish > ends_ + kTimeSlack) {
      fault(row, "its latest dates are before its own or after the end of the plan");
    }
    std::vector<int> calendars;
    for (const Hold& hold : holds_of(trace_, runs_, place.run)) {
      if (!hold.whole) continue;
      for (const int each : calendar_of_resource(trace_.scene, hold.resource)) {
        calendars.push_back(each);
      }
    }
    const Ticks total = hours_.between(calendars, run(place).end, floats.latest_finish);
    if (differ(total, floats.total)) {
      fault(row, fmt::format("its total float is {}, and it works for {} from its finish to its "
                             "latest finish",
                             clock_text(floats.total), clock_text(total)));
    }
    check_latest_start(place, calendars);
    check_latest_lift(place);
    for (const SceneLink& link : trace_.scene.tasks[at(task)].after) check_link(task, link);
  }

  /// Working time of a run in which it waited for the hours of those who hook, adjust and release.
  Ticks waited_for_hours(const TaskRun& own, const std::vector<int>& calendars) const {
    Ticks waited = 0;
    for (const int i : own.records) {
      const Record& record = trace_.records[at(i)];
      if (const auto* pause = std::get_if<Pause>(&record.what)) {
        if (pause->why != "shift" && pause->why != "lift") continue;
        waited += hours_.between(calendars, pause->from, record.time);
      } else if (const auto* work = std::get_if<Work>(&record.what)) {
        const Ticks own_hours = hours_.between(calendars, work->from, record.time);
        waited += std::max<Ticks>(own_hours - work->time, 0);
      }
    }
    return waited;
  }

  /// A lift that was in time is in time at its latest, too.
  void check_latest_lift(const Place& place) {
    const TaskRun& own = run(place);
    const auto lift = find_lift(trace_, own);
    if (!lift || lift->overtime > 0 || !has_room(own.task) || differ(lift->to, own.end)) return;
    const Ticks latest_finish = place.row->floats->latest_finish;
    const auto calendars = calendars_of_lift(trace_.scene, trace_.scene.tasks[at(own.task)]);
    const Ticks whole = lift->to - lift->from;
    if (hours_.between(calendars, latest_finish - whole, latest_finish) >= whole - kTimeSlack) {
      return;
    }
    fault(*place.row, "its float is too large: at its latest its lift is not in one shift");
  }

  /// At its latest it has as much working time as it had, and starts where all that it needs work;
  /// a second sooner where that is the end of a shift. What has no working time takes as long as it
  /// took. Who works in it for a time, by hours of his own, may take longer at its latest.
  void check_latest_start(const Place& place, const std::vector<int>& calendars) {
    const TaskRun& own = run(place);
    const RowFloat& floats = *place.row->floats;
    const Ticks work =
        hours_.between(calendars, own.start, own.end) - waited_for_hours(own, calendars);
    const std::vector<Hold> holds = holds_of(trace_, runs_, place.run);
    const bool may_wait =
        std::any_of(holds.begin(), holds.end(), [](const Hold& hold) { return !hold.whole; });
    const Ticks least = floats.latest_finish - floats.latest_start;
    if (!has_room(own.task) || work == 0) {
      if (!differ(least, own.end - own.start)) return;
    } else {
      const Ticks left = hours_.between(calendars, floats.latest_start, floats.latest_finish);
      const bool works =
          hours_.between(calendars, floats.latest_start, floats.latest_start + 2 * kSecond) > 0;
      const bool is_all = may_wait || left <= work + kSecond + kTimeSlack;
      if (left >= work - kTimeSlack && is_all && works) return;
    }
    fault(*place.row, fmt::format("it works for {}, and its latest start is {} before its latest "
                                  "finish",
                                  clock_text(work), clock_text(least)));
  }

  void check_link(int task, const SceneLink& link) {
    if (!has_floats(link.task) || !has_room(link.task)) return;
    const bool from_start = link.type == LinkType::SS || link.type == LinkType::SF;
    const bool to_start = link.type == LinkType::FS || link.type == LinkType::SS;
    const Ticks before = latest(link.task, from_start) + link.lag;
    if (before <= latest(task, to_start) + kTimeSlack) return;
    const ScheduleRow& row = *place_of_[at(link.task)].row;
    fault(row, fmt::format("its float is too large: at its latest it holds up {} by {}",
                           trace_.scene.tasks[at(task)].name,
                           clock_text(before - latest(task, to_start))));
  }

  /// Robots, and crews that tasks take whole, go from task to task.
  void check_handovers() {
    if (file_ == ResultFile::schedule_csv) return;
    std::map<int, std::vector<Hold>> holds;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      if (!runs_[i].happened || runs_[i].task < 0) continue;
      for (const Hold& hold : holds_of(trace_, runs_, static_cast<int>(i))) {
        if (hold.people == size_of_resource(trace_.scene, hold.resource) && hold.whole) {
          holds[hold.resource].push_back(hold);
        }
      }
    }
    for (auto& [resource, all] : holds) {
      std::stable_sort(all.begin(), all.end(),
                       [](const Hold& a, const Hold& b) { return a.from < b.from; });
      for (std::size_t i = 1; i < all.size(); ++i) check_handover(all[i - 1], all[i]);
    }
  }

  void check_handover(const Hold& given, const Hold& taken) {
    const int before = runs_[at(given.run)].task, after = runs_[at(taken.run)].task;
    if (!has_floats(before) || !has_floats(after) || !has_room(before)) return;
    if (latest(before, false) <= latest(after, true) + kTimeSlack) {
      check_repair(given, taken);
      return;
    }
    fault(*place_of_[at(before)].row,
          fmt::format("its float is too large: at its latest it has {} when {} needs it",
                      resource_name(trace_.scene, given.resource),
                      trace_.scene.tasks[at(after)].name));
  }

  /// A machine that broke down at the end of a task is repaired before the next has it.
  void check_repair(const Hold& given, const Hold& taken) {
    const TaskRun& own = runs_[at(given.run)];
    for (const BreakdownRecord& each : trace_.breakdowns) {
      if (each.robot != given.resource || each.during != trace_.runs[at(own.run)] ||
          differ(each.from, given.to)) {
        continue;
      }
      const Ticks left =
          hours_.between(calendar_of_resource(trace_.scene, given.resource),
                         latest(own.task, false), latest(runs_[at(taken.run)].task, true));
      if (left >= each.repair - kTimeSlack) continue;
      fault(*place_of_[at(own.task)].row,
            fmt::format("its float is too large: at its latest {} is not repaired when {} needs it",
                        resource_name(trace_.scene, given.resource),
                        trace_.scene.tasks[at(runs_[at(taken.run)].task)].name));
    }
  }

  const Trace& trace_;
  const std::vector<TaskRun>& runs_;
  const WorkingHours& hours_;
  const std::vector<ScheduleRow>& rows_;
  ResultFile file_;
  Ticks ends_;
  Faults& faults_;
  std::vector<Place> place_of_;  ///< by task
};

}  // namespace

void check_plan_dates(const Trace& trace, const std::vector<TaskRun>& runs,
                      const WorkingHours& hours, const std::vector<ScheduleRow>& rows,
                      ResultFile file, Ticks ends, Faults& faults) {
  if (trace.scene.short_form) return;
  PlanDateCheck(trace, runs, hours, rows, file, ends, faults).check();
}

}  // namespace rubicon::verify
