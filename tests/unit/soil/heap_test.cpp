#include "src/earth/soil/heap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace rubicon::soil {
namespace {

constexpr double kPi = 3.14159265358979323846;

Terrain apply(Terrain ground, const HeapGrowth& growth) {
  for (const auto& [cell, height] : growth.heights) {
    ground.heights.set(static_cast<std::size_t>(cell), height);
  }
  return ground;
}

std::int64_t units_between(const Terrain& before, const Terrain& after) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < before.heights.size(); ++i) {
    sum += after.heights[i] - before.heights[i];
  }
  return sum;
}

/// By how many mm a cell that was raised is above one beside it more than the slope allows.
double steepest_excess(const Terrain& after, const HeapGrowth& growth, double repose_deg) {
  const double slope = std::tan(repose_deg * kPi / 180);
  double most = -1e9;
  for (const auto& each : growth.heights) {
    const int column = each.first % after.columns;
    const int row = each.first / after.columns;
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, after.rows - 1); ++r) {
      for (int c = std::max(column - 1, 0); c <= std::min(column + 1, after.columns - 1); ++c) {
        const double apart =
            std::hypot(c - column, r - row) * static_cast<double>(after.cell) * slope;
        const auto down = static_cast<double>(each.second - after.heights[after.index(c, r)]);
        most = std::max(most, down - apart);
      }
    }
  }
  return most;
}

TEST(Heap, ConeOnLevelGround) {
  // 10 m3 at 35 deg: a cone of radius (3 V / (pi tan))^(1/3) = 2.389 m and 1.673 m high.
  const Terrain ground = flat(80, 80, 100, 0);
  const HeapGrowth growth = tip_over(ground, static_cast<int>(ground.index(40, 40)), 1'000'000, 35);
  const Terrain after = apply(ground, growth);
  EXPECT_FALSE(growth.reaches_border);
  EXPECT_EQ(units_between(ground, after), 1'000'000);
  EXPECT_NEAR(static_cast<double>(after.heights[after.index(40, 40)]), 1673, 15);
  EXPECT_GT(after.heights[after.index(40 + 23, 40)], 0);
  EXPECT_EQ(after.heights[after.index(40 + 25, 40)], 0);
  EXPECT_LE(steepest_excess(after, growth, 35), 2);
}

TEST(Heap, ReachesTheBorder) {
  const Terrain ground = flat(20, 20, 500, 0);
  EXPECT_TRUE(tip_over(ground, 0, 100, 35).reaches_border);
  EXPECT_FALSE(tip_over(ground, static_cast<int>(ground.index(10, 10)), 100, 35).reaches_border);
  // More than the whole grid holds without falling over its border.
  const HeapGrowth all =
      tip_over(ground, static_cast<int>(ground.index(10, 10)), 400LL * 100'000, 35);
  EXPECT_TRUE(all.reaches_border);
  EXPECT_EQ(units_between(ground, apply(ground, all)), 400LL * 100'000);
}

/// Loads at random places on hilly ground, some of it steeper than loose soil lies.
TEST(Heap, RandomLoadsKeepVolumeAndSlope) {
  std::mt19937_64 random(20261126);
  Terrain ground = flat(48, 40, 250, 0);
  for (std::size_t i = 0; i < ground.heights.size(); ++i) {
    ground.heights.set(i, static_cast<Millimetres>(random() % 900));
  }
  std::int64_t total = 0;
  Terrain now = ground;
  for (int load = 0; load < 2'000; ++load) {
    if (load % 100 == 0) now = ground, total = 0;
    const int cell = static_cast<int>(random() % now.heights.size());
    const auto units = static_cast<std::int64_t>(1 + random() % 40'000);
    const double repose = 20 + static_cast<double>(random() % 30);
    const HeapGrowth growth = tip_over(now, cell, units, repose);
    for (const auto& each : growth.heights) {
      ASSERT_GT(each.second, now.heights[static_cast<std::size_t>(each.first)]);
    }
    now = apply(now, growth);
    total += units;
    ASSERT_EQ(units_between(ground, now), total) << "load " << load;
    ASSERT_LE(steepest_excess(now, growth, repose), 2) << "load " << load;
  }
}

}  // namespace
}  // namespace rubicon::soil
