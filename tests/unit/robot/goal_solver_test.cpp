#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/closed_form_goal.hpp"
#include "tests/unit/robot/robots.hpp"

namespace rubicon::robot {
namespace {

using math::rotation_x_deg;
using math::rotation_y_deg;
using math::rotation_z_deg;
using math::translation;

/// For goals whose orientation the machine cannot choose.
constexpr PoseTolerance kAnyOrientation = {1e-6, 4};

double uniform(std::mt19937_64& random, double lower, double upper) {
  return std::uniform_real_distribution<double>(lower, upper)(random);
}

void expect_in_range(const RobotModel& model, const std::vector<double>& q) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    EXPECT_GE(q[i], model.parameters[i].lower) << i;
    EXPECT_LE(q[i], model.parameters[i].upper) << i;
  }
}

void expect_meets(const RobotModel& model, const Mounting& mounting, const GoalSolution& solution,
                  const Pose& goal) {
  EXPECT_TRUE(solution.reachable);
  expect_in_range(model, solution.q);
  const Pose X = tool_pose(model, mounting, solution.q);
  EXPECT_LE((Vec3(X.translation()) - Vec3(goal.translation())).norm(), 1e-9);
  EXPECT_LE(math::radians(math::rotation_angle_deg(goal.linear() * X.linear().transpose())), 1e-9);
}

TEST(SolveGoal, TheBaseMovesOnlyForWhatTheEffectorCannotReach) {
  const RobotModel model = finisher();
  const Mounting mounting = mounting_of(model);
  const std::vector<double> now = {2, -1, 0};
  const auto far = solve_goal(model, mounting, now, translation(8.2, -0.5, 18), {});
  ASSERT_TRUE(far.reachable);
  EXPECT_NEAR(far.q[0], 6.7, 1e-9);
  EXPECT_NEAR(far.q[1], -2, 1e-9);
  EXPECT_NEAR(far.q[2], 1.5, 1e-9);
  const auto near = solve_goal(model, mounting, now, translation(3.1, -0.5, 17), {});
  ASSERT_TRUE(near.reachable);
  EXPECT_EQ(near.q[0], 2) << "the effector alone reaches that far";
  EXPECT_NEAR(near.q[1], -3, 1e-9);
  EXPECT_NEAR(near.q[2], 1.1, 1e-9);
  const auto back =
      solve_goal(model, mounting, std::vector<double>{30, -1, 1}, translation(12, -0.5, 19), {});
  ASSERT_TRUE(back.reachable);
  EXPECT_NEAR(back.q[0], 13.5, 1e-9);
  EXPECT_NEAR(back.q[2], -1.5, 1e-9);
}

TEST(SolveGoal, OutOfReachTheNearestConfigurationIsGiven) {
  const RobotModel model = finisher();
  const auto solution = solve_goal(model, mounting_of(model), std::vector<double>{2, -1, 0},
                                   translation(45, 0.5, 18), {});
  EXPECT_FALSE(solution.reachable);
  EXPECT_NEAR(solution.q[0], 40, 1e-9);
  EXPECT_NEAR(solution.q[1], -2, 1e-9);
  EXPECT_NEAR(solution.q[2], 1.5, 1e-9);
  EXPECT_NEAR(solution.position_error, std::sqrt(3.5 * 3.5 + 1), 1e-9);
  EXPECT_EQ(solution.orientation_error, 0);
}

TEST(SolveGoal, ARotationWithoutParameterCountsOnlyAgainstTheTolerance) {
  const RobotModel model = finisher();
  const Mounting mounting = mounting_of(model);
  const Pose goal = translation(8.2, -0.5, 18) * rotation_x_deg(3);
  const std::vector<double> now = {2, -1, 0};
  const auto strict = solve_goal(model, mounting, now, goal, {});
  EXPECT_FALSE(strict.reachable);
  EXPECT_LE(strict.position_error, 1e-9) << "the position is solved all the same";
  EXPECT_NEAR(strict.orientation_error, math::radians(3), 1e-12);
  const auto loose = solve_goal(model, mounting, now, goal, {1e-6, math::radians(3.01)});
  EXPECT_TRUE(loose.reachable);
  EXPECT_NEAR(loose.q[0], 6.7, 1e-9);
}

