#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/turns.hpp"
#include "src/motion/robot/turns.hpp"
#include "tests/unit/robot/robots.hpp"

namespace rubicon::robot {
namespace {

using math::rotation_x_deg;
using math::rotation_y_deg;
using math::rotation_z_deg;
using math::translation;

TEST(ForwardKinematics, CraneHookHangsAtRadiusAndBearing) {
  const RobotModel model = crane();
  const Mounting mounting = mounting_of(model, translation(100, 0, 0));
  const std::vector<double> q = {90, 20, 7};
  EXPECT_EQ(Vec3(tool_pose(model, mounting, q).translation()), Vec3(100, 20, 7));
  std::vector<Pose> X_WB;
  body_poses(model, mounting, q, X_WB);
  ASSERT_EQ(X_WB.size(), 3U);
  EXPECT_EQ(Vec3(X_WB[0].translation()), Vec3(100, 0, 0));
  EXPECT_EQ(X_WB[1].linear(), rotation_z_deg(90).linear());
}

TEST(ForwardKinematics, FramesAreProductsOfTheirElements) {
  RobotModel model;
  add_body(model, "a", -1);
  const int x = add_parameter(model, "x", -9, 9, 1);
  const int psi = add_parameter(model, "psi", -90, 90, 1);
  model.bodies[0].frame = {rotx(of(psi)), trans(of(x), number(1), number(2)), roty(number(30))};
  add_body(model, "b", 0);
  const int theta = add_cyclic(model, "theta", 1);
  model.bodies[1].frame = {rotz(number(2) * of(theta)), trans(3, 4, 5)};
  model.tool_frame = {rotx(number(-20)), trans(0, 0, 1)};
  const std::vector<double> q = {1.5, 40, 25};
  const Pose X_WM = translation(7, 8, 9) * rotation_y_deg(10);
  const Pose expected = X_WM * rotation_x_deg(40) * translation(1.5, 1, 2) * rotation_y_deg(30) *
                        rotation_z_deg(50) * translation(3, 4, 5) * rotation_x_deg(-20) *
                        translation(0, 0, 1);
  EXPECT_TRUE(tool_pose(model, mounting_of(model, X_WM), q).isApprox(expected, 1e-14));
}

TEST(ApplyRules, TheMobileAgentDrivesAlongItsHeadingAndKeepsItsFloor) {
  const RobotModel model = agent();
  Mounting mounting = mounting_of(model);
  mounting.starts[2] = 3;
  const std::vector<double> q = {1, 2, 5, 30};
  std::vector<double> next(4);
  apply_rules(model, mounting, q, one_step(model, 0, 2), next);
  EXPECT_EQ(next[0], 1 + 2 * math::cos_deg(30));
  EXPECT_EQ(next[1], 3);
  EXPECT_EQ(next[2], 3);
  EXPECT_EQ(next[3], 30);
}

TEST(ApplyRules, AllRulesReadTheOldValues) {
  RobotModel model;
  add_body(model, "swap", -1);
  const int x = add_parameter(model, "x", -9, 9, 1);
  const int y = add_parameter(model, "y", -9, 9, 1);
  model.parameters[0].rule = of(y) + step_of(x);
  model.parameters[1].rule = of(x) + step_of(y);
  model.parameters[0].direct = model.parameters[1].direct = false;
  std::vector<double> next(2);
  apply_rules(model, mounting_of(model), std::vector<double>{1, 2}, one_step(model, x, 0.5), next);
  EXPECT_EQ(next, (std::vector<double>{2.5, 1}));
}

TEST(ApplyRules, RulesOfOtherBodiesAreLeftAlone) {
  RobotModel model = agent();
  add_body(model, "arm", 0);
  const int arm_x = add_parameter(model, "x", 0, 2, 0.1);
  std::vector<double> next(5);
  apply_rules(model, mounting_of(model), std::vector<double>{1, 2, 5, 30, 0},
              one_step(model, arm_x, 0.1), next);
  EXPECT_EQ(next, (std::vector<double>{1, 2, 5, 30, 0.1}));
}

TEST(ApplyRules, CyclicAnglesStayUnwrappedUntilNormalised) {
  const RobotModel model = agent();
  std::vector<double> next(4);
  apply_rules(model, mounting_of(model), std::vector<double>{0, 0, 0, 175}, one_step(model, 3, 10),
              next);
  EXPECT_EQ(next[3], 185);
  normalise(model, next);
  EXPECT_EQ(next[3], -175);
}

TEST(ApplyRules, DerivedParametersFollowTheNewValues) {
  RobotModel model = excavator();
  Parameter& bucket = model.parameters[3];
  bucket.derived = true;
  bucket.free = false;
  bucket.derived_value = number(90) - of(1) - of(2);
  std::vector<double> next(4);
  apply_rules(model, mounting_of(model), std::vector<double>{0, 10, 60, 20}, one_step(model, 1, -4),
              next);
  EXPECT_EQ(next, (std::vector<double>{0, 6, 60, 24}));
}

TEST(ApplyRules, DerivedAnglesThatAreCyclicRunOn) {
  RobotModel model;
  add_body(model, "drum", -1);
  add_parameter(model, "theta", -1e9, 1e9, 10);
  add_parameter(model, "psi", -1e9, 1e9, 0);
  model.parameters[0].cyclic = model.parameters[1].cyclic = true;
  model.parameters[1].derived = true;
  model.parameters[1].derived_value = number(2) * of(0);
  std::vector<double> q = {175, 350};
  update_derived(model, mounting_of(model), q);
  EXPECT_EQ(q[1], -10);
  std::vector<double> next(2);
  apply_rules(model, mounting_of(model), q, one_step(model, 0, 10), next);
  EXPECT_EQ(next, (std::vector<double>{185, 10})) << "20 degrees, not 380";
  normalise(model, next);
  EXPECT_EQ(next, (std::vector<double>{-175, 10}));
}

TEST(Model, TheSmallestStepOfATranslationIsAMetreWhereThereIsNone) {
  EXPECT_EQ(finisher().smallest_translation_step(), 0.25);
  EXPECT_EQ(RobotModel().smallest_translation_step(), 1);
}

TEST(RelativeGoal, AgentDrivesToTheFootOfThePerpendicularAndFacesTheGoal) {
  const RobotModel model = agent();
  const Mounting mounting = mounting_of(model);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number_(-30, 30);
  for (int i = 0; i < 200; ++i) {
    const std::vector<double> q = {number_(random), number_(random), 0, 6 * number_(random)};
    const Vec3 goal(number_(random), number_(random), number_(random));
    const double along =
        math::cos_deg(q[3]) * (goal.x() - q[0]) + math::sin_deg(q[3]) * (goal.y() - q[1]);
    EXPECT_NEAR(relative_goal(model, mounting, q, 0, goal), q[0] + along, 1e-12);
    const double bearing = math::atan2_deg(goal.y() - q[1], goal.x() - q[0]);
    EXPECT_NEAR(math::normalised_deg(relative_goal(model, mounting, q, 3, goal) - bearing), 0,
                1e-11);
  }
}

TEST(RelativeGoal, CraneTurnsToTheBearingAndReachesTheRadius) {
  const RobotModel model = crane();
  const Mounting mounting = mounting_of(model, translation(-8, 10, 0));
  const Vec3 goal = Vec3(-8, 10, 4) + 30 * Vec3(math::cos_deg(120), math::sin_deg(120), 0);
  const std::vector<double> q = {120, 20, 10};
  EXPECT_NEAR(relative_goal(model, mounting, std::vector<double>{-60, 20, 10}, 0, goal), 120,
              1e-12);
  EXPECT_NEAR(relative_goal(model, mounting, q, 1, goal), 30, 1e-12);
  EXPECT_NEAR(relative_goal(model, mounting, q, 2, goal), 4, 1e-12);
}

TEST(RelativeGoal, LimitedRotationUsesTheNearestTurn) {
  RobotModel model = crane();
  model.parameters[0].lower = -400;
  model.parameters[0].upper = 400;
  const Mounting mounting = mounting_of(model);
  EXPECT_NEAR(relative_goal(model, mounting, std::vector<double>{350, 20, 0}, 0, Vec3(10, 0, 0)),
              360, 1e-12);
  EXPECT_NEAR(relative_goal(model, mounting, std::vector<double>{-350, 20, 0}, 0, Vec3(0, 10, 0)),
              -270, 1e-12);
  EXPECT_NEAR(relative_goal(model, mounting, std::vector<double>{390, 20, 0}, 0, Vec3(0, 10, 0)),
              90, 1e-12);
}

TEST(RelativeGoal, FinisherMovesBaseOrEffector) {
  const RobotModel model = finisher();
  const Mounting mounting = mounting_of(model);
  const std::vector<double> q = {2, -1, 0.5};
  EXPECT_NEAR(relative_goal(model, mounting, q, 0, Vec3(8.2, -0.5, 18)), 7.7, 1e-12);
  EXPECT_NEAR(relative_goal(model, mounting, q, 1, Vec3(8.2, -0.5, 18)), -2, 1e-12);
  EXPECT_NEAR(relative_goal(model, mounting, q, 2, Vec3(8.2, -0.5, 18)), 6.2, 1e-12);
}

TEST(RelativeGoal, AtTheDestinationNothingTurns) {
  const RobotModel model = agent();
  const std::vector<double> q = {3, 4, 0, 77};
  EXPECT_EQ(relative_goal(model, mounting_of(model), q, 3, Vec3(3, 4 + 4e-6, 5)), 77);
  EXPECT_NE(relative_goal(model, mounting_of(model), q, 3, Vec3(3, 4 + 6e-6, 5)), 77);
}

TEST(RelativeGoal, PsiFacesWithItsYAxisAndSignsFollowTheFrame) {
  RobotModel model;
  add_body(model, "roller", -1);
  const int psi = add_cyclic(model, "psi", 1);
  const int phi = add_cyclic(model, "phi", 1);
  model.bodies[0].frame = {rotx(of(psi))};
  add_body(model, "tilt", 0);
  model.parameters[1].body = 1;
  model.bodies[1].frame = {roty(-of(phi))};
  const Mounting mounting = mounting_of(model);
  EXPECT_NEAR(relative_goal(model, mounting, std::vector<double>{20, 0}, psi, Vec3(5, 0, 3)), 90,
              1e-12);
  // roty(-phi): x rises with phi, so a goal straight above is at phi = 90.
  EXPECT_NEAR(relative_goal(model, mounting, std::vector<double>{0, 20}, phi, Vec3(0, 0, 3)), 90,
              1e-12);
}

TEST(RelativeGoal, AParameterThatMovesNothingKeepsItsValue) {
  RobotModel model = crane();
  model.bodies[2].frame = {trans(of(1), number(0), number(3))};
  const Mounting mounting = mounting_of(model);
  EXPECT_EQ(relative_goal(model, mounting, std::vector<double>{0, 20, 10}, 2, Vec3(1, 2, 3)), 10);
  model.bodies[1].frame = {};
  EXPECT_EQ(relative_goal(model, mounting, std::vector<double>{15, 20, 10}, 0, Vec3(1, 2, 3)), 15);
}

}  // namespace
}  // namespace rubicon::robot
