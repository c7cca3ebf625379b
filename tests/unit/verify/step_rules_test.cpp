#include "src/results/verify/replay/step_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/motion/math/angles.hpp"

namespace rubicon::verify {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Parameter {
  const char* name;
  const char* rule;
  double step;
  double speed;
  bool cyclic = false;
  bool derived = false;
};

SceneRobot robot_of(const std::vector<Parameter>& list) {
  SceneRobot robot;
  std::vector<std::string> names;
  for (const Parameter& each : list) names.emplace_back(each.name);
  for (const Parameter& each : list) {
    SceneParameter parameter;
    parameter.name = each.name;
    parameter.rule = Formula::parse(each.rule, names);
    parameter.step = each.step;
    parameter.speed = each.speed;
    parameter.loaded_speed = each.speed / 2;
    parameter.cyclic = each.cyclic;
    parameter.rotation = each.cyclic;
    parameter.derived = each.derived;
    robot.parameters.push_back(parameter);
    robot.starts.push_back(0);
  }
  return robot;
}

SceneRobot gantry() {
  SceneRobot robot = robot_of({{"x", "x + x_s", 1, 0.5},
                               {"z", "z + z_s", 0.5, 0.25},
                               {"phi", "3 * z + 1", 0, 0, false, true}});
  robot.parameters[0].lower = -2;
  robot.parameters[0].upper = 8;
  return robot;
}

SceneRobot cart() {
  return robot_of({{"x", "x + x_s * cos(theta)", 0.5, 1},
                   {"y", "y + x_s * sin(theta)", 0, 0},
                   {"theta", "theta + theta_s", 200, 20, true}});
}

StepResult check(const SceneRobot& robot, const std::vector<double>& before,
                 const std::vector<double>& after, const std::vector<int>& moved, double seconds,
                 bool loaded = false) {
  return check_step(robot, {before, after, moved, loaded,
                            static_cast<Ticks>(seconds * static_cast<double>(kSecond) + 0.5)});
}

TEST(StepRules, AllowAStepOfOneParameter) {
  EXPECT_THAT(check(gantry(), {0, 2, 7}, {1, 2, 7}, {0}, 2).faults, IsEmpty());
  EXPECT_THAT(check(gantry(), {0, 2, 7}, {-0.3, 2, 7}, {0}, 0.6).faults, IsEmpty());
  EXPECT_THAT(check(gantry(), {0, 2, 7}, {0, 2.5, 8.5}, {1}, 2).faults, IsEmpty());
  EXPECT_THAT(check(gantry(), {0, 2, 7}, {0, 2.5, 8.5}, {1}, 4, true).faults, IsEmpty());
}

TEST(StepRules, TogetherLastsAsLongAsItsSlowestPart) {
  EXPECT_THAT(check(gantry(), {0, 2, 7}, {1, 2.25, 7.75}, {0, 1}, 2).faults, IsEmpty());
  EXPECT_THAT(check(gantry(), {0, 2, 7}, {1, 2.25, 7.75}, {0, 1}, 1).faults,
              ElementsAre(HasSubstr("lasts 1 s instead of 2 s")));
  EXPECT_THAT(check(gantry(), {0, 2, 7}, {1, 2, 7}, {0, 1}, 2).faults, IsEmpty());
}

TEST(StepRules, TellWhatIsWrong) {
  EXPECT_THAT(check(gantry(), {0, 2, 7}, {1, 2.001, 7.003}, {0}, 2).faults,
              testing::Contains(HasSubstr("z is 2.001 after the step, its rule gives 2")));
  EXPECT_THAT(check(gantry(), {0, 2, 7}, {1, 2, 7.1}, {0}, 2).faults,
              ElementsAre(HasSubstr("phi is 7.1")));
  EXPECT_THAT(check(gantry(), {0, 2, 7}, {1.5, 2, 7}, {0}, 3).faults,
              ElementsAre(HasSubstr("the longest is 1")));
  EXPECT_THAT(check(gantry(), {7.5, 2, 7}, {8.2, 2, 7}, {0}, 1.4).faults,
              ElementsAre(HasSubstr("out of its range")));
  EXPECT_THAT(check(gantry(), {0, 2, 7}, {1, 2, 7}, {0}, 1.99).faults,
              ElementsAre(HasSubstr("lasts 1.99 s instead of 2 s")));
  EXPECT_THAT(check(gantry(), {0, 2, 7}, {0, 2, 8}, {2}, 0).faults,
              testing::Contains(HasSubstr("phi cannot be moved")));
}

TEST(StepRules, ALocalParameterMovesAlongItsHeading) {
  const double c = math::cos_deg(30);
  EXPECT_THAT(check(cart(), {1, 1, 30}, {1 + 0.5 * c, 1.25, 30}, {0}, 0.5).faults, IsEmpty());
  EXPECT_THAT(check(cart(), {1, 1, 30}, {1 - 0.2 * c, 0.9, 30}, {0}, 0.2).faults, IsEmpty());
  EXPECT_THAT(check(cart(), {1, 1, 30}, {1.5, 1, 30}, {0}, 0.5).faults,
              testing::Contains(HasSubstr("x is 1.5")));
  EXPECT_THAT(check(cart(), {1, 1, 90}, {1, 1.5, 90}, {0}, 0.5).faults, IsEmpty());
}

TEST(StepRules, AnglesThatTurnFreelyPassHalfATurn) {
  const StepResult over = check(cart(), {0, 0, 175}, {0, 0, -175}, {2}, 0.5);
  EXPECT_THAT(over.faults, IsEmpty());
  EXPECT_DOUBLE_EQ(over.reached[2], 185);
  const StepResult back = check(cart(), {0, 0, -175}, {0, 0, 175}, {2}, 0.5);
  EXPECT_DOUBLE_EQ(back.reached[2], -185);
  // By its duration it went the long way round.
  const StepResult far = check(cart(), {0, 0, 0}, {0, 0, -170}, {2}, 9.5);
  EXPECT_THAT(far.faults, IsEmpty());
  EXPECT_DOUBLE_EQ(far.reached[2], 190);
}

TEST(StepRules, DerivedAnglesPassHalfATurnWithTheirs) {
  const SceneRobot geared = robot_of(
      {{"theta", "theta + theta_s", 10, 10, true}, {"psi", "2 * theta", 0, 0, true, true}});
  const StepResult over = check(geared, {175, -10}, {-175, 10}, {0}, 1);
  EXPECT_THAT(over.faults, IsEmpty());
  EXPECT_THAT(over.reached, ElementsAre(185, 10));
}

TEST(StepRules, NothingElseJumpsByAWholeTurn) {
  SceneRobot robot = robot_of(
      {{"theta", "theta + theta_s", 10, 10, true}, {"psi", "theta / 2", 0, 0, false, true}});
  // 92.5 belongs to 185: the next step would go on from -87.5.
  EXPECT_THAT(check(robot, {175, 87.5}, {-175, 92.5}, {0}, 1).faults,
              ElementsAre("psi is 92.5 after the step, the values beside it give -87.5"));
  EXPECT_THAT(check(robot, {165, 82.5}, {175, 87.5}, {0}, 1).faults, IsEmpty());

  robot = robot_of({{"theta", "theta + theta_s", 10, 10, true}});
  robot.bodies.push_back({"drum", -1, parse_frame("rotz(3 * theta)", {"theta"}), {}});
  EXPECT_THAT(check(robot, {175}, {-175}, {0}, 1).faults, IsEmpty());
  robot.tool_frame = parse_frame("trans(0, 0, 0.01 * theta)", {"theta"});
  EXPECT_THAT(check(robot, {175}, {-175}, {0}, 1).faults,
              ElementsAre("a whole turn that the record leaves out moves the frame of the tool"));
  EXPECT_THAT(check(robot, {165}, {175}, {0}, 1).faults, IsEmpty());

  robot = robot_of(
      {{"x", "x + x_s * cos(theta / 2)", 1, 1}, {"theta", "theta + theta_s", 10, 10, true}});
  EXPECT_THAT(check(robot, {0, 175}, {0, -175}, {1}, 1).faults,
              ElementsAre("a whole turn that the record leaves out changes the rule of x"));
}

TEST(StepRules, DerivedValuesBeginAsComputed) {
  SceneRobot robot = gantry();
  robot.starts = {1, 2, 99};
  EXPECT_THAT(start_values(robot), ElementsAre(1, 2, 7));
}

TEST(StepRules, EndForRulesWithoutSolution) {
  SceneRobot robot = robot_of({{"x", "x / (x - x)", 1, 1}, {"y", "y + x_s * x_s", 1, 1}});
  EXPECT_FALSE(check(robot, {1, 1}, {2, 2}, {0}, 1).faults.empty());
  EXPECT_FALSE(check(robot, {1, 1}, {2, 2}, {0, 1}, 1).faults.empty());
}

/// 0.5 m/s at 0.25 m/s2: 2 s and 0.5 m until it is fast.
SceneRobot ramped() {
  SceneRobot robot = robot_of({{"x", "x + x_s", 0.5, 0.5}, {"z", "z + z_s", 0.5, 0.5}});
  robot.parameters[0].acceleration = 0.25;
  return robot;
}

Ticks ticks(double seconds) { return static_cast<Ticks>(seconds * 1e9 + 0.5); }

TEST(StepRules, AStepLastsAsItsPlaceInTheRampWants) {
  const SceneRobot robot = ramped();
  const std::vector<double> a = {0, 0}, b = {0.25, 0}, c = {0.75, 0};
  const std::vector<int> x = {0};
  const StepResult first = check_step(robot, {a, b, x, false, 1'414'213'562, {}});
  EXPECT_THAT(first.faults, IsEmpty());
  EXPECT_FALSE(first.goes_on);
  const StepResult second =
      check_step(robot, {b, c, x, false, ticks(2.5) - 1'414'213'562, first.run});
  EXPECT_THAT(second.faults, IsEmpty());
  EXPECT_TRUE(second.goes_on);
  // T(0.75) = 2 sqrt(3) s.
  EXPECT_NEAR(static_cast<double>(rest_time(robot, second.run).time),
              (2 * 1.7320508075688772 - 2.5) * 1e9, 1);
  // As if it stood before, as if it had its speed at once, and the other way round.
  EXPECT_THAT(check_step(robot, {b, c, x, false, ticks(2), first.run}).faults,
              ElementsAre(HasSubstr("lasts 2 s instead of 1.08579 s")));
  EXPECT_THAT(check_step(robot, {a, b, x, false, ticks(0.5), {}}).faults,
              ElementsAre(HasSubstr("lasts 0.5 s instead of 1.41421 s")));
  const StepResult back = check_step(robot, {b, a, x, false, 1'414'213'562, first.run});
  EXPECT_THAT(back.faults, IsEmpty());
  EXPECT_FALSE(back.goes_on);
}

TEST(StepRules, AnotherSetIsAnotherRunAndWithoutAccelerationThereIsNone) {
  const SceneRobot robot = ramped();
  const std::vector<double> a = {0, 0}, b = {0.5, 0}, c = {1, 0.5}, d = {1, 1};
  const StepResult first = check_step(robot, {a, b, std::vector<int>{0}, false, ticks(2), {}});
  EXPECT_THAT(first.faults, IsEmpty());
  const StepResult both =
      check_step(robot, {b, c, std::vector<int>{1, 0}, false, ticks(2), first.run});
  EXPECT_THAT(both.faults, IsEmpty());
  EXPECT_FALSE(both.goes_on);
  const StepResult one =
      check_step(robot, {c, d, std::vector<int>{0, 1}, false, ticks(1), both.run});
  EXPECT_THAT(one.faults, IsEmpty());
  EXPECT_FALSE(one.goes_on);
  EXPECT_TRUE(one.run.parts.empty());
}

}  // namespace
}  // namespace rubicon::verify
