#include "src/motion/coverage/dubins.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/turns.hpp"

namespace rubicon::coverage {
namespace {

double apart(const Place& a, const Place& b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// Drives a way in small steps, by its parts alone.
Heading driven(const DubinsWay& way, double step) {
  Heading at = way.from;
  double heading = at.heading_deg;
  const auto go = [&](double length, double turned) {
    const int steps = std::max(1, static_cast<int>(std::ceil(length / step)));
    for (int i = 0; i < steps; ++i) {
      const double middle = math::radians(heading + turned / steps * (i + 0.5));
      at.place.x += length / steps * std::cos(middle);
      at.place.y += length / steps * std::sin(middle);
    }
    // `heading` stands still within a part: its middle is taken step by step.
    heading += turned;
  };
  const auto arc = [&](double turned) {
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(turned))) * 10);
    for (int i = 0; i < pieces; ++i) {
      go(math::radians(std::abs(turned) / pieces) * way.radius, turned / pieces);
    }
  };
  arc(way.turned_deg[0]);
  way.straight > 0 ? go(way.straight, 0) : arc(way.turned_deg[1]);
  arc(way.turned_deg[2]);
  at.heading_deg = heading;
  return at;
}

TEST(Dubins, KnownLengths) {
  const double pi = math::kPi;
  // Straight on; half a circle to the line 2 r beside; round three quarters.
  EXPECT_NEAR(dubins_ways({{0, 0}, 0}, {{7, 0}, 0}, 2).front().length(), 7, 1e-9);
  EXPECT_NEAR(dubins_ways({{0, 0}, 0}, {{0, 4}, 180}, 2).front().length(), 2 * pi, 1e-9);
  EXPECT_NEAR(dubins_ways({{0, 0}, 0}, {{0, 7}, 180}, 2).front().length(), 2 * pi + 3, 1e-9);
  EXPECT_NEAR(dubins_ways({{0, 0}, 90}, {{3, 3}, 0}, 3).front().length(), 1.5 * pi, 1e-9);
  // To the line beside it: three arcs, the middle one longer than half a turn. Its circles are 2 r
  // and d apart: cos u = (2 r + d) / 4 r.
  const DubinsWay bulb = dubins_ways({{0, 0}, 0}, {{0, 1}, 180}, 1).front();
  EXPECT_EQ(bulb.word, DubinsWord::kRlr);
  EXPECT_NEAR(bulb.length(), pi + 4 * std::acos(0.75), 1e-9);
  EXPECT_EQ(bulb.turns(), 3);
}

TEST(Dubins, EveryWordArrives) {
  std::mt19937 engine(1957);
  std::uniform_real_distribution<double> place(-6, 6), heading(-180, 180), size(0.3, 3);
  int found[6] = {};
  for (int trial = 0; trial < 300; ++trial) {
    const Heading from{{place(engine), place(engine)}, heading(engine)};
    const Heading to{{place(engine), place(engine)}, heading(engine)};
    const double radius = size(engine);
    for (const DubinsWord word : kDubinsWords) {
      const auto way = dubins_way(word, from, to, radius);
      if (!way) continue;
      ++found[static_cast<int>(word)];
      const Heading end = driven(*way, 0.01);
      ASSERT_LT(apart(end.place, to.place), 1e-3) << trial << " " << static_cast<int>(word);
      ASSERT_LT(std::abs(math::normalised_deg(end.heading_deg - to.heading_deg)), 1e-6);
      const std::vector<Heading> corners = way->corners(10);
      ASSERT_LT(apart(corners.back().place, to.place), 1e-9);
      double chords = 0;
      for (std::size_t i = 1; i < corners.size(); ++i) {
        chords += apart(corners[i - 1].place, corners[i].place);
        const double turned =
            std::abs(math::normalised_deg(corners[i].heading_deg - corners[i - 1].heading_deg));
        ASSERT_LE(turned, 10 + 1e-9);
        // On a circle of the radius, or straight.
        if (turned > 1e-9) {
          ASSERT_NEAR(apart(corners[i - 1].place, corners[i].place),
                      2 * radius * std::sin(math::radians(turned / 2)), 1e-9);
        }
      }
      ASSERT_LE(chords, way->length() + 1e-9);
      ASSERT_GE(chords, way->length() * 0.998);
      if (word == DubinsWord::kRlr || word == DubinsWord::kLrl) {
        ASSERT_GE(std::abs(way->turned_deg[1]), 180 - 1e-9);
      }
    }
  }
  for (const int count : found) EXPECT_GT(count, 40);
}

/// What a machine may drive ends somewhere, and the shortest word there is no longer; backwards it
/// is as long.
TEST(Dubins, TheShortestIsNoLongerThanAnyWayOfArcsAndStraights) {
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> part(0, 3), turn(-1, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    // A random way of five parts ends somewhere; the shortest word there is no longer.
    Heading at{{0, 0}, 0};
    double length = 0;
    for (int i = 0; i < 5; ++i) {
      const double run = part(engine);
      const double curvature = i % 2 == 0 ? turn(engine) : 0;
      const int steps = 200;
      for (int k = 0; k < steps; ++k) {
        const double turned = math::degrees(curvature * run / steps);
        const double middle = math::radians(at.heading_deg + turned / 2);
        const double bend = math::radians(turned / 2);
        const double chord = run / steps * (bend == 0 ? 1 : std::sin(bend) / bend);
        at.place.x += chord * std::cos(middle);
        at.place.y += chord * std::sin(middle);
        at.heading_deg += turned;
      }
      length += run;
    }
    const Heading end = at;
    ASSERT_LE(dubins_ways({{0, 0}, 0}, end, 1).front().length(), length + 1e-6) << trial;
    const double there = dubins_ways({{0, 0}, 0}, end, 1).front().length();
    const Heading turned_end{end.place, end.heading_deg + 180};
    ASSERT_NEAR(dubins_ways(turned_end, {{0, 0}, 180}, 1).front().length(), there, 1e-6);
  }
}

}  // namespace
}  // namespace rubicon::coverage
