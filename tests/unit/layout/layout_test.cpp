#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "src/fleets/layout/best_layouts.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/lanes/lane_fixtures.hpp"

namespace rubicon::layout {
namespace {

using lanes::TestRandom;

Polygon rectangle(double width, double height) {
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

Sizes sizes_of(double length, double depth, double lane) {
  Sizes sizes;
  sizes.length = length;
  sizes.depth = depth;
  sizes.lane = lane;
  sizes.spacing = lane;
  return sizes;
}

TEST(Layout, OneAisleByHand) {
  Hall hall;
  hall.outline = rectangle(20, 5.4);
  hall.gates = {{"gate", {-2, 2.7}}};
  const Sizes sizes = sizes_of(2, 1.2, 3);
  const Choice choice{false, Ways::shared, 0, 1.2};
  const Layout layout = judge(choice, arrange(HallSpace(hall, false), sizes, choice), sizes);
  // The aisle from y = 1.2 to 4.2, cross aisles 3 m wide at both walls, 7 modules in each row.
  ASSERT_EQ(layout.modules.size(), 14u);
  EXPECT_EQ(layout.aisles, 1);
  // Nodes at 1.5 + 3.4 k; the gate is 3.5 m from the first. Modules in the middle of 4, 6 ... 16
  // are served from 4.9, 4.9, 8.3, 8.3, 11.7, 15.1, 15.1.
  EXPECT_NEAR(layout.mean_trip, 2 * (2 * 6.9 + 2 * 10.3 + 13.7 + 2 * 17.1) / 7, 1e-6);
  // All trips go through the crossing: it is held while a vehicle comes from the gate and goes to
  // the first node, 3.5 s + 3.4 s, and the same on the way back; the first node longer for none.
  EXPECT_NEAR(layout.trips_per_hour, 3600 / (2 * (3.5 + 3.4)), 1e-6);
  // 17 m of aisle and 3.5 m to the gate.
  EXPECT_NEAR(layout.lane_metres, 20.5, 1e-9);
}

TEST(Layout, OneWayNeedsARing) {
  Hall hall;
  hall.outline = rectangle(20, 5.4);
  hall.gates = {{"gate", {-2, 2.7}}};
  const Sizes sizes = sizes_of(2, 1.2, 3);
  const Choice choice{false, Ways::one_way, 0, 1.2};
  EXPECT_TRUE(judge(choice, arrange(HallSpace(hall, false), sizes, choice), sizes).modules.empty());
}

TEST(Layout, RowsLeaveOutColumns) {
  Hall hall;
  hall.outline = rectangle(20, 5.4);
  hall.gates = {{"gate", {-2, 2.7}}};
  hall.obstacles = {square({8, 0.6}, 0.4)};
  const Sizes sizes = sizes_of(2, 1.2, 3);
  const Choice choice{false, Ways::shared, 0, 1.2};
  const Layout layout = judge(choice, arrange(HallSpace(hall, false), sizes, choice), sizes);
  // From 3 two modules up to the column at 7.8, from 8.2 four more.
  EXPECT_EQ(layout.modules.size(), 7u + 2 + 4);
  // A column in the aisle breaks it: nothing behind can be reached.
  hall.obstacles = {around({10, 2.7}, 0.4)};
  const Layout broken = judge(choice, arrange(HallSpace(hall, false), sizes, choice), sizes);
  for (const Module& module : broken.modules) EXPECT_LT(module.box.x1, 13);
  EXPECT_LT(broken.modules.size(), 14u);
  EXPECT_GT(broken.modules.size(), 0u);
}

TEST(Layout, AGateReachesBothLanesOfAnAisle) {
  Hall hall;
  hall.outline = rectangle(30, 12);
  hall.gates = {{"gate", {-2, 6}}};
  const Sizes sizes = sizes_of(2, 1.2, 3);
  const Choice choice{false, Ways::two_lanes, 0, 3};
  const Layout layout = judge(choice, arrange(HallSpace(hall, false), sizes, choice), sizes);
  ASSERT_FALSE(layout.modules.empty());
  // The lanes along the left wall lie at x = 1.5 and 4.5: from the gate a lane leads to the first,
  // and one from there to the second.
  int from_gate = 0;
  int between = 0;
  for (const lanes::Lane& lane : layout.network.lanes) {
    const lanes::Node& a = layout.network.nodes[static_cast<std::size_t>(lane.from)];
    const lanes::Node& b = layout.network.nodes[static_cast<std::size_t>(lane.to)];
    from_gate += a.x == -2 && b.x == 1.5 ? 1 : 0;
    between += a.x == 1.5 && b.x == 4.5 && a.y == b.y ? 1 : 0;
  }
  EXPECT_EQ(from_gate, 1);
  EXPECT_GE(between, 1);
}

TEST(Layout, RefusesWhatCannotBe) {
  Hall hall;
  hall.outline = rectangle(20, 20);
  EXPECT_THROW(best_layouts(hall, sizes_of(2, 1, 3)), std::invalid_argument);
  hall.gates = {{"gate", {-2, 10}}};
  EXPECT_THROW(best_layouts(hall, sizes_of(0, 1, 3)), std::invalid_argument);
  EXPECT_THROW(best_layouts(hall, sizes_of(2, 1, NAN)), std::invalid_argument);
  EXPECT_THROW(best_layouts(hall, sizes_of(0.01, 0.01, 3)), std::invalid_argument);
  EXPECT_TRUE(best_layouts(hall, sizes_of(2, 1, 25)).best.empty());
  hall.gates = {{"gate", {10, 100}}, {"far", {500, 500}}};
  EXPECT_TRUE(best_layouts(hall, sizes_of(2, 1, 3)).best.empty());
}

/// A hall in the shape of an L, or a rectangle, with columns and gates at the walls.
Hall random_hall(TestRandom& random) {
  Hall hall;
  const double width = random.whole(20, 40);
  const double height = random.whole(16, 30);
  hall.outline = rectangle(width, height);
  if (random.whole(0, 1) == 0) {
    const double x = random.whole(10, 15);
    const double y = random.whole(8, 12);
    hall.outline = {{0, 0}, {width, 0}, {width, y}, {x, y}, {x, height}, {0, height}};
  }
  const int columns = random.whole(0, 6);
  for (int i = 0; i < columns; ++i) {
    const double x = random.whole(20, 180) / 10.0;
    const double y = random.whole(20, 140) / 10.0;
    hall.obstacles.push_back(i % 2 == 0 ? square({x, y}, 0.5) : around({x, y}, 0.6));
  }
  hall.gates.push_back({"a", {-3, static_cast<double>(random.whole(2, 12))}});
  if (random.whole(0, 1) == 0) {
    hall.gates.push_back({"b", {static_cast<double>(random.whole(2, 9)), height + 3}});
  }
  return hall;
}

bool is_inside(const Polygon& polygon, Point place) {
  int windings = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i];
    const Point b = polygon[(i + 1) % polygon.size()];
    const double side = (b.x - a.x) * (place.y - a.y) - (b.y - a.y) * (place.x - a.x);
    if (a.y <= place.y && b.y > place.y && side > 0) ++windings;
    if (a.y > place.y && b.y <= place.y && side < 0) --windings;
  }
  return windings != 0;
}

/// Looked at point by point.
void expect_free(const Hall& hall, const Rectangle& box) {
  constexpr int kParts = 8;
  for (int i = 0; i <= kParts; ++i) {
    for (int k = 0; k <= kParts; ++k) {
      const double margin = 1e-4;
      const Point place{box.x0 + margin + (box.x1 - box.x0 - 2 * margin) * i / kParts,
                        box.y0 + margin + (box.y1 - box.y0 - 2 * margin) * k / kParts};
      EXPECT_TRUE(is_inside(hall.outline, place)) << place.x << ", " << place.y;
      for (const Polygon& each : hall.obstacles) EXPECT_FALSE(is_inside(each, place));
    }
  }
}

bool overlap(const Rectangle& a, const Rectangle& b) {
  const double margin = 1e-6;
  return a.x0 < b.x1 - margin && b.x0 < a.x1 - margin && a.y0 < b.y1 - margin &&
         b.y0 < a.y1 - margin;
}

/// Seconds from node to node by relaxing all lanes until nothing changes.
std::vector<double> times_from(const lanes::NetworkDescription& network, std::size_t from,
                               bool backwards) {
  std::vector<double> times(network.nodes.size(), std::numeric_limits<double>::infinity());
  times[from] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const lanes::Lane& lane : network.lanes) {
      auto a = static_cast<std::size_t>(lane.from);
      auto b = static_cast<std::size_t>(lane.to);
      const double length = std::hypot(network.nodes[a].x - network.nodes[b].x,
                                       network.nodes[a].y - network.nodes[b].y);
      const auto lane_class = static_cast<std::size_t>(lane.lane_class);
      if (backwards) std::swap(a, b);
      const double time = times[a] + length / network.classes[lane_class].speed;
      if (time < times[b] - 1e-9) {
        times[b] = time;
        changed = true;
      }
    }
  }
  return times;
}

