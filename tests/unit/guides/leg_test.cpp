#include "src/motion/guides/leg.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/motion/robot/turns.hpp"
#include "tests/unit/guides/guide_machines.hpp"

namespace rubicon::guides {
namespace {

using Q = std::vector<double>;

/// All that `next_step` leads through, the target last.
std::vector<Q> followed(const robot::RobotModel& model, Q q, const Q& target, int most = 1000) {
  const robot::Mounting mounting = test::standing(model);
  const Leg leg(model, mounting);
  std::vector<Q> places;
  Q steps(q.size());
  Q next(q.size());
  while (static_cast<int>(places.size()) < most && leg.next_step(q, target, steps)) {
    robot::apply_rules(model, mounting, q, steps, next);
    robot::normalise(model, next);
    q = next;
    places.push_back(q);
  }
  EXPECT_TRUE(leg.is_there(q, target));
  return places;
}

TEST(Leg, PlainParametersArriveTogetherOnAStraightLine) {
  const std::vector<Q> places = followed(test::gantry(), {0, 0}, {8, 3});
  ASSERT_EQ(places.size(), 8u);
  for (const Q& q : places) EXPECT_NEAR(q[1], q[0] * 3 / 8, 1e-12);
  EXPECT_NEAR(places.front()[0], 1, 1e-12);
  EXPECT_NEAR(places.back()[0], 8, 1e-12);
}

TEST(Leg, NoStepIsLongerThanThatOfItsParameter) {
  const robot::RobotModel model = test::excavator();
  Q before{0, 0, 100, 100};
  for (const Q& q : followed(model, before, {170, 60, 30, 200})) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      EXPECT_LE(std::fabs(q[i] - before[i]), model.parameters[i].step + 1e-9);
    }
    before = q;
  }
}

TEST(Leg, ACyclicAngleGoesTheShortWayRound) {
  const std::vector<Q> places =
      followed(test::excavator(), {170, 0, 100, 100}, {-170, 0, 100, 100});
  ASSERT_EQ(places.size(), 4u);
  EXPECT_NEAR(places[0][0], 175, 1e-9);
  EXPECT_NEAR(places[2][0], -175, 1e-9);
}

TEST(Leg, AVehicleTurnsDrivesAndTurns) {
  const std::vector<Q> places = followed(test::vehicle(), {0, 0, 0}, {3, 4, 0});
  std::size_t i = 0;
  while (i < places.size() && places[i][0] == 0 && places[i][1] == 0) ++i;
  EXPECT_EQ(i, 6u);  // 53.13 degrees, 10 a step
  for (; i < places.size() && places[i][2] == places[5][2]; ++i) {
    EXPECT_NEAR(places[i][1] * 3, places[i][0] * 4, 1e-9);
  }
  EXPECT_EQ(i, 16u);  // 5 m, half a metre a step
  EXPECT_NEAR(places[i - 1][0], 3, 1e-9);
  EXPECT_EQ(places.size(), 22u);
  EXPECT_NEAR(places.back()[2], 0, 1e-9);
}

TEST(Leg, AVehicleOfManyDirectionsArrivesAndStops) {
  for (int n = 0; n < 400; ++n) {
    const double turn = 0.9 * n;
    const Q target{0.37 * n * std::cos(turn), 0.11 * n * std::sin(turn) - 3, 179.0 - 1.7 * n};
    Q reduced = target;
    robot::normalise(test::vehicle(), reduced);
    followed(test::vehicle(), {1.234, -2.345, 12.3}, reduced, 2000);
  }
}

TEST(Leg, AVehicleGetsSomewhereWithEveryStep) {
  for (const double beside : {2.9e-7, 1.1e-8, -3e-6, 1e-9, -5e-10}) {
    const std::vector<Q> places = followed(test::vehicle(), {0, 0, 0}, {12.67, beside, -140});
    Q before{0, 0, 0};
    for (const Q& q : places) {
      const bool drives = std::hypot(q[0] - before[0], q[1] - before[1]) > 1e-6;
      EXPECT_TRUE(drives || std::fabs(q[2] - before[2]) > 1e-5) << beside;
      before = q;
    }
  }
}

TEST(Leg, CornersAreWhereTheStepsLead) {
  const robot::RobotModel model = test::vehicle();
  const robot::Mounting mounting = test::standing(model);
  const auto corners = Leg(model, mounting).corners(Q{0, 0, 0}, Q{3, 4, 90});
  ASSERT_EQ(corners.size(), 3u);
  EXPECT_NEAR(corners[0][2], 53.13010235, 1e-6);
  EXPECT_NEAR(corners[1][0], 3, 1e-9);
  EXPECT_NEAR(corners[1][1], 4, 1e-9);
  EXPECT_NEAR(corners[2][2], 90, 1e-9);
}

TEST(Leg, RefusesRulesThatAreNeitherPlainNorAVehicle) {
  robot::RobotModel model = test::vehicle();
  model.parameters[1].step = 0.5;  // it also goes sideways
  EXPECT_EQ(Leg(model, test::standing(model)).refusal(),
            "the rule of y is neither plain nor that of one local parameter");
  model = test::vehicle();
  model.parameters[2].step = 0;
  EXPECT_EQ(Leg(model, test::standing(model)).refusal(),
            "x drives it along no heading that it can turn");
}

}  // namespace
}  // namespace rubicon::guides
