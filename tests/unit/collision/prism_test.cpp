#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "src/motion/collision/base/polygon.hpp"
#include "tests/unit/collision/random_scene.hpp"

namespace rubicon::collision::test {
namespace {

double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

bool is_convex(const Polygon& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const Eigen::Vector2d& c = polygon[(i + 2) % polygon.size()];
    if ((b - a).x() * (c - b).y() - (b - a).y() * (c - b).x() < -1e-12) return false;
  }
  return true;
}

bool inside_convex(const Polygon& polygon, const Eigen::Vector2d& p) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d edge = polygon[(i + 1) % polygon.size()] - a;
    if (edge.x() * (p - a).y() - edge.y() * (p - a).x() < 0) return false;
  }
  return true;
}

bool inside(const Polygon& polygon, const Eigen::Vector2d& p) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
      in = !in;
  }
  return in;
}

/// A star-shaped polygon: simple by construction, seldom convex.
Polygon random_star(Random& random, int corners) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double heading = 360.0 * (i + random.between(0.1, 0.9)) / corners;
    const double distance = random.between(0.2, 2);
    polygon.emplace_back(distance * math::cos_deg(heading), distance * math::sin_deg(heading));
  }
  return polygon;
}

const Polygon kL = {{0, 0}, {2, 0}, {2, 0.5}, {0.5, 0.5}, {0.5, 2}, {0, 2}};

TEST(Prism, PartsAreConvexAndCoverThePolygonExactly) {
  Random random(31);
  for (int i = 0; i < 500; ++i) {
    Polygon polygon = random_star(random, 3 + random.below(30));
    if (i % 2) std::reverse(polygon.begin(), polygon.end());
    const std::vector<Polygon> parts = convex_parts(simple_polygon(polygon));
    double sum = 0;
    for (const Polygon& part : parts) {
      EXPECT_TRUE(is_convex(part));
      sum += area(part);
    }
    EXPECT_NEAR(sum, std::fabs(area(polygon)), 1e-9);
    for (int k = 0; k < 20; ++k) {
      const Eigen::Vector2d p(random.between(-2, 2), random.between(-2, 2));
      const bool covered = std::any_of(parts.begin(), parts.end(),
                                       [&](const Polygon& part) { return inside_convex(part, p); });
      EXPECT_EQ(covered, inside(polygon, p));
    }
  }
}

TEST(Prism, AnLHasTwoParts) { EXPECT_EQ(convex_parts(simple_polygon(kL)).size(), 2U); }

TEST(Prism, CornersOnAStraightSideAndRepeatedOnesAreDropped) {
  EXPECT_EQ(simple_polygon({{0, 0}, {1, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}, {0, 0}}).size(), 4U);
}

TEST(Prism, TheNotchIsFreeTheMaterialIsNot) {
  const BodyPtr corner = prepare({{geometry::Prism{0, 3, kL}, Pose::Identity()}});
  const BodyPtr post = box(Vec3(0.2, 0.2, 1));
  EXPECT_FALSE(
      overlaps(*post, at(0.7, 0.7, 1.5), *corner, at(0, 0, 0), 1e-6));  // touches both legs
  EXPECT_TRUE(overlaps(*post, at(0.69, 0.7, 1.5), *corner, at(0, 0, 0), 1e-6));
  const Motion into_the_corner = geometry::translating(at(1.2, 1.2, 1.5), Vec3(-0.5, -0.5, 0));
  EXPECT_FALSE(blocked(*post, into_the_corner, corner, at(0, 0, 0), 1e-6));
}

TEST(Prism, ARodDoesNotPassThroughAnInternalCut) {
  // With a tolerance above half its width each part alone would let the rod through.
  const BodyPtr wall = prepare({{geometry::Prism{0, 3, kL}, Pose::Identity()}});
  const BodyPtr rod = box(Vec3(0.006, 0.006, 1));
  for (int i = 0; i <= 40; ++i) {
    for (int k = 0; k <= 40; ++k) {
      const double x = 0.02 + 0.46 * i / 40;
      const double y = 0.02 + 0.46 * k / 40;
      EXPECT_TRUE(overlaps(*rod, at(x, y, 1.5), *wall, at(0, 0, 0), 0.01)) << x << " " << y;
    }
  }
}

TEST(Prism, SheetsThinnerThanTheToleranceDoNotPassThroughEachOtherInSmallSteps) {
  const BodyPtr sheet = box(Vec3(1, 0.002, 1));
  bool stopped = false;
  for (double y = -0.01; y < 0.01 && !stopped; y += 0.001) {
    stopped = blocked(*sheet, geometry::translating(at(0, y, 0), Vec3(0, 0.001, 0)), sheet,
                      at(0, 0, 0), 0.01);
  }
  EXPECT_TRUE(stopped);
  EXPECT_FALSE(overlaps(*sheet, at(0, 0.0035, 0), *sheet, at(0, 0, 0), 0.01));
}

TEST(Prism, BadPolygonsAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuse = [](const Polygon& polygon) {
    EXPECT_THROW(prepare({{geometry::Prism{0, 1, polygon}, Pose::Identity()}}),
                 std::invalid_argument);
  };
  refuse({});
  refuse({{0, 0}, {1, 0}});
  refuse({{0, 0}, {1, 0}, {2, 0}});                  // no area
  refuse({{0, 0}, {2, 2}, {2, 0}, {0, 2}});          // a bow tie
  refuse({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}});  // a corner on another side
  refuse({{0, 0}, {2, 0}, {1, 0}, {1, 1}});          // folds back
  refuse({{0, 0}, {nan, 0}, {1, 1}});
  refuse({{0, 0}, {4, 0}, {4, 3}, {2, 1}, {0, 3}, {0, 1}, {4, 2}});
  EXPECT_THROW(prepare({{geometry::Prism{1, 1, kL}, Pose::Identity()}}), std::invalid_argument);
}

}  // namespace
}  // namespace rubicon::collision::test
