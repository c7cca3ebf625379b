// Machines, crews and people in one timeline: who waits for whom, and what happens when nobody can
// go on.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/taskplan/run_plan.hpp"
#include "tests/support/memory_files.hpp"
#include "tests/unit/taskplan/crane_plan.hpp"
#include "tests/unit/taskplan/plain_robots.hpp"

namespace rubicon::taskplan {
namespace {

using schedule::kSecond;
using testing::HasSubstr;

/// The same, which waits by itself when something is in the way.
constexpr const char* kWaiting = R"(robot waiting {
  body car {
    param x range(-100, 100) step(1) speed(1 m/s);
    frame trans(x, 0, 0);
    shape box(-0.5, -0.5, 0, 0.5, 0.5, 1);
  }
  tool car;
  behaviour { first { move_to(x, goal(x)), wait }; }
}
)";
/// A car that goes to and fro.
constexpr const char* kPacing = R"(robot pacing {
  body car {
    param x range(-100, 100) step(1) speed(1 m/s);
    frame trans(x, 0, 0);
    shape box(-0.5, -0.5, 0, 0.5, 0.5, 1);
  }
  tool car;
  behaviour { cycle { move_dir(x, 1), move_dir(x, -1) }; }
}
)";

struct SiteRun {
  std::map<std::string, TaskOutcome> tasks;
  Schedule schedule;
};

SiteRun run_site(const std::string& items) {
  test::MemoryFiles files({{"site.plan", "plan site {\n" + items + "\n}\n"},
                           {"line.robot", kLine},
                           {"waiting.robot", kWaiting},
                           {"pacing.robot", kPacing},
                           {"gantry.robot", kGantry}});
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const auto plan = interpreter::load_plan("site.plan", sources, files, diagnostics);
  if (!plan) {
    for (const auto& each : diagnostics.sorted()) ADD_FAILURE() << each.code << each.message;
    return {};
  }
  SiteRun ran;
  test::Lines lines;
  ran.schedule = run_plan(*plan, sources, &lines);
  for (const TaskOutcome& task : ran.schedule.tasks) {
    ran.tasks[task.task] = task;
    const WaitTimes& waits = task.waits;
    if (task.result != TaskResult::done) continue;
    EXPECT_EQ(waits.predecessor + waits.resource + waits.machine + waits.shift + task.motion_time +
                  task.work_time,
              task.start + task.duration)
        << task.task;
  }
  return ran;
}

TEST(SeveralMachines, OneWaitsUntilTheOtherIsOutOfTheWay) {
  const SiteRun ran = run_site(R"(
    robot a "line.robot" { start x 0; }
    robot b "line.robot" { start x 5; }
    task follow { by a; go x 20; }
    task lead { by b; go x 40; after pause; }
    task pause { takes 1 min; })");
  EXPECT_EQ(ran.tasks.at("follow").result, TaskResult::done) << ran.tasks.at("follow").reason;
  EXPECT_GE(ran.tasks.at("follow").waits.machine, 50 * kSecond);
  EXPECT_EQ(ran.tasks.at("follow").motion_time, 20 * kSecond);
  EXPECT_EQ(ran.tasks.at("lead").duration, 35 * kSecond);
}

TEST(SeveralMachines, WhoWaitForEachOtherAreNamedAndTheLastGivesWay) {
  for (const char* robot : {"line.robot", "waiting.robot"}) {
    const SiteRun ran = run_site(std::string(R"(
      robot a ")") + robot +
                                 R"(" { start x 0; }
      robot b ")" + robot +
                                 R"(" { start x 10; park x 30; }
      task east { by a; go x 10; }
      task west { by b; go x 0; })");
    EXPECT_EQ(ran.tasks.at("west").result, TaskResult::rejected);
    EXPECT_THAT(ran.tasks.at("west").reason, HasSubstr("machines wait for each other: "));
    EXPECT_THAT(ran.tasks.at("west").reason, HasSubstr("a (east) waits for b: a.car meets b.car"));
    EXPECT_THAT(ran.tasks.at("west").reason, HasSubstr("b (west) waits for a: b.car meets a.car"));
    EXPECT_EQ(ran.tasks.at("east").result, TaskResult::done) << ran.tasks.at("east").reason;
    EXPECT_EQ(ran.tasks.at("park b").result, TaskResult::done);
    EXPECT_TRUE(ran.tasks.at("park b").parking);
  }
}

