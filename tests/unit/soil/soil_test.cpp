#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/earth/soil/blocks.hpp"
#include "src/earth/soil/excavation.hpp"
#include "src/earth/soil/terrain.hpp"
#include "src/motion/math/random.hpp"
#include "tests/support/random_cases.hpp"

namespace rubicon::soil {
namespace {

constexpr double kMm3 = 1e9;

std::vector<Eigen::Vector2d> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

CubicMillimetres volume_between(const Terrain& under, const Terrain& above) {
  CubicMillimetres sum = 0;
  for (std::size_t i = 0; i < above.heights.size(); ++i) {
    sum += (above.heights[i] - under.heights[i]) * above.cell * above.cell;
  }
  return sum;
}

TEST(Excavation, UprightWallsAreExact) {
  const Terrain ground = flat(80, 60, 250, 0);
  const Excavation pit = excavate(ground, {rectangle(5, 4, 9.75, 6), -3200}, 90);
  EXPECT_EQ(pit.volume, 4750LL * 2000 * 3200);
  EXPECT_EQ(pit.volume, pit.in_outline);
  EXPECT_EQ(pit.cells, 19 * 8);
  EXPECT_FALSE(pit.reaches_border);
  EXPECT_EQ(pit.after.heights[ground.index(20, 16)], -3200);
  EXPECT_EQ(pit.after.heights[ground.index(19, 16)], 0);
}

/// A pit with battered walls: the rectangle, wedges along its sides, quarter cones at its corners.
TEST(Excavation, SlopesAreThoseOfTheHandbook) {
  for (const double stands : {35.0, 45.0, 60.0, 80.0}) {
    const double wide = 6, deep = 3, depth = 2.5;
    const double run = depth / std::tan(stands * std::numbers::pi / 180);
    const double expected = wide * deep * depth + (wide + deep) * depth * run +
                            std::numbers::pi * run * run * depth / 3;
    const Terrain ground = flat(400, 400, 50, 1000);
    const Excavation pit =
        excavate(ground, {rectangle(7, 8, 7 + wide, 8 + deep), 1000 - 2500}, stands);
    EXPECT_NEAR(static_cast<double>(pit.volume) / kMm3, expected, 0.003 * expected) << stands;
    EXPECT_EQ(pit.in_outline, 6000LL * 3000 * 2500);
  }
}

TEST(Excavation, WhatIsLowerStays) {
  Terrain ground = flat(40, 40, 500, 0);
  for (int row = 0; row < 40; ++row) ground.heights.set(ground.index(10, row), -5000);
  const Excavation pit = excavate(ground, {rectangle(2, 2, 18, 18), -2000}, 90);
  EXPECT_EQ(pit.after.heights[ground.index(10, 20)], -5000);
  EXPECT_EQ(pit.volume, (32LL * 32 - 32) * 500 * 500 * 2000);
}

TEST(Excavation, TellsWhenSlopesLeaveTheTerrain) {
  const Terrain ground = flat(20, 20, 500, 0);
  EXPECT_FALSE(excavate(ground, {rectangle(4, 4, 6, 6), -1000}, 45).reaches_border);
  EXPECT_TRUE(excavate(ground, {rectangle(4, 4, 6, 6), -5000}, 45).reaches_border);
}

/// Random ground and polygons: nothing is lost, no slope from the pit is steeper than allowed, and
/// blocks are the soil between the surfaces, each piece once.
TEST(Excavation, RandomPitsKeepTheirBalance) {
  math::Random random(3);
  for (int round = 0; round < test::cases(300); ++round) {
    const int columns = 5 + static_cast<int>(random.index(30));
    const int rows = 5 + static_cast<int>(random.index(30));
    Terrain ground = flat(columns, rows, 100 + static_cast<int>(random.index(5)) * 100, 0);
    const bool rough = random.index(2) == 0;
    for (std::size_t i = 0; i < ground.heights.size(); ++i) {
      ground.heights.set(i, rough ? static_cast<Millimetres>(random.index(3000)) : 1000);
    }
    Pit pit;
    pit.bottom = -static_cast<Millimetres>(random.index(4000));
    const double side = static_cast<double>(ground.cell) * 1e-3;
    const Eigen::Vector2d middle(random.between(0, columns * side), random.between(0, rows * side));
    const int corners = 3 + static_cast<int>(random.index(6));
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      pit.outline.push_back(middle + random.between(0.3, 4) * side *
                                         Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    const double stands = random.index(3) == 0 ? 90 : random.between(20, 89);
    const Excavation dug = excavate(ground, pit, stands);
    EXPECT_EQ(dug.volume, volume_between(dug.after, ground));
    for (std::size_t i = 0; i < ground.heights.size(); ++i) {
      EXPECT_LE(dug.after.heights[i], ground.heights[i]);
      EXPECT_GE(dug.after.heights[i], std::min(pit.bottom, ground.heights[i]));
    }
    const std::vector<Block> blocks = blocks_between(dug.after, ground);
    CubicMillimetres sum = 0;
    std::vector<int> times(ground.heights.size(), 0);
    for (const Block& block : blocks) {
      sum += block.volume(ground.cell);
      for (int row = block.first_row; row < block.end_row; ++row) {
        for (int column = block.first_column; column < block.end_column; ++column) {
          const std::size_t at = ground.index(column, row);
          ++times[at];
          EXPECT_EQ(block.bottom, dug.after.heights[at]);
          EXPECT_EQ(block.top, ground.heights[at]);
        }
      }
    }
    EXPECT_EQ(sum, dug.volume);
    for (std::size_t i = 0; i < times.size(); ++i) {
      EXPECT_EQ(times[i], dug.after.heights[i] < ground.heights[i] ? 1 : 0);
    }
    // A second time there is nothing to dig.
    EXPECT_EQ(excavate(dug.after, pit, stands).volume, 0);
  }
}

TEST(Blocks, FlatGroundIsOne) {
  const Terrain ground = flat(300, 200, 250, 0);
  EXPECT_EQ(blocks_between(flat(300, 200, 250, -1000), ground).size(), 1u);
  const Excavation pit = excavate(ground, {rectangle(10, 10, 20, 15), -2000}, 90);
  EXPECT_LE(blocks_between(flat(300, 200, 250, -3000), pit.after).size(), 5u);
  EXPECT_EQ(blocks_between(pit.after, ground).size(), 1u);
}

TEST(TerrainText, IsReadAsAMapIsDrawn) {
  const auto read = terrain_of("# heights\n1, 2.5, 3\r\n\n4;5;6.0004\n", 3, 2, 500);
  ASSERT_TRUE(std::holds_alternative<Terrain>(read));
  const Terrain& ground = std::get<Terrain>(read);
  ASSERT_EQ(ground.heights.size(), 6u);
  const Heights expected(std::vector<Millimetres>{4000, 5000, 6000, 1000, 2500, 3000});
  EXPECT_EQ(ground.heights.next_difference(expected, 0), 6u);
}

TEST(TerrainText, SaysWhatIsWrong) {
  const auto fault = [](const char* text) {
    const auto read = terrain_of(text, 3, 2, 500);
    return std::holds_alternative<std::string>(read) ? std::get<std::string>(read) : "";
  };
  EXPECT_EQ(fault("1 2 3\n4 5\n"), "line 2: expected 3 heights, found 2");
  EXPECT_EQ(fault("1 2 3 4\n"), "line 1: more than 3 heights in a row");
  EXPECT_EQ(fault("1 2 3\n"), "expected 2 rows of heights, found 1");
  EXPECT_EQ(fault(""), "expected 2 rows of heights, found 0");
  EXPECT_EQ(fault("1 2 3\n1 2 3\n1 2 3\n"), "line 3: more than 2 rows of heights");
  EXPECT_EQ(fault("1 2 x3\n1 2 3\n"), "line 1: expected a height in m, found 'x3'");
  EXPECT_EQ(fault("1 2 3m\n1 2 3\n"), "line 1: expected a height in m, found '3m'");
  EXPECT_EQ(fault("1 2 1e300\n1 2 3\n"), "line 1: a height is up to 10000 m either way");
  EXPECT_EQ(fault("1 2 nan\n1 2 3\n"), "line 1: a height is up to 10000 m either way");
}

}  // namespace
}  // namespace rubicon::soil
