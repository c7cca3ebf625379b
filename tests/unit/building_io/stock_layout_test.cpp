#include "src/exchange/building_io/stock_layout.hpp"

#include <gtest/gtest.h>

#include <random>

#include "src/motion/math/pose.hpp"

namespace rubicon::building_io {
namespace {

StockArea area(const Vec3& lower, const Vec3& upper, int stack = 1, const std::string& name = "") {
  StockArea result;
  result.name = name;
  result.box = {lower, upper};
  result.stack = stack;
  return result;
}

struct Block {
  Vec3 lower, upper;
};

Block block_of(const StockItem& item, const StockPlace& place) {
  const bool turned = place.turn_deg == 90;
  const double x = turned ? item.size.y() : item.size.x();
  const double y = turned ? item.size.x() : item.size.y();
  return {place.origin - Vec3(x / 2, y / 2, 0), place.origin + Vec3(x / 2, y / 2, item.size.z())};
}

/// Places are given to 0.01 mm.
constexpr double kRounding = 2e-5;

TEST(StockLayout, NothingTouchesAndAllLieInTheirArea) {
  std::mt19937 random(3);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() % 1000) / 1000;
  };
  for (int round = 0; round < 200; ++round) {
    std::vector<StockItem> items;
    for (int i = 0; i < 60; ++i) {
      StockItem item;
      item.size = {between(0.5, 8), between(0.05, 0.5), between(0.05, 3)};
      item.group = random() % 3;
      items.push_back(item);
    }
    const std::vector<StockArea> areas = {area({-40, -10, -1}, {-20, between(0, 20), between(1, 4)},
                                               1 + static_cast<int>(random() % 6)),
                                          area({0, 0, 0.5}, {between(9, 30), 12, 3})};
    const auto places = lay_out(items, areas);
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (!places[i]) continue;
      const Block block = block_of(items[i], *places[i]);
      bool inside = false;
      for (const StockArea& each : areas) {
        inside = inside || ((block.lower - each.box.lower).head<2>().minCoeff() > -kRounding &&
                            (each.box.upper - block.upper).minCoeff() > -kRounding);
      }
      EXPECT_TRUE(inside);
      for (const Block& other : blocks) {
        const double apart = std::max((block.lower - other.upper).maxCoeff(),
                                      (other.lower - block.upper).maxCoeff());
        EXPECT_GT(apart, 0.1 - kRounding);
      }
      blocks.push_back(block);
    }
    EXPECT_FALSE(blocks.empty());
  }
}

TEST(StockLayout, NothingIsHigherThanItsArea) {
  StockItem wall, slab;
  wall.size = {4, 0.3, 3};
  slab.size = {4, 2.5, 1.2};
  const std::vector<StockArea> areas = {area({0, 0, -1}, {20, 10, 0}),
                                        area({30, 0, 0}, {50, 10, 1.2})};
  const auto places = lay_out({wall, slab}, areas);
  EXPECT_FALSE(places[0]);
  ASSERT_TRUE(places[1]);
  EXPECT_GT(places[1]->origin.x(), 30);
}

TEST(StockLayout, WhatIsUsedFirstLiesOnTop) {
  StockItem slab;
  slab.size = {6, 1.2, 0.3};
  const auto places = lay_out(std::vector<StockItem>(4, slab), {area({0, 0, 0}, {20, 10, 4}, 3)});
  EXPECT_NEAR(places[0]->origin.z(), 0.8, 1e-9);
  EXPECT_NEAR(places[1]->origin.z(), 0.4, 1e-9);
  EXPECT_NEAR(places[2]->origin.z(), 0, 1e-9);
  EXPECT_NEAR(places[3]->origin.z(), 0, 1e-9);
  EXPECT_NE(places[3]->origin.y(), places[2]->origin.y());
}

TEST(StockLayout, PilesAreOfOneGroupFlatAndNotTooHigh) {
  StockItem slab;
  slab.size = {6, 1.2, 0.3};
  StockItem other = slab;
  other.group = 1;
  StockItem wall;
  wall.size = {6, 0.2, 2.7};
  const StockArea wide = area({0, 0, 0}, {20, 10, 4}, 9);
  const auto lowest = [](const std::vector<std::optional<StockPlace>>& places) {
    int count = 0;
    for (const auto& place : places) count += place->origin.z() == 0 ? 1 : 0;
    return count;
  };
  EXPECT_EQ(lowest(lay_out({slab, slab}, {wide})), 1);
  EXPECT_EQ(lowest(lay_out({slab, other}, {wide})), 2);
  EXPECT_EQ(lowest(lay_out({wall, wall}, {wide})), 2);
  EXPECT_EQ(lowest(lay_out({slab, slab}, {area({0, 0, 0}, {20, 10, 0.65}, 9)})), 2);
}

TEST(StockLayout, LongerSidesLieAlongTheLongerSideOfTheArea) {
  StockItem item;
  item.size = {6, 1, 1};
  EXPECT_EQ(lay_out({item}, {area({0, 0, 0}, {20, 10, 4})})[0]->turn_deg, 0);
  EXPECT_EQ(lay_out({item}, {area({0, 0, 0}, {10, 20, 4})})[0]->turn_deg, 90);
}

TEST(StockLayout, ANamedAreaIsKeptToAndAFullOneSaysSo) {
  StockItem item;
  item.size = {6, 1, 1};
  StockItem in_yard = item;
  in_yard.stock = "yard";
  const std::vector<StockArea> areas = {area({0, 0, 0}, {7, 1.2, 2}, 1, "yard"),
                                        area({50, 0, 0}, {57, 1.2, 2}, 1, "lot")};
  const auto places = lay_out({item, item, in_yard, item}, areas);
  EXPECT_LT(places[0]->origin.x(), 7);
  EXPECT_GT(places[1]->origin.x(), 50);
  EXPECT_FALSE(places[2]);
  EXPECT_FALSE(places[3]);
  EXPECT_FALSE(lay_out({item}, {})[0]);
  EXPECT_TRUE(lay_out({}, areas).empty());
}

}  // namespace
}  // namespace rubicon::building_io
