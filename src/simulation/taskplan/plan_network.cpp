#include "src/simulation/taskplan/plan_network.hpp"

#include "interpreter/program/world.hpp"
#include "src/simulation/taskplan/plan_calendars.hpp"

namespace rubicon::taskplan {

namespace {

schedule::LinkType type_of(interpreter::LinkType type) {
  switch (type) {
    case interpreter::LinkType::FS:
      return schedule::LinkType::FS;
    case interpreter::LinkType::SS:
      return schedule::LinkType::SS;
    case interpreter::LinkType::FF:
      return schedule::LinkType::FF;
    case interpreter::LinkType::SF:
      return schedule::LinkType::SF;
  }
  return schedule::LinkType::FS;
}

}  // namespace

std::vector<schedule::NetworkTask> network_tasks(const interpreter::PlanModel& plan) {
  std::vector<schedule::NetworkTask> tasks;
  tasks.reserve(plan.tasks.size());
  for (const interpreter::TaskSpec& spec : plan.tasks) {
    schedule::NetworkTask& task = tasks.emplace_back();
    task.name = spec.name;
    task.priority = spec.priority;
    task.resources = held_resources(plan, spec);
    for (const auto& work : {spec.hook, spec.adjust, spec.release}) {
      if (work) task.work += interpreter::ticks_from_seconds(work->duration);
    }
    for (const interpreter::WorkSpec& work : spec.takes) {
      task.work += interpreter::ticks_from_seconds(work.duration);
    }
    for (const interpreter::LinkSpec& link : spec.after) {
      task.after.push_back({link.task, type_of(link.type),
                            interpreter::ticks_from_seconds(link.lag),
                            schedule::LagClock::elapsed});
    }
  }
  return tasks;
}

}  // namespace rubicon::taskplan
