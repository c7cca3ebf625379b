#include "src/simulation/taskplan/plan_network.hpp"

#include "src/simulation/taskplan/plan_calendars.hpp"

namespace rubicon::taskplan {

std::vector<schedule::NetworkTask> network_tasks(const interpreter::PlanModel& plan,
                                                 const interpreter::Draws& draws) {
  std::vector<schedule::NetworkTask> tasks;
  tasks.reserve(plan.tasks.size());
  for (const interpreter::TaskSpec& spec : plan.tasks) {
    schedule::NetworkTask& task = tasks.emplace_back();
    task.name = spec.name;
    task.priority = spec.priority;
    task.not_before = spec.not_before;
    task.resources = held_resources(plan, spec);
    for (const int resource : task.resources) {
      task.units.push_back(people_of(plan, spec, resource));
    }
    for (const auto* const work : {&spec.hook, &spec.adjust, &spec.release}) {
      if (*work) task.work += schedule::ticks_from_seconds(draws.duration(**work));
    }
    for (const interpreter::WorkSpec& work : spec.takes) {
      task.work += schedule::ticks_from_seconds(draws.duration(work));
    }
    for (const interpreter::LinkSpec& link : spec.after) {
      task.after.push_back({link.task, link.type, link.lag, schedule::LagClock::elapsed});
    }
  }
  return tasks;
}

}  // namespace rubicon::taskplan
