// Crew work as the simulation runs it, against schedules worked by hand and against the calculation
// of src/simulation/schedule.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "src/simulation/taskplan/run_plan.hpp"
#include "tests/unit/schedule/calendar_cases.hpp"
#include "tests/unit/schedule/link_cases.hpp"
#include "tests/unit/schedule/random_network.hpp"
#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::taskplan {
namespace {

using schedule::kHour;
using schedule::kSecond;

interpreter::CalendarSpec calendar_spec(const std::string& name,
                                        const schedule::CalendarRules& rules) {
  interpreter::CalendarSpec spec{rules, {}};
  spec.name = name;
  return spec;
}

double seconds(Ticks ticks) { return static_cast<double>(ticks) / static_cast<double>(kSecond); }

interpreter::TaskSpec crew_task(const std::string& name, Ticks work, std::vector<int> crews) {
  interpreter::TaskSpec task;
  task.name = name;
  task.crews = std::move(crews);
  if (work > 0) task.takes = {{seconds(work), -1, {}}};
  return task;
}

std::map<std::string, TaskOutcome> outcomes(const interpreter::PlanModel& plan) {
  const interpreter::SourceMap sources;
  std::map<std::string, TaskOutcome> result;
  for (const TaskOutcome& task : run_plan(plan, sources, nullptr).tasks) result[task.task] = task;
  return result;
}

TEST(CrewSchedule, LinksAreAsWorkedByHand) {
  int count = 0;
  for (const test::LinkCases& group : test::link_cases()) {
    for (const test::LinkCase& given : group.cases) {
      if (given.clock == schedule::LagClock::working) continue;  // plan files have none
      interpreter::PlanModel plan;
      plan.name = "links";
      plan.start_at = schedule::parse_civil_time(group.start);
      if (group.rules) plan.calendars.push_back(calendar_spec("site", *group.rules));
      for (const char* name : {"first", "second", "third"}) {
        plan.crews.push_back({name, 1, {}, group.rules ? "site" : "", {}});
      }
      plan.tasks = {crew_task("lead", 10 * kHour, {0}), crew_task("a", 6 * kHour, {1}),
                    crew_task("b", 4 * kHour, {2})};
      plan.tasks[1].after = {{0, interpreter::LinkType::FS, 0, {}}};
      plan.tasks[2].after = {{1, given.type, given.lag, {}}};
      const TaskOutcome b = outcomes(plan).at("b");
      EXPECT_EQ(fmt::format("{} .. {}", test::moment_text(group.start, b.start),
                            test::moment_text(group.start, b.start + b.duration)),
                given.expected)
          << group.name << " " << given.name << ": " << given.why;
      EXPECT_EQ(b.work_time, 4 * kHour);
      ++count;
    }
  }
  EXPECT_GE(count, 40);
}

/// The network as a plan; `far` puts a zone far from everything on each work, which changes nothing
/// but that nothing can be precomputed.
interpreter::PlanModel plan_of(const schedule::Network& network, bool far) {
  interpreter::PlanModel plan;
  plan.name = "random";
  plan.start_at = schedule::parse_civil_time(test::kRandomStart);
  plan.calendars = {calendar_spec("daily", test::daily_shift()),
                    calendar_spec("weekday", test::weekday_shift())};
  for (const schedule::NetworkResource& resource : network.resources) {
    const std::string calendar =
        resource.calendar < 0 ? ""
                              : plan.calendars[static_cast<std::size_t>(resource.calendar)].name;
    plan.crews.push_back({resource.name, 1, {}, calendar, {}});
  }
  for (const schedule::NetworkTask& each : network.tasks) {
    interpreter::TaskSpec& task =
        plan.tasks.emplace_back(crew_task(each.name, each.work, each.resources));
    task.priority = each.priority;
    for (const schedule::Link& link : each.after) {
      task.after.push_back({link.task, link.type, link.lag, {}});
    }
    if (far && each.work > 0) {
      task.zones.push_back({geometry::Box{{0, 0, 0}, {1, 1, 1}}, math::translation(900, 0, 0)});
    }
  }
  return plan;
}

void expect_same(const schedule::Network& network, bool far, int number) {
  const auto times = std::get<schedule::NetworkTimes>(schedule::times_of(network));
  const auto ran = outcomes(plan_of(network, far));
  for (std::size_t i = 0; i < network.tasks.size(); ++i) {
    const TaskOutcome& task = ran.at(network.tasks[i].name);
    EXPECT_EQ(task.result, TaskResult::done) << task.reason;
    EXPECT_EQ(task.start, times.tasks[i].start) << "network " << number << ", " << task.task;
    EXPECT_EQ(task.start + task.duration, times.tasks[i].finish)
        << "network " << number << ", " << task.task;
    const WaitTimes& waits = task.waits;
    EXPECT_EQ(waits.predecessor + waits.resource + waits.machine + waits.shift + task.work_time,
              task.start + task.duration)
        << "network " << number << ", " << task.task;
  }
}

schedule::Network elapsed(schedule::Network network) {
  for (schedule::NetworkTask& task : network.tasks) {
    for (schedule::Link& link : task.after) link.clock = schedule::LagClock::elapsed;
  }
  return network;
}

TEST(CrewSchedule, WhatCanBePrecomputedIsAsCalculated) {
  test::Dice dice(11);
  for (int i = 0; i < 200; ++i) expect_same(elapsed(dice.network({})), false, i);
}

TEST(CrewSchedule, EventByEventIsAsCalculatedWhereNoLinkLooksAhead) {
  test::Dice dice(12);
  for (int i = 0; i < 200; ++i) {
    expect_same(elapsed(dice.network({true, true, true, true})), true, i);
  }
}

}  // namespace
}  // namespace rubicon::taskplan