TEST(SeveralMachines, TheTaskOfLeastPriorityGivesWay) {
  const SiteRun ran = run_site(R"(
    robot a "line.robot" { start x 0; park x -20; }
    robot b "line.robot" { start x 10; }
    task east { by a; go x 10; }
    task west { by b; go x 0; priority 1; })");
  EXPECT_EQ(ran.tasks.at("east").result, TaskResult::rejected);
  EXPECT_EQ(ran.tasks.at("west").result, TaskResult::done) << ran.tasks.at("west").reason;
}

TEST(SeveralMachines, WhoseTaskWasLeftOutIsNamedWhereItStandsInTheWay) {
  const SiteRun ran = run_site(R"(
    robot a "line.robot" { start x 0; park x -20; }
    robot b "line.robot" { start x 10; }
    task east { by a; go x 10; }
    task west { by b; go x 0; })");
  EXPECT_EQ(ran.tasks.at("east").reason,
            "blocked for ever: a.car meets b.car, which does not move any more, as west was left "
            "out; where west is done without this task, let this one come after it, or give b a "
            "park position");
  EXPECT_EQ(ran.tasks.at("west").result, TaskResult::done) << ran.tasks.at("west").reason;
}

TEST(SeveralMachines, AnIdleMachineWithoutAParkPositionIsInTheWayForEver) {
  const SiteRun ran = run_site(R"(
    robot a "line.robot" { start x 0; }
    robot b "line.robot" { start x 5; }
    crew riggers;
    task east { by a, riggers; go x 20; priority 5; }
    task joints { by riggers; takes 1 h; })");
  EXPECT_EQ(ran.tasks.at("east").result, TaskResult::rejected);
  EXPECT_EQ(ran.tasks.at("east").reason,
            "blocked for ever: a.car meets b.car, which does not move any more; give b a park "
            "position");
  EXPECT_EQ(ran.tasks.at("joints").result, TaskResult::done);
  EXPECT_EQ(ran.tasks.at("joints").start, 0);  // nobody was held up
}

TEST(SeveralMachines, KeepOutOfTheZonesOfPeople) {
  const SiteRun ran = run_site(R"(
    robot a "line.robot" { start x 0; }
    crew masons;
    task bricks { by masons; takes 5 min; zone box(10, -2, 0, 12, 2, 2); }
    task past { by a; go x 20; })");
  EXPECT_EQ(ran.tasks.at("past").result, TaskResult::done) << ran.tasks.at("past").reason;
  EXPECT_EQ(ran.tasks.at("past").start + ran.tasks.at("past").duration, (300 + 11) * kSecond);
  EXPECT_EQ(ran.tasks.at("past").waits.machine, (300 - 9) * kSecond);
}

TEST(SeveralMachines, WhatStandsInAZoneIsNotTakenWhilePeopleWorkThere) {
  const SiteRun ran = run_site(R"(
    robot g "gantry.robot" { start x 0, z 5; }
    crew masons;
    component c { shape box(-1, -1, 0, 1, 1, 3); at trans(0, 0, 0); grip trans(0, 0, 3); mass 0.1 t; }
    task bricks { by masons; takes 5 min; zone box(-2, -2, 0, 2, 2, 2.5); }
    task fetch { by g; move c to trans(0, 9, 0); })");
  EXPECT_EQ(ran.tasks.at("fetch").result, TaskResult::done) << ran.tasks.at("fetch").reason;
  EXPECT_EQ(ran.tasks.at("fetch").waits.machine, (300 - 2) * kSecond);
  EXPECT_EQ(ran.tasks.at("fetch").duration, (300 + 9) * kSecond);
}

