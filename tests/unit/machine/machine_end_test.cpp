#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/scripted_run.hpp"

namespace rubicon::test {
namespace {

using interpreter::MotionStatus;
using testing::HasSubstr;

TEST(End, SaysWhatIsShortOfTheGoal) {
  const Scenario setup = set_up(kGantry, "chain { move_to(x, goal(x) + 3) };");
  PredicateWorld world;
  auto task = setup.task({}, {{"x", 2}, {"y", 1}});
  auto end = run(setup, task, world);
  EXPECT_EQ(end.status, MotionStatus::done);
  EXPECT_FALSE(end.reached);
  EXPECT_EQ(end.message, "short of the goal: x is 3 m above the goal, y is 1 m below the goal");
  EXPECT_EQ(end.residual, (std::vector<std::pair<int, double>>{{0, -3}, {1, 1}}));
  task.within.values = {{0, 3}, {1, 1}};
  EXPECT_TRUE(run(setup, task, world).reached);
}

TEST(End, LivelockIsExactWithItsPeriod) {
  const Scenario setup = set_up(kGantry, "chain { move_to(x, goal(x)), move_to(x, max(x)) };");
  PredicateWorld world;
  const auto end = run(setup, setup.task({{"x", 8}}, {{"x", 10}}), world);
  EXPECT_EQ(end.status, MotionStatus::livelock);
  EXPECT_EQ(end.period, 2);
  EXPECT_EQ(end.tries, 5);
  EXPECT_EQ(end.accepted, 4);
  EXPECT_THAT(
      end.message,
      HasSubstr("after 4 steps the robot is back in the state it had after 2 steps (period 2) "
                "at move_to(x, goal(x))"));
}

TEST(End, WaitingInAStaticWorldIsALivelockAtOnce) {
  const Scenario setup = set_up(kGantry, "chain { move_to(x, goal(x)), wait };");
  PredicateWorld world;
  world.blocked = [](std::span<const double> q) { return q[0] > 0.5; };
  const auto end = run(setup, setup.task({}, {{"x", 3}}), world);
  EXPECT_EQ(end.status, MotionStatus::livelock);
  // the first round also remembers that the chain has moved
  EXPECT_EQ(end.tries, 4);
}

TEST(End, TimeInTheScriptIsPartOfTheState) {
  const Scenario setup = set_up(kGantry, "chain { wait } until (time() > 60);");
  PredicateWorld world;
  const auto end = run(setup, setup.task({}, {{"x", 0}}), world);
  EXPECT_EQ(end.status, MotionStatus::done);
  EXPECT_EQ(end.tries, 61);
}

TEST(End, AChangedWorldForgetsWhatWasSeen) {
  const Scenario setup = set_up(kGantry, "chain { move_to(x, goal(x)), wait };");
  PredicateWorld world;
  world.blocked = [&](std::span<const double> q) { return q[0] > 0.5 && world.changes < 20; };
  interpreter::Machine machine(*setup.program, setup.task({}, {{"x", 3}}));
  while (machine.advance(world, nullptr)) ++world.changes;
  EXPECT_EQ(machine.end().status, MotionStatus::done);
  EXPECT_TRUE(machine.end().reached);
}

TEST(End, CirclingIsFoundWhereTheStateNeverComesBackExactly) {
  // Turning by an irrational-like step: near the same places for ever, never exactly there.
  const Scenario setup =
      set_up(R"(robot r {
    body b {
      param x step(1);
      param y;
      param theta cyclic step(80.7318);
      rule x <- x + x_s * cos(theta);
      rule y <- y + x_s * sin(theta);
      frame trans(x, y, 0) * rotz(theta);
    }
    tool b;
    behaviour "s.motion";
  })",
             "cycle { move_dir(theta, 1), move_dir(x, 1) } until (dist() > 100); ");
  PredicateWorld world;
  auto task = setup.task({}, {{"x", 0}});
  task.budget = 1e6;
  EXPECT_EQ(run(setup, task, world).status, MotionStatus::circling);
}

