#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "interpreter/check/plan_model.hpp"

namespace rubicon::interpreter {

namespace {

/// Calls `use` with each work of a task that is not certain, and the name of its place.
template <typename Task, typename Use>
void for_each_uncertain(Task& task, const Use& use) {
  const auto one = [&](auto& work, const char* name) {
    if (work && work->law) use(*work, fmt::format("{}.{}", task.name, name));
  };
  one(task.hook, "hook");
  one(task.adjust, "adjust");
  one(task.release, "release");
  for (std::size_t i = 0; i < task.takes.size(); ++i) {
    if (!task.takes[i].law) continue;
    use(task.takes[i],
        i == 0 ? fmt::format("{}.takes", task.name) : fmt::format("{}.takes_{}", task.name, i + 1));
  }
}

}  // namespace

void draw_durations(PlanModel& plan, const SampleSpec& sample) {
  plan.sample = sample;
  const auto draw = [&](WorkSpec& work, const std::string& place) {
    work.duration = sampling::draw(*work.law, {sample.seed, sample.run, place});
  };
  const auto draw_dig = [&](TaskSpec& task) {
    if (!task.dig || task.dig->operation.uncertain_stages() == 0) return;
    task.dig->result =
        simulate(task.dig->operation, hauling::Draws{sample.seed, sample.run, task.name});
    task.takes.front().duration = static_cast<double>(task.dig->result.time) / hauling::kPerSecond;
  };
  for (TaskSpec& task : plan.tasks) {
    for_each_uncertain(task, draw);
    draw_dig(task);
    for (TaskSpec& choice : task.choices) {
      for_each_uncertain(choice, draw);
      draw_dig(choice);
    }
  }
  for (CalendarSpec& calendar : plan.calendars) calendar.weather = {{sample.seed, sample.run}};
}

std::vector<UncertainDuration> uncertain_durations(const PlanModel& plan) {
  std::vector<UncertainDuration> result;
  for (const TaskSpec& task : plan.tasks) {
    for_each_uncertain(task, [&](const WorkSpec& work, const std::string& place) {
      result.push_back({place, &*work.law});
    });
  }
  return result;
}

int count_uncertain(const PlanModel& plan) {
  int count = static_cast<int>(uncertain_durations(plan).size());
  for (const TaskSpec& task : plan.tasks) {
    if (task.dig) count += task.dig->operation.uncertain_stages();
    if (task.motion_dig) count += task.motion_dig->hauls.uncertain_stages();
  }
  return count;
}

bool loses_days(const PlanModel& plan) {
  return std::any_of(plan.calendars.begin(), plan.calendars.end(),
                     [](const CalendarSpec& each) { return each.loses_days(); });
}

bool has_breakdowns(const PlanModel& plan) {
  return std::any_of(plan.robots.begin(), plan.robots.end(),
                     [](const RobotSpec& each) { return each.breakdown.has_value(); });
}

}  // namespace rubicon::interpreter
