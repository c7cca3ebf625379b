#include <gtest/gtest.h>

#include "src/motion/collision/mesh/winding.hpp"
#include "src/motion/collision/pair/containment.hpp"
#include "src/motion/collision/sweep/body.hpp"
#include "tests/unit/collision/box_oracle.hpp"
#include "tests/unit/collision/meshes.hpp"
#include "tests/unit/collision/random_scene.hpp"

namespace rubicon::collision::test {
namespace {

/// The L mesh at X as the union of two boxes.
std::vector<OracleBox> l_boxes(const Pose& X) {
  return {{X * at(1, 0.25, 0.5), Vec3(1, 0.25, 0.5)}, {X * at(0.25, 1, 0.5), Vec3(0.25, 1, 0.5)}};
}

OracleBox resized(const OracleBox& box, double by) { return {box.X_WC, box.half.array() + by}; }

/// A box on its way against the L. Deep for sure: the box, smaller by twice the tolerance, still
/// meets a leg. Clear for sure: the box grown by the band touches neither.
void check_against_l(const BodyPtr& l, const Vec3& half, const Motion& motion, const Pose& X_WL,
                     int& deep, int& clear) {
  const auto& screw = std::get<geometry::ScrewMotion>(motion.kind);
  const double radius = screw.axis.cross(screw.X0.translation() - screw.point).norm() + half.norm();
  const double speed = math::radians(std::fabs(screw.angle_deg)) * radius + screw.slide.norm();
  const auto depth = [&](double s, double by) {
    const OracleBox moving = resized({motion.pose(s), half}, by);
    double greatest = -1e9;
    for (const OracleBox& leg : l_boxes(X_WL))
      greatest = std::max(greatest, box_depth(moving, leg));
    return greatest;
  };
  const Truth smaller =
      classify([&](double s) { return depth(s, -2 * kTolerance); }, speed, 0, 1e-5);
  const Truth larger = classify([&](double s) { return depth(s, kBand); }, speed, 0, 1e-5);
  if (smaller != Truth::kHit && larger != Truth::kFree) return;
  const bool expected = smaller == Truth::kHit;
  ++(expected ? deep : clear);
  ASSERT_EQ(blocked(*box(half), motion, l, X_WL, kTolerance), expected) << "a box against the mesh";
  // The same step seen the other way round: the mesh moves, the box stands.
  const Pose X_0 = motion.pose(0);
  geometry::ScrewMotion inverse;
  inverse.X0 = X_WL;
  inverse.axis = screw.axis;
  inverse.point = screw.point;
  inverse.angle_deg = -screw.angle_deg;
  inverse.slide = -screw.slide;
  ASSERT_EQ(blocked(*l, Motion{inverse}, box(half), X_0, kTolerance), expected)
      << "the mesh against a box";
}

class LMesh : public testing::TestWithParam<int> {};

TEST_P(LMesh, AgreesWithTheUnionOfTwoBoxes) {
  const BodyPtr l = mesh_body(l_mesh(GetParam()));
  Random random(41);
  int deep = 0;
  int clear = 0;
  for (int i = 0; i < 1200; ++i) {
    const Vec3 half(random.between(0.02, 0.4), random.between(0.02, 0.4),
                    random.between(0.02, 0.4));
    const Pose X_WL = random.pose(0.5);
    const Pose X_WA = random.pose(1.5);
    const Motion motion = i % 2 ? geometry::translating(X_WA, random.vector(0.5))
                                : turning(X_WA, random.direction(), random.vector(3),
                                          random.between(-15, 15), random.between(-0.2, 0.2));
    check_against_l(l, half, motion, X_WL, deep, clear);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(deep, 150);
  EXPECT_GT(clear, 150);
}

INSTANTIATE_TEST_SUITE_P(CoarseAndFine, LMesh, testing::Values(0, 1, 3));

TEST(Mesh, AConvexClosedMeshIsTakenAsASolid) {
  const BodyPtr cuboid = mesh_body(cuboid_mesh(Vec3(1, 2, 3), 1));
  ASSERT_EQ(cuboid->convexes().size(), 1U);
  EXPECT_TRUE(cuboid->soups().empty());
  EXPECT_EQ(cuboid->convexes()[0].normals.size(), 3U);
  EXPECT_EQ(cuboid->convexes()[0].edges.size(), 3U);
  EXPECT_EQ(mesh_body(l_mesh())->soups().size(), 1U);
}

TEST(Mesh, AConvexMeshAnswersLikeTheBox) {
  Random random(42);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 half(random.between(0.1, 1), random.between(0.1, 1), random.between(0.1, 1));
    const BodyPtr part = box(Vec3(0.2, 0.3, 0.4));
    const Motion motion = geometry::translating(random.pose(1.2), random.vector(0.5));
    const Pose X = random.pose(0.5);
    EXPECT_EQ(blocked(*part, motion, mesh_body(cuboid_mesh(half, 1)), X, 1e-3),
              blocked(*part, motion, box(half), X, 1e-3));
  }
}

TEST(Mesh, InsideAClosedMeshIsAHitBothWays) {
  const BodyPtr l = mesh_body(l_mesh());
  const BodyPtr pebble = box(Vec3::Constant(0.05));
  const Pose inside = at(1.5, 0.25, 0.5);
  EXPECT_TRUE(overlaps(*pebble, inside, *l, at(0, 0, 0), 1e-3));
  EXPECT_TRUE(overlaps(*l, at(0, 0, 0), *pebble, inside, 1e-3));
  EXPECT_TRUE(
      blocked(*pebble, geometry::translating(inside, Vec3(0.1, 0, 0)), l, at(0, 0, 0), 1e-3));
  EXPECT_TRUE(
      blocked(*l, geometry::translating(at(0, 0, 0), Vec3(0.1, 0, 0)), pebble, inside, 1e-3));
  EXPECT_FALSE(overlaps(*pebble, at(1.5, 1.5, 0.5), *l, at(0, 0, 0),
                        1e-3));  // in the notch, inside the hull

  CollisionWorld world;
  const ObstacleId id = world.insert(l, at(0, 0, 0));
  EXPECT_EQ(world.blocked_at(*pebble, inside, 1e-3, {}), id);
  EXPECT_EQ(world.blocked_at(*pebble, inside, 1e-3, {id}), std::nullopt);

  const BodyPtr small_l =
      prepare({{geometry::Mesh{"s.stl", std::make_shared<geometry::TriangleMesh>([] {
                                 geometry::TriangleMesh mesh = l_mesh();
                                 for (Vec3& vertex : mesh.vertices) vertex *= 0.05;
                                 return mesh;
                               }())},
                Pose::Identity()}});
  EXPECT_TRUE(overlaps(*small_l, inside, *l, at(0, 0, 0), 1e-3));
  EXPECT_TRUE(overlaps(*l, at(0, 0, 0), *small_l, inside, 1e-3));
  EXPECT_FALSE(overlaps(*small_l, at(1.5, 1.5, 0.5), *l, at(0, 0, 0), 1e-3));
}

TEST(Mesh, ACavityIsRoomAShellIsNot) {
  const BodyPtr hollow = mesh_body(hollow_cube_mesh());
  const BodyPtr pebble = box(Vec3::Constant(0.1));
  EXPECT_FALSE(overlaps(*pebble, at(0.2, 0, 0), *hollow, at(0, 0, 0), 1e-3));
  EXPECT_TRUE(overlaps(*pebble, at(0.75, 0, 0), *hollow, at(0, 0, 0), 1e-3));
  EXPECT_TRUE(overlaps(*pebble, at(0.5, 0, 0), *hollow, at(0, 0, 0), 1e-3));
  EXPECT_FALSE(
      overlaps(*pebble, at(0.4, 0, 0), *hollow, at(0, 0, 0), 1e-3));  // touches the cavity's wall
}

TEST(Mesh, WindingNumberAgreesWithTheUnionOfBoxes) {
  const BodyPtr l = mesh_body(l_mesh(2));
  Random random(43);
  for (int i = 0; i < 3000; ++i) {
    // Half of the points on the lattice, where rays meet edges and corners.
    const Vec3 p =
        i % 2
            ? Vec3(random.between(-0.2, 2.2), random.between(-0.2, 2.2), random.between(-0.2, 1.2))
            : Vec3(0.125 * random.below(20) - 0.1875, 0.125 * random.below(20) - 0.1875,
                   0.125 * random.below(10) - 0.0625);
    double clearance = -1e9;
    for (const OracleBox& leg : l_boxes(at(0, 0, 0))) {
      clearance =
          std::max(clearance, (leg.half - (p - leg.X_WC.translation()).cwiseAbs()).minCoeff());
    }
    if (std::fabs(clearance) < 1e-6) continue;
    const Vec3 centred = p - l->extent().centre;
    EXPECT_EQ(winding_number(l->soups()[0], centred) != 0, clearance > 0) << p.transpose();
  }
}

TEST(Mesh, RestingSlidingAndTurningOnAMeshIsFree) {
  // An L-shaped slab, finely cut, and a panel that stands on it; both as triangles.
  for (const int fineness : {0, 3}) {
    const BodyPtr slab = mesh_body(l_mesh(fineness));
    const BodyPtr panel = box(Vec3(0.2, 0.05, 0.4));
    const BodyPtr l_panel = mesh_body(l_mesh(fineness));
    for (const double deeper : {0.0, 0.5e-3}) {
      const Pose X = at(0.9, 0.25, 1.4 - deeper);
      EXPECT_FALSE(overlaps(*panel, X, *slab, at(0, 0, 0), 1e-3));
      EXPECT_FALSE(
          blocked(*panel, geometry::translating(X, Vec3(0.3, 0.02, 0)), slab, at(0, 0, 0), 1e-3));
      EXPECT_FALSE(blocked(*panel, turning(X, Vec3::UnitZ(), Vec3(0.9, 0.25, 0), 5), slab,
                           at(0, 0, 0), 1e-3));
      EXPECT_FALSE(overlaps(*l_panel, at(0.3, 0.1, 1 - deeper), *slab, at(0, 0, 0), 1e-3));
      EXPECT_FALSE(blocked(*l_panel,
                           geometry::translating(at(0.3, 0.1, 1 - deeper), Vec3(0.3, 0.02, 0)),
                           slab, at(0, 0, 0), 1e-3));
    }
    EXPECT_TRUE(blocked(*panel, geometry::translating(at(0.9, 0.25, 1.4), Vec3(0.1, 0, -0.01)),
                        slab, at(0, 0, 0), 1e-3));
    EXPECT_TRUE(overlaps(*l_panel, at(0.3, 0.1, 0.99), *slab, at(0, 0, 0), 1e-3));
  }
}

TEST(Mesh, FineMeshesCannotBePassedThrough) {
  // Triangles of some 10 mm against a tolerance of 10 mm: each pair alone would be shallow.
  const auto scaled_l = [](double scale, int fineness) {
    geometry::TriangleMesh mesh = l_mesh(fineness);
    for (Vec3& vertex : mesh.vertices) vertex *= scale;
    return mesh_body(mesh);
  };
  const BodyPtr fine = scaled_l(0.2, 5);
  const BodyPtr other = scaled_l(0.1, 4);
  Random random(44);
  for (int i = 0; i < 50; ++i) {
    Pose X = random.pose(0.0);
    X.translation() = Vec3(0.25, 0.05, 0.2) - X.linear() * Vec3(0.1, 0.02, 0.05);
    EXPECT_TRUE(overlaps(*other, X, *fine, at(0, 0, 0), 0.01)) << "case " << i;
    EXPECT_TRUE(overlaps(*fine, at(0, 0, 0), *other, X, 0.01)) << "case " << i;
  }
}

TEST(Mesh, AnOpenMeshHasSurfacesButNoInside) {
  geometry::TriangleMesh sheet = l_mesh();
  sheet.triangles.resize(sheet.triangles.size() - 2);
  sheet.closed = false;
  const BodyPtr open = mesh_body(sheet);
  const BodyPtr pebble = box(Vec3::Constant(0.05));
  EXPECT_FALSE(overlaps(*pebble, at(1.5, 0.25, 0.5), *open, at(0, 0, 0), 1e-3));
  EXPECT_TRUE(overlaps(*pebble, at(1.5, 0.5, 0.5), *open, at(0, 0, 0), 1e-3));
}

}  // namespace
}  // namespace rubicon::collision::test
