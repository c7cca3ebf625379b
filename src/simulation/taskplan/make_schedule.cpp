#include <algorithm>
#include <cstdint>
#include <numeric>
#include <set>
#include <utility>

#include "src/simulation/schedule/critical_chain.hpp"
#include "src/simulation/taskplan/plan_calendars.hpp"
#include "src/simulation/taskplan/plan_cost.hpp"
#include "src/simulation/taskplan/plan_floats.hpp"
#include "src/simulation/taskplan/simulation.hpp"

namespace rubicon::taskplan {

namespace {

/// A part of a time, added up without rounding on the way.
struct SharedTime {
  Ticks whole = 0;
  std::int64_t rest = 0;  ///< in parts of `size`

  void add(Ticks time, int people, int size) {
    whole += time / size * people;
    rest += time % size * people;
    whole += rest / size;
    rest %= size;
  }
};

/// Adds up who was used for how long.
void count_uses(Schedule& schedule) {
  std::vector<SharedTime> held(schedule.resources.size()), busy(schedule.resources.size());
  for (const TaskOutcome& task : schedule.tasks) {
    std::set<int> had;
    for (const ResourceHold& hold : task.holds) {
      const auto resource = static_cast<std::size_t>(hold.resource);
      ResourceUse& use = schedule.resources[resource];
      const int size = static_cast<int>(use.size);
      held[resource].add(hold.held, hold.people, size);
      busy[resource].add(hold.busy, hold.people, size);
      if (had.insert(hold.resource).second) ++use.tasks;
    }
  }
  for (std::size_t i = 0; i < schedule.resources.size(); ++i) {
    schedule.resources[i].held = held[i].whole;
    schedule.resources[i].busy = busy[i].whole;
  }
}

}  // namespace

std::vector<TimetableOutcome> timetables_of(const site::SiteWorld& site, Ticks now) {
  std::vector<TimetableOutcome> all;
  for (int i = 0; i < site.movings(); ++i) {
    const site::MovingState& state = site.moving(i).state();
    const Ticks stood = state.stop ? now - state.stop->since : 0;
    all.push_back({site.moving(i).name(), state.stops, state.delay + stood,
                   state.stop ? state.stop->by : std::string()});
  }
  return all;
}

Schedule Simulation::make_schedule() {
  Schedule schedule;
  schedule.start_at = plan_.start_at;
  schedule.currency = plan_.currency;
  std::vector<TaskOutcome*> all;
  const auto add = [&](TaskOutcome& outcome) { all.push_back(&outcome); };
  for (int task = 0; task < static_cast<int>(plan_.tasks.size()); ++task) {
    if (auto& outcome = records_.outcome(task)) {
      schedule.process_time = std::max(schedule.process_time, outcome->start + outcome->duration);
      add(*outcome);
    } else {
      schedule.feasible = false;
      add(excluded_.at(task).outcome);
    }
  }
  for (TaskOutcome& parking : records_.parkings()) add(parking);
  for (TaskOutcome& parking : stage_.failed_parkings) add(parking);
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return all[a]->start < all[b]->start; });
  std::vector<std::size_t> row_of(all.size());  // of the tasks of the plan, as in the file
  schedule.tasks.reserve(all.size());
  for (const std::size_t place : order) {
    row_of[place] = schedule.tasks.size();
    schedule.tasks.push_back(std::move(*all[place]));
    // Room for the next.
    if (place < plan_.tasks.size()) records_.outcome(static_cast<int>(place)).reset();
  }

  for (const interpreter::RobotSpec& robot : plan_.robots) {
    ResourceUse& use = schedule.resources.emplace_back();
    use.name = robot.name;
    use.robot = true;
    use.rate = robot.cost_per_hour;
  }
  for (const interpreter::CrewSpec& crew : plan_.crews) {
    ResourceUse& use = schedule.resources.emplace_back();
    use.name = crew.name;
    use.size = crew.size;
    use.rate = crew.cost_per_hour;
  }
  schedule.timetables = timetables_of(stage_.site, stage_.now());
  // A machine may still be on its way out of the way when the last task is done.
  Ticks end = schedule.process_time;
  for (const TaskOutcome& task : schedule.tasks) {
    if (task.result == TaskResult::done) end = std::max(end, task.start + task.duration);
  }
  for (std::size_t i = 0; i < schedule.resources.size(); ++i) {
    schedule.resources[i].shift_time =
        stage_.allocator->hours(static_cast<int>(i)).work_between(0, end);
  }
  add_lost_days(schedule, end);
  if (plan_.workspaces) {
    for (const int robot : plan_.workspaces->robots) {
      schedule.workspaces.push_back(plan_.robots[static_cast<std::size_t>(robot)].name);
    }
    schedule.foresees = plan_.workspaces->foreseen() > 0;
    schedule.watches = plan_.workspaces->watch;
  }
  schedule.breaks_down = interpreter::has_breakdowns(plan_);
  schedule.breakdowns = std::move(stage_.breakdown_outcomes);
  count_uses(schedule);
  add_costs(plan_, schedule);
  add_floats(row_of, schedule);
  add_critical_chain(row_of, schedule);
  return schedule;
}

