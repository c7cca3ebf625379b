#include "src/simulation/taskplan/run_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::taskplan {
namespace {

using math::translation;
using nlohmann::ordered_json;
using schedule::kSecond;
using test::box_component;
using test::chain;
using test::crane_plan;
using test::goal_of;
using test::list;
using test::move_dir;
using test::move_task;
using test::move_to;
using testing::ElementsAre;
using testing::HasSubstr;

struct TracedRun {
  Schedule schedule;
  std::vector<ordered_json> records;
  std::vector<std::string> lines;

  std::vector<ordered_json> of_type(const std::string& type) const {
    std::vector<ordered_json> found;
    for (const ordered_json& record : records) {
      if (record.at("type") == type) found.push_back(record);
    }
    return found;
  }
};

TracedRun run_traced(const interpreter::PlanModel& plan) {
  test::Lines lines;
  const interpreter::SourceMap sources = test::numbered_lines();
  TracedRun ran;
  ran.schedule = run_plan(plan, sources, &lines);
  for (const std::string& line : lines.lines) ran.records.push_back(ordered_json::parse(line));
  ran.lines = lines.lines;
  return ran;
}

/// A short plan: the crane turns from jib.theta 0 to 60 at x 20, with a wall at 30 degrees.
interpreter::PlanModel over_the_wall(double wall_height) {
  interpreter::PlanModel plan = crane_plan();
  plan.short_form = true;
  plan.components.push_back(box_component("wall", {16, 3, wall_height},
                                          math::rotation_z_deg(30) * translation(20, 0, 0)));
  plan.robots[0].start = {0, 20, 6, 0};
  plan.robots[0].robot = test::crane(list(chain(list(move_to("jib.theta", goal_of("jib.theta"), 11),
                                                     move_dir("z", test::upwards(), 13)),
                                                10),
                                          chain(list(move_to("z", goal_of("z"), 16)), 15)));
  plan.carry = {{geometry::Box{{-2, -2, -4}, {2, 2, 0}}, math::Pose::Identity()}};
  plan.goal.emplace();
  plan.goal->values = {{0, 60}, {2, 6}};
  return plan;
}

TEST(ShortPlan, TheCraneRaisesItsLoadOverAWall) {
  const TracedRun ran = run_traced(over_the_wall(16.5));
  ASSERT_EQ(ran.schedule.tasks.size(), 1u);
  const TaskOutcome& task = ran.schedule.tasks[0];
  EXPECT_EQ(task.task, "site");
  EXPECT_EQ(task.result, TaskResult::done);
  EXPECT_EQ(task.reason, "");
  EXPECT_TRUE(ran.schedule.feasible);
  // 12 turning steps of 1 s, and lifting by 15 m and lowering again at 0.5 m/s.
  EXPECT_EQ(ran.schedule.process_time, (12 + 2 * 15 * 2) * kSecond);
  EXPECT_EQ(task.accepted, 12 + 30);
  const auto tries = ran.of_type("try");
  EXPECT_EQ(static_cast<int>(tries.size()), task.tried);
  const auto hit = std::find_if(tries.begin(), tries.end(),
                                [](const ordered_json& record) { return !record.at("ok"); });
  ASSERT_NE(hit, tries.end());
  EXPECT_EQ(hit->at("hit").dump(), R"(["load","wall"])");
  EXPECT_EQ(hit->at("line"), 11);
  EXPECT_EQ(hit->at("task"), "site");
  ASSERT_EQ(ran.of_type("end").size(), 1u);
  EXPECT_EQ(ran.of_type("end")[0].at("reached"), true);
  EXPECT_EQ(ran.of_type("end")[0].at("q").at("jib.theta"), 60);
}

TEST(ShortPlan, AWallTooHighIsNamedWithStepAndLine) {
  const TracedRun ran = run_traced(over_the_wall(43));
  const TaskOutcome& task = ran.schedule.tasks[0];
  EXPECT_EQ(task.result, TaskResult::ended_short);  // the script ended, short of its goal
  EXPECT_FALSE(ran.schedule.feasible);
  EXPECT_EQ(ran.of_type("task_end")[0].at("result"), "short");
  EXPECT_EQ(ran.of_type("end")[0].at("status"), "done");
  EXPECT_THAT(task.reason, HasSubstr("blocked by wall at step "));
  EXPECT_THAT(task.reason, HasSubstr("(jib.theta, line 11): load meets wall"));
  EXPECT_THAT(task.reason, HasSubstr("short of the goal"));
  EXPECT_EQ(ran.of_type("end")[0].at("reached"), false);
}

TEST(ShortPlan, WhatThePlanAllowsIsDone) {
  interpreter::PlanModel plan = over_the_wall(43);
  plan.within.values.push_back({0, 60});
  const TracedRun ran = run_traced(plan);
  EXPECT_EQ(ran.schedule.tasks[0].result, TaskResult::done) << ran.schedule.tasks[0].reason;
  EXPECT_TRUE(ran.schedule.feasible);
}

TEST(ShortPlan, ImpossibleStartsAreRejected) {
  interpreter::PlanModel plan = over_the_wall(16.5);
  plan.robots[0].start = {30, 20, 6, 0};
  const TracedRun ran = run_traced(plan);
  EXPECT_EQ(ran.schedule.tasks[0].result, TaskResult::rejected);
  EXPECT_FALSE(ran.schedule.feasible);
  EXPECT_THAT(ran.schedule.tasks[0].reason, HasSubstr("start in collision"));
}

/// Two blocks side by side on the ground; the first is set on a slab by crane and crew.
interpreter::PlanModel two_blocks() {
  interpreter::PlanModel plan = crane_plan();
  plan.site.push_back({geometry::Box{{-60, -60, -1}, {60, 60, 0}}, math::Pose::Identity()});
  plan.components.push_back(box_component("block_1", {2, 2, 3}, translation(10, 0, 0)));
  plan.components.push_back(box_component("block_2", {2, 2, 3}, translation(15, 0, 0)));
  plan.tasks.push_back(move_task("set_1", 0, translation(0, 20, 0)));
  plan.tasks.push_back(move_task("set_2", 1, translation(2, 20, 0)));
  return plan;
}

TEST(FullPlan, MovesAComponentAndCountsTheTime) {
  interpreter::PlanModel plan = two_blocks();
  plan.tasks.resize(1);
  plan.tasks[0].hook = interpreter::WorkSpec{240, 0, {}};
  plan.tasks[0].adjust = interpreter::WorkSpec{360, 0, {}};
  plan.tasks[0].release = interpreter::WorkSpec{120, -1, {}};
  plan.tasks[0].takes = {{30, -1, {}}};
  const TracedRun ran = run_traced(plan);
  const TaskOutcome& task = ran.schedule.tasks[0];
  EXPECT_EQ(task.result, TaskResult::done) << task.reason;
  EXPECT_EQ(task.robot, "crane");
  EXPECT_THAT(task.crews, ElementsAre("riggers"));
  EXPECT_EQ(task.work_time, (240 + 360 + 120 + 30) * kSecond);
  // Grip: 17 m down at 0.5 m/s. Carry: 17 up, 90 degrees at 5 and 10 m at 1 per second, the hook
  // turned back by 90 degrees at 15, 15 m down to 2 m above. Place: up to 20 again, 17 down.
  EXPECT_EQ(task.motion_time, (34 + 34 + 18 + 10 + 6 + 30 + 30 + 34) * kSecond);
  EXPECT_EQ(task.duration, task.motion_time + task.work_time);
  EXPECT_EQ(task.motions, 3);
  std::vector<bool> reached;
  for (const ordered_json& record : ran.records) {
    if (record["type"] == "end") reached.push_back(record["reached"]);
  }
  EXPECT_THAT(reached, ElementsAre(true, false, true));  // the carrying one is short on purpose
  std::vector<std::string> types;
  for (const ordered_json& record : ran.records) {
    for (const char* type : {"task_start", "attach", "end", "detach", "task_end"}) {
      if (record.at("type") == type) types.push_back(type);
    }
  }
  EXPECT_THAT(types,
              ElementsAre("task_start", "end", "attach", "end", "end", "detach", "task_end"));
  EXPECT_EQ(ran.of_type("attach")[0].at("t"), 34 + 240);
  const auto pose = ran.of_type("detach")[0].at("pose").get<std::vector<double>>();
  EXPECT_NEAR(pose[0], 1, 1e-6);
  EXPECT_NEAR(pose[3], 0, 1e-6);
  EXPECT_NEAR(pose[7], 20, 1e-6);
  EXPECT_NEAR(pose[11], 0, 1e-6);
  // Attempts are numbered through the task.
  const auto tries = ran.of_type("try");
  for (std::size_t i = 0; i < tries.size(); ++i) {
    EXPECT_EQ(tries[i].at("n"), static_cast<int>(i) + 1);
  }
}

TEST(FullPlan, NeighboursMayTouchAndAPlacedOneIsInTheWay) {
  interpreter::PlanModel plan = two_blocks();
  const TracedRun ran = run_traced(plan);  // set_2 exactly beside block_1
  EXPECT_EQ(ran.schedule.tasks[0].result, TaskResult::done) << ran.schedule.tasks[0].reason;
  EXPECT_EQ(ran.schedule.tasks[1].result, TaskResult::done) << ran.schedule.tasks[1].reason;
  EXPECT_EQ(ran.schedule.tasks[1].start, ran.schedule.tasks[0].duration);

  plan.tasks[1].X_WO_goal = translation(1.5, 20, 0);  // half a metre into it
  const TracedRun blocked = run_traced(plan);
  EXPECT_EQ(blocked.schedule.tasks[1].result, TaskResult::rejected);
  EXPECT_THAT(blocked.schedule.tasks[1].reason, HasSubstr("blocked by block_1 at step "));
  EXPECT_THAT(blocked.schedule.tasks[1].reason, HasSubstr("block_2 meets block_1"));
  EXPECT_THAT(blocked.schedule.tasks[1].reason, HasSubstr("while placing block_2"));
}

TEST(FullPlan, ARejectedTaskIsUndoneAndWhatDependsOnItIsNotReached) {
  interpreter::PlanModel plan = two_blocks();
  plan.components[0].X_WO = translation(70, 0, 0);  // out of reach
  plan.tasks[1].after = {{0, interpreter::LinkType::FS, 0, {}}};
  plan.tasks.push_back(move_task("set_3", 1, translation(0, -20, 0)));
  plan.tasks[2].after = {{1, interpreter::LinkType::FS, 0, {}}};
  plan.tasks.push_back(move_task("set_4", 1, translation(0, -20, 0)));
  const TracedRun ran = run_traced(plan);
  const auto& tasks = ran.schedule.tasks;
  ASSERT_EQ(tasks.size(), 4u);
  EXPECT_EQ(tasks[0].result, TaskResult::rejected);
  EXPECT_THAT(tasks[0].reason, HasSubstr("goal out of reach"));
  EXPECT_EQ(tasks[0].duration, 0);
  EXPECT_EQ(tasks[1].result, TaskResult::not_reached);
  EXPECT_EQ(tasks[1].reason, "it comes after set_1, which is rejected");
  EXPECT_EQ(tasks[2].result, TaskResult::not_reached);
  EXPECT_EQ(tasks[2].reason,
            "it comes after set_2, which is not reached because set_1 is rejected");
  EXPECT_EQ(tasks[3].result, TaskResult::done) << tasks[3].reason;
  EXPECT_EQ(tasks[3].start, 0);
  EXPECT_FALSE(ran.schedule.feasible);
  const auto ends = ran.of_type("task_end");
  ASSERT_EQ(ends.size(), 4u);
  EXPECT_EQ(ends[1].at("result"), "not reached");
}

TEST(FullPlan, WhatStoppedTheCarryingIsTheReasonOfAPlacingThatFallsShort) {
  interpreter::PlanModel plan = two_blocks();
  plan.tasks.resize(1);
  plan.components.push_back(
      box_component("wall", {12, 1, 2}, math::rotation_z_deg(45) * translation(10, 0, 0)));
  // Only the carrying motion turns; the placing one has nothing to do and so meets nothing itself.
  plan.robots[0].start = {0, 10, 3, 0};
  plan.robots[0].robot = test::crane(
      list(test::which("place", chain(list(move_to("z", goal_of("z"), 7)), 7),
                       chain(list(move_to("jib.theta", goal_of("jib.theta"), 9)), 9), 6)));
  plan.tasks[0].X_WO_goal = math::rotation_z_deg(90) * translation(10, 0, 0);
  const TracedRun ran = run_traced(plan);
  EXPECT_EQ(ran.schedule.tasks[0].result, TaskResult::rejected);
  const std::string& reason = ran.schedule.tasks[0].reason;
  EXPECT_THAT(reason, HasSubstr("(jib.theta, line 9): block_1 meets wall"));
  EXPECT_THAT(reason, HasSubstr("while placing block_1"));
}

TEST(FullPlan, ATaskThatFailsWithItsLoadPutsItBack) {
  interpreter::PlanModel plan = two_blocks();
  plan.components.push_back(box_component("tower", {2, 2, 3}, translation(0, 20, 0)));
  plan.tasks[0].hook = interpreter::WorkSpec{240, 0, {}};
  const TracedRun ran = run_traced(plan);  // set_1 would set block_1 into the tower
  EXPECT_EQ(ran.schedule.tasks[0].result, TaskResult::rejected);
  EXPECT_GT(ran.schedule.tasks[0].tried, 0);
  EXPECT_EQ(ran.of_type("task_end")[0].at("t"), 0);
  EXPECT_EQ(ran.of_type("attach").size(), 2u);
  EXPECT_EQ(ran.of_type("detach").size(), 1u);
  EXPECT_EQ(ran.schedule.tasks[1].start, 0);
  EXPECT_EQ(ran.schedule.tasks[1].result, TaskResult::done) << ran.schedule.tasks[1].reason;

  // Also beside other machines the attempt leaves no mark.
  plan.robots.push_back(plan.robots[0]);
  plan.robots[1].name = "other";
  plan.robots[1].X_WM = translation(0, -100, 0);
  const TracedRun two = run_traced(plan);
  EXPECT_EQ(two.schedule.tasks[0].result, TaskResult::rejected);
  EXPECT_EQ(two.schedule.tasks[0].duration, 0);
  EXPECT_EQ(two.schedule.tasks[1].start, 0);
}

TEST(FullPlan, MotionsThatHoldMakeNoStep) {
  interpreter::PlanModel plan = two_blocks();
  plan.robots[0].start = {0, 10, 3, 0};
  plan.tasks.resize(1);
  plan.tasks[0].X_WO_goal = plan.components[0].X_WO;
  const TracedRun ran = run_traced(plan);
  EXPECT_EQ(ran.schedule.tasks[0].result, TaskResult::done);
  EXPECT_EQ(ran.schedule.tasks[0].tried, 0);
  EXPECT_EQ(ran.of_type("end").size(), 3u);
}

TEST(FullPlan, CrewWorkGoAndRemove) {
  interpreter::PlanModel plan = two_blocks();
  plan.tasks.clear();
  interpreter::TaskSpec strip;
  strip.name = "strip";
  strip.crews = {0};
  strip.takes = {{600, 0, {}}};
  strip.remove = {0};
  interpreter::TaskSpec aside;
  aside.name = "aside";
  aside.robot = 0;
  aside.go.emplace();
  aside.go->values = {{2, 1}};  // where block_1 stood
  aside.after = {{0, interpreter::LinkType::FS, 0, {}}};
  interpreter::TaskSpec again = strip;
  again.name = "again";
  again.after = {{1, interpreter::LinkType::FS, 0, {}}};
  plan.tasks = {strip, aside, again};
  const TracedRun ran = run_traced(plan);
  const auto& tasks = ran.schedule.tasks;
  EXPECT_EQ(tasks[0].result, TaskResult::done);
  EXPECT_EQ(tasks[0].duration, 600 * kSecond);
  EXPECT_EQ(tasks[0].robot, "");
  EXPECT_EQ(tasks[1].result, TaskResult::done) << tasks[1].reason;
  EXPECT_EQ(tasks[1].duration, 38 * kSecond);
  EXPECT_EQ(tasks[2].result, TaskResult::rejected);
  EXPECT_EQ(tasks[2].reason, "block_1 is not on the site any more");
  EXPECT_EQ(ran.schedule.process_time, 638 * kSecond);
}

TEST(FullPlan, WayPointsApplyToTheCarryingMotion) {
  interpreter::PlanModel plan = two_blocks();
  plan.tasks.resize(1);
  plan.tasks[0].via.emplace_back();
  plan.tasks[0].via[0].values = {{0, 45}};
  const TracedRun ran = run_traced(plan);
  EXPECT_EQ(ran.schedule.tasks[0].result, TaskResult::done) << ran.schedule.tasks[0].reason;
  const auto goals = ran.of_type("goal");
  ASSERT_EQ(goals.size(), 4u);
  EXPECT_EQ(goals[1].at("n"), 2);
  EXPECT_EQ(goals[3].at("n"), 1);
}

TEST(FullPlan, TooHeavyALoadIsNotLifted) {
  interpreter::PlanModel plan = two_blocks();
  auto robot = test::crane(test::lifting_script());
  robot->model.capacity = {{5, 5000}, {10, 2000}, {50, 500}};
  plan.robots[0].robot = robot;
  plan.components[0].mass = 4000;
  const TracedRun ran = run_traced(plan);
  EXPECT_EQ(ran.schedule.tasks[0].result, TaskResult::rejected);
  EXPECT_EQ(ran.schedule.tasks[0].reason,
            "too heavy: block_1 has 4000 kg, the load chart of crane allows 2000 kg at 10 m, where "
            "it is taken up, and 1625 kg at 20 m, where it is set down");
  EXPECT_EQ(ran.schedule.tasks[0].tried, 0);
}

TEST(FullPlan, TooHeavyWhereItIsSetDownIsToldBeforeAnythingMoves) {
  interpreter::PlanModel plan = two_blocks();
  auto robot = test::crane(test::lifting_script());
  robot->model.capacity = {{5, 5000}, {10, 2000}, {50, 500}};
  plan.robots[0].robot = robot;
  plan.components[0].mass = 1500;
  plan.tasks[0].X_WO_goal = translation(0, 30, 0);
  const TracedRun ran = run_traced(plan);
  EXPECT_EQ(ran.schedule.tasks[0].result, TaskResult::rejected);
  EXPECT_EQ(ran.schedule.tasks[0].reason,
            "too heavy: block_1 has 1500 kg, the load chart of crane allows 2000 kg at 10 m, where "
            "it is taken up, and 1250 kg at 30 m, where it is set down");
  EXPECT_EQ(ran.schedule.tasks[0].tried, 0);
}

TEST(FullPlan, SameInputSameBytes) {
  const interpreter::PlanModel plan = two_blocks();
  EXPECT_EQ(run_traced(plan).lines, run_traced(plan).lines);
}

}  // namespace
}  // namespace rubicon::taskplan
