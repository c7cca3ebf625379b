#include "src/motion/geometry/volume.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numbers>

namespace rubicon::geometry {
namespace {

using std::numbers::pi;

void expect_volume(const Shape& shape, double volume, const Vec3& centre) {
  const auto found = volume_of(shape);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->volume, volume, 1e-12 * (1 + volume));
  EXPECT_LT((found->centre - centre).norm(), 1e-9) << found->centre.transpose();
}

/// A box as twelve triangles that face outwards.
std::shared_ptr<TriangleMesh> box_mesh(const Vec3& lower, const Vec3& upper) {
  auto mesh = std::make_shared<TriangleMesh>();
  for (int i = 0; i < 8; ++i) {
    mesh->vertices.emplace_back((i & 1) != 0 ? upper.x() : lower.x(),
                                (i & 2) != 0 ? upper.y() : lower.y(),
                                (i & 4) != 0 ? upper.z() : lower.z());
  }
  mesh->triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  mesh->closed = true;
  return mesh;
}

TEST(Volume, OfSolids) {
  const Pose X = math::translation(10, 0, 0) * math::rotation_z_deg(90);
  expect_volume({Box{{0, 0, 0}, {2, 1, 4}}, X}, 8, {9.5, 1, 2});
  expect_volume({Cylinder{0.5, 1, 3}, X}, 0.5 * pi, {10, 0, 2});
  expect_volume({Sphere{{1, 0, 0}, 2}, X}, 32.0 / 3 * pi, {10, 1, 0});
  expect_volume({Capsule{{0, 0, 0}, {3, 0, 0}, 1}, X}, 3 * pi + 4.0 / 3 * pi, {10, 1.5, 0});
}

TEST(Volume, OfAPrismEitherWayRound) {
  // A square of 3 m without one of 2 m in its corner.
  Prism angle{0, 2, {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}};
  expect_volume({angle}, 10, {1.1, 1.1, 1});
  std::reverse(angle.polygon.begin(), angle.polygon.end());
  expect_volume({angle}, 10, {1.1, 1.1, 1});
}

TEST(Volume, OfAMeshFarFromTheOriginAndOfNoneThatIsOpen) {
  const Vec3 far(1e5, -2e5, 10);
  auto mesh = box_mesh(far, far + Vec3(1, 2, 3));
  const auto found = volume_of(Shape{Mesh{"box", mesh}, Pose::Identity()});
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->volume, 6, 1e-9);
  EXPECT_LT((found->centre - far - Vec3(0.5, 1, 1.5)).norm(), 1e-9);
  mesh->closed = false;
  EXPECT_FALSE(volume_of(Shape{Mesh{"box", mesh}, Pose::Identity()}).has_value());
}

TEST(Volume, OfSeveralShapesIsTheirSum) {
  const std::vector<Shape> shapes = {{Box{{0, 0, 0}, {1, 1, 1}}}, {Box{{2, 0, 0}, {5, 1, 1}}}};
  const auto found = volume_of(shapes);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->volume, 4, 1e-12);
  EXPECT_NEAR(found->centre.x(), (0.5 + 3 * 3.5) / 4, 1e-12);
  EXPECT_FALSE(volume_of(std::vector<Shape>{}).has_value());
}

}  // namespace
}  // namespace rubicon::geometry