TEST(SolveGoal, AlreadyThereNothingMoves) {
  const RobotModel model = excavator();
  const Mounting mounting = mounting_of(model);
  const std::vector<double> now = {20, -13, 91, 55};
  EXPECT_EQ(solve_goal(model, mounting, now, tool_pose(model, mounting, now), {}).q, now);
}

/// An excavator on tracks: angles as inner angles at the pins, the other way round than the axes.
RobotModel excavator_on_tracks() {
  RobotModel model;
  add_body(model, "tracks", -1);
  const int x = add_parameter(model, "x", -20, 20, 1);
  model.bodies.back().frame = {trans(of(x), number(0.3), number(0))};
  add_body(model, "swing", 0);
  const int theta = add_cyclic(model, "theta", 5);
  model.bodies.back().frame = {trans(0, 0, 1.2), rotz(of(theta) + number(15))};
  add_body(model, "boom", 1);
  const int boom = add_parameter(model, "phi", -170, 170, 2);
  model.bodies.back().frame = {trans(0.2, 0.1, 0.6), roty(-of(boom))};
  add_body(model, "stick", 2);
  const int stick = add_parameter(model, "phi", 15, 345, 2);
  model.bodies.back().frame = {trans(5.7, 0.05, 0.4), roty(number(180) - of(stick))};
  add_body(model, "bucket", 3);
  const int bucket = add_parameter(model, "phi", 0, 360, 2);
  model.bodies.back().frame = {trans(2.9, 0, 0), roty(number(180) - of(bucket))};
  model.tool_frame = {trans(1.5, 0, 0.2), roty(number(20)), rotx(number(30))};
  return model;
}

TEST(SolveGoal, AnArmByFormulaIsAsGoodAsTheSearch) {
  std::mt19937_64 random(41);
  int same = 0;
  int both = 0;
  for (int i = 0; i < 600; ++i) {
    const bool tracks = i % 2 == 1;
    const RobotModel model = tracks ? excavator_on_tracks() : excavator();
    const Mounting mounting =
        mounting_of(model, translation(2, 3, 1) * rotation_z_deg(uniform(random, -180, 180)));
    std::vector<double> there;
    std::vector<double> now;
    for (const Parameter& p : model.parameters) {
      const double lower = p.cyclic ? -180 : p.lower;
      const double upper = p.cyclic ? 180 : p.upper;
      there.push_back(uniform(random, lower, upper));
      now.push_back(uniform(random, lower, upper));
    }
    if (tracks) now[0] = there[0];
    const Pose goal = tool_pose(model, mounting, there);
    const GoalChain chain(model);
    const GoalProblem problem(chain, mounting, now, goal);
    const auto known = closed_form_goal(problem);
    ASSERT_TRUE(known) << i;
    ASSERT_TRUE(problem.solved(*known)) << i;
    expect_in_range(model, known->q);
    if (tracks) {
      EXPECT_EQ(known->q[0], now[0]) << "what is below the arm stays";
    }
    const GoalState searched = search_goal(problem);
    if (!problem.solved(searched)) continue;
    EXPECT_FALSE(problem.better(searched, *known)) << i;
    ++both;
    double off = 0;
    for (std::size_t v = 0; v < problem.variables().size(); ++v) {
      off = std::max(off, std::fabs(problem.moved(*known, v) - problem.moved(searched, v)));
    }
    if (off <= 1e-9) ++same;
  }
  EXPECT_GE(both, 550);
  EXPECT_GE(same, both * 9 / 10) << both;
}

