// Rings of waiting through machines, zones, crews and links: found as soon as they close, and every
// link named.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/taskplan/run_plan.hpp"
#include "tests/support/memory_files.hpp"
#include "tests/unit/taskplan/crane_plan.hpp"
#include "tests/unit/taskplan/plain_robots.hpp"

namespace rubicon::taskplan {
namespace {

using testing::HasSubstr;

/// Somebody far away who is at work for three minutes.
constexpr const char* kOther = R"(
  robot far "line.robot" at trans(0, 50, 0) { start x -90; }
  task long_way { by far; go x 90; }
)";

struct RingRun {
  std::map<std::string, TaskOutcome> tasks;
  std::map<std::string, int> told;  ///< how often each was over
};

RingRun run_ring(const std::string& items) {
  test::MemoryFiles files({{"site.plan", "plan site {\n" + items + kOther + "}\n"},
                           {"line.robot", kLine},
                           {"gantry.robot", kGantry}});
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const auto plan = interpreter::load_plan("site.plan", sources, files, diagnostics);
  if (!plan) {
    for (const auto& each : diagnostics.sorted()) ADD_FAILURE() << each.code << each.message;
    return {};
  }
  RingRun ran;
  test::Lines lines;
  RunOptions options;
  options.on_task = [&](int, int, const TaskOutcome& task) { ++ran.told[task.task]; };
  for (TaskOutcome& task : run_plan(*plan, sources, &lines, options).tasks) {
    ran.tasks[task.task] = std::move(task);
  }
  // Where a ring is seen only when nothing else happens, the long way is gone twice.
  EXPECT_EQ(ran.told["long_way"], 1);
  EXPECT_EQ(ran.tasks["long_way"].result, TaskResult::done);
  return ran;
}

TEST(Rings, ThroughACrew) {
  const RingRun ran = run_ring(R"(
    crew riggers;
    robot hoist "gantry.robot" { start x 5, y 0, z 0; }
    robot truck "line.robot" { start x 20; }
    component block { shape box(-0.1, -0.1, -0.2, 0.1, 0.1, 0); at trans(5, 0, 0); mass 0.1 t; }
    task lift { by hoist; move block to trans(5, 30, 0); hook 1 min by riggers; after drive SS; }
    task drive { by truck, riggers; go x -5; }
  )");
  EXPECT_EQ(ran.tasks.at("drive").result, TaskResult::rejected);
  EXPECT_EQ(ran.tasks.at("drive").reason,
            "tasks wait for each other: hoist (lift) waits for riggers, which drive holds; "
            "truck (drive) waits for hoist: truck.car meets hoist.hoist");
  EXPECT_EQ(ran.tasks.at("lift").result, TaskResult::not_reached);
}

TEST(Rings, ThroughAZoneAndACrew) {
  const RingRun ran = run_ring(R"(
    support off;
    crew riggers;
    robot hoist "gantry.robot" { start x 5, y 8, z 0; }
    robot truck "line.robot" { start x 20; }
    component block { shape box(-0.1, -0.1, -0.2, 0.1, 0.1, 0); at trans(5, 4, 0); mass 0.1 t; }
    task lift { by hoist; move block to trans(5, 30, 0); hook 1 min by riggers; zone box(4, -2, 0, 6, 2, 2); priority 1; }
    task drive { by truck, riggers; go x -5; }
  )");
  EXPECT_EQ(ran.tasks.at("drive").reason,
            "tasks wait for each other: hoist (lift) waits for riggers, which drive holds; "
            "truck (drive) waits for the people of lift: truck.car meets the zone of lift");
  EXPECT_EQ(ran.tasks.at("lift").result, TaskResult::done) << ran.tasks.at("lift").reason;
}

TEST(Rings, ThroughALinkThatHoldsAFinish) {
  const RingRun ran = run_ring(R"(
    robot guard "line.robot" { start x 0; }
    robot truck "line.robot" { start x 20; }
    task stand { by guard; go x 5; after drive FF; priority 1; }
    task drive { by truck; go x -5; }
  )");
  EXPECT_EQ(ran.tasks.at("drive").reason,
            "tasks wait for each other: guard (stand) does not finish until drive has finished; "
            "truck (drive) waits for guard: truck.car meets guard.car");
  EXPECT_EQ(ran.tasks.at("stand").result, TaskResult::done) << ran.tasks.at("stand").reason;
}

TEST(Rings, ThroughAMachineThatStandsInAZone) {
  const RingRun ran = run_ring(R"(
    crew painters;
    robot guard "line.robot" { start x 0; }
    task paint { by painters; takes 1 min; zone box(4, -2, 0, 6, 2, 2); after stand SS + 10 s; }
    task stand { by guard; go x 5; after paint FF; priority 1; }
  )");
  EXPECT_EQ(ran.tasks.at("paint").reason,
            "tasks wait for each other: paint waits until guard has left its zone; "
            "guard (stand) does not finish until paint has finished");
  EXPECT_EQ(ran.tasks.at("stand").result, TaskResult::done) << ran.tasks.at("stand").reason;
}

// To take the task away that would move the idle machine helps nobody.
TEST(Rings, ThroughAMachineThatMovesOnlyLater) {
  const RingRun ran = run_ring(R"(
    robot truck "line.robot" { start x 20; }
    robot idle "line.robot" { start x 0; }
    task drive { by truck; go x -5; }
    task go_home { by idle; go x -50; after drive; }
  )");
  EXPECT_EQ(ran.tasks.at("drive").reason,
            "tasks wait for each other: truck (drive) waits for idle: truck.car meets idle.car, "
            "and idle moves only in go_home: give it a park position; "
            "idle (go_home) does not start until drive has finished");
  EXPECT_EQ(ran.tasks.at("go_home").result, TaskResult::not_reached);
}

// The one that may still move the idle machine is on its way: nobody is rejected.
TEST(Rings, AreNoneWhereSomebodyMayHelp) {
  const RingRun ran = run_ring(R"(
    crew painters;
    robot truck "line.robot" { start x 20; }
    robot idle "line.robot" { start x 0; }
    task drive { by truck; go x -5; }
    task go_home { by idle; go x -50; after drive; }
    task make_room { by idle; go x -20; after lunch; }
    task lunch { by painters; takes 5 min; }
  )");
  for (const auto& [name, task] : ran.tasks) {
    EXPECT_EQ(task.result, TaskResult::done) << name << ": " << task.reason;
  }
}

// Who was rejected for a ring with one that is not done in the end is let in again.
TEST(Rings, WithATaskThatIsNotDoneEitherAreForgotten) {
  const RingRun ran = run_ring(R"(
    robot a "line.robot" { start x 0; park x -20; }
    robot b "line.robot" { start x 10; park x 30; }
    task east { by a; go x 10; priority 1; remove prop; after clear; }
    task west { by b; go x 0; after clear; }
    task clear { takes 1 s; remove prop; }
    component prop { shape box(0, 0, 0, 1, 1, 1); at trans(0, 30, 0); }
  )");
  EXPECT_THAT(ran.tasks.at("east").reason, HasSubstr("prop is not on the site any more"));
  EXPECT_EQ(ran.tasks.at("west").result, TaskResult::done) << ran.tasks.at("west").reason;
}

}  // namespace
}  // namespace rubicon::taskplan
