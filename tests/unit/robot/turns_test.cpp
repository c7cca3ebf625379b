#include "src/motion/robot/turns.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rubicon::robot {
namespace {

Parameter cyclic(int prefer = 1) {
  Parameter p;
  p.rotation = p.cyclic = true;
  p.prefer = prefer;
  return p;
}

TEST(Turns, OnlyACyclicParameterIsReduced) {
  EXPECT_EQ(reduced(cyclic(), 190), -170);
  EXPECT_EQ(reduced(cyclic(-1), -180), 180) << "a value has one form, whatever is preferred";
  EXPECT_EQ(reduced(Parameter(), 190), 190);
  RobotModel model;
  model.parameters = {cyclic(), Parameter()};
  std::vector<double> q = {-190, -190};
  normalise(model, q);
  EXPECT_EQ(q, (std::vector<double>{170, -190}));
}

TEST(Turns, TheWayIsTheShortOneAndATieGoesThePreferredWay) {
  EXPECT_EQ(way_between(cyclic(), 170, -170), 20);
  EXPECT_EQ(way_between(cyclic(), -170, 170), -20);
  EXPECT_EQ(way_between(cyclic(), 0, 180), 180);
  EXPECT_EQ(way_between(cyclic(), 180, 0), 180);
  EXPECT_EQ(way_between(cyclic(-1), 0, 180), -180);
  Parameter limited;
  limited.rotation = true;
  limited.prefer = -1;
  EXPECT_EQ(way_between(limited, 0, 180), 180) << "it cannot go round";
  EXPECT_EQ(way_between(limited, 170, -170), -340);
}

TEST(Turns, TheNearestSenseOfAnAxis) {
  EXPECT_EQ(nearest_axis(cyclic(), 10, 170), 190);
  EXPECT_EQ(nearest_axis(cyclic(), 90, 0), 90);
  EXPECT_EQ(nearest_axis(cyclic(), -90, 0), 90) << "a quarter turn both ways";
  EXPECT_EQ(nearest_axis(cyclic(-1), 90, 0), -90);
  EXPECT_EQ(nearest_axis(cyclic(), 90 - 1e-12, 0), 90) << "but for rounding";
}

TEST(Turns, AnyTurnInsideTheRangeWillDo) {
  Parameter p;
  p.rotation = true;
  p.lower = 300;
  p.upper = 400;
  EXPECT_TRUE(has_turn_equivalent(p, 0));
  EXPECT_TRUE(has_turn_equivalent(p, -60));
  EXPECT_FALSE(has_turn_equivalent(p, 180));
}

TEST(TurnEquivalent, TheNearestInsideTheRange) {
  Parameter p;
  p.rotation = true;
  p.lower = -400;
  p.upper = 400;
  EXPECT_EQ(nearest_turn_equivalent(p, 10, 0), 10);
  EXPECT_EQ(nearest_turn_equivalent(p, 10, 300), 370);
  EXPECT_EQ(nearest_turn_equivalent(p, 730, -200), -350);
  EXPECT_EQ(nearest_turn_equivalent(p, 50, 500), 50) << "410 is out of range";
  EXPECT_EQ(nearest_turn_equivalent(p, 180, 0), 180) << "a tie goes the preferred way";
  p.prefer = -1;
  EXPECT_EQ(nearest_turn_equivalent(p, 180, 0), -180);
}

TEST(TurnEquivalent, WithoutOneInRangeTheValueStays) {
  Parameter p;
  p.rotation = true;
  p.lower = -30;
  p.upper = 30;
  EXPECT_EQ(nearest_turn_equivalent(p, 200, 0), 200);
  EXPECT_EQ(nearest_turn_equivalent(p, 385, 0), 25);
  EXPECT_EQ(nearest_turn_equivalent(p, 30 + 1e-12, 0), 30) << "rounding does not leave the range";
  p.rotation = false;
  EXPECT_EQ(nearest_turn_equivalent(p, 385, 0), 385);
}

}  // namespace
}  // namespace rubicon::robot