TEST(SolveGoal, AnArmBendsTheWayThatMovesItsBaseLess) {
  const RobotModel model = excavator_on_tracks();
  const Mounting mounting = mounting_of(model);
  const std::vector<double> one = {4, 30, 50, 80, 150};
  const Pose goal = tool_pose(model, mounting, one);
  // The other bend, from far away; then each from near it.
  GoalClauses locked;
  locked.locked = {0};
  const auto other =
      solve_goal(model, mounting, std::vector<double>{4, 30, -60, 280, 150}, goal, {}, locked);
  expect_meets(model, mounting, other, goal);
  EXPECT_LT(other.q[2], 0);
  EXPECT_GT(other.q[3], 180);
  for (const std::vector<double>& wanted : {one, other.q}) {
    std::vector<double> near = wanted;
    for (double& value : near) value += 3;
    near[0] = 4;
    const auto found = solve_goal(model, mounting, near, goal, {}, locked);
    expect_meets(model, mounting, found, goal);
    for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_NEAR(found.q[k], wanted[k], 1e-9);
  }
}

TEST(SolveGoal, VehicleRoundTrips) {
  RobotModel model = agent();
  model.tool_frame = {trans(1.5, 0.2, 0.3), rotz(number(90))};
  std::mt19937_64 random(31);
  for (int i = 0; i < 500; ++i) {
    const Mounting mounting =
        mounting_of(model, translation(2, 3, 0) * rotation_z_deg(uniform(random, -180, 180)));
    const std::vector<double> q = {uniform(random, -50, 50), uniform(random, -50, 50), 0,
                                   uniform(random, -179, 180)};
    const std::vector<double> now = {uniform(random, -50, 50), uniform(random, -50, 50), 0,
                                     uniform(random, -179, 180)};
    const Pose goal = tool_pose(model, mounting, q);
    const auto solution = solve_goal(model, mounting, now, goal, {});
    expect_meets(model, mounting, solution, goal);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(solution.q[k], q[k], 1e-9);
  }
}

TEST(SolveGoal, CraneRoundTripsAndStaysInItsTurn) {
  RobotModel model = crane();
  std::mt19937_64 random(32);
  for (int i = 0; i < 500; ++i) {
    model.tool_frame = {trans(uniform(random, -1, 1), uniform(random, -1, 1), -2)};
    const Mounting mounting =
        mounting_of(model, translation(-8, 10, 1) * rotation_z_deg(uniform(random, -180, 180)));
    const std::vector<double> q = {uniform(random, -180, 180), uniform(random, 4, 50),
                                   uniform(random, 0, 42)};
    const std::vector<double> now = {uniform(random, -180, 180), uniform(random, 4, 50),
                                     uniform(random, 0, 42)};
    const Pose goal = tool_pose(model, mounting, q);
    const auto solution = solve_goal(model, mounting, now, goal, {});
    expect_meets(model, mounting, solution, goal);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(solution.q[k], q[k], 1e-8);
  }
}

TEST(SolveGoal, CraneIgnoresAnOrientationItCannotGive) {
  const RobotModel model = crane();
  const Mounting mounting = mounting_of(model);
  const Vec3 p(-12, 9, 5);
  const auto solution = solve_goal(model, mounting, std::vector<double>{0, 20, 10},
                                   translation(-12, 9, 5), kAnyOrientation);
  ASSERT_TRUE(solution.reachable);
  EXPECT_NEAR(solution.q[0], math::atan2_deg(9, -12), 1e-9);
  EXPECT_NEAR(solution.q[1], 15, 1e-9);
  EXPECT_NEAR(solution.q[2], 5, 1e-9);
  EXPECT_FALSE(
      solve_goal(model, mounting, std::vector<double>{0, 20, 10}, translation(-12, 9, 5), {})
          .reachable);
}

TEST(SolveGoal, CraneOnItsBearingKeepsItsAngleExactly) {
  const RobotModel model = crane();
  const Mounting mounting = mounting_of(model);
  const std::vector<double> now = {33.3, 20, 10};
  const Pose goal = tool_pose(model, mounting, std::vector<double>{33.3, 31.7, 4.2});
  EXPECT_EQ(solve_goal(model, mounting, now, goal, {}).q[0], 33.3);
}

