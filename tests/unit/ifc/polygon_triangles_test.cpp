#include "src/exchange/ifc/polygon_triangles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace rubicon::ifc {
namespace {

using math::Vec3;

double area(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
            const Vec3& normal) {
  double sum = 0;
  for (const auto& t : triangles) {
    const double each = loop_normal(points, {t[0], t[1], t[2]}).dot(normal) / 2;
    EXPECT_GT(each, 0);
    sum += each;
  }
  return sum;
}

/// Every side of a loop is a side of one triangle more than it is of others, the other way round.
void expect_bordered(const std::vector<Loop>& loops,
                     const std::vector<std::array<int, 3>>& triangles) {
  std::map<std::pair<int, int>, int> uses;
  for (const auto& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++uses[{t[k], t[(k + 1) % 3]}];
      --uses[{t[(k + 1) % 3], t[k]}];
    }
  }
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int a = loop[i];
      const int b = loop[(i + 1) % loop.size()];
      --uses[{a, b}];
      ++uses[{b, a}];
    }
  }
  for (const auto& [edge, count] : uses) EXPECT_EQ(count, 0) << edge.first << " " << edge.second;
}

TEST(PolygonTriangles, HolesStayOpenAndCornersOnLinesAreKept) {
  // A square with corners in the middle of its sides and two holes, one touching a corner.
  const std::vector<Vec3> points = {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0},
                                    {2, 4, 0}, {0, 4, 0}, {1, 1, 0}, {1, 2, 0},
                                    {2, 2, 0}, {2, 1, 0}, {3, 3, 0}, {3, 4, 0}};
  const std::vector<Loop> loops = {{0, 1, 2, 3, 4, 5}, {6, 7, 8, 9}, {8, 4, 10}};
  WorkBudget budget(100000);
  const auto triangles = triangulate(points, loops, Vec3::UnitZ(), budget);
  ASSERT_TRUE(triangles);
  EXPECT_NEAR(area(points, *triangles, Vec3::UnitZ()), 16 - 1 - 1, 1e-12);
  expect_bordered(loops, *triangles);
}

TEST(PolygonTriangles, StarsWithHolesInAnyPlane) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0.2, 1);
  for (int round = 0; round < 300; ++round) {
    const Vec3 normal = Vec3(unit(random) - 0.6, unit(random) - 0.6, unit(random) - 0.6);
    if (normal.norm() < 0.1) continue;
    const Vec3 n = normal.normalized();
    const Vec3 u = n.unitOrthogonal();
    const Vec3 v = n.cross(u);
    std::vector<Vec3> points;
    std::vector<Loop> loops;
    double expected = 0;
    const auto add_star = [&](const Vec3& centre, double size, int corners, bool hole) {
      Loop loop;
      for (int i = 0; i < corners; ++i) {
        const double angle = (hole ? -1 : 1) * 2 * 3.141592653589793 * i / corners;
        const double r = size * unit(random);
        loop.push_back(static_cast<int>(points.size()));
        points.push_back(centre + r * (std::cos(angle) * u + std::sin(angle) * v));
      }
      expected += loop_normal(points, loop).dot(n) / 2;
      loops.push_back(loop);
    };
    // A star of radius 0.2 * 20 and more around holes that lie on a circle of radius 2.
    add_star(Vec3::Zero(), 20, 5 + round % 40, false);
    for (int h = 0; h < round % 6; ++h) {
      const double angle = 2 * 3.141592653589793 * h / 6;
      add_star(2 * (std::cos(angle) * u + std::sin(angle) * v), 0.7, 3 + h, true);
    }
    if (loops[0].size() < 12) continue;  // its sides may come nearer than its corners
    WorkBudget budget(10000000);
    const auto triangles = triangulate(points, loops, n, budget);
    ASSERT_TRUE(triangles) << round;
    EXPECT_NEAR(area(points, *triangles, n), expected, 1e-9);
    expect_bordered(loops, *triangles);
  }
}

TEST(PolygonTriangles, LinesThatCrossAreNoticed) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  WorkBudget budget(1000);
  EXPECT_TRUE(lines_cross(points, {{0, 1, 2, 3}}, Vec3::UnitZ(), budget));
  EXPECT_FALSE(lines_cross(points, {{0, 2, 1, 3}}, Vec3::UnitZ(), budget));
}

TEST(PolygonTriangles, NothingWithoutAreaOrWork) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  WorkBudget none(0);
  EXPECT_FALSE(triangulate(points, {{0, 1, 2, 3}}, Vec3::UnitZ(), none));
  WorkBudget budget(1000);
  EXPECT_FALSE(triangulate({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}, Vec3::UnitZ(), budget));
  EXPECT_FALSE(
      triangulate({{0, 0, 0}, {NAN, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, Vec3::UnitZ(), budget));
}

}  // namespace
}  // namespace rubicon::ifc
