#include "src/results/report/schedule_reader.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "interpreter/check/plan_model.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/results/report/schedule_text.hpp"
#include "src/simulation/taskplan/run_plan.hpp"
#include "tests/support/places.hpp"

namespace rubicon::report {
namespace {

using taskplan::Schedule;
using taskplan::TaskResult;

Schedule run(const std::string& path) {
  interpreter::SourceMap sources;
  files::DiskFiles disk;
  interpreter::Diagnostics diagnostics;
  const auto plan = load_plan(test::source_dir() + "/" + path, sources, disk, diagnostics);
  EXPECT_TRUE(plan) << path;
  taskplan::RunOptions options;
  options.detail = trace::TraceDetail::none;
  return taskplan::run_plan(*plan, sources, nullptr, options);
}

/// Everything that can stand in a schedule, with names that need quotes.
Schedule full_schedule() {
  Schedule schedule;
  schedule.start_at = {{2026, 3, 2}, 7 * 60};
  schedule.currency = "\"<€>\"";
  schedule.costed = true;
  schedule.cost = 0.1 + 0.2;
  schedule.has_kinds = schedule.burns_fuel = schedule.pays_fuel = true;
  schedule.cost_by_kind = {0.1, 0, 0, 0, 0.2, 0, 0};
  schedule.fuel = 0.125;
  schedule.process_time = 26'000'000'123'456'789;
  taskplan::TaskOutcome task;
  task.task = "a \"b\"\n\x01";
  task.robot = "crane";
  task.crews = {"riggers", "masons"};
  task.start = 26'000'000'123'456'788;
  task.duration = 1;
  task.motion_time = 3;
  task.work_time = 4;
  task.waits = {5, 6, 7, 8};
  task.cost = 1e-7;
  task.fuel = 0.125;
  task.tried = 9;
  task.accepted = 8;
  task.component = "panel \"1\"";
  task.attributes = {{"name", "Wand \"Nord\", links"}, {"fire", "60 min"}};
  schedule.tasks.push_back(task);
  task.attributes.clear();
  task.component.clear();
  task.parking = true;
  task.result = TaskResult::rejected;
  task.reason = "blocked";
  schedule.tasks.push_back(task);
  schedule.resources.push_back({"crane", true, 1, 2, 30, 20, 40, 12.5, 3, 0.125});
  schedule.resources.push_back(
      {"riggers", false, 2.5, 2, 30, 20, 0, std::nullopt, 0, std::nullopt});
  schedule.critical.push_back({"a", true, "a starts with the plan"});
  schedule.components.push_back({"panel \"1\"", {{"storey", "0"}, {"fire", "90 min"}}});
  return schedule;
}

TEST(ScheduleReader, GivesTheSameTextAgain) {
  const std::string text = schedule_json(full_schedule());
  EXPECT_EQ(schedule_json(schedule_from_json(text)), text);
  EXPECT_EQ(schedule_csv(schedule_from_json(text)), schedule_csv(full_schedule()));
  EXPECT_EQ(schedule_table(schedule_from_json(text)), schedule_table(full_schedule()));
  EXPECT_EQ(schedule_from_json(text).tasks.front().crews, full_schedule().tasks.front().crews);
  const std::string empty = schedule_json(Schedule{});
  EXPECT_EQ(schedule_json(schedule_from_json(empty)), empty);
}

TEST(ScheduleReader, ReadsTheResultsOfShippedPlans) {
  for (const char* path :
       {"taskplans/unit.plan", "taskplans/two_cranes.plan", "taskplans/people_below.plan",
        "taskplans/crane_and_trucks.plan", "taskplans/three_tow_motors.plan",
        "taskplans/residential.plan", "examples/01_one_step_at_a_time/site.plan",
        "examples/08_what_cannot_be_done/site.plan"}) {
    const Schedule schedule = run(path);
    const std::string text = schedule_json(schedule);
    const Schedule read = schedule_from_json(text);
    EXPECT_EQ(schedule_json(read), text) << path;
    EXPECT_EQ(schedule_csv(read), schedule_csv(schedule)) << path;
    EXPECT_EQ(read.feasible, schedule.feasible) << path;
  }
}

TEST(ScheduleReader, RefusesWhatIsNoSchedule) {
  const std::string good = schedule_json(full_schedule());
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return place == std::string::npos ? text : text.replace(place, from.size(), to);
  };
  for (const std::string& bad :
       {std::string("{}"), std::string("[]"), good.substr(0, good.size() / 2),
        with("\"done\"", "\"fine\""), with("\"kind\":\"robot\"", "\"kind\":\"dog\""),
        with("2026-03-02", "2026-02-30"), with("\"start\":26000000.123456788", "\"start\":-1"),
        with("\"tried\":9", "\"tried\":1e99"), with("\"size\":2.5", "\"size\":1e300"),
        with("\"critical\"", "\"cricital\"")}) {
    EXPECT_THROW(schedule_from_json(bad), std::invalid_argument) << bad;
  }
  for (std::size_t length = 0; length + 2 < good.size(); length += 7) {
    EXPECT_THROW(schedule_from_json(good.substr(0, length)), std::invalid_argument) << length;
  }
}

}  // namespace
}  // namespace rubicon::report
