#include "src/results/gltf/triangles.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "src/motion/math/angles.hpp"

namespace rubicon::gltf {
namespace {

using verify::ShapeData;

/// What closed triangles that face outwards enclose (m3).
double volume(const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) sum += t[0].dot(t[1].cross(t[2])) / 6;
  return sum;
}

/// The area of them all as a vector: nothing for closed ones.
Vec3 net_area(const std::vector<Triangle>& triangles) {
  Vec3 sum = Vec3::Zero();
  for (const Triangle& t : triangles) sum += (t[1] - t[0]).cross(t[2] - t[0]) / 2;
  return sum;
}

double closed_volume(const ShapeData& shape) {
  const auto triangles = triangles_of({shape}, {});
  EXPECT_LT(net_area(triangles).norm(), 1e-9);
  return volume(triangles);
}

TEST(Triangles, EncloseABox) {
  ShapeData box;
  box.a = {-1, -2, 3};
  box.b = {1, 1, 4};
  EXPECT_EQ(triangles_of({box}, {}).size(), 12U);
  EXPECT_NEAR(closed_volume(box), 6, 1e-12);
  box.X_BS = math::translation(10, 0, 0) * math::rotation_x_deg(30);
  EXPECT_NEAR(closed_volume(box), 6, 1e-9);
}

TEST(Triangles, EncloseRoundShapes) {
  ShapeData cylinder;
  cylinder.kind = ShapeData::Kind::cylinder;
  cylinder.radius = 2;
  cylinder.z1 = 3;
  EXPECT_NEAR(closed_volume(cylinder) / (math::kPi * 12), 1, 0.01);
  ShapeData sphere;
  sphere.kind = ShapeData::Kind::sphere;
  sphere.a = sphere.b = {5, 5, 5};
  sphere.radius = 2;
  EXPECT_NEAR(closed_volume(sphere) / (math::kPi * 32 / 3), 1, 0.02);
  ShapeData capsule = sphere;
  capsule.kind = ShapeData::Kind::capsule;
  capsule.b = {5, 1, 5};
  EXPECT_NEAR(closed_volume(capsule) / (math::kPi * (32.0 / 3 + 16)), 1, 0.02);
}

TEST(Triangles, EncloseAPrismOfEitherOrientation) {
  ShapeData prism;
  prism.kind = ShapeData::Kind::prism;
  prism.z0 = -1;
  prism.z1 = 1;
  prism.polygon = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};  // an L
  EXPECT_NEAR(closed_volume(prism), 14, 1e-12);
  std::reverse(prism.polygon.begin(), prism.polygon.end());
  EXPECT_NEAR(closed_volume(prism), 14, 1e-12);
}

TEST(Triangles, RefuseMoreThanAnyFilmHas) {
  ShapeData sphere;
  sphere.kind = ShapeData::Kind::sphere;
  sphere.radius = 1;
  const std::size_t each = triangles_of({sphere}, {}).size();
  const std::vector<ShapeData> many(3, sphere);
  EXPECT_EQ(triangles_of(many, {}, 3 * each).size(), 3 * each);
  EXPECT_THROW(triangles_of(many, {}, 3 * each - 1), verify::UnreadableInput);
}

TEST(Triangles, LeaveOutWhatHasNoArea) {
  verify::MeshData mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 1}, {0, 1, 3}};
  ShapeData shape;
  shape.kind = ShapeData::Kind::mesh;
  shape.mesh = 0;
  EXPECT_EQ(triangles_of({shape}, {mesh}).size(), 1U);
}

}  // namespace
}  // namespace rubicon::gltf