TEST(SolveGoal, CraneWithTurningHookRoundTrips) {
  const RobotModel model = crane_with_turning_hook();
  std::mt19937_64 random(33);
  for (int i = 0; i < 500; ++i) {
    const Mounting mounting =
        mounting_of(model, translation(-8, 10, 1) * rotation_z_deg(uniform(random, -180, 180)));
    std::vector<double> q = {uniform(random, -179, 180), uniform(random, 4, 50),
                             uniform(random, -30, 0), uniform(random, -179, 180)};
    const std::vector<double> now = {uniform(random, -179, 180), uniform(random, 4, 50),
                                     uniform(random, -30, 0), uniform(random, -179, 180)};
    const Pose goal = tool_pose(model, mounting, q);
    const auto solution = solve_goal(model, mounting, now, goal, {});
    expect_meets(model, mounting, solution, goal);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(solution.q[k], q[k], 1e-7) << k;
  }
}

/// Heights that count from elsewhere, ropes with two falls, a trolley that counts inwards.
TEST(SolveGoal, WhereParametersStandInSumsTheFormulaHoldsToo) {
  RobotModel model = crane_with_turning_hook();
  const auto scaled = [](int parameter, double slope, double offset) {
    return number(slope) * of(parameter) + number(offset);
  };
  std::mt19937_64 random(35);
  for (int i = 0; i < 300; ++i) {
    const double x_slope = i % 2 == 0 ? 1 : -1;
    const double z_slope = i % 3 == 0 ? 1 : 0.5;
    model.parameters[1].lower = x_slope > 0 ? 0 : -50;
    model.parameters[1].upper = x_slope > 0 ? 50 : 0;
    model.bodies[1].frame[0] = rotz(of(0) + number(uniform(random, -90, 90)));
    model.bodies[2].frame = {trans(scaled(1, x_slope, 4), number(0.2), number(-1))};
    model.bodies[3].frame = {trans(number(0), number(0), of(2) - number(31.2)), rotz(of(3))};
    if (z_slope != 1) model.bodies[3].frame[0] = trans(number(0), number(0), scaled(2, z_slope, 2));
    const Mounting mounting =
        mounting_of(model, translation(-8, 10, 1) * rotation_z_deg(uniform(random, -180, 180)));
    const auto any = [&] {
      const double theta = uniform(random, -179, 180);
      const double x = uniform(random, model.parameters[1].lower, model.parameters[1].upper);
      const double z = uniform(random, -30, 0);
      return std::vector<double>{theta, x, z, uniform(random, -179, 180)};
    };
    const std::vector<double> q = any();
    const std::vector<double> now = any();
    const Pose goal = tool_pose(model, mounting, q);
    const auto by_formula = closed_form_goal(GoalProblem(GoalChain(model), mounting, now, goal));
    ASSERT_TRUE(by_formula.has_value()) << i;
    const auto solution = solve_goal(model, mounting, now, goal, {});
    expect_meets(model, mounting, solution, goal);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(solution.q[k], q[k], 1e-7) << k;
  }
  model.bodies[3].frame[0] = trans(number(0), number(0), of(2) * of(2));
  const std::vector<double> now = {0, model.parameters[1].start, -5, 0};
  EXPECT_FALSE(closed_form_goal(
      GoalProblem(GoalChain(model), mounting_of(model), now, translation(20, 0, 0))));
}

TEST(SolveGoal, OfTwoCraneSolutionsTheJibTurnsLess) {
  RobotModel model = crane();
  model.parameters[1].lower = -50;
  const Mounting mounting = mounting_of(model);
  const auto solution = solve_goal(model, mounting, std::vector<double>{10, 20, 10},
                                   translation(-20, 0, 10) * rotation_z_deg(0), kAnyOrientation);
  ASSERT_TRUE(solution.reachable);
  EXPECT_NEAR(solution.q[0], 0, 1e-9) << "and the orientation fits as well";
  EXPECT_NEAR(solution.q[1], -20, 1e-9);
}