TEST(SeveralMachines, AZoneWaitsUntilNoMachineIsInIt) {
  const SiteRun ran = run_site(R"(
    robot a "line.robot" { start x 11; park x 20; }
    crew masons;
    task bricks { by masons; takes 5 min; zone box(10, -2, 0, 12, 2, 2); })");
  EXPECT_EQ(ran.tasks.at("bricks").result, TaskResult::done) << ran.tasks.at("bricks").reason;
  EXPECT_EQ(ran.tasks.at("park a").duration, 9 * kSecond);
  EXPECT_GT(ran.tasks.at("bricks").start, 0);
  EXPECT_EQ(ran.tasks.at("bricks").waits.machine, ran.tasks.at("bricks").start);

  const SiteRun stuck = run_site(R"(
    robot a "line.robot" { start x 11; }
    crew masons;
    task bricks { by masons; takes 5 min; zone box(10, -2, 0, 12, 2, 2); })");
  EXPECT_EQ(stuck.tasks.at("bricks").reason, "a stands in its zone and does not move any more");
}

// The work tells its finish when it begins, and the moment that the lag allows is over then: to
// make it shorter helps nobody.
TEST(SeveralMachines, WorkWhoseFinishIsToldTooLateForALagDoesNotCount) {
  const std::string plan = R"(
    robot car "line.robot" { start x 0; }
    crew c;
    crew d;
    task drive { by car; go x 10; }
    task build { by c; takes %s; after drive; }
    task paint { by d; takes 1 h; after build - 1 h; })";
  const auto with = [&](const std::string& work) {
    std::string text = plan;
    return run_site(text.replace(text.find("%s"), 2, work));
  };
  const SiteRun ran = with("10 min");
  ASSERT_EQ(ran.schedule.critical.size(), 3U);
  EXPECT_TRUE(ran.schedule.critical[0].work_counts);
  EXPECT_FALSE(ran.schedule.critical[1].work_counts);
  EXPECT_EQ(ran.schedule.critical[1].text,
            "build starts after drive (FS); its own work does not count");
  EXPECT_EQ(with("5 min").schedule.process_time, ran.schedule.process_time);
}

// A machine makes room for a task that is rejected then: it has not moved.
TEST(SeveralMachines, WhoMadeRoomForATaskThatIsNotDoneHasNotMoved) {
  const SiteRun ran = run_site(R"(
    component gone { shape box(0, 0, 0, 1, 1, 1); at trans(0, 50, 0); }
    robot car "line.robot" { start x 0; park x 20; }
    crew c;
    task clear { by c; takes 1 s; remove gone; }
    task paint { by c; takes 1 min; zone box(-1, -1, 0, 1, 1, 2); remove gone; after clear; }
    task drive { by car; go x -10; after clear + 10 min; })");
  EXPECT_EQ(ran.tasks.at("paint").result, TaskResult::rejected);
  EXPECT_FALSE(ran.tasks.contains("park car"));
  EXPECT_EQ(ran.tasks.at("drive").motion_time, 10 * kSecond);
}

// The painters look on while the fitters hook and release.
TEST(SeveralMachines, WhoLooksOnIsHeldAndNotBusy) {
  const SiteRun ran = run_site(R"(
    component block { shape box(-0.2, -0.2, 0, 0.2, 0.2, 0.5); at trans(5, 0, 0); grip trans(0, 0, 0.5); mass 0.1 t; }
    robot hoist "gantry.robot" { start x 5, y 0, z 5; }
    crew fitters;
    crew painters;
    task lift { by hoist, fitters, painters; move block to trans(5, 9, 0); hook 40 s by fitters; release 20 s; })");
  const std::vector<ResourceUse>& uses = ran.schedule.resources;
  EXPECT_EQ(uses[1].busy, 60 * kSecond);
  EXPECT_EQ(uses[2].busy, 20 * kSecond);
  EXPECT_EQ(uses[1].held, uses[2].held);
}

