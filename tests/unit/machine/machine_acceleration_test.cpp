// accel(a): steps in one direction make a run, whose rest is charged before anything else begins.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "interpreter/machine/motion_run.hpp"
#include "src/motion/robot/trapezoid.hpp"
#include "tests/support/scripted_run.hpp"

namespace rubicon::test {
namespace {

using interpreter::Machine;
using interpreter::MotionEnd;
using interpreter::MotionRun;
using interpreter::MotionStatus;
using interpreter::Ticks;
using interpreter::ticks_from_seconds;
using testing::ElementsAre;

// 0.5 m/s at 0.25 m/s2: 2 s and 0.5 m until it is fast. y has its speed at once.
const char* const kTrolley = R"(robot trolley {
  time_step 1;
  body trolley {
    param x step(0.5) speed(0.5 m/s) loaded(0.25 m/s) accel(0.25 m/s2) range(-20, 20);
    param y step(0.5) speed(0.5 m/s) range(-20, 20);
    frame trans(x, y, 0);
  }
  body hoist on trolley {
    param z step(0.5) speed(0.25 m/s) accel(0.25 m/s2) range(0, 20);
    frame trans(0, 0, z);
  }
  tool hoist;
  behaviour "s.motion";
}
)";

struct Ran {
  MotionEnd end;
  std::vector<std::string> lines;
  double seconds() const { return interpreter::seconds_from_ticks(end.time); }
};

Ran run_script(const std::string& script, const std::vector<std::pair<std::string, double>>& goal,
               PredicateWorld world = {}) {
  const Scenario setup = set_up(kTrolley, script);
  EventLog log;
  Ran ran{run(setup, setup.task({}, goal), world, &log), {}};
  ran.lines = log.lines;
  return ran;
}

TEST(Acceleration, OneWayTakesTheWholeTrapezoid) {
  const Ran ran = run_script("chain { move_to(x, goal(x)) };", {{"x", 4}});
  EXPECT_EQ(ran.seconds(), 4 / 0.5 + 2);
  EXPECT_EQ(ran.lines.back(), "stop t 10") << "the rest of the run comes at its end";
  const Ran triangle = run_script("chain { move_to(x, goal(x)) };", {{"x", 0.25}});
  EXPECT_EQ(triangle.seconds(), 2);
}

TEST(Acceleration, StepsLastAsTheRampWantsIt) {
  const Scenario setup = set_up(kTrolley, "chain { move_to(x, goal(x)) };");
  PredicateWorld world;
  Machine machine(*setup.program, setup.task({}, {{"x", 1.5}}));
  std::vector<double> times;
  while (machine.advance(world, nullptr)) {
    times.push_back(interpreter::seconds_from_ticks(machine.time()));
  }
  // sqrt(2 * 0.5 / 0.25) = 2, then at 0.5 m/s; T(1.5) = 3 + 2.
  EXPECT_THAT(times, ElementsAre(2, 3, 4, 5));
  EXPECT_TRUE(machine.ended());
  EXPECT_EQ(machine.end().accepted, 3) << "a stop is no attempt";
}

TEST(Acceleration, LoadedTakesTheLoadedSpeed) {
  PredicateWorld world;
  world.is_loaded = true;
  EXPECT_EQ(run_script("chain { move_to(x, goal(x)) };", {{"x", 4}}, world).seconds(), 16 + 1);
}

TEST(Acceleration, AReversalStandsFirst) {
  const Ran ran = run_script("chain { move_to(x, 1) }; chain { move_to(x, goal(x)) };", {{"x", 0}});
  EXPECT_EQ(ran.seconds(), 4 + 4);
  EXPECT_THAT(ran.lines,
              ElementsAre("goal 1 of 1", "chain {", "1 + move_to 0.5 0 0", "2 + move_to 1 0 0",
                          "} chain reached 2", "chain {", "stop t 4", "3 + move_to 0.5 0 0",
                          "4 + move_to 0 0 0", "} chain reached 2", "stop t 8"));
}

TEST(Acceleration, AnotherParameterStandsFirstAlsoOneWithoutAcceleration) {
  EXPECT_EQ(run_script("move_to(x, 0.5); move_to(y, 0.5); move_to(x, 1);", {{"x", 1}}).seconds(),
            interpreter::seconds_from_ticks(2 * ticks_from_seconds(2 * std::sqrt(2.0))) + 1);
}