TEST(SolveGoal, OutOfTheCranesReach) {
  const RobotModel model = crane();
  const auto solution = solve_goal(model, mounting_of(model), std::vector<double>{0, 20, 10},
                                   translation(0, 55, 10), kAnyOrientation);
  EXPECT_FALSE(solution.reachable);
  EXPECT_NEAR(solution.position_error, 5, 1e-6);
  EXPECT_NEAR(solution.q[0], 90, 1e-4);
  EXPECT_NEAR(solution.q[1], 50, 1e-9);
  const auto low = solve_goal(model, mounting_of(model), std::vector<double>{0, 20, 10},
                              translation(0, 30, -3), kAnyOrientation);
  EXPECT_FALSE(low.reachable);
  EXPECT_NEAR(low.position_error, 3, 1e-6);
}

TEST(SolveGoal, PlanarArmRoundTrips) {
  const RobotModel model = planar_arm();
  const Mounting mounting = mounting_of(model, translation(1, 2, 3));
  std::mt19937_64 random(34);
  for (int i = 0; i < 300; ++i) {
    std::vector<double> q, now;
    for (int k = 0; k < 3; ++k) {
      q.push_back(uniform(random, -160, 160));
      now.push_back(uniform(random, -160, 160));
    }
    const Pose goal = tool_pose(model, mounting, q);
    expect_meets(model, mounting, solve_goal(model, mounting, now, goal, {}), goal);
  }
}

TEST(SolveGoal, PlanarArmOutOfReachStretchesTowardsTheGoal) {
  const RobotModel model = planar_arm();
  const auto solution = solve_goal(model, mounting_of(model), std::vector<double>{20, 30, -40},
                                   translation(12, 0, 0), kAnyOrientation);
  EXPECT_FALSE(solution.reachable);
  EXPECT_NEAR(solution.position_error, 3, 1e-4);
  const auto across = solve_goal(model, mounting_of(model), std::vector<double>{20, 30, -40},
                                 translation(5, 2, 0), kAnyOrientation);
  EXPECT_FALSE(across.reachable) << "the arm stays in its plane";
  EXPECT_NEAR(across.position_error, 2, 1e-6);
}

TEST(SolveGoal, TheLinkAtTheTipGoesFirst) {
  const RobotModel model = planar_arm();
  const Mounting mounting = mounting_of(model);
  const std::vector<double> now = {-40, 50, 20};
  const auto tip = solve_goal(model, mounting, now,
                              tool_pose(model, mounting, std::vector<double>{-40, 50, 75}), {});
  ASSERT_TRUE(tip.reachable);
  EXPECT_EQ(tip.q[0], -40);
  EXPECT_EQ(tip.q[1], 50);
  EXPECT_NEAR(tip.q[2], 75, 1e-7);
  const auto two = solve_goal(model, mounting, now,
                              tool_pose(model, mounting, std::vector<double>{-40, 30, 75}), {});
  ASSERT_TRUE(two.reachable);
  EXPECT_EQ(two.q[0], -40);
  EXPECT_NEAR(two.q[1], 30, 1e-7);
}

TEST(SolveGoal, ExcavatorOnATurningBaseRoundTrips) {
  const RobotModel model = excavator();
  std::mt19937_64 random(35);
  for (int i = 0; i < 300; ++i) {
    const Mounting mounting =
        mounting_of(model, translation(4, -3, 0) * rotation_z_deg(uniform(random, -180, 180)));
    std::vector<double> q, now;
    for (const Parameter& p : model.parameters) {
      const double lower = p.cyclic ? -179 : p.lower;
      const double upper = p.cyclic ? 180 : p.upper;
      q.push_back(uniform(random, lower, upper));
      now.push_back(uniform(random, lower, upper));
    }
    const Pose goal = tool_pose(model, mounting, q);
    expect_meets(model, mounting, solve_goal(model, mounting, now, goal, {}), goal);
  }
}

