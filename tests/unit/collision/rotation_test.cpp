#include <gtest/gtest.h>

#include "tests/support/random_cases.hpp"
#include "tests/unit/collision/box_oracle.hpp"
#include "tests/unit/collision/random_scene.hpp"

namespace rubicon::collision::test {
namespace {

void check(const Vec3& half, const Motion& motion, const OracleBox& b, double tolerance,
           Count& count) {
  const auto& screw = std::get<geometry::ScrewMotion>(motion.kind);
  const double radius = screw.axis.cross(screw.X0.translation() - screw.point).norm() + half.norm();
  const double speed = math::radians(std::fabs(screw.angle_deg)) * radius + screw.slide.norm();
  const auto depth = [&](double s) { return box_depth({motion.pose(s), half}, b); };
  const Truth truth = classify(depth, speed, tolerance, kBand);
  if (truth == Truth::kNearBoundary) return;
  const bool expected = truth == Truth::kHit;
  ++(expected ? count.hit : count.free);
  ASSERT_EQ(blocked(*box(half), motion, box(b.half), b.X_WC, tolerance), expected);
}

TEST(Rotation, GenericScrews) {
  Random random(11);
  Count count;
  for (int i = 0; i < rubicon::test::cases(2500); ++i) {
    const Vec3 half(random.between(0.05, 1), random.between(0.05, 1), random.between(0.05, 1));
    const OracleBox b{random.pose(0.8), Vec3(random.between(0.05, 1), random.between(0.05, 1),
                                             random.between(0.05, 1))};
    const Motion motion = turning(random.pose(0.8), random.direction(), random.vector(2),
                                  random.between(-90, 90), random.between(-0.5, 0.5));
    check(half, motion, b, i % 2 ? 1e-6 : 1e-3, count);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(count.free, rubicon::test::at_least(300));
  EXPECT_GT(count.hit, rubicon::test::at_least(300));
}

TEST(Rotation, SlewingWithThirtyMetresOfJibThroughThinWalls) {
  Random random(12);
  Count count;
  for (int i = 0; i < rubicon::test::cases(3000); ++i) {
    const Vec3 half(random.between(0.1, 2), random.between(0.05, 0.2), random.between(0.1, 1.5));
    const double radius = random.between(5, 30);
    const Pose X0 = math::rotation_z_deg(random.between(0, 360)) * at(radius, 0, 0) *
                    math::rotation_z_deg(random.below(4) * random.between(0, 90));
    const double step = random.below(2) ? 5 : -5;
    const Motion motion = turning(X0, Vec3::UnitZ(), Vec3::Zero(), step);
    const double where = random.between(-0.3, 1.3);
    OracleBox wall;
    wall.X_WC = motion.pose(where);
    wall.X_WC.linear() = wall.X_WC.linear() * random.rotation();
    wall.X_WC.translation() += random.vector(1.0);
    wall.half = Vec3(random.between(0.2, 3), random.between(0.01, 0.075), random.between(0.2, 3));
    check(half, motion, wall, 1e-3, count);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(count.free, rubicon::test::at_least(300));
  EXPECT_GT(count.hit, rubicon::test::at_least(300));
}

TEST(Rotation, TheSagittaOfAnArcCounts) {
  // Between start and end the corner swings out by 30 m * (1 - cos 2.5 deg) = 28.6 mm; the wall
  // stands 20 mm away.
  const BodyPtr load = box(Vec3(0.1, 0.1, 0.1));
  const Pose X0 = math::rotation_z_deg(-2.5) * at(30, 0, 0);
  const double outermost = 30 * math::cos_deg(2.5) + 0.1;
  const BodyPtr wall = box(Vec3(0.1, 0.02, 1));
  const Motion slew = turning(X0, Vec3::UnitZ(), Vec3::Zero(), 5);
  EXPECT_TRUE(blocked(*load, slew, wall, at(outermost + 0.1 + 0.02, 0, 0), 1e-3));
  const double swept_radius = std::sqrt(30.1 * 30.1 + 0.1 * 0.1);
  EXPECT_FALSE(blocked(*load, slew, wall, at(swept_radius + 0.1 + 1e-5, 0, 0), 1e-6));
  EXPECT_TRUE(blocked(*load, slew, wall, at(swept_radius + 0.1 - 1e-4, 0, 0), 1e-6));
}

TEST(Rotation, StandingOnASlabWhileTurningIsFree) {
  Random random(13);
  for (int i = 0; i < rubicon::test::cases(1000); ++i) {
    const Vec3 far = i % 2 ? Vec3(1e5, -1e5, 0) : Vec3(0, 0, 0);
    const Vec3 half(random.between(0.1, 3), random.between(0.05, 0.2), random.between(0.1, 1.5));
    const BodyPtr slab = box(Vec3(20, 20, 0.1));
    const Vec3 place = far + Vec3(random.between(-3, 3), random.between(-3, 3), 0.1 + half.z());
    Pose X0 = math::rotation_z_deg(random.between(0, 360));
    X0.translation() = place;
    const Vec3 pivot = far + random.vector(30);
    const Motion turn = turning(X0, Vec3::UnitZ(), pivot, random.between(-5, 5));
    EXPECT_FALSE(blocked(*box(half), turn, slab, Pose(Eigen::Translation3d(far)), 1e-6))
        << "case " << i;
    const Motion lowered = turning(X0, Vec3::UnitZ(), pivot, random.between(1, 5), -1e-4);
    if (pivot.x() == far.x()) continue;
    EXPECT_TRUE(blocked(*box(half), lowered, slab, Pose(Eigen::Translation3d(far)), 1e-6))
        << "case " << i;
  }
}

TEST(Rotation, TurningAwayFromANeighbourIsFreeTurningIntoItIsNot) {
  // Two panels side by side; the first turns about its own far corner.
  const BodyPtr panel = box(Vec3(1, 0.1, 1.5));
  const Pose neighbour = at(0, 0.2, 0);
  EXPECT_FALSE(blocked(*panel, turning(at(0, 0, 0), Vec3::UnitZ(), Vec3(-1, 0.1, 0), -5), panel,
                       neighbour, 1e-6));
  EXPECT_TRUE(blocked(*panel, turning(at(0, 0, 0), Vec3::UnitZ(), Vec3(-1, 0.1, 0), 5), panel,
                      neighbour, 1e-6));
}

TEST(Rotation, AFaceRollingOverAnEdgeStaysFree) {
  // The block turns about a line in its lower face, where a wedge carries it: the separating
  // direction turns with the block.
  const BodyPtr block = prepare({box_shape(Vec3(-1, 0, -0.5), Vec3(1, 1, 0.5))});
  const BodyPtr wedge =
      prepare({{geometry::Prism{-1, 1, {{0, 0}, {-0.5, -1}, {0.5, -1}}}, Pose::Identity()}});
  const Motion roll = turning(math::rotation_z_deg(-10), Vec3::UnitZ(), Vec3::Zero(), 20);
  EXPECT_FALSE(blocked(*block, roll, wedge, at(0, 0, 0), 1e-6));
  EXPECT_TRUE(blocked(*block, roll, wedge, at(0, 1e-5, 0), 1e-6));
  EXPECT_FALSE(blocked(*wedge, roll, block, at(0, 0, 0), 1e-6));
  EXPECT_TRUE(blocked(*wedge, roll, block, at(0, -1e-5, 0), 1e-6));
}

TEST(Rotation, TheRimOfADiscCounts) {
  // A thin disc turned about its diameter; only well inside the step does its rim reach the post.
  const BodyPtr disc = prepare({{geometry::Cylinder{1, -0.01, 0.01}, Pose::Identity()}});
  const Motion turn = turning(math::rotation_x_deg(-40), Vec3::UnitX(), Vec3::Zero(), 60);
  const BodyPtr post = box(Vec3(0.02, 0.02, 0.02));
  EXPECT_TRUE(blocked(*disc, turn, post, at(0, 1.01, 0), 1e-3));
  EXPECT_FALSE(blocked(*disc, turn, post, at(0, 1.021, 0), 1e-3));
}

TEST(Rotation, WholeTurnsAndMore) {
  const BodyPtr arm = prepare({box_shape(Vec3(0, -0.1, 0), Vec3(5, 0.1, 0.2))});
  const BodyPtr post = box(Vec3(0.05, 0.05, 1));
  for (const double angle : {200.0, 360.0, 720.0, -540.0}) {
    const Motion turn = turning(at(0, 0, 0), Vec3::UnitZ(), Vec3::Zero(), angle);
    EXPECT_TRUE(blocked(*arm, turn, post, at(-4, 0, 0), 1e-3)) << angle;
    EXPECT_FALSE(blocked(*arm, turn, post, at(-5.2, 0, 0), 1e-3)) << angle;
  }
}

TEST(Rotation, ACylinderTurningInItselfStaysFree) {
  const BodyPtr mast = prepare({{geometry::Cylinder{0.5, 0, 10}, Pose::Identity()}});
  const BodyPtr wall = box(Vec3(1, 1, 5));
  const Motion turn = turning(at(0, 0, 0), Vec3::UnitZ(), Vec3::Zero(), 90);
  EXPECT_FALSE(blocked(*mast, turn, wall, at(1.5, 0, 5), 1e-6));
  EXPECT_TRUE(blocked(*mast, turn, wall, at(1.5 - 1e-5, 0, 5), 1e-6));
}

}  // namespace
}  // namespace rubicon::collision::test
