#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/unit/collision/random_scene.hpp"

namespace rubicon::collision::test {
namespace {

using geometry::Shape;

const double kInfinity = std::numeric_limits<double>::infinity();

void expect_refused(const geometry::Solid& solid, const std::string& part_of_message) {
  try {
    prepare({Shape{solid, Pose::Identity()}});
    ADD_FAILURE() << "accepted; expected a message with \"" << part_of_message << '"';
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(part_of_message), std::string::npos) << error.what();
  }
}

geometry::Solid mesh(std::vector<Vec3> vertices, std::vector<std::array<int, 3>> triangles) {
  return geometry::Mesh{"part.stl", std::make_shared<geometry::TriangleMesh>(geometry::TriangleMesh{
                                        std::move(vertices), std::move(triangles), false})};
}

TEST(Prepare, RefusesWhatHasNoExtentOrIsNotFinite) {
  EXPECT_THROW(prepare({}), std::invalid_argument);
  expect_refused(geometry::Box{Vec3(0, 0, 0), Vec3(1, 0, 1)}, "length of a box along y is 0");
  expect_refused(geometry::Box{Vec3(0, 0, 0), Vec3(1, kNan, 1)}, "not finite");
  expect_refused(geometry::Box{Vec3(0, 0, -kInfinity), Vec3(1, 1, 1)}, "not finite");
  expect_refused(geometry::Sphere{Vec3::Zero(), 0}, "radius of a sphere");
  expect_refused(geometry::Sphere{Vec3::Zero(), -1}, "radius of a sphere is -1");
  expect_refused(geometry::Sphere{Vec3(kNan, 0, 0), 1}, "centre of a sphere");
  expect_refused(geometry::Cylinder{0, 0, 1}, "radius of a cylinder");
  expect_refused(geometry::Cylinder{1, 2, 2}, "height of a cylinder");
  expect_refused(geometry::Cylinder{kInfinity, 0, 2}, "radius of a cylinder is not finite");
  expect_refused(geometry::Capsule{Vec3::Zero(), Vec3::UnitX(), kNan}, "radius of a capsule");
  expect_refused(geometry::Capsule{Vec3::Zero(), Vec3(kInfinity, 0, 0), 1}, "end of a capsule");
}

TEST(Prepare, RefusesBadMeshesAndNamesThem) {
  expect_refused(geometry::Mesh{"gone.stl", nullptr}, "gone.stl");
  expect_refused(mesh({Vec3::Zero()}, {}), "no triangle");
  expect_refused(mesh({Vec3::Zero(), Vec3::UnitX(), Vec3(0, kNan, 0)}, {{0, 1, 2}}), "not finite");
  expect_refused(mesh({Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()}, {{0, 1, 3}}), "vertex 3");
  expect_refused(mesh({Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()}, {{0, -1, 2}}), "vertex -1");
  expect_refused(mesh({Vec3::Zero(), Vec3::UnitX(), 2 * Vec3::UnitX()}, {{0, 1, 2}}),
                 "without area");
}

TEST(Prepare, RefusesPlacesThatAreNotRigid) {
  Pose scaled = Pose::Identity();
  scaled.linear() *= 2;
  Pose mirrored = Pose::Identity();
  mirrored.linear()(0, 0) = -1;
  Pose nowhere = Pose::Identity();
  nowhere.translation().x() = kNan;
  for (const Pose& X : {scaled, mirrored, nowhere}) {
    EXPECT_THROW(prepare({Shape{geometry::Sphere{Vec3::Zero(), 1}, X}}), std::invalid_argument);
    CollisionWorld world;
    EXPECT_THROW(world.insert(box(Vec3::Constant(1)), X), std::invalid_argument);
  }
}

TEST(Prepare, TwoCornersOfABoxMayBeAnyTwo) {
  const BodyPtr body = prepare({box_shape(Vec3(1, -1, 2), Vec3(-1, 1, 0))});
  EXPECT_TRUE(overlaps(*body, at(0, 0, 0), *box(Vec3::Constant(0.1)), at(0, 0, 1.95), 1e-6));
  EXPECT_FALSE(overlaps(*body, at(0, 0, 0), *box(Vec3::Constant(0.1)), at(0, 0, 2.1), 1e-6));
}

TEST(Prepare, ShapesStandAtTheirPlace) {
  const Shape beam{geometry::Box{Vec3(0, -0.1, -0.1), Vec3(3, 0.1, 0.1)},
                   at(1, 0, 0) * math::rotation_z_deg(90)};
  const BodyPtr body = prepare({beam});
  const BodyPtr ball = prepare({{geometry::Sphere{Vec3::Zero(), 0.1}, Pose::Identity()}});
  EXPECT_TRUE(overlaps(*body, at(0, 0, 0), *ball, at(1, 2.9, 0), 1e-6));
  EXPECT_FALSE(overlaps(*body, at(0, 0, 0), *ball, at(2.9, 0, 0), 1e-6));
}

}  // namespace
}  // namespace rubicon::collision::test
