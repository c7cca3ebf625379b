#include "src/results/verify/schedule/check_waits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/schedule/check_choices.hpp"
#include "src/results/verify/schedule/check_lifts.hpp"
#include "src/results/verify/schedule/task_clock.hpp"

namespace rubicon::verify {

namespace {

using math::at;

bool holds_finish(const SceneLink& link) {
  return link.type == LinkType::FF || link.type == LinkType::SF;
}

Ticks bound_of(const SceneLink& link, const TaskRun& before) {
  const bool from_start = link.type == LinkType::SS || link.type == LinkType::SF;
  return (from_start ? before.start : before.end) + link.lag;
}

}  // namespace

WaitCheck::WaitCheck(const Trace& trace, const std::vector<TaskRun>& runs,
                     const WorkingHours& hours)
    : trace_(trace),
      runs_(runs),
      hours_(hours),
      run_of_(trace.scene.tasks.size(), nullptr),
      given_back_(trace.scene.robots.size() + trace.scene.crews.size()),
      held_(runs.size()) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i].happened) continue;
    if (runs[i].task >= 0) run_of_[at(runs[i].task)] = &runs[i];
    for (const Hold& hold : holds_of(trace, runs, static_cast<int>(i))) {
      given_back_[at(hold.resource)].emplace(hold.to, hold.run);
      if (hold.whole) held_[i].push_back(hold.resource);
    }
  }
  // A machine that breaks down at the end of a task is free when it is repaired.
  for (const BreakdownRecord& each : trace.breakdowns) {
    const bool outlasts = std::any_of(runs.begin(), runs.end(), [&](const TaskRun& run) {
      return run.happened && run.robot == each.robot && trace.runs[at(run.run)] == each.during &&
             std::llabs(run.end - each.from) <= kTimeSlack;
    });
    if (outlasts) given_back_[at(each.robot)].emplace(each.until, -1);
  }
  for (const Kept& kept : kept_for_nothing(trace, runs)) {
    given_back_[at(kept.resource)].emplace(kept.until, -1);
  }
}

/// Whether another run gives it back at this moment.
bool WaitCheck::given_back(int resource, Ticks time, int to_run) const {
  const auto& all = given_back_[at(resource)];
  for (auto each = all.lower_bound(time - kTimeSlack);
       each != all.end() && each->first <= time + kTimeSlack; ++each) {
    if (each->second != to_run) return true;
  }
  return false;
}

bool WaitCheck::any_given_back(int index, Ticks time) const {
  return std::any_of(held_[at(index)].begin(), held_[at(index)].end(),
                     [&](int resource) { return given_back(resource, time, index); });
}

std::vector<int> WaitCheck::held_calendars(int index) const {
  std::vector<int> calendars;
  for (const int resource : held_[at(index)]) {
    for (const int calendar : calendar_of_resource(trace_.scene, resource)) {
      calendars.push_back(calendar);
    }
  }
  return calendars;
}

/// Whether one of the links that hold the finish lets go at this moment. What a negative lag allows
/// may be over when it becomes known.
bool WaitCheck::finish_is_due(const TaskRun& run, Ticks time) const {
  if (run.task < 0) return false;
  const std::vector<SceneLink>& links = trace_.scene.tasks[at(run.task)].after;
  return std::any_of(links.begin(), links.end(), [&](const SceneLink& link) {
    const TaskRun* before = run_of_[at(link.task)];
    if (!holds_finish(link) || before == nullptr) return false;
    return link.lag < 0 || std::llabs(bound_of(link, *before) - time) <= kTimeSlack;
  });
}

/// Whether the record of that number begins a lift: hook work, or the pick-up.
bool WaitCheck::begins_lift(const TaskRun& run, std::size_t number) const {
  if (number >= run.records.size()) return false;
  const auto& what = trace_.records[at(run.records[number])].what;
  const auto* work = std::get_if<Work>(&what);
  const auto* change = std::get_if<LoadChange>(&what);
  return (work != nullptr && work->what == "hook") ||
         (change != nullptr && change->kind == LoadChange::Kind::attach);
}

