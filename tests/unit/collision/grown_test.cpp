#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "tests/support/random_cases.hpp"
#include "tests/unit/collision/bodies.hpp"
#include "tests/unit/collision/exact_distance.hpp"
#include "tests/unit/collision/meshes.hpp"

namespace rubicon::collision::test {
namespace {

constexpr double kTolerance = 1e-3;

/// One shape of each kind, of about a metre.
std::vector<geometry::Shape> shapes_of_all_kinds() {
  const auto mesh = std::make_shared<const geometry::TriangleMesh>(l_mesh());
  return {
      {geometry::Box{Vec3(-0.3, -0.2, -0.4), Vec3(0.3, 0.2, 0.4)}, Pose::Identity()},
      {geometry::Cylinder{0.3, -0.5, 0.4}, Pose::Identity()},
      {geometry::Sphere{Vec3(0.1, 0, 0), 0.4}, Pose::Identity()},
      {geometry::Capsule{Vec3(0, 0, -0.4), Vec3(0.2, 0, 0.4), 0.2}, Pose::Identity()},
      {geometry::Prism{0, 0.5, {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {0, -0.1}, {-0.5, 0.5}}},
       Pose::Identity()},
      {geometry::Mesh{"l.stl", mesh}, Pose::Identity()},
  };
}

TEST(GrownBodies, OfBoxesAreMetByWhatIsNearer) {
  Random random(711);
  const double by = 0.4;
  std::array<int, 2> counts = {};
  for (int i = 0; i < rubicon::test::cases(4000); ++i) {
    const Vec3 half = Vec3(0.4, 0.4, 0.4) + random.vector(0.35);
    const OracleBox a{random.pose(0.3), half};
    const OracleBox b{random.pose(1.5), Vec3(0.4, 0.4, 0.4) + random.vector(0.35)};
    const BodyPtr grown = prepare({{geometry::Box{-half, half}, Pose::Identity()}}, by);
    const bool met = overlaps(*grown, a.X_WC, *box(b.half), b.X_WC, kTolerance);
    const double distance = box_distance(a, b);
    ++counts[met ? 1 : 0];
    if (distance < by - kTolerance - 1e-9) {
      EXPECT_TRUE(met) << "case " << i << ": " << distance;
    }
    if (distance > by - kTolerance + 1e-6) {
      EXPECT_FALSE(met) << "case " << i << ": " << distance;
    }
  }
  EXPECT_GT(counts[0], rubicon::test::at_least(1000));
  EXPECT_GT(counts[1], rubicon::test::at_least(1000));
}

TEST(GrownBodies, OfEveryShapeAreMetInAStepThatComesNearer) {
  Random random(712);
  const std::vector<geometry::Shape> shapes = shapes_of_all_kinds();
  std::array<int, 2> counts = {};
  for (int i = 0; i < rubicon::test::cases(1200); ++i) {
    const geometry::Shape& shape = shapes[static_cast<std::size_t>(i) % shapes.size()];
    const double by = random.between(0.05, 0.6);
    const BodyPtr plain = prepare({shape});
    const BodyPtr grown = prepare({shape}, by);
    CollisionWorld world;
    world.insert(random_body(random), random.pose(2));
    const Motion motion = random_motion(random);
    const auto asked = [&](const BodyPtr& body) {
      SweptQuery query;
      query.contact_tolerance = kTolerance;
      query.items = {item(*body, motion)};
      return query;
    };
    const Clearance clearance = world.clearance(asked(plain), 2 * by, 1e-4);
    const bool met = world.test(asked(grown)).hit || world.test(asked(plain)).hit;
    SCOPED_TRACE("case " + std::to_string(i));
    ++counts[met ? 1 : 0];
    if (clearance.upper_bound < by - 2 * kTolerance) {
      EXPECT_TRUE(met) << clearance.upper_bound;
    }
    if (clearance.lower_bound > by) {
      EXPECT_FALSE(met) << clearance.lower_bound;
    }
  }
  EXPECT_GT(counts[0], rubicon::test::at_least(200));
  EXPECT_GT(counts[1], rubicon::test::at_least(200));
}

TEST(GrownBodies, KeepWhatTheyAreWithoutABuffer) {
  const BodyPtr body =
      prepare({{geometry::Box{Vec3(0, 0, 0), Vec3(1, 1, 1)}, Pose::Identity()}}, 0);
  EXPECT_FALSE(overlaps(*body, Pose::Identity(), *body, math::translation(1.1, 0, 0), kTolerance));
  EXPECT_TRUE(overlaps(*body, Pose::Identity(), *body, math::translation(0.9, 0, 0), kTolerance));
}

}  // namespace
}  // namespace rubicon::collision::test