TEST(SeveralMachines, ATaskThatIsNotDoneDoesNotMakeThePlanLonger) {
  const SiteRun ran = run_site(R"(
    component gone { shape box(0, 0, 0, 1, 1, 1); at trans(0, 50, 0); }
    crew c;
    task clear { by c; takes 1 min; remove gone; }
    task again { by c; takes 1 min; remove gone; after clear + 9 min; })");
  EXPECT_EQ(ran.tasks.at("again").result, TaskResult::rejected);
  EXPECT_EQ(ran.schedule.resources[0].shift_time, 60 * kSecond);
  EXPECT_EQ(ran.schedule.resources[0].utilisation(), 1);
}

TEST(SeveralMachines, ACrewServesTwoMachinesByTurns) {
  const SiteRun ran = run_site(R"(
    robot g "gantry.robot" { start x 0; }
    robot h "gantry.robot" { start x 40; }
    crew riggers;
    component c { shape box(-1, -1, 0, 1, 1, 1); at trans(0, 0, 0); grip trans(0, 0, 1); mass 0.1 t; }
    component d { shape box(-1, -1, 0, 1, 1, 1); at trans(40, 0, 0); grip trans(0, 0, 1); mass 0.1 t; }
    task one { by g; move c to trans(0, 9, 0); hook 4 min by riggers; release 1 min by riggers; }
    task two { by h; move d to trans(40, 9, 0); hook 4 min by riggers; release 1 min by riggers; })");
  EXPECT_EQ(ran.tasks.at("one").waits.resource, (240 - 9) * kSecond);  // d is hooked meanwhile
  // two is hooked after one, and released after one.
  EXPECT_EQ(ran.tasks.at("two").waits.resource, (240 + 51) * kSecond);
  const auto riggers = ran.schedule.resources.at(2);
  EXPECT_EQ(riggers.held, 600 * kSecond);
  EXPECT_EQ(riggers.busy, 600 * kSecond);
}

TEST(SeveralMachines, AComponentThatIsMovedMeanwhileIsFetchedWhereItIs) {
  const SiteRun ran = run_site(R"(
    robot g "gantry.robot" { start x 9, z 5; }
    robot h "gantry.robot" { start x -60, z 9; }
    component c { shape box(-1, -1, 0, 1, 1, 1); at trans(10, 0, 0); grip trans(0, 0, 1); mass 0.1 t; }
    task earlier { by g; move c to trans(10, 20, 0); }
    task aside { by g; go x 10, y 60, z 20; after earlier; }
    task second { by h; move c to trans(-20, 0, 0); })");
  for (const auto& [name, task] : ran.tasks) {
    EXPECT_EQ(task.result, TaskResult::done) << name << task.reason;
  }
  // 70 m to where it stood, 20 m to where it stands; 30 m and 20 m to its place.
  EXPECT_EQ(ran.tasks.at("second").motion_time, (70 + 8 + 20 + 30 + 20) * kSecond);
}

TEST(SeveralMachines, AComponentThatIsRemovedWhileItIsHookedIsNotCarried) {
  const SiteRun ran = run_site(R"(
    robot g "gantry.robot" { start x 10, z 5; }
    crew riggers;
    component c { shape box(-1, -1, 0, 1, 1, 1); at trans(10, 0, 0); grip trans(0, 0, 1); mass 0.1 t; }
    task move_it { by g; move c to trans(10, 20, 0); hook 10 min; }
    task remove_it { by riggers; takes 5 min; remove c; })");
  EXPECT_EQ(ran.tasks.at("move_it").result, TaskResult::rejected);
  EXPECT_EQ(ran.tasks.at("move_it").reason, "c is not on the site any more");
  EXPECT_EQ(ran.tasks.at("remove_it").result, TaskResult::done);
}