void WaitCheck::check_pauses(int index, Faults& faults) const {
  const TaskRun& run = runs_[at(index)];
  if (!run.happened) return;
  const int robots = static_cast<int>(trace_.scene.robots.size());
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    const Record& record = trace_.records[at(run.records[i])];
    const auto* pause = std::get_if<Pause>(&record.what);
    if (pause == nullptr) continue;
    const auto fault = [&](FaultKind kind, std::string text) {
      faults.push_back({kind, ResultFile::trace, record.line, trace_.runs[at(run.run)], record.time,
                        std::move(text)});
    };
    if (pause->why == "crew") {
      const auto crew = trace_.scene.crew_index.find(pause->whom);
      if (crew == trace_.scene.crew_index.end() ||
          !given_back(robots + crew->second, record.time, index)) {
        fault(FaultKind::resource,
              fmt::format("it waits for {}, which nobody gives back then", pause->whom));
      }
    } else if (pause->why == "repair") {
      const bool known = std::any_of(
          trace_.breakdowns.begin(), trace_.breakdowns.end(), [&](const BreakdownRecord& each) {
            return each.robot == run.robot && each.during == trace_.runs[at(run.run)] &&
                   std::llabs(each.from - pause->from) <= kTimeSlack &&
                   std::llabs(each.until - record.time) <= kTimeSlack;
          });
      if (!known) fault(FaultKind::order, "its machine is repaired, and did not break down");
    } else if (pause->why == "truck") {
      const SceneTask* const task = run.task < 0 ? nullptr : &trace_.scene.tasks[at(run.task)];
      const bool by_body =
          task != nullptr && (task->haul || (task->motion_dig && task->motion_dig->load_at));
      const bool is_known = by_body ? trace_.scene.robot_index.contains(pause->whom)
                                    : trace_.scene.crew_index.contains(pause->whom);
      if (task == nullptr || !(task->motion_dig || task->haul) || !is_known) {
        fault(FaultKind::resource, "it waits for a truck, and loads none");
      }
    } else if (pause->why == "held" && !finish_is_due(run, record.time)) {
      fault(FaultKind::link, "it is held to its finish, and no link ends that then");
    } else if (pause->why == "shift") {
      std::vector<int> calendars = held_calendars(index);
      if (run.task >= 0 && trace_.scene.tasks[at(run.task)].whole && begins_lift(run, i + 1)) {
        calendars = calendars_of_lift(trace_.scene, trace_.scene.tasks[at(run.task)]);
      } else if (i + 1 < run.records.size()) {
        const auto* work = std::get_if<Work>(&trace_.records[at(run.records[i + 1])].what);
        if (work != nullptr && work->crew >= 0) {
          const int crew = trace_.scene.crews[at(work->crew)].calendar;
          if (crew >= 0) calendars.push_back(crew);
        }
      }
      const Ticks worked = hours_.between(calendars, pause->from, record.time);
      if (worked > kTimeSlack) {
        fault(FaultKind::shift,
              fmt::format("it waits for a shift, and has {} of it", clock_text(worked)));
      }
    }
  }
}

void WaitCheck::check_start(int index, const TaskAccount& account, const ScheduleRow& row,
                            ResultFile file, Faults& faults) const {
  const TaskRun& run = runs_[at(index)];
  if (!run.happened || run.task < 0) return;
  const auto fault = [&](std::string text) {
    faults.push_back({FaultKind::schedule, file, row.line, row.task, row.start, std::move(text)});
  };
  const Ticks ready = row.split.predecessor - account.held;
  const Ticks resource = row.split.resource - account.crew;
  const Ticks shift = row.split.shift - account.shift;
  const SceneTask& task = trace_.scene.tasks[at(run.task)];
  Ticks bound = task.not_before;
  bool certain = true;  // what a negative lag allows may be over; links may keep a finish late
  for (const SceneLink& link : task.after) {
    const TaskRun* before = run_of_[at(link.task)];
    certain = certain && link.lag >= 0 && !holds_finish(link);
    if (before == nullptr || holds_finish(link)) continue;
    bound = std::max(bound, bound_of(link, *before));
  }
  if (ready < bound - kTimeSlack || (certain && ready > bound + kTimeSlack)) {
    fault(fmt::format("it waits for predecessors until {}, they let it start at {}",
                      clock_text(ready), clock_text(bound)));
  }
  if (resource > kTimeSlack && !any_given_back(index, ready + resource)) {
    fault(fmt::format("it waits for robots and crews until {}, and nobody gives one back then",
                      clock_text(ready + resource)));
  }
  // While machines stand in its zone shifts come and go; the table does not tell when.
  const Ticks machine = row.split.machine - account.machine - account.script_waits;
  if (machine > kTimeSlack && task.zones.empty()) {
    fault("it waits for machines before it starts, and has no zone");
  } else if (machine <= kTimeSlack && task.zones.empty() && shift > kTimeSlack) {
    const Ticks worked = hours_.between(held_calendars(index), run.start - shift, run.start);
    if (worked > kTimeSlack) {
      fault(fmt::format("it waits for a shift, and has {} of it", clock_text(worked)));
    }
  }
}

}  // namespace rubicon::verify
