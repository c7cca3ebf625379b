// Waiting is bounded for every script, also for one that counts or looks at the clock, so that no
// state ever comes back: what it waits counts against its budget until somebody makes progress.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/taskplan/run_plan.hpp"
#include "tests/support/memory_files.hpp"
#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::taskplan {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string car(const std::string& script) {
  return R"(robot car {
  body car {
    param x range(-100, 100) step(1) speed(1 m/s);
    frame trans(x, 0, 0);
    shape box(-0.5, -0.5, 0, 0.5, 0.5, 1);
  }
  tool car;
  behaviour { )" +
         script + " }\n}\n";
}

constexpr const char* kPlainWait = "chain { move_to(x, goal(x)), wait };";
constexpr const char* kCounting =
    "var(n) = 0; chain { move_to(x, goal(x)), var(n) = var(n) + 1, wait };";

/// A plan with robots of the files left.robot and right.robot; every task by its name.
std::map<std::string, TaskOutcome> run(const std::string& items, const std::string& left,
                                       const std::string& right) {
  test::MemoryFiles files({{"site.plan", "plan site {\n" + items + "\n}\n"},
                           {"left.robot", car(left)},
                           {"right.robot", car(right)}});
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const auto plan = interpreter::load_plan("site.plan", sources, files, diagnostics);
  if (!plan) {
    for (const auto& each : diagnostics.sorted()) ADD_FAILURE() << each.code << each.message;
    return {};
  }
  std::map<std::string, TaskOutcome> tasks;
  test::Lines lines;
  for (TaskOutcome& task : run_plan(*plan, sources, &lines).tasks) {
    tasks[task.task] = std::move(task);
  }
  return tasks;
}

/// Two machines that face each other in a corridor, each on its way past the other.
std::map<std::string, TaskOutcome> run_corridor(const std::string& left, const std::string& right) {
  return run(R"(
    budget 60;
    robot left "left.robot" { start x -6; }
    robot right "right.robot" { start x 6; }
    task go_right { by left; go x 7; }
    task go_left { by right; go x -7; }
  )",
             left, right);
}

class Waiting : public testing::TestWithParam<const char*> {};

/// Rejected, and where that is for its attempts the waits are named.
void expect_end(const TaskOutcome& task) {
  EXPECT_EQ(task.result, TaskResult::rejected) << task.task;
  if (task.reason.starts_with("budget: ")) {
    EXPECT_THAT(task.reason,
                HasSubstr(" of them waits since 0 s, when anybody last made progress"));
  } else {
    EXPECT_THAT(task.reason, StartsWith("blocked for ever: "));
  }
}

TEST_P(Waiting, OfTwoWhoCountEnds) {
  const auto tasks = run_corridor(GetParam(), GetParam());
  expect_end(tasks.at("go_right"));
  expect_end(tasks.at("go_left"));
  EXPECT_THAT(tasks.at("go_right").reason + tasks.at("go_left").reason,
              HasSubstr("budget: 60 attempts are used up before "));
}

TEST_P(Waiting, OfOneWhoCountsAndOneWhoDoesNotEnds) {
  for (const auto& tasks :
       {run_corridor(GetParam(), kPlainWait), run_corridor(kPlainWait, GetParam())}) {
    expect_end(tasks.at("go_right"));
    expect_end(tasks.at("go_left"));
  }
}

TEST(WaitingOfOneWhoCounts, IsRejectedWithAllWhoWait) {
  const auto tasks = run(R"(
    budget 60;
    robot left "left.robot" { start x -6; }
    robot right "right.robot" { start x 6; park x 50; }
    task go_right { by left; go x 7; }
    task go_left { by right; go x -7; budget 30; }
  )",
                         kPlainWait, kCounting);
  EXPECT_THAT(tasks.at("go_left").reason,
              HasSubstr("of them waits since 0 s, when anybody last made progress: right (go_left) "
                        "waits for left: right.car meets left.car, left (go_right) waits for "
                        "right: left.car meets right.car"));
  EXPECT_EQ(tasks.at("go_right").result, TaskResult::done) << tasks.at("go_right").reason;
}