/// A hall of 54 x 15 m: four aisles of 2 m and eight rows of 0.8 m are 14.4 m deep, and between
/// cross aisles of 3.6 m 24 modules of 1.9 m stand in a row.
TEST(Layout, AislesAndCrossAislesHaveWidthsOfTheirOwn) {
  Hall hall;
  hall.outline = {{0, 0}, {54, 0}, {54, 15}, {0, 15}};
  hall.gates = {{"g", {-4, 7}}};
  const auto modules = [&](double aisle, double cross) {
    Sizes sizes = sizes_of(1.9, 0.8, aisle);
    sizes.cross_lane = cross;
    sizes.spacing = std::max(aisle, cross);
    return best_layouts(hall, sizes).best.front().modules.size();
  };
  EXPECT_EQ(modules(2, 2), 208u);
  EXPECT_EQ(modules(2, 3.6), 192u);
  EXPECT_GT(modules(3.6, 2), modules(3.6, 3.6));
}

/// A layout of nothing but what it is worth.
Layout worth(std::size_t modules, double trip, double per_hour) {
  Layout layout;
  layout.modules.resize(modules);
  layout.mean_trip = trip;
  layout.trips_per_hour = per_hour;
  return layout;
}

std::vector<Layout> table_of(const std::vector<Layout>& tried) {
  std::vector<Layout> front;
  for (const Layout& each : tried) add_to_front(front, each);
  return thinned(std::move(front));
}

