#include <gtest/gtest.h>

#include "tests/unit/collision/meshes.hpp"
#include "tests/unit/collision/random_scene.hpp"

namespace rubicon::collision::test {
namespace {

BodyPtr random_body(Random& random) {
  const double r = random.between(0.1, 0.5);
  const double length = random.between(0.2, 0.8);
  switch (random.below(6)) {
    case 0:
      return box(Vec3(r, length, random.between(0.05, 0.6)));
    case 1:
      return prepare({{geometry::Sphere{Vec3::Zero(), r}, Pose::Identity()}});
    case 2:
      return prepare({{geometry::Cylinder{r, -length, length}, Pose::Identity()}});
    case 3:
      return prepare(
          {{geometry::Capsule{Vec3(0, 0, -length), Vec3(0, 0, length), r}, Pose::Identity()}});
    case 4:
      return prepare(
          {{geometry::Prism{0, length, {{0, 0}, {1, 0}, {1, 0.3}, {0.3, 0.3}, {0.3, 1}, {0, 1}}},
            Pose::Identity()}});
    default:
      return mesh_body(l_mesh(1));
  }
}

Motion random_motion(Random& random) {
  const Pose X = random.pose(1.2);
  return random.below(2) ? geometry::translating(X, random.vector(0.6))
                         : turning(X, random.direction(), random.vector(2), random.between(-30, 30),
                                   random.between(-0.2, 0.2));
}

/// The part [s0, s1] of a screw as a motion of its own.
Motion part_of(const Motion& motion, double s0, double s1) {
  geometry::ScrewMotion screw = std::get<geometry::ScrewMotion>(motion.kind);
  screw.X0 = motion.pose(s0);
  screw.angle_deg *= s1 - s0;
  screw.slide *= s1 - s0;
  return Motion{screw};
}

/// The whole scene moved by X.
Motion moved(const Pose& X, const Motion& motion) {
  geometry::ScrewMotion screw = std::get<geometry::ScrewMotion>(motion.kind);
  screw.X0 = X * screw.X0;
  screw.axis = X.linear() * screw.axis;
  screw.point = X * screw.point;
  screw.slide = X.linear() * screw.slide;
  return Motion{screw};
}

TEST(Property, AFreeStepIsFreeInEachHalfAndAtEachPose) {
  Random random(81);
  int free = 0;
  for (int i = 0; i < 3000; ++i) {
    const BodyPtr a = random_body(random);
    const BodyPtr b = random_body(random);
    const Motion motion = random_motion(random);
    const Pose X = random.pose(1);
    if (blocked(*a, motion, b, X, 1e-3)) continue;
    ++free;
    // A whisker more, for the rounding of the other poses.
    EXPECT_FALSE(blocked(*a, part_of(motion, 0, 0.5), b, X, 1e-3 + 1e-8)) << "case " << i;
    EXPECT_FALSE(blocked(*a, part_of(motion, 0.5, 1), b, X, 1e-3 + 1e-8)) << "case " << i;
    for (const double s : {0.0, 0.3, 0.77, 1.0}) {
      EXPECT_FALSE(overlaps(*a, motion.pose(s), *b, X, 1e-3 + 1e-8)) << "case " << i << " at " << s;
    }
  }
  EXPECT_GT(free, 500);
}

TEST(Property, MovingTheWholeSceneChangesNothing) {
  Random random(82);
  int decided = 0;
  for (int i = 0; i < 2000; ++i) {
    const BodyPtr a = random_body(random);
    const BodyPtr b = random_body(random);
    const Motion motion = random_motion(random);
    const Pose X = random.pose(1);
    const bool answer = blocked(*a, motion, b, X, 1e-3);
    // Away from the boundary: a slightly different tolerance gives the same answer.
    if (answer != blocked(*a, motion, b, X, 1.1e-3) || answer != blocked(*a, motion, b, X, 0.9e-3))
      continue;
    ++decided;
    const Pose elsewhere = random.pose(1000);
    EXPECT_EQ(blocked(*a, moved(elsewhere, motion), b, elsewhere * X, 1e-3), answer)
        << "case " << i;
  }
  EXPECT_GT(decided, 1800);
}

TEST(Property, TheMirroredSceneGivesTheSameAnswer) {
  // Bodies that are their own mirror image; mirrored in the plane x = 0.
  Random random(83);
  const Mat3 mirror = Vec3(-1, 1, 1).asDiagonal();
  const auto mirrored = [&](const Pose& X) {
    Pose result = Pose::Identity();
    result.linear() = mirror * X.linear() * mirror;
    result.translation() = mirror * X.translation();
    return result;
  };
  for (int i = 0; i < 2000; ++i) {
    const BodyPtr a =
        box(Vec3(random.between(0.1, 0.6), random.between(0.1, 0.6), random.between(0.1, 0.6)));
    const BodyPtr b =
        prepare({{geometry::Cylinder{random.between(0.1, 0.5), -0.5, 0.5}, Pose::Identity()}});
    const Motion motion = random_motion(random);
    const Pose X = random.pose(1);
    const bool answer = blocked(*a, motion, b, X, 1e-3);
    if (answer != blocked(*a, motion, b, X, 1.1e-3) || answer != blocked(*a, motion, b, X, 0.9e-3))
      continue;
    geometry::ScrewMotion screw = std::get<geometry::ScrewMotion>(motion.kind);
    screw.X0 = mirrored(screw.X0);
    screw.axis = mirror * screw.axis;
    screw.point = mirror * screw.point;
    screw.slide = mirror * screw.slide;
    screw.angle_deg = -screw.angle_deg;
    EXPECT_EQ(blocked(*a, Motion{screw}, b, mirrored(X), 1e-3), answer) << "case " << i;
  }
}

TEST(Property, TheSameQuestionTwiceGivesTheSameAnswerAndRolesMayBeSwapped) {
  Random random(84);
  for (int i = 0; i < 2000; ++i) {
    const BodyPtr a = random_body(random);
    const BodyPtr b = random_body(random);
    const Pose X_WA = random.pose(1);
    const Pose X_WB = random.pose(1);
    const bool answer = overlaps(*a, X_WA, *b, X_WB, 1e-3);
    EXPECT_EQ(overlaps(*a, X_WA, *b, X_WB, 1e-3), answer);
    if (answer != overlaps(*a, X_WA, *b, X_WB, 1.1e-3) ||
        answer != overlaps(*a, X_WA, *b, X_WB, 0.9e-3))
      continue;
    EXPECT_EQ(overlaps(*b, X_WB, *a, X_WA, 1e-3), answer) << "case " << i;
  }
}

}  // namespace
}  // namespace rubicon::collision::test