INSTANTIATE_TEST_SUITE_P(
    Scripts, Waiting,
    testing::Values(
        kCounting, "var(n) = 0; first { move_to(x, goal(x)), var(n) = var(n) + 1, wait };",
        "var(n) = 0; cycle { move_to(x, goal(x)), var(n) = var(n) + 1, wait };",
        "var(n) = 0; chain { each { move_to(x, goal(x)), move_dir(x, dir(x, goal(x))) }, "
        "var(n) = var(n) + 1, wait };",
        "var(n) = 0; chain { move_to(x, goal(x)), var(n) = time(), wait };",
        "var(n) = 1e15; chain { which { when (var(n) > 0 and not clear(x, dir(x, "
        "goal(x)))): var(n) = var(n) - 1; wait; default: move_to(x, goal(x)); } } "
        "until (dist(x, goal(x)) < 0.001);",
        "var(n) = 20; chain { which { when (var(n) > 0 and not clear(x, dir(x, "
        "goal(x)))): var(n) = var(n) + 1; wait; default: move_to(x, goal(x)); } } "
        "until (dist(x, goal(x)) < 0.001);"));

// A work of 50 s is over ever again: nobody's 60 waits are used up.
TEST(WaitingForAnHour, IsFineWhileOthersMakeProgress) {
  std::string items = R"(
    budget 60;
    crew people;
    robot left "left.robot" { start x -6; }
    task drive { by left; go x 7; }
  )";
  for (int i = 0; i < 80; ++i) {
    items += "task work" + std::to_string(i) +
             " { by people; takes 50 s; zone box(50, 50, 0, 51, 51, 1); }\n";
  }
  const auto tasks = run(
      items, "chain { wait } until (time() >= 3600); chain { move_to(x, goal(x)) };", kPlainWait);
  EXPECT_EQ(tasks.at("drive").result, TaskResult::done) << tasks.at("drive").reason;
  EXPECT_GT(tasks.at("drive").duration, Ticks{3600} * 1'000'000'000);
}

TEST(WaitingForAnHour, EndsWhenNobodyMakesProgress) {
  const auto tasks =
      run(R"(
    budget 60;
    crew people;
    robot left "left.robot" { start x -6; }
    task drive { by left; go x 7; }
    task work { by people; takes 50 s; zone box(50, 50, 0, 51, 51, 1); }
    task long_work { by people; takes 2 h; zone box(50, 50, 0, 51, 51, 1); after work; }
  )",
          "chain { wait } until (time() >= 3600); chain { move_to(x, goal(x)) };", kPlainWait);
  EXPECT_EQ(tasks.at("drive").reason,
            "budget: 60 attempts are used up before wait (left.robot:8); 60 of them waits since "
            "50 s, when anybody last made progress");
  EXPECT_EQ(tasks.at("long_work").result, TaskResult::done);
}

// To go over the same waypoints again is no progress.
TEST(WaitingBetweenWayPoints, Ends) {
  const auto tasks = run(R"(
    budget 60;
    robot left "left.robot" { start x -6; }
    robot right "right.robot" { start x 6; }
    task go_right { by left; go x 7; via x -5; via x -4; }
    task go_left { by right; go x -7; via x 5; }
  )",
                         kCounting, kCounting);
  EXPECT_EQ(tasks.at("go_right").result, TaskResult::rejected);
  EXPECT_EQ(tasks.at("go_left").result, TaskResult::rejected);
}

// Meets what is in the way at 4 s, and is back where it began to look, far from it, when that has
// long gone: it goes there again instead of waiting for what comes no more.
constexpr const char* kTurnsBack =
    "chain { move_to(x, goal(x)) }; chain { move_dir(x, -1) } until (x <= -20);";

TEST(WaitingForWhatHasGone, EndsWithoutTheZone) {
  const auto tasks = run(R"(
    crew people;
    robot left "left.robot" { start x 0; }
    task work { by people; takes 8 s; zone box(5, -2, 0, 6, 2, 2); }
    task drive { by left; go x 10; }
  )",
                         kTurnsBack, kPlainWait);
  EXPECT_EQ(tasks.at("work").result, TaskResult::done);
  EXPECT_EQ(tasks.at("drive").tried, 29 + 60);
  EXPECT_THAT(tasks.at("drive").reason, StartsWith("short of the goal"));
}

TEST(WaitingForWhatHasGone, EndsWithoutTheMachine) {
  const auto tasks = run(R"(
    crew people;
    robot left "left.robot" { start x 0; }
    robot right "right.robot" { start x 6; }
    task drive { by left; go x 10; }
    task work { by people; takes 6 s; }
    task leave { by right; go x 20; after work; }
  )",
                         kTurnsBack, kPlainWait);
  EXPECT_EQ(tasks.at("leave").result, TaskResult::done);
  EXPECT_THAT(tasks.at("drive").reason, StartsWith("short of the goal"));
}

}  // namespace
}  // namespace rubicon::taskplan
