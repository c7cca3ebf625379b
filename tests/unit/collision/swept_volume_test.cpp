#include "src/motion/collision/query/swept_volume.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/unit/collision/meshes.hpp"
#include "tests/unit/collision/random_scene.hpp"
#include "tests/unit/collision/two_joint_motion.hpp"

namespace rubicon::collision::test {
namespace {

const Vec3 kUp = Vec3::UnitZ();

bool meets(const SweptVolume& volume, const BodyPtr& body, const Motion& motion,
           double tolerance = kTolerance) {
  SweptQuery query;
  query.contact_tolerance = tolerance;
  query.items = {item(*body, motion)};
  MovingBodies bodies(query);
  return volume.meets(bodies, 0);
}

bool meets_at(const SweptVolume& volume, const BodyPtr& body, const Pose& X,
              double tolerance = kTolerance) {
  return meets(volume, body, geometry::stationary(X), tolerance);
}

/// A jib of 52 m, its inner end on the axis, that slews by 5 degrees.
SweptVolume slewing_jib(const Vec3& place = Vec3::Zero()) {
  const BodyPtr jib = prepare({box_shape({0, -0.8, 44}, {52, 0.8, 46})});
  return {jib, turning(at(place.x(), place.y(), place.z()), kUp, place, 5), kGrowth};
}

TEST(SweptVolume, OfABodyThatStandsIsTheBody) {
  const SweptVolume volume(box(Vec3::Ones()), geometry::stationary(at(3, 0, 0)), kGrowth);
  EXPECT_TRUE(meets_at(volume, box(Vec3::Ones()), at(4.99, 0, 0)));
  EXPECT_FALSE(meets_at(volume, box(Vec3::Ones()), at(5, 0, 0)));
  EXPECT_EQ(volume.bounds().lower, Vec3(2, -1, -1));
}

TEST(SweptVolume, OfATranslationIsExact) {
  const BodyPtr half = box(Vec3::Constant(0.5));
  const Vec3 way(0, 3, 4);
  const SweptVolume volume(half, geometry::translating(at(0, 0, 0), way), kGrowth);
  // Beside the way, in the middle of it and far from both ends.
  EXPECT_TRUE(meets_at(volume, half, at(0.99, 1.5, 2), 0));
  EXPECT_FALSE(meets_at(volume, half, at(1, 1.5, 2), 0));
  // The way's lower side runs through (0.5, -0.5) in y and z; a corner just below it is free.
  const Vec3 corner = Vec3(0, 0.5 + 1.5, -0.5 + 2) - 1e-6 * Vec3(0, 4, -3);
  const Pose X = at(0, corner.y() + 0.5, corner.z() - 0.5);
  EXPECT_TRUE(meets_at(volume, half, X, 0));
  EXPECT_FALSE(meets_at(volume, half, at(0, 1e-5, -1e-5) * X, 0));
}

TEST(SweptVolume, AlongABoxIsABox) {
  const SweptVolume volume(box(Vec3::Ones()), geometry::translating(at(0, 0, 0), {0, 0, 8}),
                           kGrowth);
  const BodyPtr plate = box(Vec3(0.5, 0.5, 0.5));
  EXPECT_FALSE(meets(volume, plate, turning(at(1.5, 0, 4), Vec3::UnitX(), {1.5, 0, 4}, 90)));
  EXPECT_TRUE(meets(volume, plate, turning(at(1.5, 0, 4), Vec3::UnitY(), {1.5, 0, 4}, 90)));
}

TEST(SweptVolume, HoldsTheMiddleOfASlew) {
  const SweptVolume jib = slewing_jib();
  const BodyPtr hook = box(Vec3::Constant(0.1));
  EXPECT_TRUE(meets_at(jib, hook, at(49, 2, 45)));
  EXPECT_FALSE(meets_at(jib, hook, at(49, 2, 46.1)));
  EXPECT_TRUE(meets(jib, hook, geometry::translating(at(49, 2, 40), {0, 0, 20})));
  // Just outside of what the tip reaches, and just within: the tip's corners are 52.00615 m out.
  const double tip = std::sqrt(52 * 52 + 0.8 * 0.8);
  const Pose out = math::rotation_z_deg(2.5);
  const double near = tip * math::cos_deg(2.5) + 0.8 * math::sin_deg(2.5);
  EXPECT_FALSE(meets_at(jib, hook, out * at(tip + 0.1, 0, 45)));
  EXPECT_TRUE(meets_at(jib, hook, out * at(near - 0.5, 0, 45)));
}

TEST(SweptVolume, IsCloseWhereTheHullOfBothEndsIsNot) {
  // A rod that turns about its middle leaves the notch between its ends free, deep down to it.
  const BodyPtr rod = box(Vec3(2, 0.05, 0.05));
  const SweptVolume volume(rod, turning(at(0, 0, 0), kUp, Vec3::Zero(), 60), kGrowth);
  const Pose across = math::rotation_z_deg(120);
  EXPECT_FALSE(meets_at(volume, box(Vec3(0.02, 0.02, 0.02)), across * at(0.15, 0, 0)));
  EXPECT_TRUE(meets_at(volume, box(Vec3(0.02, 0.02, 0.02)), across * at(0.06, 0, 0)));
  const Pose along = math::rotation_z_deg(30);
  EXPECT_TRUE(meets_at(volume, box(Vec3(0.02, 0.02, 0.02)), along * at(1.9, 0, 0)));
}

TEST(SweptVolume, TouchingIsFree) {
  const SweptVolume jib = slewing_jib();
  const BodyPtr slab = box(Vec3(30, 30, 1));
  EXPECT_FALSE(meets_at(jib, slab, at(20, 0, 47)));
  EXPECT_TRUE(meets_at(jib, slab, at(20, 0, 47 - 1.1e-3)));
  EXPECT_FALSE(meets(jib, slab, geometry::translating(at(20, 0, 47), {5, 5, 0})));
  // Several joints at once: bounds that know nothing of the axis.
  TwoJointMotion crane;
  crane.theta1 = 4;
  crane.place0 = Vec3(10, 0, 0);
  crane.place1 = Vec3(11, 0, 0);
  const SweptVolume load(box(Vec3(1, 0.2, 1)), crane.motion(), kGrowth);
  EXPECT_FALSE(meets_at(load, slab, at(20, 0, 2)));
  EXPECT_TRUE(meets_at(load, slab, at(20, 0, 2 - 1.3e-3)));
}

TEST(SweptVolume, JudgesThinThingsAsTheyAre) {
  // A sheet of 2 mm may only be 0.5 mm deep; the way makes it no thicker.
  const BodyPtr sheet = box(Vec3(1, 1, 1e-3));
  const SweptVolume volume(sheet, geometry::translating(at(0, 0, 0), {0, 0, 1}), kGrowth);
  const BodyPtr block = box(Vec3::Constant(0.5));
  EXPECT_TRUE(meets_at(volume, block, at(0, 0, 1.501 - 0.6e-3)));
  EXPECT_FALSE(meets_at(volume, block, at(0, 0, 1.501 - 0.4e-3)));
}

TEST(SweptVolume, OfAClosedMeshHoldsWhatIsInside) {
  const BodyPtr l = mesh_body(l_mesh(1));
  const Motion motion = geometry::translating(at(0, 0, 0), {10, 0, 0});
  const SweptVolume volume(l, motion, kGrowth);
  const BodyPtr small = box(Vec3::Constant(0.05));
  EXPECT_TRUE(meets_at(volume, small, at(1, 0.25, 0.5)));
  EXPECT_TRUE(meets_at(volume, small, at(6, 0.25, 0.5)));
  EXPECT_TRUE(meets_at(volume, small, at(11.5, 0.25, 0.5)));
  EXPECT_FALSE(meets_at(volume, small, at(1, 2.5, 0.5)));
  EXPECT_FALSE(meets_at(volume, small, at(12.1, 0.25, 0.5)));
  // And the other way round: a box that moves about inside a mesh that passes it.
  const SweptVolume moved(small, geometry::translating(at(1, 0.25, 0.5), {0.2, 0, 0}), kGrowth);
  EXPECT_TRUE(meets_at(moved, l, at(0, 0, 0)));
  EXPECT_FALSE(meets_at(moved, l, at(0, 1, 0)));
}

TEST(SweptVolume, FarFromTheOriginIsTheSame) {
  const Vec3 place(400000, -250000, 100);
  const SweptVolume jib = slewing_jib(place);
  const Pose X = at(place.x(), place.y(), place.z());
  const BodyPtr hook = box(Vec3::Constant(0.1));
  EXPECT_TRUE(meets_at(jib, hook, X * at(49, 2, 45)));
  EXPECT_FALSE(meets_at(jib, box(Vec3(30, 30, 1)), X * at(20, 0, 47)));
  EXPECT_TRUE(meets_at(jib, box(Vec3(30, 30, 1)), X * at(20, 0, 47 - 1.1e-3)));
}

/// A motion of which nothing is known.
class Unbounded : public TwoJointMotion {
 public:
  double chord_deviation(double, double, double) const override {
    return std::numeric_limits<double>::quiet_NaN();
  }
};

TEST(SweptVolume, OfAMotionWithoutBoundIsEverywhere) {
  const BodyPtr body = box(Vec3::Ones());
  const SweptVolume volume(body, {std::make_shared<Unbounded>()}, kGrowth);
  EXPECT_TRUE(meets_at(volume, body, at(1000, 0, 0)));
}

TEST(SweptVolume, RefusesMotionsThatAreNotValid) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const BodyPtr body = box(Vec3::Ones());
  EXPECT_THROW(SweptVolume(body, geometry::translating(at(0, 0, 0), {nan, 0, 0}), kGrowth),
               std::invalid_argument);
  SweptQuery query;
  query.items = {item(*body, turning(at(0, 0, 0), {2, 0, 0}, Vec3::Zero(), 10))};
  EXPECT_THROW(MovingBodies{query}, std::invalid_argument);
}

}  // namespace
}  // namespace rubicon::collision::test
