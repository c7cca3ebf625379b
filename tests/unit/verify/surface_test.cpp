#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "src/results/verify/input/closed_surface.hpp"
#include "src/results/verify/input/fault.hpp"
#include "src/results/verify/input/mesh_parts.hpp"
#include "src/results/verify/input/polygon_parts.hpp"
#include "tests/unit/verify/random.hpp"

namespace rubicon::verify {
namespace {

/// A torus about z: closed, nowhere convex as a whole.
MeshData torus(double ring, double tube, int around, int across) {
  MeshData mesh;
  mesh.closed = true;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 360.0 * i / around;
      const double v = 360.0 * j / across;
      const double r = ring + tube * math::cos_deg(v);
      mesh.vertices.emplace_back(r * math::cos_deg(u), r * math::sin_deg(u),
                                 tube * math::sin_deg(v));
    }
  }
  const auto at = [&](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

TEST(ClosedSurface, HoldsWhatIsInsideATorus) {
  const MeshData mesh = torus(2, 0.5, 48, 24);
  const ClosedSurface surface(mesh.vertices, mesh.triangles);
  Random random(8);
  int inside = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 p = random.point(2.6).cwiseProduct(Vec3(1, 1, 0.25));
    const double from_ring = std::hypot(std::hypot(p.x(), p.y()) - 2, p.z());
    // The flat faces lie up to 10 mm inside of the true torus.
    if (from_ring < 0.48) {
      EXPECT_TRUE(surface.holds(p, 0));
      ++inside;
    }
    if (from_ring > 0.5) {
      EXPECT_FALSE(surface.holds(p, 0));
    }
    if (from_ring < 0.38) {
      EXPECT_TRUE(surface.holds(p, 0.1));
    }
    if (from_ring > 0.41) {
      EXPECT_FALSE(surface.holds(p, 0.1));
    }
  }
  EXPECT_GT(inside, 500);
}

TEST(ClosedSurface, IsNotFooledByRaysThroughCornersAndEdges) {
  // Points from which the rays pass through many corners: those of the torus itself, moved a little
  // in and out.
  const MeshData mesh = torus(2, 0.5, 12, 8);
  const ClosedSurface surface(mesh.vertices, mesh.triangles);
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 8; ++j) {
      const Vec3 centre(2 * math::cos_deg(30.0 * i), 2 * math::sin_deg(30.0 * i), 0);
      const Vec3 corner = mesh.vertices[static_cast<std::size_t>(i * 8 + j)];
      EXPECT_TRUE(surface.holds(centre + 0.9 * (corner - centre), 0));
      EXPECT_FALSE(surface.holds(centre + 1.1 * (corner - centre), 0));
    }
  }
}

TEST(ClosedSurface, InnerPointsAreInside) {
  const MeshData mesh = torus(2, 0.5, 24, 12);
  const ClosedSurface surface(mesh.vertices, mesh.triangles);
  const auto points = surface.inner_points(200);
  EXPECT_GT(points.size(), 150u);
  for (const InnerPoint& point : points) {
    EXPECT_TRUE(surface.holds(point.p, 0));
    EXPECT_GT(point.width, 0.1);
  }
}

TEST(ClosedSurface, NearestPointsOfATriangleAreNearest) {
  Random random(9);
  for (int i = 0; i < 500; ++i) {
    const std::array<Vec3, 3> triangle = {random.point(1), random.point(1), random.point(1)};
    const Vec3 p = random.point(2);
    const double found = (nearest_of_triangle(p, triangle) - p).norm();
    double sampled = 1e300;
    constexpr int kSteps = 40;
    for (int u = 0; u <= kSteps; ++u) {
      for (int v = 0; u + v <= kSteps; ++v) {
        const Vec3 q =
            (u * triangle[0] + v * triangle[1] + (kSteps - u - v) * triangle[2]) / kSteps;
        sampled = std::min(sampled, (q - p).norm());
      }
    }
    EXPECT_LE(found, sampled + 1e-12);
    EXPECT_GE(found, sampled - 0.08);
  }
}

TEST(MeshParts, WhatIsNotConvexStaysTriangles) {
  const MeshParts parts = parts_of(torus(2, 0.5, 12, 8));
  EXPECT_TRUE(parts.solids.empty());
  EXPECT_EQ(parts.triangles.size(), 192u);
  EXPECT_EQ(parts.closed_rest.size(), 192u);
}

TEST(MeshParts, AnOpenMeshHasNoInside) {
  MeshData mesh = torus(2, 0.5, 12, 8);
  mesh.triangles.pop_back();
  mesh.closed = false;
  const MeshParts parts = parts_of(mesh);
  EXPECT_EQ(parts.triangles.size(), 191u);
  EXPECT_TRUE(parts.closed_rest.empty());
}

double area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& a = polygon[i];
    const auto& b = polygon[(i + 1) % polygon.size()];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum / 2;
}

bool is_convex(const Polygon& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d u = polygon[(i + 1) % polygon.size()] - polygon[i];
    const Eigen::Vector2d v = polygon[(i + 2) % polygon.size()] - polygon[(i + 1) % polygon.size()];
    if (u.x() * v.y() - u.y() * v.x() < -1e-9) return false;
  }
  return true;
}

TEST(PolygonParts, AreConvexAndMakeTheWhole) {
  Random random(10);
  for (int round = 0; round < 300; ++round) {
    Polygon star;
    const int corners = random.whole(3, 30);
    for (int i = 0; i < corners; ++i) {
      const double angle = 360.0 * (i + random.real(0, 0.9)) / corners;
      const double radius = random.real(0.2, 2);
      star.emplace_back(radius * math::cos_deg(angle), radius * math::sin_deg(angle));
    }
    if (round % 2 == 0) std::reverse(star.begin(), star.end());
    // A star about the origin is simple where no two corners are half a turn apart.
    if (std::fabs(area(star)) < 0.2) continue;
    const auto parts = convex_parts(star);
    double sum = 0;
    for (const Polygon& part : parts) {
      EXPECT_TRUE(is_convex(part));
      EXPECT_GT(area(part), 0);
      sum += area(part);
    }
    EXPECT_NEAR(sum, std::fabs(area(star)), 1e-9) << round;
  }
}

TEST(PolygonParts, OfAWallWithADoorAreFew) {
  const Polygon wall = {{-2, 0},  {-0.5, 0}, {-0.5, 2.1}, {0.5, 2.1},
                        {0.5, 0}, {2, 0},    {2, 2.6},    {-2, 2.6}};
  EXPECT_LE(convex_parts(wall).size(), 3u);
  const Polygon square = {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_EQ(convex_parts(square).size(), 1u);
}

TEST(PolygonParts, OfACrossedPolygonAreRefused) {
  EXPECT_THROW(convex_parts({{0, 0}, {2, 2}, {2, 0}, {0, 2.5}, {-1, 1}, {3, 1}}), UnreadableInput);
}

}  // namespace
}  // namespace rubicon::verify