TEST(Acceleration, AWaitStandsFirst) {
  const Ran ran = run_script("chain { move_to(x, 1) }; wait; move_to(x, 1.5);", {{"x", 1.5}});
  // T(1) = 4, wait 1, T(0.5) = 2 sqrt(0.5 / 0.25).
  EXPECT_NEAR(ran.seconds(), 4 + 1 + 2 * std::sqrt(2.0), 2e-9);
  EXPECT_EQ(ran.lines.at(5), "stop t 4");
  EXPECT_EQ(ran.lines.at(6), "3 + wait t 5");
}

TEST(Acceleration, ARefusedTryEndsNoRun) {
  PredicateWorld world;
  world.blocked = [](std::span<const double> q) { return q[1] > 0; };
  EXPECT_EQ(
      run_script("move_to(x, 2); move_to(y, 1); move_to(x, 2); move_to(x, 2);", {{"x", 1.5}}, world)
          .seconds(),
      5)
      << "T(1.5)";
  EXPECT_EQ(
      run_script("move_to(x, 2); move_to(y, 1); move_to(x, -2);", {{"x", 0}}, world).seconds(),
      interpreter::seconds_from_ticks(2 * ticks_from_seconds(2 * std::sqrt(2.0))))
      << "what moves after the refusal ends it";
}

TEST(Acceleration, ARunGoesOnFromCommandToCommandAndThroughWayPoints) {
  EXPECT_EQ(
      run_script("move_to(x, 0.5); move_dir(x, 1); together { move_to(x, 1.5), move_to(z, 0) };",
                 {{"x", 1.5}})
          .seconds(),
      5);
  const Scenario setup = set_up(kTrolley, "chain { move_to(x, goal(x)) };");
  auto task = setup.task({}, {{"x", 2}});
  task.goals.push_back(task.goals.front());
  task.goals[0].values[0].second = 1;
  PredicateWorld world;
  EXPECT_EQ(run(setup, task, world).time, ticks_from_seconds(2 / 0.5 + 2));
  task.goals[1].values[0].second = 0;
  EventLog log;
  EXPECT_EQ(run(setup, task, world, &log).time, ticks_from_seconds(4 + 4));
  EXPECT_THAT(log.lines, testing::Contains("stop t 4"));
}

TEST(Acceleration, TogetherIsARunOfItsSetAndLastsAsLongAsItsSlowestPart) {
  // x needs 5 s for 1.5 m, z 6 + 1 s: its steps and its rest are the longer ones but for the first.
  const Ran ran = run_script("chain { together { move_to(x, 1.5), move_to(z, 1.5) } };",
                             {{"x", 1.5}, {"z", 1.5}});
  // Steps: sqrt(4) = 2 (x) or 0.5 / 0.25 + 0.5 = 2.5 (z); then 1 or 2 s; the rest 1 or 0.5 s.
  EXPECT_EQ(ran.seconds(), 2.5 + 2 + 2 + 1);
  EXPECT_THAT(ran.lines, testing::Contains(testing::StartsWith("stop")).Times(1));
  // Where one of them is there already, another set moves.
  const Ran uneven =
      run_script("chain { together { move_to(x, 0.5), move_to(z, 1) } };", {{"x", 0.5}, {"z", 1}});
  EXPECT_THAT(uneven.lines, testing::Contains(testing::StartsWith("stop")).Times(2));
}

TEST(Acceleration, EveryEndStandsFirst) {
  PredicateWorld world;
  const Ran livelock =
      run_script("cycle { move_dir(x, 1), move_dir(x, -1) } until (x > 5);", {{"x", 9}});
  EXPECT_EQ(livelock.end.status, MotionStatus::livelock) << livelock.end.message;
  EXPECT_EQ(livelock.lines.back().substr(0, 4), "stop");
  const Scenario setup = set_up(kTrolley, "chain { move_dir(x, 1) } until (x > 15);");
  auto task = setup.task({}, {{"x", 15}});
  task.budget = 3;
  const MotionEnd budget = run(setup, task, world);
  EXPECT_EQ(budget.status, MotionStatus::budget);
  EXPECT_EQ(budget.time, ticks_from_seconds(5));
}

