#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/scripted_run.hpp"

namespace rubicon::test {
namespace {

using interpreter::MotionStatus;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> log_of(const std::string& script,
                                const std::vector<std::pair<std::string, double>>& goal,
                                const std::function<bool(std::span<const double>)>& blocked = {}) {
  const Scenario setup = set_up(kGantry, script);
  PredicateWorld world;
  if (blocked) world.blocked = blocked;
  EventLog log;
  run(setup, setup.task({}, goal), world, &log);
  return log.lines;
}

TEST(Chain, GoesBackOneElementAfterASuccess) {
  EXPECT_THAT(log_of("chain { move_to(x, goal(x)), move_to(y, goal(y)) };", {{"x", 1}, {"y", 2}}),
              ElementsAre("goal 1 of 1", "chain {", "1 + move_to 1 0", "2 - move_to 1 0 at goal",
                          "3 + move_to 1 1", "4 - move_to 1 1 at goal", "5 + move_to 1 2",
                          "} chain reached 3"));
}

TEST(Chain, EndsAtEntryWhenItsGoalHolds) {
  EXPECT_THAT(log_of("chain { move_to(x, goal(x)), move_dir(y, 1) };", {{"x", 0}}),
              ElementsAre("goal 1 of 1", "chain {", "} chain reached 0"));
}

TEST(Chain, RunsAssignmentsForwardOnly) {
  // The second assignment runs each time the command before it fails, never on the way back.
  EXPECT_THAT(
      log_of("chain { var(a) = 1, move_to(x, 1), var(b) = y, move_to(y, 2) };", {{"x", 1}}),
      ElementsAre("goal 1 of 1", "chain {", "var(a) = 1", "1 + move_to 1 0",
                  "2 - move_to 1 0 at goal", "var(b) = 0", "3 + move_to 1 1",
                  "4 - move_to 1 1 at goal", "var(b) = 1", "5 + move_to 1 2", "} chain reached 3"));
}

TEST(First, StartsAgainAtItsFirstCommand) {
  // x may go on only while y is even, so the third element frees it; a chain would go back to the
  // second only.
  const auto lines = log_of("first { var(a) = 1, move_to(x, 2), wait } until (x >= 2);", {{"x", 2}},
                            [](std::span<const double>) { return false; });
  EXPECT_THAT(lines, ElementsAre("goal 1 of 1", "first {", "var(a) = 1", "1 + move_to 1 0",
                                 "2 + move_to 2 0", "} first reached 2"));
  const auto back = log_of("first { move_dir(x, 1), move_to(x, 0), move_to(y, 2) };", {},
                           [](std::span<const double> q) { return q[0] > 0.5; });
  EXPECT_THAT(
      back, ElementsAre("goal 1 of 1", "first {", "1 - move_dir 0 0 hit", "2 - move_to 0 0 at goal",
                        "3 + move_to 0 1", "4 - move_dir 0 1 hit", "5 - move_to 0 1 at goal",
                        "6 + move_to 0 2", "} first reached 2"));
}

TEST(Cycle, WrapsBackwardsFromTheFirstToTheLast) {
  const auto lines = log_of("cycle { move_dir(x, 1), move_dir(y, 1) } until (y >= 2);", {},
                            [](std::span<const double> q) { return q[0] > 1.5; });
  EXPECT_THAT(lines, ElementsAre("goal 1 of 1", "cycle {", "1 + move_dir 1 0", "2 + move_dir 1 1",
                                 "3 - move_dir 1 1 hit", "4 + move_dir 1 2", "} cycle reached 3"));
}

TEST(Cycle, IsExhaustedWhenAllItsCommandsFailInARow) {
  const auto lines = log_of("cycle { move_dir(x, 1), move_dir(y, 1) } until (y >= 2);", {},
                            [](std::span<const double> q) { return q[0] > 0.5 || q[1] > 0.5; });
  EXPECT_THAT(lines, ElementsAre("goal 1 of 1", "cycle {", "1 - move_dir 0 0 hit",
                                 "2 - move_dir 0 0 hit", "} cycle exhausted 0"));
}

TEST(Each, KeepsItsActiveElementAndStartsAgainWhenExhausted) {
  const auto lines =
      log_of("chain { each { move_dir(x, 1), move_dir(x, -1) }, move_dir(y, 1) } until (y >= 2);",
             {}, [](std::span<const double> q) { return q[0] > 1.5 || q[0] < -0.5; });
  EXPECT_THAT(lines,
              ElementsAre("goal 1 of 1", "chain {", "1 + move_dir 1 0", "2 - move_dir 1 0 hit",
                          "3 + move_dir 0 0", "4 - move_dir 0 0 hit", "5 + move_dir 0 1",
                          "6 + move_dir 1 1", "7 - move_dir 1 1 hit", "8 + move_dir 0 1",
                          "9 - move_dir 0 1 hit", "10 + move_dir 0 2", "} chain reached 6"));
}

TEST(Which, RunsTheFirstModuleWhoseLabelHolds) {
  const Scenario setup = set_up(kGantry, R"(
    which { night: dusk: chain { move_to(x, 1) }; when (y > 3): chain { move_to(x, 2) };
            default: chain { move_to(x, 3) }; };)");
  const auto end_x = [&](std::vector<std::string> situations, double y) {
    PredicateWorld world;
    interpreter::MotionTask task = setup.task({{"y", y}}, {{"x", 0}});
    task.situations = std::move(situations);
    return run(setup, task, world).q[0];
  };
  EXPECT_EQ(end_x({"dusk"}, 5), 1);
  EXPECT_EQ(end_x({}, 5), 2);
  EXPECT_EQ(end_x({}, 0), 3);
}

TEST(Nested, ALoopAtItsGoalFailsAsAnElement) {
  // The inner chain has nothing to do, so the outer one goes on to its second element and ends.
  EXPECT_THAT(log_of("chain { chain { move_to(x, 0) }, move_to(y, 1) };", {}),
              ElementsAre("goal 1 of 1", "chain {", "chain {", "} chain reached 0",
                          "1 + move_to 0 1", "} chain reached 1"));
}

TEST(Behaviour, SucceedsIfOneOfItsStatementsDid) {
  EXPECT_THAT(log_of(R"(behaviour both { move_to(x, 1); move_to(y, 1); }
                        chain { both, move_to(y, 1) };)",
                     {}),
              ElementsAre("goal 1 of 1", "chain {", "1 + move_to 1 0", "2 + move_to 1 1",
                          "} chain reached 1"));
}

TEST(Behaviour, ThatGoesOnWithoutMovingIsAnError) {
  std::string script = "behaviour b0 { var(a) = 1; }\n";
  for (int i = 1; i < 40; ++i) {
    script += "behaviour b" + std::to_string(i) + " { b" + std::to_string(i - 1) + "; b" +
              std::to_string(i - 1) + "; }\n";
  }
  const Scenario setup = set_up(kGantry, script + "b39;");
  PredicateWorld world;
  const auto end = run(setup, setup.task({}, {{"x", 1}}), world);
  EXPECT_EQ(end.status, MotionStatus::error);
  EXPECT_THAT(end.message, HasSubstr("without proposing any motion step"));
}

TEST(Wait, TakesOneTimeStepAndSucceeds) {
  EXPECT_THAT(
      log_of("chain { wait } until (time() >= 2);", {}),
      ElementsAre("goal 1 of 1", "chain {", "1 + wait t 1", "2 + wait t 2", "} chain reached 2"));
}

}  // namespace
}  // namespace rubicon::test
