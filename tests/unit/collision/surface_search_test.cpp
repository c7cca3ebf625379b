#include "src/motion/collision/pair/surface_search.hpp"

#include <gtest/gtest.h>

#include "meshes.hpp"
#include "random_scene.hpp"
#include "src/motion/collision/mesh/winding.hpp"

namespace rubicon::collision::test {
namespace {

TriangleSoup soup_of(const geometry::TriangleMesh& mesh) {
  return {mesh.vertices, mesh.triangles, mesh.closed};
}

/// A block of 2 m x 1 m x 0.5 m with a notch of 0.5 m x 0.5 m in a long side.
geometry::TriangleMesh notched_block(int fineness) {
  return extruded_mesh({{0, 0}, {2, 0}, {2, 1}, {1.5, 1}, {1.5, 0.5}, {1, 0.5}, {1, 1}, {0, 1}},
                       {{0, 5, 7}, {5, 6, 7}, {0, 1, 5}, {1, 4, 5}, {1, 2, 4}, {2, 3, 4}}, 0, 0.5,
                       fineness);
}

TEST(MeshInside, MiddlesAreInside) {
  for (const int fineness : {0, 1, 2, 3}) {
    for (const auto& mesh : {l_mesh(fineness), hollow_cube_mesh()}) {
      const TriangleSoup soup = soup_of(mesh);
      const MeshInside inside(soup);
      EXPECT_FALSE(inside.middles().empty());
      for (const MeshInside::Middle& middle : inside.middles()) {
        EXPECT_NE(winding_number(soup, middle.point), 0);
        EXPECT_LE(middle.width, 2.0 + 1e-9);
        EXPECT_GE(middle.width, 0.5 - 1e-9);
      }
    }
  }
}

TEST(MeshInside, ThinWallsAllowAQuarterOfTheirWidth) {
  const TriangleSoup soup =
      soup_of(extruded_mesh({{0, 0}, {1, 0}, {1, 0.002}, {0.002, 0.002}, {0.002, 1}, {0, 1}},
                            {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, 0, 1));
  const MeshInside inside(soup);
  EXPECT_NEAR(inside.least_allowed(1e-3), 0.5e-3, 1e-9);
  EXPECT_NEAR(inside.least_allowed(1e-4), 1e-4, 1e-12);
  EXPECT_TRUE(inside.is_plain());
}

TEST(MeshInside, NormalsPointOutwardsHoweverTheMeshIsTurned) {
  geometry::TriangleMesh mesh = l_mesh();
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  const TriangleSoup soup = soup_of(mesh);
  const MeshInside inside(soup);
  for (int i = 0; i < static_cast<int>(soup.triangles().size()); ++i) {
    const Vec3 centre = (soup.corner(i, 0) + soup.corner(i, 1) + soup.corner(i, 2)) / 3.0;
    EXPECT_FALSE(inside.holds(centre + 1e-3 * inside.outwards(i)));
    EXPECT_TRUE(inside.holds(centre - 1e-3 * inside.outwards(i)));
  }
}

TEST(MeshInside, OverlappingPartsAreNotPlain) {
  geometry::TriangleMesh mesh = l_mesh();
  const int offset = static_cast<int>(mesh.vertices.size());
  const geometry::TriangleMesh other = l_mesh();
  for (const Vec3& vertex : other.vertices) mesh.vertices.push_back(vertex + Vec3(0.3, 0.1, 0.2));
  for (const auto& [a, b, c] : other.triangles) {
    mesh.triangles.push_back({a + offset, b + offset, c + offset});
  }
  const TriangleSoup soup = soup_of(mesh);
  EXPECT_FALSE(MeshInside(soup).is_plain());
}

/// The deepest of many points of the surface of one mesh in another (m); negative outside.
double deepest_of_points(const TriangleSoup& inner, const TriangleSoup& outer,
                         const Placement& to_outer, double enough) {
  constexpr int kShares = 40;
  double deepest = -1;
  for (int i = 0; i < static_cast<int>(inner.triangles().size()); ++i) {
    for (int u = 0; u <= kShares; ++u) {
      for (int v = 0; u + v <= kShares; ++v) {
        const Vec3 point = to_outer * (inner.corner(i, 0) +
                                       u * (inner.corner(i, 1) - inner.corner(i, 0)) / kShares +
                                       v * (inner.corner(i, 2) - inner.corner(i, 0)) / kShares);
        if (surface_within(outer, point, enough) || winding_number(outer, point) == 0) continue;
        deepest = enough;
      }
    }
  }
  return deepest;
}

TEST(SurfaceSearch, FindsWhatManyPointsFindAndNothingElse) {
  Random random(5);
  int found = 0;
  int free = 0;
  for (int round = 0; round < 150; ++round) {
    const TriangleSoup inner = soup_of(random.below(2) ? l_mesh() : notched_block(0));
    const TriangleSoup outer = soup_of(random.below(2) ? l_mesh(1) : notched_block(1));
    const MeshInside inside_inner(inner);
    const MeshInside inside_outer(outer);
    Pose X = random.below(3) ? Pose::Identity() : random.pose(0);
    X.translation() = random.below(2) ? random.lattice_vector(1) : random.vector(1);
    const Placement to_outer{X};
    const double tolerance = random.below(2) ? 1e-3 : 0.03;
    SurfaceSearch search(inside_inner, inside_outer, to_outer, tolerance);
    const std::optional<Vec3> point = search.find();
    if (deepest_of_points(inner, outer, to_outer, 1.001 * tolerance) > 0) {
      EXPECT_TRUE(point) << round;
    }
    if (!point) {
      ++free;
      continue;
    }
    ++found;
    EXPECT_TRUE(inside_outer.holds(*point)) << round;
    EXPECT_FALSE(surface_within(outer, *point, 0.99 * tolerance)) << round;
    const Vec3 own = to_outer.inverse() * *point;
    EXPECT_TRUE(surface_within(inner, own, 1e-9) || inside_inner.holds(own)) << round;
  }
  EXPECT_GT(found, 40);
  EXPECT_GT(free, 40);
}

TEST(FlatRegion, IsWithinTheMarginAndCoversTheTriangle) {
  Random random(6);
  for (int round = 0; round < 2000; ++round) {
    SeenTriangle triangle;
    std::array<Vec3, 3> corners;
    const double size = random.below(2) ? 1 : 0.05;
    for (int k = 0; k < 3; ++k) {
      corners[k] = random.vector(size);
      if (random.below(4) == 0) corners[k].z() = 0;
      if (random.below(8) == 0) corners[k].x() = corners[0].x();
      triangle.at[k] = corners[k].head<2>();
      triangle.height[k] = corners[k].z();
    }
    const double height = 0.02;
    const double margin = 0.03;
    const double fullness = random.below(2) ? 0.9 : 0.99;
    const FlatRegion region(triangle, height, margin, fullness);
    for (int i = 0; i < 200; ++i) {
      // A tiny square stands for a point.
      const double share_b = random.unit();
      const double share_c = random.unit() * (1 - share_b);
      const Vec3 on =
          corners[0] + share_b * (corners[1] - corners[0]) + share_c * (corners[2] - corners[0]);
      const Vec3 at = on + (random.below(3) ? random.vector(0.05) : Vec3(Vec3::Zero()));
      constexpr double kTiny = 1e-9;
      const Vec2 p = at.head<2>();
      std::vector<FlatPolygon> rest;
      region.cut_from({p, p + Vec2(kTiny, 0), p + Vec2(kTiny, kTiny), p + Vec2(0, kTiny)}, rest);
      const bool covered = rest.empty();
      if (at == on && std::fabs(on.z()) <= height) {
        EXPECT_TRUE(covered) << round;
      }
      if (!covered) continue;
      // Some point of the triangle, not higher than that, is within the margin.
      double nearest = 1;
      constexpr int kShares = 60;
      for (int u = 0; u <= kShares; ++u) {
        for (int v = 0; u + v <= kShares; ++v) {
          const Vec3 other = corners[0] + u * (corners[1] - corners[0]) / kShares +
                             v * (corners[2] - corners[0]) / kShares;
          if (std::fabs(other.z()) > height + size / kShares) continue;
          nearest = std::min(nearest, (other.head<2>() - p).norm());
        }
      }
      EXPECT_LE(nearest, margin + 4 * size / kShares) << round;
    }
  }
}

TEST(FlatRegion, CutsIntoPiecesThatAddUp) {
  Random random(7);
  const FlatPolygon square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int round = 0; round < 2000; ++round) {
    SeenTriangle triangle;
    for (int k = 0; k < 3; ++k) {
      triangle.at[k] = Vec2(random.between(-0.5, 1.5), random.between(-0.5, 1.5));
      triangle.height[k] = 0;
    }
    const FlatRegion region(triangle, 0, 0.05, 0.9);
    std::vector<FlatPolygon> rest;
    region.cut_from(square, rest);
    double area = 0;
    for (const FlatPolygon& piece : rest) {
      EXPECT_GE(area_of(piece), 0);
      area += area_of(piece);
    }
    EXPECT_LE(area, 1 - area_of(common_part(square, triangle.at)) + 1e-9);
    // Once more cuts nothing away.
    for (const FlatPolygon& piece : rest) {
      std::vector<FlatPolygon> again;
      region.cut_from(piece, again);
      double left = 0;
      for (const FlatPolygon& part : again) left += area_of(part);
      EXPECT_NEAR(left, area_of(piece), 1e-3);
    }
  }
}

}  // namespace
}  // namespace rubicon::collision::test
