#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/scripted_run.hpp"

namespace rubicon::test {
namespace {

using interpreter::MotionStatus;
using testing::ElementsAre;

TEST(MoveTo, ShortensTheLastStepAndStopsAtTheLimit) {
  const Scenario setup = set_up(kGantry, "chain { move_to(x, goal(x)) };");
  PredicateWorld world;
  EventLog log;
  auto end = run(setup, setup.task({{"x", 57.5}}, {{"x", 59.25}}), world, &log);
  EXPECT_TRUE(end.reached);
  EXPECT_THAT(log.lines, ElementsAre("goal 1 of 1", "chain {", "1 + move_to 58.5 0",
                                     "2 + move_to 59.25 0", "} chain reached 2"));
  const Scenario beyond = set_up(kGantry, "chain { move_to(x, 100) };");
  end = run(beyond, beyond.task({{"x", 58.5}}, {{"x", 59}}), world);
  EXPECT_EQ(end.q[0], 60);
  EXPECT_EQ(end.rejected.limit, 1);
}

TEST(MoveDir, TakesOnlyTheSign) {
  const Scenario setup =
      set_up(kGantry, "chain { move_dir(x, 0.001) } until (x >= 2); move_dir(y, 0 * x);");
  PredicateWorld world;
  const auto end = run(setup, setup.task({}, {{"x", 2}}), world);
  EXPECT_EQ(end.q[0], 2);
  EXPECT_EQ(end.rejected.no_direction, 1);
}

const char* const kArm = R"(robot arm {
  time_step 2;
  const level = 30 deg;
  body boom {
    param phi range(-60, 60) step(4) speed(8 deg/s) loaded(2 deg/s);
    frame roty(phi);
    shape box(0, -0.1, -0.1, 4, 0.1, 0.1);
  }
  body stick on boom {
    param phi range(-90, 90) step(5);
    frame trans(4, 0, 0) * roty(phi);
    shape box(0, -0.1, -0.1, 3, 0.1, 0.1);
  }
  body bucket on stick {
    param phi = level - boom.phi - stick.phi;
    frame trans(3, 0, 0) * roty(phi);
  }
  tool bucket;
  touching boom bucket;
  behaviour "s.motion";
}
)";

TEST(Together, MovesAllPartsAtOnceAndLastsAsLongAsTheSlowest) {
  const Scenario setup =
      set_up(kArm, "chain { together { move_to(boom.phi, 10), move_to(stick.phi, 5) } };");
  PredicateWorld world;
  EventLog log;
  auto end = run(setup, setup.task({}, {{"boom.phi", 10}, {"stick.phi", 5}}), world, &log);
  // bucket.phi = 30 - boom.phi - stick.phi follows
  EXPECT_THAT(log.lines,
              ElementsAre("goal 1 of 1", "chain {", "1 + together 4 5 21", "2 + together 8 5 17",
                          "3 + together 10 5 15", "} chain reached 3"));
  // stick: 5 degrees at 2.5 degrees/s = 2 s; boom: 4 degrees at 8 = 0.5 s, then 2 degrees = 0.25 s
  EXPECT_DOUBLE_EQ(interpreter::seconds_from_ticks(end.time), 2 + 0.5 + 0.25);
  world.is_loaded = true;
  end = run(setup, setup.task({{"stick.phi", 5}}, {{"boom.phi", 10}}), world);
  EXPECT_DOUBLE_EQ(interpreter::seconds_from_ticks(end.time), 2 + 2 + 1);
}

TEST(Together, WithNothingLeftFailsWithTheReasonOfItsFirstPart) {
  const Scenario setup =
      set_up(kArm, "together { move_to(boom.phi, 0), move_dir(stick.phi, 0 * stick.phi) };");
  PredicateWorld world;
  EventLog log;
  run(setup, setup.task({}, {{"boom.phi", 0}}), world, &log);
  EXPECT_THAT(log.lines, ElementsAre("goal 1 of 1", "1 - together 0 0 30 at goal"));
}

