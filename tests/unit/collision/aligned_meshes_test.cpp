#include <gtest/gtest.h>

#include <cmath>

#include "random_scene.hpp"
#include "src/motion/collision/sweep/body.hpp"
#include "src/motion/math/angles.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/collision/random_scene.hpp"

// Bodies that overlap although no surface of one crosses a surface of the other: faces lie in each
// other, or one body is wholly inside the other.

namespace rubicon::collision::test {
namespace {

using Corner = std::array<double, 2>;

/// The closed mesh over a polygon (counterclockwise) from z0 to z1; `caps` triangulates the
/// polygon.
BodyPtr extruded(const std::vector<Corner>& polygon, const std::vector<std::array<int, 3>>& caps,
                 double z0, double z1) {
  auto mesh = std::make_shared<geometry::TriangleMesh>();
  const int count = static_cast<int>(polygon.size());
  for (const double z : {z0, z1}) {
    for (const Corner& corner : polygon) mesh->vertices.emplace_back(corner[0], corner[1], z);
  }
  for (const auto& [a, b, c] : caps) {
    mesh->triangles.push_back({a, c, b});
    mesh->triangles.push_back({count + a, count + b, count + c});
  }
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    mesh->triangles.push_back({i, next, count + next});
    mesh->triangles.push_back({i, count + next, count + i});
  }
  mesh->closed = true;
  return prepare({{geometry::Mesh{"extruded", mesh}, Pose::Identity()}});
}

const std::vector<std::array<int, 3>> kAngleCaps = {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {3, 4, 5}};

/// An L of 2 m x 2 m with legs of 1 m, 1 m high.
BodyPtr angle() {
  return extruded({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, kAngleCaps, 0, 1);
}

/// A channel of 0.3 m x 0.3 m, standing, 5 m long.
BodyPtr channel(double wall = 0.02) {
  const double inner = 0.3 - wall;
  return extruded({{0, 0},
                   {0.3, 0},
                   {0.3, 0.3},
                   {inner, 0.3},
                   {inner, wall},
                   {wall, wall},
                   {wall, 0.3},
                   {0, 0.3}},
                  {{0, 5, 7}, {5, 6, 7}, {0, 1, 5}, {1, 4, 5}, {1, 2, 4}, {2, 3, 4}}, 0, 5);
}

/// An L of sheet metal lying on z = 0, legs of 1 m.
BodyPtr sheet(double thickness) {
  return extruded({{0, 0}, {1, 0}, {1, 0.3}, {0.3, 0.3}, {0.3, 1}, {0, 1}}, kAngleCaps, 0,
                  thickness);
}

/// A column of 200 sides, too many corners to be tested as one polytope.
BodyPtr column() {
  std::vector<Corner> circle;
  std::vector<std::array<int, 3>> caps;
  for (int i = 0; i < 200; ++i) {
    circle.push_back({0.3 * math::cos_deg(1.8 * i), 0.3 * math::sin_deg(1.8 * i)});
    if (i >= 2) caps.push_back({0, i - 1, i});
  }
  return extruded(circle, caps, 0, 3);
}

bool lowered(const Body& body, const Pose& X, const Vec3& way, const BodyPtr& obstacle) {
  return blocked(body, geometry::translating(X, way), obstacle, Pose::Identity(), kTolerance);
}

TEST(AlignedMeshes, AtTheSamePlaceOverlap) {
  for (const BodyPtr& body : {angle(), channel(), column()}) {
    ASSERT_EQ(body->soups().size(), 1U) << "else this tests polytopes";
    EXPECT_TRUE(overlaps(*body, at(0, 0, 0), *body, at(0, 0, 0), kTolerance));
    EXPECT_TRUE(overlaps(*body, at(0, 0, 0.25), *body, at(0, 0, 0), kTolerance));
    EXPECT_TRUE(overlaps(*body, at(0, 0, 0.5), *body, at(0, 0, 0), kTolerance));
  }
  EXPECT_TRUE(overlaps(*angle(), at(0.5, 0, 0), *angle(), at(0, 0, 0), kTolerance));
}

TEST(AlignedMeshes, MayStandOnAndBesideEachOther) {
  EXPECT_FALSE(overlaps(*angle(), at(0, 0, 1), *angle(), at(0, 0, 0), kTolerance));
  EXPECT_FALSE(overlaps(*angle(), at(2, 0, 0), *angle(), at(0, 0, 0), kTolerance));
  EXPECT_FALSE(overlaps(*channel(), at(0, 0, 5), *channel(), at(0, 0, 0), kTolerance));
  EXPECT_FALSE(overlaps(*column(), at(0, 0, 3), *column(), at(0, 0, 0), kTolerance));
  // Slid along each other.
  EXPECT_FALSE(lowered(*angle(), at(0, 0, 1), Vec3(0.5, 0.3, 0), angle()));
  EXPECT_FALSE(lowered(*channel(), at(0, 0, 5), Vec3(0, 0, 0.5), channel()));
}

TEST(AlignedMeshes, CannotBePushedIntoEachOther) {
  EXPECT_TRUE(lowered(*angle(), at(0, 0, 1), Vec3(0, 0, -0.4), angle()));
  EXPECT_TRUE(lowered(*angle(), at(0, 0, 1.0005), Vec3(0, 0, -0.4), angle()));
  EXPECT_TRUE(lowered(*angle(), at(0, 0, 1), Vec3(0, 0, -1), angle()));
  EXPECT_TRUE(lowered(*channel(), at(0, 0, 5), Vec3(0, 0, -0.5), channel()));
  EXPECT_TRUE(lowered(*channel(), at(0.0003, 0.0002, 5), Vec3(0, 0, -0.5), channel()));
  EXPECT_TRUE(lowered(*column(), at(0, 0, 3), Vec3(0, 0, -0.5), column()));
}

TEST(AlignedMeshes, CannotCreepIntoEachOther) {
  const BodyPtr body = channel();
  double depth = 0;
  while (depth < 0.1 && !lowered(*body, at(0, 0, 5 - depth), Vec3(0, 0, -1e-3), body)) {
    depth += 1e-3;
  }
  EXPECT_LT(depth, 0.02);
}

TEST(AlignedMeshes, WhollyInsideWithFlushFaces) {
  const BodyPtr slab = extruded({{-5, -5}, {9, -5}, {9, 9}, {2, 9}, {2, 8}, {-5, 8}},
                                {{0, 1, 2}, {0, 2, 4}, {2, 3, 4}, {0, 4, 5}}, 0, 1);
  EXPECT_TRUE(overlaps(*angle(), at(0, 0, 0), *slab, at(0, 0, 0), kTolerance));
  // No face in a face, but all its corners within the tolerance of them.
  const BodyPtr inner = extruded({{.1, .1}, {.9, .1}, {.9, .4}, {.4, .4}, {.4, .9}, {.1, .9}},
                                 kAngleCaps, 0.0009, 0.9991);
  EXPECT_TRUE(overlaps(*inner, at(0, 0, 0), *angle(), at(0, 0, 0), kTolerance));
}

TEST(AlignedMeshes, ThinnerThanTheToleranceAtTheSamePlace) {
  for (const double wall : {1.5e-3, 0.8e-3, 0.3e-3, 0.1e-3}) {
    const BodyPtr thin = channel(wall);
    EXPECT_TRUE(overlaps(*thin, at(0, 0, 0), *thin, at(0, 0, 0), kTolerance)) << wall;
    EXPECT_TRUE(overlaps(*thin, at(0, 0, 2.5), *thin, at(0, 0, 0), kTolerance)) << wall;
    EXPECT_TRUE(overlaps(*thin, at(0, 0, -4.9), *thin, at(0, 0, 0), kTolerance)) << wall;
    EXPECT_FALSE(overlaps(*thin, at(0, 0, 5), *thin, at(0, 0, 0), kTolerance)) << wall;
    EXPECT_FALSE(overlaps(*thin, at(0.3, 0, 0), *thin, at(0, 0, 0), kTolerance)) << wall;
    EXPECT_FALSE(overlaps(*thin, at(0, -0.3, 1), *thin, at(0, 0, 0), kTolerance)) << wall;
    EXPECT_TRUE(lowered(*thin, at(0, 0, 5), Vec3(0, 0, -0.3), thin)) << wall;
    EXPECT_FALSE(lowered(*thin, at(0.3, 0, 5), Vec3(0, 0, -5), thin)) << wall;
  }
}

TEST(AlignedMeshes, ASheetSunkIntoASlab) {
  const BodyPtr thin = sheet(0.8e-3);
  EXPECT_TRUE(overlaps(*thin, at(0.4, 0.4, 1 - 0.8e-3), *angle(), at(0, 0, 0), kTolerance));
  EXPECT_TRUE(overlaps(*thin, at(0, 0, 1 - 0.8e-3), *angle(), at(0, 0, 0), kTolerance));
  EXPECT_FALSE(overlaps(*thin, at(0, 0, 1), *angle(), at(0, 0, 0), kTolerance));
  EXPECT_FALSE(overlaps(*thin, at(0, 0, 1 - 0.1e-3), *angle(), at(0, 0, 0), kTolerance));
}

TEST(AlignedMeshes, SheetsCannotCreepThroughEachOther) {
  const BodyPtr thin = sheet(0.8e-3);
  double height = 1.5e-3;
  while (height > -1.5e-3 && !lowered(*thin, at(0, 0, height), Vec3(0, 0, -1e-4), thin)) {
    height -= 1e-4;
  }
  EXPECT_GT(height, 0.5e-3);
}

TEST(AlignedMeshes, TurnedAsAWhole) {
  const Pose X = math::translation(3, -2, 1) * math::rotation_z_deg(33) * math::rotation_x_deg(17);
  for (const BodyPtr& body : {angle(), channel(), channel(1e-3), column()}) {
    EXPECT_TRUE(overlaps(*body, X, *body, X, kTolerance));
    EXPECT_TRUE(overlaps(*body, X * at(0, 0, 0.7), *body, X, kTolerance));
  }
  EXPECT_FALSE(overlaps(*angle(), X * at(0.3, 0.4, 1), *angle(), X, kTolerance));
  EXPECT_FALSE(overlaps(*channel(1e-3), X * at(0, 0, 5), *channel(1e-3), X, kTolerance));
}

TEST(AlignedMeshes, AConeWithManyCornersAtItsRim) {
  for (const int sides : {12, 50, 100, 200}) {
    auto mesh = std::make_shared<geometry::TriangleMesh>();
    for (int i = 0; i < sides; ++i) {
      const double round = 360.0 * i / sides;
      mesh->vertices.emplace_back(0.5 + 0.2 * math::cos_deg(round),
                                  0.5 + 0.2 * math::sin_deg(round), 1);
    }
    mesh->vertices.emplace_back(0.5, 0.5, 0.91);
    for (int i = 0; i < sides; ++i) mesh->triangles.push_back({(i + 1) % sides, i, sides});
    for (int i = 1; i + 1 < sides; ++i) mesh->triangles.push_back({0, i, i + 1});
    mesh->closed = true;
    const BodyPtr cone = prepare({{geometry::Mesh{"cone", mesh}, Pose::Identity()}});
    ASSERT_EQ(cone->convexes().size(), 1U);
    EXPECT_TRUE(overlaps(*cone, at(0, 0, 0), *angle(), at(0, 0, 0), kTolerance)) << sides;
  }
}

TEST(AlignedMeshes, AThinSheetInsideAThinWall) {
  const BodyPtr wall =
      extruded({{0, 0}, {2, 0}, {2, 0.0018}, {1, 0.0018}, {1, 0.5}, {0, 0.5}}, kAngleCaps, 0, 1);
  const BodyPtr sheet = prepare({box_shape(Vec3(1.2, 0.00015, 0.2), Vec3(1.8, 0.00165, 0.8))});
  EXPECT_TRUE(overlaps(*sheet, at(0, 0, 0), *wall, at(0, 0, 0), kTolerance));
  EXPECT_FALSE(overlaps(*sheet, at(0, 0.01, 0), *wall, at(0, 0, 0), kTolerance));
}

}  // namespace
}  // namespace rubicon::collision::test