// Of two things in the way the one is named that was there first, also after a task was undone that
// had taken it.
TEST(SeveralMachines, WhatAnUndoneTaskTookKeepsItsRank) {
  const std::string items = R"(
    component gone { shape box(0, 0, 0, 1, 1, 1); at trans(0, 50, 0); }
    component near_one { shape box(-0.2, -0.2, 0, 0.2, 0.2, 0.5); at trans(5, -0.3, 0); grip trans(0, 0, 0.5); mass 0.1 t; }
    component next_one { shape box(-0.2, -0.2, 0, 0.2, 0.2, 0.5); at trans(5, 0.3, 0); }
    robot hoist "gantry.robot" { start x 5, y -0.3, z 5; }
    robot car "line.robot" { start x 0; }
    crew c;
    task clear { by c; takes 1 s; remove gone; }
    task drive { by car; go x 10; after clear + 2 min; }
  )";
  const SiteRun alone = run_site(items);
  const SiteRun beside = run_site(items + R"(
    task undone { by hoist; move near_one to trans(5, -8, 0); remove gone; after clear; })");
  EXPECT_EQ(beside.tasks.at("undone").result, TaskResult::rejected);
  EXPECT_GT(beside.tasks.at("undone").motions, 2);
  EXPECT_THAT(alone.tasks.at("drive").reason, HasSubstr("blocked by near_one"));
  EXPECT_EQ(beside.tasks.at("drive").reason, alone.tasks.at("drive").reason);
}

TEST(SeveralMachines, WhatComesAfterARemovalThatFailsIsNotReached) {
  const SiteRun ran = run_site(R"(
    crew riggers;
    component c { shape box(-1, -1, 0, 1, 1, 1); at trans(10, 0, 0); mass 0.1 t; }
    task work { by riggers; takes 1 min; after gone FS - 30 s; }
    task gone { remove c; after earlier; }
    task earlier { remove c; })");
  EXPECT_EQ(ran.tasks.at("earlier").result, TaskResult::done);
  EXPECT_EQ(ran.tasks.at("gone").result, TaskResult::rejected);
  EXPECT_EQ(ran.tasks.at("work").result, TaskResult::not_reached);
}

TEST(SeveralMachines, MotionsFinishAfterTheShiftOrStopWithIt) {
  const std::string plan = R"(
    start_at "2026-03-02 11:59";
    robot a "line.robot" { start x 0; calendar site; cost 3600 per h; }
    task east { by a; go x 100; })";
  const SiteRun through = run_site("calendar site { mon-fri 07:00-12:00, 13:00-16:00; }" + plan);
  EXPECT_EQ(through.tasks.at("east").duration, 100 * kSecond);
  EXPECT_NEAR(through.schedule.cost, 100, 1e-9);  // a second costs 1
  const SiteRun stops =
      run_site("calendar site { mon-fri 07:00-12:00, 13:00-16:00; carry_over; }" + plan);
  EXPECT_EQ(stops.tasks.at("east").duration, (100 + 3600) * kSecond);
  EXPECT_EQ(stops.tasks.at("east").waits.shift, 3600 * kSecond);
  EXPECT_NEAR(stops.schedule.cost, 100, 1e-9);
}

TEST(SeveralMachines, WaitingInAScriptDoesNotUseUpItsBudget) {
  const SiteRun ran = run_site(R"(
    budget 250;
    robot a "waiting.robot" { start x 0; }
    robot b "line.robot" { start x 5; }
    robot c "line.robot" at trans(0, 20, 0) { start x -90; }
    task round { by c; go x 90; }
    task follow { by a; go x 20; }
    task lead { by b; go x 40; after round; })");
  EXPECT_EQ(ran.tasks.at("follow").result, TaskResult::done) << ran.tasks.at("follow").reason;
  EXPECT_GT(ran.tasks.at("follow").waits.machine, 150 * kSecond);
}