/// What the weather took up to the end of the plan, also in the trace.
void Simulation::add_lost_days(Schedule& schedule, Ticks end) {
  schedule.loses_days = interpreter::loses_days(plan_);
  if (!schedule.loses_days || !stage_.draws.sample) return;
  const std::vector<schedule::WorkCalendar> calendars = calendars_of(plan_, stage_.draws);
  for (std::size_t i = 0; i < calendars.size(); ++i) {
    if (!plan_.calendars[i].loses_days()) continue;
    const schedule::WorkCalendar::Lost lost = calendars[i].lost_until(end);
    LostDaysOutcome& outcome = schedule.lost_days.emplace_back();
    outcome.calendar = plan_.calendars[i].name;
    outcome.working_days = static_cast<int>(lost.working_days);
    for (const std::int64_t day : lost.days) {
      outcome.dates.push_back(schedule::text_of(schedule::date_from_days(day)));
    }
    stage_.trace.lost_days(outcome, end);
  }
}

void Simulation::add_floats(const std::vector<std::size_t>& row_of, Schedule& schedule) const {
  std::vector<DoneTask> done;
  for (int task = 0; task < static_cast<int>(plan_.tasks.size()); ++task) {
    if (schedule.tasks[row_of[index(task)]].result != TaskResult::done) continue;
    done.push_back({task, row_of[index(task)], &stage_.calendar(task),
                    stage_.links->is_milestone(task), stage_.spec(task).priority});
    for (const TaskStretch& part : schedule.tasks[row_of[index(task)]].parts) {
      done.back().parts.push_back({part.work, &stage_.allocator->calendar(part.queue), part.whole});
    }
  }
  const auto hours_of = [this](int resource) -> const schedule::WorkCalendar& {
    return stage_.allocator->hours(resource);
  };
  taskplan::add_floats(done, *stage_.links, hours_of, schedule);
}

/// A shift was missed in a run that went back: whether the other task gave the resource back at
/// that moment in the end, too.
bool Simulation::gave_back(const schedule::MissedShift& missed,
                           const std::vector<std::size_t>& row_of, const Schedule& schedule) const {
  if (stage_.is_park(missed.task_before) || excluded_.contains(missed.task_before)) return false;
  const std::vector<ResourceHold>& holds = schedule.tasks[row_of[index(missed.task_before)]].holds;
  return std::any_of(holds.begin(), holds.end(), [&](const ResourceHold& hold) {
    return hold.resource == missed.resource && hold.to == missed.until;
  });
}

void Simulation::add_critical_chain(const std::vector<std::size_t>& row_of,
                                    Schedule& schedule) const {
  if (schedule.process_time == 0) return;
  schedule::NetworkTimes times;
  times.tasks = stage_.links->all_times();
  for (std::size_t task = 0; task < times.tasks.size(); ++task) {
    if (excluded_.contains(static_cast<int>(task))) times.tasks[task] = {};
    // The plan is over with its own tasks.
    if (stage_.is_park(static_cast<int>(task))) times.tasks[task].finish = 0;
    for (schedule::MidWait& wait : times.tasks[task].mid_waits) {
      if (!wait.missed || gave_back(*wait.missed, row_of, schedule)) continue;
      wait.missed.reset();
      wait.first_gain = 0;
    }
  }
  for (const schedule::ChainStep& step : critical_chain(stage_.links->network(), times)) {
    schedule.critical.push_back({stage_.spec(step.task).name, step.work_counts,
                                 schedule::text_of(stage_.links->network(), step)});
  }
}

}  // namespace rubicon::taskplan
