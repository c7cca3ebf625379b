#include <gtest/gtest.h>

#include <cmath>

#include "src/motion/coverage/coverage.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/math/turns.hpp"
#include "tests/unit/coverage/random_floors.hpp"

namespace rubicon::coverage {
namespace {

/// m: places of a way are rounded to the grid.
constexpr double kGrid = 2e-4;

CoverageOptions turning(double radius, double clearance = 0.25) {
  CoverageOptions options;
  options.clearance = clearance;
  options.turn_radius = radius;
  options.tries = 200;
  return options;
}

/// Holds a way to the floor and to the radius by its places and headings alone.
Measures expect_drivable(const FloorDescription& floor, const CoverageOptions& options,
                         const CoverageWay& way, const std::string& which) {
  const Measures measures = measure(floor, options, way.points);
  EXPECT_EQ(measures.outside, 0) << which;
  EXPECT_EQ(measures.inside_holes, 0) << which;
  double length = 0;
  for (std::size_t i = 1; i < way.points.size(); ++i) {
    const WayPoint& a = way.points[i - 1];
    const WayPoint& b = way.points[i];
    const double x = b.place.x - a.place.x;
    const double y = b.place.y - a.place.y;
    const double chord = std::hypot(x, y);
    const double turned = math::normalised_deg(b.heading_deg - a.heading_deg);
    const double bend = math::radians(std::abs(turned)) / 2;
    // No narrower than the radius, no more than a step at once, forwards, and in between its
    // headings: beside that by what the grid rounds.
    EXPECT_GE(chord, 2 * options.turn_radius * std::sin(bend) - kGrid) << which << " " << i;
    EXPECT_LE(std::abs(turned), 10 + 1e-6) << which << " " << i;
    const double middle = a.heading_deg + turned / 2;
    EXPECT_LE(std::abs(-x * math::sin_deg(middle) + y * math::cos_deg(middle)), kGrid) << which;
    EXPECT_GE(x * math::cos_deg(middle) + y * math::sin_deg(middle), -kGrid) << which;
    if (b.working) {
      EXPECT_LE(std::abs(turned), 1e-6) << which;
    }
    length += bend > 1e-9 ? 2 * bend * options.turn_radius : chord;
  }
  EXPECT_NEAR(way.arcs->length, length, 1e-3 * static_cast<double>(way.points.size()) / 10)
      << which;
  return measures;
}

TEST(Turning, OfAHall) {
  FloorDescription hall;
  hall.outline = box(0, 0, 28.8, 12);
  const CoverageOptions options = turning(2);
  const CoverageWay way = plan_coverage(hall, options);
  const Measures measures = expect_drivable(hall, options, way, "hall");
  // Four corners of 2 x 2 m stay, but for what lines reach of them.
  EXPECT_GE(measures.coverage, 0.95);
  EXPECT_EQ(way.cut_off, 0);
  // 12 lines of 24.8 m, 4 of 8 m across, and between two of them at least half a circle.
  EXPECT_EQ(way.lines.size(), 16u);
  EXPECT_GE(way.arcs->length, 12 * 24.8 + 4 * 8 + 11 * math::kPi * 2 - 1e-6);
  EXPECT_LE(way.arcs->length, 500);
  EXPECT_LE(way.arcs->turns, 30);
  const CoverageWay again = plan_coverage(hall, options);
  ASSERT_EQ(again.points.size(), way.points.size());
  for (std::size_t i = 0; i < way.points.size(); ++i) {
    EXPECT_EQ(again.points[i].heading_deg, way.points[i].heading_deg);
  }
}

/// No two walls at right angles: fronts run along the slanted ones.
TEST(Turning, WorksFrontsAlongSlantedWalls) {
  FloorDescription five;
  five.outline = {{0, 0}, {18, -3}, {28, 7}, {22, 21}, {4, 17}};
  const CoverageOptions options = turning(1);
  const CoverageWay way = plan_coverage(five, options);
  EXPECT_GE(expect_drivable(five, options, way, "five corners").coverage, 0.97);
  // Passes that are neither on a wall nor along the lines.
  int fronts = 0;
  for (const CoverageLine& line : way.lines) {
    const Place middle{(line.points.front().x + line.points.back().x) / 2,
                       (line.points.front().y + line.points.back().y) / 2};
    double nearest = 1e9;
    for (std::size_t i = 0; i < five.outline.size(); ++i) {
      const Place& a = five.outline[i];
      const Place& b = five.outline[(i + 1) % five.outline.size()];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      nearest = std::min(
          nearest, ((b.x - a.x) * (middle.y - a.y) - (b.y - a.y) * (middle.x - a.x)) / length);
    }
    fronts += line.is_pass && nearest > 0.4 ? 1 : 0;
  }
  EXPECT_GE(fronts, 3);
}

TEST(Turning, BeginsWhereItIsTold) {
  FloorDescription hall;
  hall.outline = box(0, 0, 16, 12);
  CoverageOptions options = turning(1);
  options.from = Place{8, 6};
  const CoverageWay way = plan_coverage(hall, options);
  EXPECT_EQ(way.points[0].place.x, 8);
  EXPECT_EQ(way.points[0].place.y, 6);
  expect_drivable(hall, options, way, "from");
  options.from.reset();
  options.inlet = Place{0, 0};
  const Place far = plan_coverage(hall, options).points[0].place;
  EXPECT_GT(far.x + far.y, 14);
}

TEST(Turning, HasNoWayWhereThereIsNoRoom) {
  FloorDescription corridor;
  corridor.outline = box(0, 0, 30, 1.9);
  EXPECT_TRUE(plan_coverage(corridor, turning(2)).points.empty());
  // One line of it may be driven, and no turn leads to the other.
  const CoverageWay one = plan_coverage(corridor, turning(1));
  EXPECT_EQ(one.lines.size() + static_cast<std::size_t>(one.cut_off), 2u);
}

TEST(Turning, OfRandomFloors) {
  FloorRandom random(29);
  double least = 1, sum = 0;
  const int count = 24;
  for (int trial = 0; trial < count; ++trial) {
    CoverageOptions options = turning(random.between(0.3, 1.5), 0.1);
    options.tries = 0;
    const FloorDescription floor = trial % 3 == 0 ? random_general_floor(random, options)
                                                  : random_orthogonal_floor(random, options);
    const CoverageWay way = plan_coverage(floor, options);
    if (way.points.empty()) continue;
    const double share =
        expect_drivable(floor, options, way, "floor " + std::to_string(trial)).coverage;
    sum += share;
    least = std::min(least, share);
    if (HasFailure()) return;
  }
  RecordProperty("least", std::to_string(least));
  RecordProperty("mean", std::to_string(sum / count));
}

}  // namespace
}  // namespace rubicon::coverage