TEST(Acceleration, ALivelockIsFoundAfterAsManyStepsAsWithoutIt) {
  for (const char* const script : {"cycle { move_dir(x, 1), move_dir(x, -1) } until (x > 5);",
                                   "chain { cycle { move_dir(x, 1), move_dir(y, 1), move_dir(x, "
                                   "-1), move_dir(y, -1) } until (x > 5) };",
                                   "chain { move_to(x, goal(x)), wait };"}) {
    std::string plain = kTrolley;
    for (std::size_t at; (at = plain.find(" accel(0.25 m/s2)")) != std::string::npos;) {
      plain.erase(at, 17);
    }
    PredicateWorld world;
    world.blocked = [](std::span<const double> q) { return q[0] > 2.1; };
    const Scenario with = set_up(kTrolley, script), without = set_up(plain, script);
    const MotionEnd a = run(with, with.task({}, {{"x", 9}}), world);
    const MotionEnd b = run(without, without.task({}, {{"x", 9}}), world);
    EXPECT_EQ(a.status, b.status) << script;
    EXPECT_EQ(a.tries, b.tries) << script;
    EXPECT_EQ(a.period, b.period) << script;
    EXPECT_EQ(a.message, b.message) << script;
    EXPECT_GT(a.time, b.time) << script;
  }
}

TEST(Acceleration, ACommandThatIsBlockedOnceTheMachineStandsIsRefusedThen) {
  const Scenario setup = set_up(kTrolley, "move_to(x, 1); move_dir(x, -1); move_to(x, 1);");
  PredicateWorld world;
  EventLog log;
  Machine machine(*setup.program, setup.task({}, {{"x", 1}}));
  ASSERT_TRUE(machine.advance(world, &log));
  ASSERT_TRUE(machine.advance(world, &log));
  EXPECT_EQ(log.lines.back().substr(0, 4), "stop");
  EXPECT_EQ(machine.tries(), 1);
  world.blocked = [](std::span<const double> q) { return q[0] < 0.4; };
  ++world.changes;
  ASSERT_TRUE(machine.advance(world, &log));
  EXPECT_EQ(log.lines.back(), "2 - move_dir 0.5 0 0 hit");
  while (machine.advance(world, &log)) {
  }
  // Twice T(0.5): the second step begins a run of its own.
  EXPECT_EQ(machine.time(), 2 * ticks_from_seconds(2 * std::sqrt(2.0)));
}

TEST(Acceleration, ItsStateIsAValue) {
  const Scenario setup =
      set_up(kTrolley, "cycle { move_dir(x, 1), move_dir(z, 1), wait } until (x > 3);");
  PredicateWorld world;
  Machine whole(*setup.program, setup.task({}, {{"x", 3}}));
  std::vector<Machine> copies;
  do {
    copies.push_back(whole);
  } while (whole.advance(world, nullptr));
  ASSERT_GT(copies.size(), 25u);
  for (Machine& copy : copies) {
    while (copy.advance(world, nullptr)) {
    }
    EXPECT_EQ(copy.end().time, whole.end().time);
    EXPECT_EQ(copy.end().tries, whole.end().tries);
  }
}

TEST(MotionRun, AddsUpToTheWholeWayHoweverItIsCut) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const double speed = 0.05 + 4 * share(random);
    const double acceleration = 0.02 + 3 * share(random);
    const double whole = 0.01 + 60 * share(random) * share(random);
    const int parts = 1 + static_cast<int>(200 * share(random) * share(random));
    MotionRun run(0, true, speed, acceleration);
    Ticks time = 0;
    double gone = 0;
    for (int n = 1; n < parts; ++n) {
      const double step = (whole - gone) * share(random) / 4;
      if (!(step > 0)) break;
      time += run.advance(step);
      gone += step;
    }
    time += run.advance(whole - gone);
    const Ticks expected = ticks_from_seconds(robot::time_to_rest(whole, speed, acceleration));
    EXPECT_NEAR(static_cast<double>(time + run.rest()), static_cast<double>(expected), 1)
        << whole << " m in " << parts << " steps";
  }
}

TEST(MotionRun, EqualStepsAddUpToTheTick) {
  for (const int parts : {1, 2, 3, 7, 10, 100, 1000, 9999}) {
    MotionRun run(0, true, 0.67, 0.3);
    Ticks time = 0;
    for (int n = 0; n < parts; ++n) time += run.advance(30.0 / parts);
    EXPECT_EQ(time + run.rest(), ticks_from_seconds(30 / 0.67 + 0.67 / 0.3)) << parts;
  }
}

}  // namespace
}  // namespace rubicon::test
