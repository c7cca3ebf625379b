#include "src/motion/geometry/motion.hpp"

#include <gtest/gtest.h>

namespace rubicon::geometry {
namespace {

TEST(Motion, StationaryDoesNotMove) {
  const Pose X = math::translation(1, 2, 3) * math::rotation_z_deg(20);
  const Motion motion = stationary(X);
  EXPECT_FALSE(motion.moves());
  EXPECT_TRUE(motion.pose(0.7).isApprox(X, 0));
}

TEST(Motion, TranslationHasAnyDirectionAndKeepsTheOrientation) {
  const Pose X = math::translation(1, 2, 3) * math::rotation_z_deg(20);
  const Motion motion = translating(X, Vec3(4, -2, 8));
  EXPECT_TRUE(motion.moves());
  EXPECT_EQ(Vec3(motion.pose(0.5).translation()), Vec3(3, 1, 7));
  EXPECT_EQ(motion.pose(1).linear(), X.linear());
}

TEST(Motion, ScrewTurnsAboutItsLineAndSlidesAlongIt) {
  ScrewMotion screw;
  screw.X0 = math::translation(3, 0, 0);
  screw.axis = Vec3::UnitZ();
  screw.point = Vec3(2, 0, 5);
  screw.angle_deg = 180;
  screw.slide = Vec3(0, 0, 4);
  const Motion motion{screw};
  EXPECT_TRUE(motion.moves());
  EXPECT_EQ(Vec3(motion.pose(0.5).translation()), Vec3(2, 1, 2));
  EXPECT_EQ(motion.pose(0.5).linear(), math::rotation_z_deg(90).linear());
  EXPECT_EQ(Vec3(motion.pose(1).translation()), Vec3(1, 0, 4));
}

TEST(Motion, AGeneralMotionThatIsMissingStandsStill) {
  const Motion motion{std::shared_ptr<const GeneralMotion>()};
  EXPECT_FALSE(motion.moves());
}

}  // namespace
}  // namespace rubicon::geometry