TEST(Rules, AreEvaluatedWithOldValuesAtOnce) {
  const Scenario setup = set_up(
      R"(robot agent {
    body truck {
      param x step(2);
      param y;
      param theta cyclic step(90);
      rule x <- x + x_s * cos(theta);
      rule y <- y + x_s * sin(theta);
      frame trans(x, y, 0) * rotz(theta);
    }
    tool truck;
    behaviour "s.motion";
  })",
      "move_dir(x, 1); move_dir(theta, 1); move_dir(x, 1); move_dir(theta, 1); move_dir(x, 1);");
  PredicateWorld world;
  EventLog log;
  run(setup, setup.task({}, {{"x", 0}}), world, &log);
  EXPECT_THAT(log.lines,
              ElementsAre("goal 1 of 1", "1 + move_dir 2 0 0", "2 + move_dir 2 0 90",
                          "3 + move_dir 2 2 90", "4 + move_dir 2 2 180", "5 + move_dir 0 2 180"));
}

TEST(Directions, StoredZeroBecomesThePreferredOne) {
  const Scenario setup = set_up(
      R"(robot r {
    body b { param x step(1) prefer(-1); param y step(1); frame trans(x, y, 0); }
    tool b;
    behaviour "s.motion";
  })",
      R"(var(a) = dir(x, x); var(b) = -dir(x, x); var(c) = dir(y, y + 0.4); var(d) = dir(y, y) + 0;
                                var(e) = -var(a); move_dir(x, 1);)");
  PredicateWorld world;
  const auto end = run(setup, setup.task({}, {{"x", 0}}), world);
  using Pair = std::pair<std::string, double>;
  EXPECT_THAT(end.variables,
              ElementsAre(Pair("a", -1), Pair("b", 1), Pair("c", 1), Pair("d", 0), Pair("e", 1)));
}

TEST(Cyclic, TurnsTheShortWayAndPrefers) {
  const char* const robot = R"(robot r {
    body b { param theta cyclic step(30) prefer(-1); frame rotz(theta); }
    tool b;
    behaviour "s.motion";
  })";
  const Scenario setup = set_up(robot, "chain { move_to(theta, goal(theta)) };");
  PredicateWorld world;
  EventLog log;
  run(setup, setup.task({{"theta", 160}}, {{"theta", -140}}), world, &log);
  EXPECT_THAT(log.lines, ElementsAre("goal 1 of 1", "chain {", "1 + move_to -170",
                                     "2 + move_to -140", "} chain reached 2"));
  log.lines.clear();
  run(setup, setup.task({}, {{"theta", 180}}), world, &log);
  EXPECT_EQ(log.lines.at(2), "1 + move_to -30");
}

TEST(Expressions, CompareWithTheToleranceAndShortCircuit) {
  const Scenario setup = set_up(kGantry, R"(
    which { when (x >= 1 + 5e-7 and not (x > 1) and x == 1 - 5e-7): var(ok) = 1; default: var(ok) = 0; };
    which { when (y != 0 and 1 / y > 0): var(safe) = 0; default: var(safe) = 1; };
    var(f) = max(x, 5) + min(x, -5) + abs(-2) + sin(30) + cos(60) + max(x) - min(y) + dist(x, 4);
    move_dir(x, 1);)");
  PredicateWorld world;
  const auto end = run(setup, setup.task({{"x", 1}}, {{"x", 1}}), world);
  using Pair = std::pair<std::string, double>;
  EXPECT_THAT(end.variables, ElementsAre(Pair("ok", 1), Pair("safe", 1),
                                         Pair("f", 5 - 5 + 2 + 0.5 + 0.5 + 60 + 30 + 3)));
}

TEST(Clear, AsksWithoutMoving) {
  const Scenario setup = set_up(kGantry, R"(
    which { when (clear(x, 1)): move_dir(x, 1); default: move_dir(y, 1); };
    which { when (clear(x, 1)): move_dir(x, 1); default: move_dir(y, 1); };)");
  PredicateWorld world;
  world.blocked = [](std::span<const double> q) { return q[0] > 1.5; };
  const auto end = run(setup, setup.task({}, {{"x", 0}}), world);
  EXPECT_EQ(end.q, (std::vector<double>{1, 1}));
  EXPECT_EQ(end.tries, 2);
}

}  // namespace
}  // namespace rubicon::test