TEST(SolveGoal, ExcavatorReachesPositionsWhateverTheOrientation) {
  const RobotModel model = excavator();
  const Mounting mounting = mounting_of(model);
  std::mt19937_64 random(36);
  for (int i = 0; i < 100; ++i) {
    std::vector<double> q;
    for (const Parameter& p : model.parameters) {
      q.push_back(uniform(random, p.cyclic ? -179 : p.lower, p.cyclic ? 180 : p.upper));
    }
    const Pose X = tool_pose(model, mounting, q);
    const Vec3 p = X.translation();
    const auto solution = solve_goal(model, mounting, model.start_values(),
                                     translation(p.x(), p.y(), p.z()), kAnyOrientation);
    EXPECT_TRUE(solution.reachable);
    EXPECT_LE(solution.position_error, 1e-9);
    expect_in_range(model, solution.q);
  }
}

TEST(SolveGoal, DerivedParametersFollow) {
  RobotModel model = excavator();
  Parameter& bucket = model.parameters[3];
  bucket.derived = true;
  bucket.free = false;
  bucket.lower = -kInfinity;
  bucket.upper = kInfinity;
  bucket.derived_value =
      number(90) - of(1) - of(2);  // the bucket points down, whatever boom and stick do
  const Mounting mounting = mounting_of(model);
  std::vector<double> q = {75, -20, 100, 0}, now = {0, 0, 60, 0};
  update_derived(model, mounting, q);
  update_derived(model, mounting, now);
  const Pose goal = tool_pose(model, mounting, q);
  const auto solution = solve_goal(model, mounting, now, goal, {});
  expect_meets(model, mounting, solution, goal);
  EXPECT_NEAR(solution.q[3], 90 - solution.q[1] - solution.q[2], 1e-9);
}

TEST(SolveGoal, RedundantVehicleWithArmMovesItsWheelsAsLittleAsNeeded) {
  // A carriage on a rail along x, on it an arm sliding along the same direction and one across.
  RobotModel model;
  add_body(model, "rail", -1);
  const int rail = add_parameter(model, "x", -100, 100, 0.5);
  model.bodies[0].frame = {trans(of(rail), number(0), number(0))};
  add_body(model, "mast", 0);
  const int turn = add_parameter(model, "theta", -90, 90, 5);
  model.bodies[1].frame = {rotz(of(turn))};
  add_body(model, "arm", 1);
  const int out = add_parameter(model, "x", 2, 6, 0.1);
  model.bodies[2].frame = {trans(of(out), number(0), number(1))};
  const Mounting mounting = mounting_of(model);
  const std::vector<double> now = {0, 0, 3};
  // Straight ahead within the arm's reach: the arm alone. Aside: mast and arm. Far: the rail only
  // for the rest.
  EXPECT_EQ(solve_goal(model, mounting, now, translation(5.5, 0, 1), {}).q[0], 0);
  const auto aside = solve_goal(model, mounting, now, translation(3, 4, 1), kAnyOrientation);
  ASSERT_TRUE(aside.reachable);
  EXPECT_NEAR(aside.q[2], 6, 1e-8);
  EXPECT_NEAR(math::sin_deg(aside.q[1]), 4.0 / 6, 1e-8);
  const auto far = solve_goal(model, mounting, now, translation(10, 0, 1), {});
  ASSERT_TRUE(far.reachable);
  EXPECT_NEAR(far.q[0], 4, 1e-8);
  EXPECT_NEAR(far.q[1], 0, 1e-8);
  EXPECT_NEAR(far.q[2], 6, 1e-8);
}

/// A slide in the plane, in a direction, over a range.
struct Slide {
  Eigen::Vector2d direction;
  double lower = 0;
  double upper = 0;
};

