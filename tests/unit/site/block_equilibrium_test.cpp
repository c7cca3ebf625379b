#include "src/simulation/site/block_equilibrium.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "src/motion/math/angles.hpp"
#include "src/results/verify/geometry/balance.hpp"

namespace rubicon::site {
namespace {

using math::Vec3;

constexpr double kFriction = 0.5;

/// Boxes in the plane y = 0, 1 m wide across it, each on what is below it.
struct Tower {
  std::vector<RigidBlock> blocks;
  std::vector<BlockContact> contacts;

  int add(double x0, double x1, double z0, double z1, double density = 1) {
    blocks.push_back({{(x0 + x1) / 2, 0, (z0 + z1) / 2}, density * (x1 - x0) * (z1 - z0), false});
    return static_cast<int>(blocks.size()) - 1;
  }
  void rest(int upper, int lower, double x0, double x1, double z) {
    contacts.push_back(
        {upper, lower, {{x0, -0.5, z}, {x1, -0.5, z}, {x1, 0.5, z}, {x0, 0.5, z}}, Vec3::UnitZ()});
  }
  std::vector<int> moving(double friction = kFriction) const {
    const auto found = find_collapse(blocks, contacts, {}, friction);
    EXPECT_TRUE(found.has_value());
    std::vector<int> all;
    if (found) {
      for (const BlockMotion& each : *found) all.push_back(each.block);
    }
    return all;
  }
};

TEST(BlockEquilibrium, ABoxStandsIfItsMiddleIsOverWhatCarriesIt) {
  for (const auto& [from, stands] : {std::pair{0.0, true}, {0.45, true}, {0.52, false}}) {
    Tower tower;
    const int box = tower.add(0, 1, 0, 1);
    tower.rest(box, -1, from, 1, 0);
    EXPECT_EQ(tower.moving().empty(), stands) << from;
  }
}

// Whatever its shape: the corners of a long contact were moved along the diagonal, which is hardly
// anything across it.
TEST(BlockEquilibrium, AContactCarriesOneMillimetreInside) {
  for (const double width : {0.02, 0.2, 2.0}) {
    for (const double inside : {0.0009, 0.0011}) {
      Tower tower;
      const int box = tower.add(0, 1, 0, 1);
      tower.rest(box, -1, 0.5 + inside - width, 0.5 + inside, 0);
      EXPECT_EQ(tower.moving().empty(), inside > 0.001) << width << " " << inside;
      for (Vec3& corner : tower.contacts[0].corners) std::swap(corner.x(), corner.y());
      for (RigidBlock& block : tower.blocks) std::swap(block.centre.x(), block.centre.y());
      std::reverse(tower.contacts[0].corners.begin(), tower.contacts[0].corners.end());
      EXPECT_EQ(tower.moving().empty(), inside > 0.001) << width << " " << inside;
    }
  }
}

// One that is narrower than 2 mm carries in its middle.
TEST(BlockEquilibrium, ANarrowContactCarriesInItsMiddle) {
  Tower rails;
  const int box = rails.add(0, 1, 0, 1);
  rails.rest(box, -1, 0.1, 0.1015, 0);
  EXPECT_FALSE(rails.moving().empty());
  rails.rest(box, -1, 0.7, 0.7015, 0);
  EXPECT_TRUE(rails.moving().empty());
  rails.contacts.pop_back();
  rails.rest(box, -1, 0.4985, 0.5001, 0);  // 0.1 mm inside
  EXPECT_FALSE(rails.moving().empty());
}

// The stack of equal planks that hang over by 1/2, 1/4, 1/6 ... of their length, from the top: a
// little less stands, a little more does not.
TEST(BlockEquilibrium, TheHarmonicStackIsTheLimit) {
  for (const double share : {0.98, 1.02}) {
    Tower tower;
    constexpr int kPlanks = 8;
    double x = 0;
    for (int i = 0; i < kPlanks; ++i) {
      const double below = x;
      if (i > 0) x += share / (2 * (kPlanks - i));
      tower.add(x, x + 1, 0.1 * i, 0.1 * (i + 1));
      tower.rest(i, i - 1, x, below + 1, 0.1 * i);
    }
    EXPECT_EQ(tower.moving().empty(), share < 1) << share;
  }
}

// A beam over an edge, held by a counterweight on its tail: the lever decides.
TEST(BlockEquilibrium, ACounterweightHoldsABeam) {
  for (const auto& [mass, stands] : {std::pair{0.9, false}, {1.1, true}}) {
    Tower tower;
    const int beam = tower.add(0, 3, 0, 0.2);
    tower.blocks[0].mass = 1;
    tower.rest(beam, -1, 0, 1, 0);  // turns about x = 1: 0.5 m beside its middle
    const int weight = tower.add(0.4, 0.6, 0.2, 0.4);
    tower.blocks[1].mass = mass;
    tower.rest(weight, beam, 0.4, 0.6, 0.2);  // 0.5 m on the other side
    EXPECT_EQ(tower.moving().empty(), stands) << mass;
    const std::vector<int> expected = stands ? std::vector<int>{} : std::vector<int>{0, 1};
    EXPECT_EQ(tower.moving(), expected);
  }
}

// Its corners are those of the pier that carries it: once answered wrongly.
TEST(BlockEquilibrium, ABeamOverAPierOfItsOwnWidthTurns) {
  Tower tower;
  tower.blocks = {{{20, 0, 1.5}, 7000, false}, {{21.25, 0, 3.1}, 1000, false}};
  tower.rest(0, -1, 19.5, 20.5, 0);
  tower.rest(1, 0, 19.5, 20.5, 3);
  EXPECT_EQ(tower.moving(), std::vector<int>{1});
}

// A programme without rows: the library crashed on it.
TEST(BlockEquilibrium, WhatNothingCarriesComesDown) {
  Tower tower;
  tower.add(0, 1, 2, 3);
  const auto found = find_collapse(tower.blocks, {}, {}, kFriction);
  ASSERT_TRUE(found.has_value());
  ASSERT_EQ(found->size(), 1U);
  EXPECT_EQ(found->front().move, Vec3(0, 0, -1));
  EXPECT_EQ(found->front().turn, Vec3::Zero());
  tower.blocks[0].braced = true;
  EXPECT_EQ(tower.moving(), std::vector<int>{0});
  tower.blocks[0].mass = 0;
  EXPECT_TRUE(tower.moving().empty());
}

// On a slope a block stays up to the angle of friction, whichever way the slope looks.
TEST(BlockEquilibrium, ABlockSlidesOnASlope) {
  for (const double heading : {0.0, 20.0, 45.0, 70.0}) {
    for (const double slope : {0.3, 0.49, 0.51, 0.6}) {
      const double x = math::cos_deg(heading);
      const double y = math::sin_deg(heading);
      const Vec3 normal = Vec3(-slope * x, -slope * y, 1).normalized();
      std::vector<BlockContact> contacts(1);
      for (const auto& [a, b] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
        contacts[0].corners.emplace_back(a, b, slope * (a * x + b * y));
      }
      contacts[0].normal = normal;
      const auto moving = find_collapse({{normal * 0.1, 5, false}}, contacts, {}, kFriction);
      ASSERT_TRUE(moving.has_value());
      if (slope < kFriction) {
        EXPECT_TRUE(moving->empty()) << slope;
      }
      if (slope > kFriction) {
        EXPECT_FALSE(moving->empty()) << slope;
      }
    }
  }
}

TEST(BlockEquilibrium, BracesAndJointsHold) {
  Tower tower;
  const int box = tower.add(0, 1, 0, 1);
  tower.rest(box, -1, 0.7, 1, 0);
  EXPECT_EQ(tower.moving(), std::vector<int>{0});
  tower.blocks[0].braced = true;
  EXPECT_TRUE(tower.moving().empty());
  tower.blocks[0].braced = false;
  const auto joined = find_collapse(tower.blocks, tower.contacts, {{0, -1}}, kFriction);
  ASSERT_TRUE(joined.has_value());
  EXPECT_TRUE(joined->empty());
  // A bracket on a wall that is light enough to go with it.
  Tower wall;
  wall.add(0, 0.2, 0, 3, 1);
  wall.rest(0, -1, 0, 0.2, 0);
  wall.add(0.2, 2.2, 2, 2.2, 1);
  const auto both = find_collapse(wall.blocks, wall.contacts, {{1, 0}}, kFriction);
  ASSERT_TRUE(both.has_value());
  EXPECT_EQ(both->size(), 2U);
}

/// Random towers of boxes on one another and on piers, from a seed.
Tower random_tower(std::uint64_t seed) {
  std::uint64_t state = seed * 6364136223846793005U + 1442695040888963407U;
  const auto draw = [&](double low, double high) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return low + (high - low) * static_cast<double>(state >> 11U) * 0x1p-53;
  };
  Tower tower;
  struct Row {
    double x0, x1;
    int block;
  };
  std::vector<Row> below = {{-1, 0, -1}, {2 + draw(0, 1), 4, -1}};
  double z = 0;
  const int rows = 2 + static_cast<int>(draw(0, 3));
  for (int row = 0; row < rows; ++row) {
    std::vector<Row> here;
    double x = draw(-2, 0);
    while (x < 3.5) {
      const double end = x + draw(0.5, 4);
      const int block = tower.add(x, end, z, z + 0.3, draw(0.2, 3));
      for (const Row& each : below) {
        const double x0 = std::max(x, each.x0);
        const double x1 = std::min(end, each.x1);
        if (x1 - x0 > 0.02) tower.rest(block, each.block, x0, x1, z);
      }
      here.push_back({x, end, block});
      x = end + draw(0.01, 1);
    }
    below = here;
    z += 0.3;
  }
  return tower;
}

// Two methods that share nothing: the motion found by the library, and the forces found by the
// simplex method of verify. They may differ in the millimetre that one keeps from the edge.
TEST(BlockEquilibrium, AgreesWithTheSecondOpinion) {
  int stand = 0;
  int differ = 0;
  constexpr int kTowers = 150;
  for (int seed = 0; seed < kTowers; ++seed) {
    const Tower tower = random_tower(static_cast<std::uint64_t>(seed));
    std::vector<verify::BalancedBody> bodies;
    for (const RigidBlock& block : tower.blocks) {
      bodies.push_back({block.centre, block.mass, block.braced});
    }
    std::vector<verify::BalancePoint> points;
    for (const BlockContact& contact : tower.contacts) {
      std::vector<verify::FootingPoint> corners;
      for (const Vec3& corner : contact.corners) corners.push_back({corner, contact.normal});
      for (const verify::FootingPoint& each : verify::drawn_in(corners, 0.00098)) {
        points.push_back({contact.upper, contact.lower, each});
      }
    }
    const verify::Balance balance = verify::balance_of(bodies, points, {}, kFriction);
    ASSERT_NE(balance, verify::Balance::not_known) << seed;
    const bool stands = tower.moving().empty();
    stand += stands ? 1 : 0;
    if (stands) {
      ASSERT_EQ(balance, verify::Balance::holds) << seed;
    }
    if (!stands && balance == verify::Balance::holds) ++differ;
  }
  EXPECT_GT(stand, kTowers / 20);
  EXPECT_LT(stand, kTowers - kTowers / 20);
  EXPECT_LE(differ, kTowers / 50);
}

}  // namespace
}  // namespace rubicon::site
