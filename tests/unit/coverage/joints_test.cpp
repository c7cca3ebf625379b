#include "src/motion/coverage/joints.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace rubicon::coverage {
namespace {

/// Ticks are seconds here.
constexpr std::int64_t kHour = 3600;

TEST(Joints, AgeIsLinearAlongTwoLinesThereAndBack) {
  // 10 m there in 10 s, 2 s later back beside it: at x the first has lain 22 - 2 x seconds.
  const std::vector<LaidStretch> laid = {{{0, 0}, {10, 0}, 0, 10}, {{10, 1}, {0, 1}, 12, 22}};
  const JointFindings found = find_joints(laid, 1, 12);
  EXPECT_NEAR(found.joint_length, 10, 1e-6);
  EXPECT_EQ(found.oldest, 22);
  EXPECT_NEAR(found.oldest_at.x, 0, 1e-6);
  EXPECT_NEAR(found.oldest_at.y, 0.5, 1e-6);
  EXPECT_NEAR(found.cold_length, 5, 1e-6);
  ASSERT_EQ(found.cold.size(), 1u);
  EXPECT_EQ(found.cold[0].age, 22);
  EXPECT_EQ(found.cold[0].laid, 0);
  EXPECT_EQ(found.cold[0].joined, 22);
  EXPECT_NEAR(std::max(found.cold[0].from.x, found.cold[0].to.x), 5, 1e-6);
  EXPECT_NEAR(find_joints(laid, 1, 22).cold_length, 0, 1e-6);
}

TEST(Joints, ABreakInTheMiddleOfALineIsAJointAcrossIt) {
  const std::vector<LaidStretch> laid = {{{0, 0}, {5, 0}, 0, 5},
                                         {{5, 0}, {10, 0}, 5 + kHour, 10 + kHour}};
  const JointFindings found = find_joints(laid, 1, kHour - 1);
  EXPECT_NEAR(found.joint_length, 1, 1e-6);
  EXPECT_EQ(found.oldest, kHour);
  ASSERT_EQ(found.cold.size(), 1u);
  EXPECT_NEAR(found.cold[0].from.x, 5, 1e-6);
  EXPECT_NEAR(std::abs(found.cold[0].to.y - found.cold[0].from.y), 1, 1e-6);
}

TEST(Joints, OnlyTheFirstNeighbourMakesTheJoint) {
  // What comes last lies on both: with the second one the first has its joint already.
  const std::vector<LaidStretch> laid = {{{0, 0}, {10, 0}, 0, 10},
                                         {{0, 1}, {10, 1}, 10, 20},
                                         {{0, 1}, {10, 1}, 5 * kHour, 5 * kHour + 10},
                                         {{0, 3}, {10, 3}, 9 * kHour, 9 * kHour + 10}};
  const JointFindings found = find_joints(laid, 1, kHour);
  EXPECT_EQ(found.oldest, 10);
  EXPECT_TRUE(found.cold.empty());
}

TEST(Joints, ALineThatEndsAtAPassOlderThanIt) {
  // A pass along y at the border, then lines along x up to it; each meets it with its end.
  std::vector<LaidStretch> laid = {{{0, 0}, {0, 4}, 0, 40}};
  for (int i = 0; i < 4; ++i) {
    laid.push_back({{0.5, 0.5 + i}, {10, 0.5 + i}, 100 + 100 * i, 195 + 100 * i});
  }
  const JointFindings found = find_joints(laid, 1, 300);
  // At the pass: 4 m of ends, the oldest at the corner between the last lines; between lines 3
  // times 9.5 m, each 100 s old.
  EXPECT_NEAR(found.joint_length, 4 + 3 * 9.5, 0.1);
  EXPECT_EQ(found.oldest, 400 - 30);
  EXPECT_NEAR(found.cold_length, 1, 0.05);
}

TEST(Joints, RandomLinesThereAndBackAgreeWithTheirEnds) {
  std::mt19937 random(17);
  const auto between = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  for (int round = 0; round < 200; ++round) {
    const double spacing = 0.7 + 0.01 * between(0, 30);
    std::vector<LaidStretch> laid;
    std::int64_t now = 0;
    for (int i = 0; i < 8; ++i) {
      const std::int64_t begin = now + between(0, 2000);
      const std::int64_t end = begin + between(10, 900);
      const bool there = i % 2 == 0;
      laid.push_back(
          {{there ? 0.0 : 10.0, i * spacing}, {there ? 10.0 : 0.0, i * spacing}, begin, end});
      now = end;
    }
    // Ages are linear from one end of a joint to the other: one of its ends is the oldest.
    std::int64_t oldest = 0;
    double cold = 0;
    const std::int64_t limit = between(100, 3000);
    for (std::size_t i = 0; i + 1 < laid.size(); ++i) {
      const std::int64_t at_turn = laid[i + 1].begin - laid[i].end;
      const std::int64_t at_start = laid[i + 1].end - laid[i].begin;
      oldest = std::max({oldest, at_turn, at_start});
      const double share =
          static_cast<double>(at_start - limit) / static_cast<double>(at_start - at_turn);
      cold += 10 * std::clamp(share, 0.0, 1.0);
    }
    const JointFindings found = find_joints(laid, 1, limit);
    EXPECT_NEAR(found.joint_length, 70, 1e-6);
    EXPECT_EQ(found.oldest, oldest);
    EXPECT_NEAR(found.cold_length, cold, 1e-6);
  }
}

TEST(Joints, NothingWhereNothingTouches) {
  EXPECT_EQ(find_joints({}, 1, 1).joint_length, 0);
  const std::vector<LaidStretch> apart = {{{0, 0}, {10, 0}, 0, 10}, {{0, 1.1}, {10, 1.1}, 99, 109}};
  EXPECT_EQ(find_joints(apart, 1, 1).joint_length, 0);
  EXPECT_EQ(find_joints({{{1, 1}, {1, 1}, 0, 5}}, 1, 1).joint_length, 0);
}

}  // namespace
}  // namespace rubicon::coverage