TEST(End, BudgetStopsTheRest) {
  const Scenario setup = set_up(R"(robot r {
    body b { param x step(1); frame trans(x, 0, 0); }
    tool b;
    behaviour "s.motion";
  })",
                                "chain { move_dir(x, 1) };");
  PredicateWorld world;
  auto task = setup.task({}, {{"x", 0}});
  task.budget = 250;
  const auto end = run(setup, task, world);
  EXPECT_EQ(end.status, MotionStatus::budget);
  EXPECT_EQ(end.tries, 250);
  EXPECT_EQ(end.q[0], 250);
}

TEST(End, StartBlockedAndGoalImpossibleAreFoundBeforeMoving) {
  const Scenario setup = set_up(kGantry, "chain { move_to(x, goal(x)) };");
  PredicateWorld world;
  world.blocked = [](std::span<const double> q) { return q[0] < 0.5; };
  auto end = run(setup, setup.task({}, {{"x", 3}}), world);
  EXPECT_EQ(end.status, MotionStatus::start_blocked);
  EXPECT_EQ(end.message, "start in collision: robot.body meets wall");
  world.blocked = [](std::span<const double>) { return false; };
  auto task = setup.task({}, {});
  task.goals[0].X_WG = math::translation(3, 4, 5);
  end = run(setup, task, world);
  EXPECT_EQ(end.status, MotionStatus::goal_impossible);
  EXPECT_THAT(end.message, HasSubstr("the nearest pose is 5 m"));
  // Only a turn is missing that this robot cannot make.
  task.goals[0].X_WG = math::translation(3, 0, 0) * math::rotation_z_deg(90);
  end = run(setup, task, world);
  EXPECT_EQ(end.status, MotionStatus::goal_impossible);
  EXPECT_THAT(end.message, HasSubstr("90 degrees off; no swivel: the turn about z is not free; use "
                                     "within or add one"));
  // What is only rounding is not shown to people.
  task.goals[0].X_WG = math::translation(3, 4, 5) * math::rotation_z_deg(1e-9);
  end = run(setup, task, world);
  EXPECT_THAT(end.message, HasSubstr("the nearest pose is 5 m and 0 degrees off"));
  EXPECT_EQ(end.tries, 0);
}

TEST(End, RunTimeErrorsStopAtTheirPlace) {
  for (const auto& [script, message] : std::vector<std::pair<std::string, std::string>>{
           {"move_to(x, 1 / (x - x));", "division by zero"},
           {"move_to(x, 1e308 * (10 + x));", "the value is not finite"}}) {
    const Scenario setup = set_up(kGantry, script);
    PredicateWorld world;
    const auto end = run(setup, setup.task({}, {{"x", 1}}), world);
    EXPECT_EQ(end.status, MotionStatus::error);
    EXPECT_EQ(end.message, message);
    EXPECT_GT(end.span.end, end.span.begin);
  }
}

TEST(Via, RunsTheScriptOncePerWayPointWithFreshVariables) {
  const Scenario setup = set_up(kGantry, R"(
    chain { move_to(x, goal(x)), move_to(y, goal(y)) };
    which { via: var(passed) = 1; default: var(last) = x; };)");
  PredicateWorld world;
  EventLog log;
  auto task = setup.task({}, {{"x", 1}});
  task.goals.insert(task.goals.begin(), interpreter::GoalSpec{});
  task.goals[0].values = {{1, 1}};
  const auto end = run(setup, task, world, &log);
  EXPECT_TRUE(end.reached);
  ASSERT_EQ(end.variables.size(), 1u);
  EXPECT_EQ(end.variables[0].first, "last");
  EXPECT_THAT(log.lines, testing::Contains("goal 2 of 2"));
  EXPECT_THAT(log.lines, testing::Contains("which via"));
}

}  // namespace
}  // namespace rubicon::test