bool is_same(const Layout& a, const Layout& b) {
  return a.modules.size() == b.modules.size() && std::abs(a.mean_trip - b.mean_trip) < 1e-6 &&
         std::abs(a.trips_per_hour - b.trips_per_hour) < 1e-4;
}

// What took the place of another, though it was a little worse, had its own place taken, and so on:
// the table had nothing near the first.
TEST(Layout, TheTableTellsOfAllThatWasTriedInWhicheverOrder) {
  TestRandom random(7);
  for (int run = 0; run < 200; ++run) {
    std::vector<Layout> tried;
    for (int i = 0; i < 40; ++i) {
      const double share = random.whole(0, 60) / 1000.0;
      tried.push_back(worth(static_cast<std::size_t>(random.whole(20, 40)), 30 * (1 + share),
                            500 * (1 + share) + random.whole(-4, 4)));
      tried.back().choice.shift = i;
    }
    const std::vector<Layout> table = table_of(tried);
    for (const Layout& each : tried) {
      EXPECT_TRUE(std::any_of(table.begin(), table.end(), [&](const Layout& other) {
        return other.modules.size() >= each.modules.size() &&
               other.mean_trip <= each.mean_trip * 1.005001 &&
               other.trips_per_hour >= each.trips_per_hour * 0.994999;
      }));
    }
    for (int i = 39; i > 0; --i) {
      std::swap(tried[static_cast<std::size_t>(i)],
                tried[static_cast<std::size_t>(random.whole(0, i))]);
    }
    const std::vector<Layout> again = table_of(tried);
    ASSERT_EQ(again.size(), table.size()) << run;
    for (std::size_t i = 0; i < table.size(); ++i) {
      EXPECT_EQ(again[i].choice.shift, table[i].choice.shift) << run;
    }
  }
  // Of three in a chain the last does not tell of the first.
  const std::vector<Layout> chain = table_of(
      {worth(30, 30, 500), worth(31, 30.12, 500), worth(32, 30.24, 500), worth(33, 30.36, 500)});
  ASSERT_EQ(chain.size(), 2u);
  EXPECT_EQ(chain[0].modules.size(), 33u);
  EXPECT_EQ(chain[1].modules.size(), 31u);
}

