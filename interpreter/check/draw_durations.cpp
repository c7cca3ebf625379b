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

double drawn_work(const WorkSpec& work, const std::string& place, const SampleSpec& sample) {
  return sampling::draw(*work.law, {sample.seed, sample.run, place});
}

hauling::Result drawn_dig(const TaskSpec& task, const SampleSpec& sample) {
  return simulate(task.dig->operation, hauling::Draws{sample.seed, sample.run, task.name});
}

/// s
double work_of(const hauling::Result& dig) {
  return static_cast<double>(dig.time) / hauling::kPerSecond;
}

/// Calls `use_work` with each work that is drawn and its place, `use_dig` with each task whose dig
/// is; in one order for all that number and draw.
template <typename Plan, typename UseWork, typename UseDig>
void for_each_draw(Plan& plan, const UseWork& use_work, const UseDig& use_dig) {
  const auto one = [&](auto& task) {
    for_each_uncertain(task, use_work);
    if (task.dig && task.dig->operation.uncertain_stages() > 0) use_dig(task);
  };
  for (auto& task : plan.tasks) {
    one(task);
    for (auto& choice : task.choices) one(choice);
  }
}

}  // namespace

void draw_durations(PlanModel& plan, const SampleSpec& sample) {
  plan.sample = sample;
  for_each_draw(
      plan,
      [&](WorkSpec& work, const std::string& place) {
        work.duration = drawn_work(work, place, sample);
      },
      [&](TaskSpec& task) {
        task.dig->result = drawn_dig(task, sample);
        task.takes.front().duration = work_of(task.dig->result);
      });
  for (CalendarSpec& calendar : plan.calendars) calendar.weather = {{sample.seed, sample.run}};
}

void number_draws(PlanModel& plan) {
  int works = 0;
  int digs = 0;
  for_each_draw(
      plan, [&](WorkSpec& work, const std::string&) { work.draw = works++; },
      [&](TaskSpec& task) {
        task.dig->draw = digs++;
        task.takes.front().draw = works++;
      });
}

Draws draws_of(const PlanModel& plan, const SampleSpec& sample) {
  Draws draws;
  draws.sample = sample;
  for_each_draw(
      plan,
      [&](const WorkSpec& work, const std::string& place) {
        draws.durations.push_back(drawn_work(work, place, sample));
      },
      [&](const TaskSpec& task) {
        draws.digs.push_back(drawn_dig(task, sample));
        draws.durations.push_back(work_of(draws.digs.back()));
      });
  return draws;
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
