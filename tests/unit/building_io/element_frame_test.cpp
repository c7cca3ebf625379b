#include "src/exchange/building_io/element_frame.hpp"

#include <gtest/gtest.h>

#include "src/motion/math/pose.hpp"
#include "tests/unit/mesh_io/mesh_files_io.hpp"

namespace rubicon::building_io {
namespace {

/// A box about the origin's lower middle, turned and moved.
geometry::TriangleMesh box(const Vec3& size, double turn_deg, const Vec3& at) {
  geometry::TriangleMesh mesh;
  const math::Pose turn = math::rotation_z_deg(turn_deg);
  for (const auto& triangle : mesh_io::testing::box_soup({-size.x() / 2, -size.y() / 2, 0},
                                                         {size.x() / 2, size.y() / 2, size.z()})) {
    const auto base = static_cast<int>(mesh.vertices.size());
    for (const Vec3& p : triangle) mesh.vertices.push_back(turn * p + at);
    mesh.triangles.push_back({base, base + 1, base + 2});
  }
  mesh.closed = true;
  return mesh;
}

TEST(ElementFrame, ABoxIsFoundHoweverItLies) {
  for (const double turn : {0.0, 90.0, 30.0, -60.0, 12.3456, 45.0, -89.0}) {
    for (const Vec3& at : {Vec3(0, 0, 0), Vec3(12.34, -5, 3), Vec3(155000.12, 463000.34, -2)}) {
      const ElementFrame frame = frame_of(box({6, 0.3, 2.7}, turn, at));
      EXPECT_NEAR(frame.turn_deg, turn, 1e-3);
      EXPECT_LT((frame.size - Vec3(6, 0.3, 2.7)).norm(), 3e-5) << turn;
      EXPECT_LT((frame.origin - at).norm(), 3e-5) << turn;
      EXPECT_NEAR(frame.volume, 6 * 0.3 * 2.7, 1e-6);
    }
  }
}

TEST(ElementFrame, TheLongerSideLiesAlongX) {
  const ElementFrame frame = frame_of(box({0.3, 6, 1}, 0, {0, 0, 0}));
  EXPECT_EQ(frame.turn_deg, 90);
  EXPECT_LT((frame.size - Vec3(6, 0.3, 1)).norm(), 1e-9);
}

TEST(ElementFrame, NearlyWholeDegreesAreThem) {
  EXPECT_EQ(frame_of(box({6, 0.3, 1}, 30.004, {0, 0, 0})).turn_deg, 30);
  EXPECT_NE(frame_of(box({6, 0.3, 1}, 30.02, {0, 0, 0})).turn_deg, 30);
}

TEST(ElementFrame, AnOpenSurfaceHasNoVolume) {
  geometry::TriangleMesh mesh = box({6, 0.3, 1}, 0, {0, 0, 0});
  mesh.closed = false;
  EXPECT_EQ(frame_of(mesh).volume, 0);
}

TEST(ElementFrame, WhatHasNoWidthDoesNoHarm) {
  geometry::TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  const ElementFrame frame = frame_of(mesh);
  EXPECT_NEAR(frame.turn_deg, 45, 1e-9);
  EXPECT_NEAR(frame.size.y(), 0, 1e-9);
  mesh.vertices = {{1, 2, 3}, {1, 2, 3}, {1, 2, 4}};
  EXPECT_EQ(frame_of(mesh).origin, Vec3(1, 2, 3));
}

TEST(ElementFrame, InItsFrameAMeshLiesAboutTheOrigin) {
  const geometry::TriangleMesh mesh = box({6, 0.3, 2.7}, 30, {155000.12, 463000.34, -2});
  const geometry::TriangleMesh local = in_frame(mesh, frame_of(mesh));
  const geometry::Box extent = mesh_io::testing::extent(local);
  EXPECT_LT((extent.lower - Vec3(-3, -0.15, 0)).norm(), 3e-5);
  EXPECT_LT((extent.upper - Vec3(3, 0.15, 2.7)).norm(), 3e-5);
}

}  // namespace
}  // namespace rubicon::building_io