/// The values b for which `rest` - b * direction can be made up by the slides: the sum of segments
/// is a polygon with centre symmetry, bounded across each of them. Empty as lower > upper.
std::pair<double, double> feasible(const Eigen::Vector2d& rest, const Slide& moved,
                                   const std::vector<Slide>& slides) {
  double lower = moved.lower, upper = moved.upper;
  for (const Slide& side : slides) {
    const Eigen::Vector2d normal(-side.direction.y(), side.direction.x());
    double centre = 0, half = 0;
    for (const Slide& slide : slides) {
      const double along = normal.dot(slide.direction);
      centre += along * (slide.lower + slide.upper) / 2;
      half += std::fabs(along) * (slide.upper - slide.lower) / 2;
    }
    const double rate = normal.dot(moved.direction);
    const double middle = (normal.dot(rest) - centre) / rate;
    lower = std::max(lower, middle - half / std::fabs(rate));
    upper = std::min(upper, middle + half / std::fabs(rate));
  }
  return {lower, upper};
}

TEST(SolveGoal, SlidesOnSlidesAreTheLexicographicOptimum) {
  std::mt19937_64 random(37);
  int base_moved = 0, arm_moved = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> angles = {uniform(random, 0, 360), uniform(random, 0, 360),
                                  uniform(random, 0, 360)};
    std::vector<Slide> slides;
    for (int k = 0; k < 4; ++k) {
      const double angle = k < 3 ? angles[static_cast<std::size_t>(k)] : angles[2] + 90;
      const double size = k == 0 ? 20 : k == 1 ? 4 : 1;
      slides.push_back({{math::cos_deg(angle), math::sin_deg(angle)},
                        -uniform(random, 0, size),
                        uniform(random, 0, size)});
    }
    RobotModel model;
    for (int k = 0; k < 3; ++k) {
      add_body(model, "slide" + std::to_string(k), k - 1);
      const double angle = angles[static_cast<std::size_t>(k)];
      const Slide& slide = slides[static_cast<std::size_t>(k)];
      const int x = add_parameter(model, "x", slide.lower, slide.upper, 0.1);
      const int y = k == 2 ? add_parameter(model, "y", slides[3].lower, slides[3].upper, 0.1) : -1;
      model.bodies.back().frame = {rotz(number(angle)),
                                   trans(of(x), y < 0 ? number(0) : of(y), number(0)),
                                   rotz(number(-angle))};
    }
    const Mounting mounting = mounting_of(model);
    std::vector<double> q, now;
    for (const Parameter& p : model.parameters) {
      q.push_back(uniform(random, p.lower, p.upper));
      now.push_back(uniform(random, p.lower, p.upper));
    }
    const Pose goal = tool_pose(model, mounting, q);
    const auto solution = solve_goal(model, mounting, now, goal, {});
    ASSERT_TRUE(solution.reachable) << i;
    expect_in_range(model, solution.q);

    const Eigen::Vector2d target(goal.translation().x(), goal.translation().y());
    const auto base = feasible(target, slides[0], {slides[1], slides[2], slides[3]});
    const double best_base = std::clamp(now[0], base.first, base.second);
    EXPECT_NEAR(solution.q[0], best_base, 1e-7) << i;
    const auto arm =
        feasible(target - best_base * slides[0].direction, slides[1], {slides[2], slides[3]});
    EXPECT_NEAR(solution.q[1], std::clamp(now[1], std::min(arm.first, arm.second), arm.second),
                1e-6)
        << i;
    base_moved += best_base != now[0];
    arm_moved += solution.q[1] != now[1];
  }
  EXPECT_GT(base_moved, 300);
  EXPECT_GT(arm_moved, 300);
}

TEST(SolveGoal, LimitedTurnsAreTheNearestToNow) {
  RobotModel model = crane();
  model.parameters[0].lower = -400;
  model.parameters[0].upper = 400;
  const Mounting mounting = mounting_of(model);
  const Pose goal = tool_pose(model, mounting, std::vector<double>{10, 25, 8});
  EXPECT_NEAR(solve_goal(model, mounting, std::vector<double>{300, 20, 10}, goal, {}).q[0], 370,
              1e-9);
  EXPECT_NEAR(solve_goal(model, mounting, std::vector<double>{-300, 20, 10}, goal, {}).q[0], -350,
              1e-9);
}

