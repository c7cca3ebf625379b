#include "src/simulation/taskplan/plan_calendars.hpp"

#include <algorithm>

#include "src/simulation/schedule/calendar_rules.hpp"

namespace rubicon::taskplan {

schedule::CivilTime start_of(const interpreter::PlanModel& plan) {
  return plan.start_at.value_or(schedule::kUndatedStart);
}

std::vector<schedule::WorkCalendar> calendars_of(const interpreter::PlanModel& plan,
                                                 const interpreter::Draws& draws) {
  std::vector<schedule::WorkCalendar> calendars;
  for (interpreter::CalendarSpec rules : plan.calendars) {
    if (draws.sample) rules.weather = {{draws.sample->seed, draws.sample->run}};
    calendars.push_back(
        std::get<schedule::WorkCalendar>(schedule::calendar_of(rules, start_of(plan))));
  }
  return calendars;
}

int calendar_index(const interpreter::PlanModel& plan, const std::string& name) {
  const auto found =
      std::find_if(plan.calendars.begin(), plan.calendars.end(),
                   [&](const interpreter::CalendarSpec& each) { return each.name == name; });
  return found == plan.calendars.end() ? -1 : static_cast<int>(found - plan.calendars.begin());
}

std::vector<int> held_resources(const interpreter::PlanModel& plan,
                                const interpreter::TaskSpec& task) {
  std::vector<int> resources;
  const int robots = static_cast<int>(plan.robots.size());
  if (task.robot >= 0) resources.push_back(task.robot);
  for (const int robot : task.also_robots) resources.push_back(robot);
  for (const int crew : task.crews) resources.push_back(robots + crew);
  if (task.robot < 0) {
    for (const interpreter::WorkSpec& work : task.takes) {
      if (work.crew >= 0) resources.push_back(robots + work.crew);
    }
  }
  std::sort(resources.begin(), resources.end());
  resources.erase(std::unique(resources.begin(), resources.end()), resources.end());
  return resources;
}

int people_of(const interpreter::PlanModel& plan, const interpreter::TaskSpec& task, int resource) {
  const int crew = resource - static_cast<int>(plan.robots.size());
  if (crew < 0) return 1;
  for (const interpreter::NeedSpec& need : task.needs) {
    if (need.crew == crew) return need.people;
  }
  return static_cast<int>(plan.crews[static_cast<std::size_t>(crew)].size);
}

int resource_of(const interpreter::PlanModel& plan, const interpreter::PoolMember& member) {
  const interpreter::PoolSpec& pool = plan.pools[static_cast<std::size_t>(member.pool)];
  const int index = pool.members[static_cast<std::size_t>(member.member)];
  return pool.of_robots ? index : static_cast<int>(plan.robots.size()) + index;
}

}  // namespace rubicon::taskplan