Hall hall_of_decimetres() {
  Hall hall;
  hall.outline = rectangle(16.5, 20.2);
  for (const Point place : {Point{9.5, 4.9}, {4.3, 14.3}, {12.5, 6.3}, {11.8, 3.7}}) {
    hall.obstacles.push_back(square(place, 0.4));
  }
  hall.gates = {{"g0", {-2, 15.2}}, {"g1", {14.1, -2}}};
  return hall;
}

template <typename Change>
Hall changed(Hall hall, Change change) {
  for (Point& each : hall.outline) change(each);
  for (Polygon& polygon : hall.obstacles) {
    for (Point& each : polygon) change(each);
  }
  for (Gate& gate : hall.gates) change(gate.place);
  return hall;
}

void expect_same_table(const BestLayouts& a, const BestLayouts& b) {
  EXPECT_EQ(a.tried, b.tried);
  EXPECT_EQ(a.worked, b.worked);
  ASSERT_EQ(a.best.size(), b.best.size());
  for (std::size_t i = 0; i < a.best.size(); ++i) EXPECT_TRUE(is_same(a.best[i], b.best[i])) << i;
}

TEST(Layout, AHallThatIsMovedIsTheSame) {
  Sizes sizes = sizes_of(2.7, 1.1, 2.6);
  sizes.cross_speed = 1.5;
  std::vector<Hall> halls = {hall_of_decimetres()};
  TestRandom random(11);
  for (int run = 0; run < test::cases(6); ++run) halls.push_back(random_hall(random));
  for (const Hall& hall : halls) {
    const BestLayouts here = best_layouts(hall, sizes);
    for (const Point way : {Point{100, -60}, Point{30.3, 0.7}, Point{512345.6, 5400012.3}}) {
      const BestLayouts there = best_layouts(changed(hall,
                                                     [&](Point& place) {
                                                       place.x += way.x;
                                                       place.y += way.y;
                                                     }),
                                             sizes);
      expect_same_table(here, there);
      if (here.best.empty() || there.best.empty()) continue;
      const Rectangle& box = here.best[0].modules[0].box;
      const Rectangle& moved = there.best[0].modules[0].box;
      EXPECT_NEAR(moved.x0, box.x0 + way.x, 1e-6);
      EXPECT_NEAR(moved.y1, box.y1 + way.y, 1e-6);
      EXPECT_NEAR(there.best[0].network.nodes[0].x, hall.gates[0].place.x + way.x, 1e-6);
    }
  }
}

TEST(Layout, AHallThatIsTurnedIsTheSame) {
  Hall hall;
  hall.outline = rectangle(18.8, 22.6);
  hall.obstacles = {square({2.9, 13.7}, 0.4)};
  hall.gates = {{"g0", {-2, 10.7}}, {"g1", {12.1, -2}}};
  Sizes sizes = sizes_of(2.7, 1.1, 2);
  sizes.cross_lane = sizes.spacing = 2.6;
  sizes.cross_speed = 1.5;
  const Hall turned = changed(hall, [](Point& place) { std::swap(place.x, place.y); });
  expect_same_table(best_layouts(hall, sizes), best_layouts(turned, sizes));
}