TEST(SolveGoal, WhatDrivesTheToolFromBesideItIsTurnedToo) {
  RobotModel model;
  add_body(model, "drum", -1);
  const int psi = add_parameter(model, "psi", 0, 1800, 10);
  model.bodies.back().frame = {trans(0, 0, 20), rotx(of(psi))};
  add_body(model, "jib", -1);
  const int x = add_parameter(model, "x", 2, 40, 0.5);
  model.bodies.back().frame = {trans(of(x), number(0), number(20))};
  model.tool_body = add_body(model, "hook", 1);
  const int rope = add_parameter(model, "rope", -kInfinity, kInfinity, 0);
  const int z = add_parameter(model, "z", -kInfinity, kInfinity, 0);
  for (const int derived : {rope, z}) {
    model.parameters[static_cast<std::size_t>(derived)].derived = true;
    model.parameters[static_cast<std::size_t>(derived)].free = false;
  }
  model.parameters[static_cast<std::size_t>(rope)].derived_value = number(0.005) * of(psi);
  model.parameters[static_cast<std::size_t>(z)].derived_value = number(-2) - of(rope);
  model.bodies.back().frame = {trans(number(0), number(0), of(z))};

  const std::vector<double> now = model.start_values();
  const auto solution =
      solve_goal(model, mounting_of(model), now, translation(7.5, 0, 10), kAnyOrientation);
  ASSERT_TRUE(solution.reachable);
  EXPECT_NEAR(solution.q[static_cast<std::size_t>(x)], 7.5, 1e-6);
  EXPECT_NEAR(solution.q[static_cast<std::size_t>(psi)], 1600, 1e-6);
  EXPECT_FALSE(solve_goal(model, mounting_of(model), now, translation(7.5, 0, 8.9), kAnyOrientation)
                   .reachable);

  GoalClauses held;
  held.locked = {psi};
  EXPECT_FALSE(
      solve_goal(model, mounting_of(model), now, translation(7.5, 0, 10), kAnyOrientation, held)
          .reachable);
}

TEST(SolveGoal, BadInputIsAnswered) {
  const RobotModel model = crane();
  const Mounting mounting = mounting_of(model);
  Pose goal = translation(std::nan(""), 0, 0);
  EXPECT_FALSE(solve_goal(model, mounting, std::vector<double>{0, 20, 10}, goal, {}).reachable);
  const auto from_nan = solve_goal(model, mounting, std::vector<double>{std::nan(""), 20, 10},
                                   translation(1, 2, 3), {});
  EXPECT_FALSE(from_nan.reachable);
  EXPECT_EQ(from_nan.q.size(), 3U);
  RobotModel rigid;
  add_body(rigid, "post", -1);
  EXPECT_FALSE(solve_goal(rigid, mounting_of(rigid), {}, translation(1, 2, 3), {}).reachable);
}

TEST(SolveGoal, IsBoundedForHundredsOfJoints) {
  RobotModel model;
  for (int i = 0; i < 300; ++i) {
    add_body(model, "link" + std::to_string(i), i - 1);
    const int phi = add_parameter(model, "phi", -20, 20, 1);
    model.bodies.back().frame = {trans(0.1, 0, 0), roty(of(phi))};
  }
  const auto solution = solve_goal(model, mounting_of(model), model.start_values(),
                                   translation(0, 500, 0), kAnyOrientation);
  EXPECT_FALSE(solution.reachable);
}

TEST(SolveGoal, GivesTheSameBitsTwice) {
  const RobotModel model = excavator();
  const Mounting mounting = mounting_of(model);
  const Pose goal = tool_pose(model, mounting, std::vector<double>{100, -40, 120, 10});
  const auto once = solve_goal(model, mounting, model.start_values(), goal, {});
  const auto twice = solve_goal(model, mounting, model.start_values(), goal, {});
  EXPECT_EQ(once.q, twice.q);
}

}  // namespace
}  // namespace rubicon::robot