TEST(SeveralMachines, WhoWaitedWithoutALoadGoesOnInItsShift) {
  const SiteRun ran = run_site(R"(
    start_at "2026-03-02 15:00";
    calendar site { mon-fri 07:00-16:00; }
    robot a "line.robot" { start x 0; calendar site; }
    robot b "line.robot" { start x 5; }
    task follow { by a; go x 20; }
    task lead { by b; go x 40; after pause; }
    task pause { takes 5 h; })");
  EXPECT_EQ(ran.tasks.at("follow").result, TaskResult::done) << ran.tasks.at("follow").reason;
  EXPECT_EQ(ran.tasks.at("follow").start + ran.tasks.at("follow").duration,
            (16 * 3600 + 16) * kSecond);
}

TEST(SeveralMachines, ATaskHeldByOneThatIsRejectedIsLetGoAtOnce) {
  const SiteRun ran = run_site(R"(
    site box(20, -5, 0, 21, 5, 5);
    robot a "line.robot" { start x 0; }
    robot b "line.robot" at trans(0, 10, 0) { start x 0; }
    task hour { takes 10 h; }
    task bad { by a; go x 50; after hour; }
    task good { by b; go x 10; after bad SF; })");
  EXPECT_EQ(ran.tasks.at("bad").result, TaskResult::rejected);
  EXPECT_GT(ran.tasks.at("bad").tried, 0);
  EXPECT_EQ(ran.tasks.at("good").result, TaskResult::done);
  EXPECT_EQ(ran.tasks.at("good").duration, 10 * kSecond);
}

/// Every reason for which a task is refused, by the words of its reason.
TEST(Refusals, EveryReasonIsToldInItsWords) {
  const std::map<std::string, std::pair<std::string, std::string>> cases = {
      {"out of reach",
       {"robot a \"line.robot\"; task t { by a; go at trans(0, 7, 0); }",
        "goal out of reach: the nearest pose is 7 m"}},
      {"start in collision",
       {"robot a \"line.robot\" { start x 0; } site box(-1, -1, 0, 1, 1, 1); task t { by a; go x "
        "9; }",
        "start in collision: a.car meets site"}},
      {"blocked",
       {"robot a \"line.robot\" { start x 0; } site box(5, -1, 0, 6, 1, 1);"
        "task t { by a; go x 9; }",
        "blocked by site at step 5 (x, line 8): a.car meets site"}},
      {"livelock",
       {"robot a \"pacing.robot\" { start x 0; } task t { by a; go x 9; }", "livelock: after "}},
      {"budget",
       {"robot a \"line.robot\" { start x 0; } task t { by a; go x 9; budget 3; }",
        "budget: 3 attempts are used up before move_to(x, goal(x))"}},
      {"overload",
       {"robot a \"gantry.robot\" { start x 0; } component c { shape box(-1, -1, 0, 1, 1, 1); at "
        "trans(30, 0, 0); grip trans(0, 0, 1); mass 3 t; } task t { by a; move c to trans(0, 9, "
        "0); }",
        "too heavy: c has 3000 kg, the load chart of a allows 2000 kg at 30 m, where it is taken "
        "up, and 4000 kg at 9 m, where it is set down"}},
      {"gone",
       {"component c { } task first_one { remove c; } task t { remove c; after first_one; }",
        "c is not on the site any more"}},
  };
  for (const auto& [name, given] : cases) {
    const SiteRun ran = run_site(given.first);
    EXPECT_EQ(ran.tasks.at("t").result, TaskResult::rejected) << name;
    EXPECT_THAT(ran.tasks.at("t").reason, HasSubstr(given.second)) << name;
    EXPECT_EQ(ran.tasks.at("t").duration, 0) << name;
  }
}

}  // namespace
}  // namespace rubicon::taskplan
