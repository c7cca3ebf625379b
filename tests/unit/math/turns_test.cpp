#include "src/motion/math/turns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rubicon::math {
namespace {

TEST(Turns, NormalisedIsInTheHalfOpenTurn) {
  EXPECT_EQ(normalised_deg(180), 180);
  EXPECT_EQ(normalised_deg(-180), 180);
  EXPECT_EQ(normalised_deg(540), 180);
  EXPECT_EQ(normalised_deg(-540), 180);
  EXPECT_EQ(normalised_deg(181), -179);
  EXPECT_EQ(normalised_deg(-181), 179);
  EXPECT_EQ(normalised_deg(3605), 5);
  EXPECT_FALSE(std::signbit(normalised_deg(-720)));
  EXPECT_EQ(normalised_deg(-0x1.23456789p-30), -0x1.23456789p-30) << "bit for bit";
  EXPECT_TRUE(std::isnan(normalised_deg(std::numeric_limits<double>::infinity())));
}

TEST(Turns, AnAxisIsInTheHalfOpenHalfTurn) {
  EXPECT_EQ(normalised_axis_deg(90), 90);
  EXPECT_EQ(normalised_axis_deg(-90), 90);
  EXPECT_EQ(normalised_axis_deg(91), -89);
  EXPECT_EQ(normalised_axis_deg(180), 0);
  EXPECT_EQ(normalised_axis_deg(-180), 0);
  EXPECT_EQ(normalised_axis_deg(-91), 89);
}

TEST(Turns, ATurnAboveALeastOne) {
  EXPECT_EQ(turn_above_deg(0, 0), 360);
  EXPECT_EQ(turn_above_deg(360, 0), 360);
  EXPECT_EQ(turn_above_deg(-90, 0), 270);
  EXPECT_EQ(turn_above_deg(90, 0), 90);
  EXPECT_EQ(turn_above_deg(1e-10, 1e-9), 360 + 1e-10);
}

TEST(Turns, EquivalentsPointTheSameWay) {
  EXPECT_EQ(nearest_equivalent_deg(10, 700), 730);
  EXPECT_EQ(nearest_equivalent_deg(180, 0), 180);
  EXPECT_EQ(nearest_equivalent_deg(-180, 0), 180) << "a tie ends above";
  EXPECT_EQ(first_equivalent_deg(90, 91), 450);
  EXPECT_EQ(first_equivalent_deg(90, 90), 90);
  EXPECT_EQ(first_equivalent_deg(90, -270), -270);
  EXPECT_EQ(other_way_round_deg(90), -270);
  EXPECT_EQ(other_way_round_deg(-90), 270);
}

TEST(Turns, TheNearestWholeTurns) {
  EXPECT_EQ(whole_turns_deg(359), 360);
  EXPECT_EQ(whole_turns_deg(-181), -360);
  EXPECT_EQ(whole_turns_deg(180), 360) << "a tie goes up";
  EXPECT_EQ(whole_turns_deg(-180), 0);
  EXPECT_TRUE(is_whole_turns_deg(-720));
  EXPECT_TRUE(is_whole_turns_deg(0));
  EXPECT_FALSE(is_whole_turns_deg(361));
}

}  // namespace
}  // namespace rubicon::math
