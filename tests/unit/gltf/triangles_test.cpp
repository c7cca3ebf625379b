#include "src/results/gltf/triangles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "src/motion/math/angles.hpp"

namespace rubicon::gltf {
namespace {

using geometry::Shape;

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

double closed_volume(const Shape& shape) {
  const auto triangles = triangles_of({shape});
  EXPECT_LT(net_area(triangles).norm(), 1e-9);
  return volume(triangles);
}

TEST(Triangles, EncloseABox) {
  Shape box{geometry::Box{{-1, -2, 3}, {1, 1, 4}}};
  EXPECT_EQ(triangles_of({box}).size(), 12U);
  EXPECT_NEAR(closed_volume(box), 6, 1e-12);
  box.X_BS = math::translation(10, 0, 0) * math::rotation_x_deg(30);
  EXPECT_NEAR(closed_volume(box), 6, 1e-9);
}

TEST(Triangles, EncloseRoundShapes) {
  const Shape cylinder{geometry::Cylinder{2, 0, 3}};
  EXPECT_NEAR(closed_volume(cylinder) / (math::kPi * 12), 1, 0.01);
  const Shape sphere{geometry::Sphere{{5, 5, 5}, 2}};
  EXPECT_NEAR(closed_volume(sphere) / (math::kPi * 32 / 3), 1, 0.02);
  const Shape capsule{geometry::Capsule{{5, 5, 5}, {5, 1, 5}, 2}};
  EXPECT_NEAR(closed_volume(capsule) / (math::kPi * (32.0 / 3 + 16)), 1, 0.02);
}

TEST(Triangles, EncloseAPrismOfEitherOrientation) {
  geometry::Prism prism{-1, 1, {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}};  // an L
  EXPECT_NEAR(closed_volume({prism}), 14, 1e-12);
  std::reverse(prism.polygon.begin(), prism.polygon.end());
  EXPECT_NEAR(closed_volume({prism}), 14, 1e-12);
}

TEST(Triangles, RefuseMoreThanAnyFilmHas) {
  const Shape sphere{geometry::Sphere{{0, 0, 0}, 1}};
  const std::size_t each = triangles_of({sphere}).size();
  const std::vector<Shape> many(3, sphere);
  EXPECT_EQ(triangles_of(many, 3 * each).size(), 3 * each);
  EXPECT_THROW(triangles_of(many, 3 * each - 1), std::invalid_argument);
}

TEST(Triangles, LeaveOutWhatHasNoArea) {
  geometry::TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 1}, {0, 1, 3}};
  const Shape shape{geometry::Mesh{"", std::make_shared<geometry::TriangleMesh>(mesh)}};
  EXPECT_EQ(triangles_of({shape}).size(), 1U);
}

TEST(Triangles, RefuseSolidsWithoutExtent) {
  for (const geometry::Solid& solid :
       {geometry::Solid(geometry::Box{{0, 0, 0}, {1, 0, 1}}), geometry::Solid(geometry::Sphere{}),
        geometry::Solid(geometry::Cylinder{1, 2, 1}),
        geometry::Solid(geometry::Capsule{{0, 0, 0}, {0, 0, 1}, -1}),
        geometry::Solid(geometry::Prism{1, 1, {{0, 0}, {1, 0}, {0, 1}}})}) {
    EXPECT_THROW(triangles_of({{solid}}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace rubicon::gltf