TEST(Layout, WhatIsToldOfRandomHallsHolds) {
  int found = 0;
  const int runs = test::cases(40);
  for (int run = 0; run < runs; ++run) {
    SCOPED_TRACE(run);
    TestRandom random(static_cast<std::uint64_t>(run));
    const Hall hall = random_hall(random);
    Sizes sizes = sizes_of(random.whole(10, 30) / 10.0, random.whole(8, 16) / 10.0, 2.5);
    sizes.cross_speed = 1.5;
    sizes.cross_lane = run % 3 == 0 ? 0 : random.whole(15, 35) / 10.0;
    const double narrow = std::min(sizes.width(false), sizes.width(true));
    const BestLayouts best = best_layouts(hall, sizes);
    for (std::size_t i = 0; i < best.best.size(); ++i) {
      const Layout& layout = best.best[i];
      ++found;
      for (const Layout& other : best.best) {
        const bool is_beaten = &other != &layout && other.modules.size() >= layout.modules.size() &&
                               other.mean_trip <= layout.mean_trip &&
                               other.trips_per_hour >= layout.trips_per_hour;
        EXPECT_FALSE(is_beaten);
      }
      const lanes::NetworkDescription& network = layout.network;
      EXPECT_TRUE(lanes::faults_of(network).empty());
      for (const Module& module : layout.modules) {
        expect_free(hall, module.box);
        for (const Module& other : layout.modules) {
          EXPECT_TRUE(&other == &module || !overlap(module.box, other.box));
        }
      }
      // Along lanes inside the hall a vehicle as wide as a lane meets nothing; where it goes from
      // one lane to that beside, one that fits into all lanes.
      for (const lanes::Lane& lane : network.lanes) {
        const lanes::Node& a = network.nodes[static_cast<std::size_t>(lane.from)];
        const lanes::Node& b = network.nodes[static_cast<std::size_t>(lane.to)];
        const bool to_gate = std::min(lane.from, lane.to) < static_cast<int>(hall.gates.size());
        const bool slants = std::abs(a.x - b.x) > 1e-9 && std::abs(a.y - b.y) > 1e-9;
        EXPECT_TRUE(!slants || to_gate);
        const double length = std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
        const bool is_cross = lane.lane_class == 1;
        const double widest = std::max(sizes.width(false), sizes.width(true));
        const bool goes_beside = is_cross && length < widest + 1e-6;
        const double across = (goes_beside ? narrow : sizes.width(is_cross)) / 2;
        const bool along_x = std::abs(a.x - b.x) > std::abs(a.y - b.y);
        const double x = along_x ? narrow / 2 : across;
        const double y = along_x ? across : narrow / 2;
        const Rectangle swept{std::min(a.x, b.x) - x, std::min(a.y, b.y) - y,
                              std::max(a.x, b.x) + x, std::max(a.y, b.y) + y};
        if (!to_gate) expect_free(hall, swept);
        for (const Module& module : layout.modules) EXPECT_FALSE(overlap(swept, module.box));
      }
      double sum = 0;
      for (std::size_t gate = 0; gate < hall.gates.size(); ++gate) {
        for (const bool backwards : {false, true}) {
          const std::vector<double> times = times_from(network, gate, backwards);
          for (const Module& module : layout.modules) {
            sum += times[static_cast<std::size_t>(module.stop)];
          }
        }
      }
      const double trips = static_cast<double>(layout.modules.size() * hall.gates.size());
      EXPECT_NEAR(layout.mean_trip, sum / trips, 1e-5);
    }
  }
  EXPECT_GE(found, runs);
}

}  // namespace
}  // namespace rubicon::layout
