#include <gtest/gtest.h>

#include "tests/support/random_cases.hpp"
#include "tests/unit/collision/bodies.hpp"

namespace rubicon::collision::test {
namespace {

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
  for (int i = 0; i < rubicon::test::cases(3000); ++i) {
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
  EXPECT_GT(free, rubicon::test::at_least(500));
}

TEST(Property, AScrewThatIsHitIsHitInOneOfItsParts) {
  // At a tolerance a little smaller, since each part is judged anew: undecided near the tolerance
  // is called a hit within 0.01 mm of it.
  Random random(85);
  int hits = 0;
  for (int i = 0; i < rubicon::test::cases(3000); ++i) {
    const BodyPtr a = random_body(random);
    const BodyPtr b = random_body(random);
    const Motion motion = turning(random.pose(1.2), random.direction(), random.vector(2),
                                  random.between(-30, 30), random.between(-0.2, 0.2));
    const Pose X = random.pose(1);
    if (!blocked(*a, motion, b, X, 1e-3 + 3e-5)) continue;
    ++hits;
    const double cut = random.unit();
    EXPECT_TRUE(blocked(*a, part_of(motion, 0, cut), b, X, 1e-3) ||
                blocked(*a, part_of(motion, cut, 1), b, X, 1e-3))
        << "case " << i << " cut at " << cut;
  }
  EXPECT_GT(hits, rubicon::test::at_least(500));
}

TEST(Property, APoseThatIsTooDeepBlocksThePartThatHoldsIt) {
  Random random(86);
  int deep = 0;
  for (int i = 0; i < rubicon::test::cases(3000); ++i) {
    const BodyPtr a = random_body(random);
    const BodyPtr b = random_body(random);
    const Motion motion = random_motion(random);
    const Pose X = random.pose(1);
    const double cut = random.unit();
    for (const double s : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      if (!overlaps(*a, motion.pose(s), *b, X, 1e-3 + 1e-8)) continue;
      ++deep;
      EXPECT_TRUE(blocked(*a, motion, b, X, 1e-3)) << "case " << i << " at " << s;
      const Motion part = s <= cut ? part_of(motion, 0, cut) : part_of(motion, cut, 1);
      EXPECT_TRUE(blocked(*a, part, b, X, 1e-3)) << "case " << i << " at " << s << " of " << cut;
    }
  }
  EXPECT_GT(deep, rubicon::test::at_least(2000));
}

TEST(Property, MovingTheWholeSceneChangesNothing) {
  Random random(82);
  int decided = 0;
  for (int i = 0; i < rubicon::test::cases(2000); ++i) {
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
  EXPECT_GT(decided, rubicon::test::at_least(1800));
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
  for (int i = 0; i < rubicon::test::cases(2000); ++i) {
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
  for (int i = 0; i < rubicon::test::cases(2000); ++i) {
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
