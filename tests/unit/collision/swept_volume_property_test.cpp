#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "src/motion/collision/query/swept_volume.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/collision/bodies.hpp"
#include "tests/unit/collision/meshes.hpp"
#include "tests/unit/collision/random_scene.hpp"
#include "tests/unit/collision/two_joint_motion.hpp"

namespace rubicon::collision::test {
namespace {

/// A body with points inside it, found without the engine.
struct Solid {
  BodyPtr body;
  std::function<Vec3(Random&)> point;
};

/// Often one of the ends: where a volume is too small is seen at the surface.
double between_or_end(Random& random, double low, double high) {
  const int where = random.below(4);
  return where == 0 ? low : where == 1 ? high : random.between(low, high);
}

Vec3 point_in_box(Random& random, const Vec3& lower, const Vec3& upper) {
  const double x = between_or_end(random, lower.x(), upper.x());
  const double y = between_or_end(random, lower.y(), upper.y());
  const double z = between_or_end(random, lower.z(), upper.z());
  return {x, y, z};
}

Vec3 point_in_cylinder(Random& random, double r, double length) {
  const double distance = between_or_end(random, 0, r);
  const double angle = random.between(-180, 180);
  const double z = between_or_end(random, -length, length);
  return {distance * math::cos_deg(angle), distance * math::sin_deg(angle), z};
}

Solid random_solid(Random& random) {
  const double r = random.between(0.05, 0.6);
  const double length = random.between(0.2, 0.8);
  const auto in_l = [](double legs, double thickness, double height) {
    return [=](Random& some) {
      const Vec3 p = point_in_box(some, {0, 0, 0}, {legs, thickness, height});
      return some.below(2) ? p : Vec3(p.y(), p.x(), p.z());
    };
  };
  const Pose identity = Pose::Identity();
  switch (random.below(7)) {
    case 0: {
      const Vec3 half(r, length, random.between(0.01, 0.6));
      return {box(half), [half](Random& some) { return point_in_box(some, -half, half); }};
    }
    case 1:
      return {prepare({{geometry::Sphere{Vec3::Zero(), r}, identity}}),
              [r](Random& some) { return Vec3(between_or_end(some, 0, r) * some.direction()); }};
    case 2:
      return {prepare({{geometry::Cylinder{r, -length, length}, identity}}),
              [=](Random& some) { return point_in_cylinder(some, r, length); }};
    case 3:
      return {prepare({{geometry::Capsule{Vec3(0, 0, -length), Vec3(0, 0, length), r}, identity}}),
              [=](Random& some) { return point_in_cylinder(some, r, length); }};
    case 4:
      return {prepare({{geometry::Prism{
                            0, length, {{0, 0}, {1, 0}, {1, 0.3}, {0.3, 0.3}, {0.3, 1}, {0, 1}}},
                        identity}}),
              in_l(1, 0.3, length)};
    case 5:
      return {mesh_body(l_mesh(1)), in_l(2, 0.5, 1)};
    default: {
      // An open sheet: what is in it is on it.
      geometry::TriangleMesh sheet;
      sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
      sheet.triangles = {{0, 1, 2}};
      return {mesh_body(sheet), [](Random& some) {
                const double x = some.unit();
                return Vec3(x, (1 - x) * some.unit(), 0);
              }};
    }
  }
}

Motion any_motion(Random& random) {
  if (random.below(3) > 0) return random_motion(random);
  TwoJointMotion crane;
  crane.theta0 = random.between(-180, 180);
  crane.theta1 = crane.theta0 + random.between(-20, 20);
  crane.place0 = Vec3(random.between(0, 2), random.between(-0.5, 0.5), random.between(-0.5, 0.5));
  crane.place1 = crane.place0 + random.vector(0.5);
  return crane.motion();
}

BodyPtr ball(double radius) {
  return prepare({{geometry::Sphere{Vec3::Zero(), radius}, Pose::Identity()}});
}

bool meets(const SweptVolume& volume, const Body& body, const Motion& motion, double tolerance) {
  SweptQuery query;
  query.contact_tolerance = tolerance;
  query.items = {item(body, motion)};
  MovingBodies bodies(query);
  return volume.meets(bodies, 0);
}

bool meets_at(const SweptVolume& volume, const Body& body, const Vec3& place, double tolerance) {
  return meets(volume, body, geometry::stationary(at(place.x(), place.y(), place.z())), tolerance);
}

/// Certified least distance of a body over its motion from one that stands (m); infinite beyond
/// `range`.
double distance(const Body& body, const Motion& motion, const BodyPtr& other, const Pose& X,
                double range, double resolution) {
  CollisionWorld world;
  world.insert(other, X);
  SweptQuery query;
  query.items = {item(body, motion)};
  return world.clearance(query, range, resolution).lower_bound;
}

TEST(SweptVolumeProperty, HoldsEveryPointAtEveryMoment) {
  Random random(601);
  // As small as may be, so that what the volume lacks is seen.
  const BodyPtr probe = ball(1e-6);
  for (int i = 0; i < rubicon::test::cases(600); ++i) {
    const Solid solid = random_solid(random);
    const Motion motion = any_motion(random);
    const SweptVolume volume(solid.body, motion, kGrowth);
    for (int k = 0; k < 20; ++k) {
      const double s = k < 2 ? k : random.unit();
      const Vec3 point = motion.pose(s) * solid.point(random);
      ASSERT_TRUE(meets_at(volume, *probe, point, 0)) << "case " << i << " at " << s;
      Bounds bounds = volume.bounds();
      bounds.grow(Vec3::Constant(1e-9));
      ASSERT_TRUE(bounds.contains(point)) << "case " << i << " at " << s;
    }
  }
}

TEST(SweptVolumeProperty, IsNotLargerThanItsGrowth) {
  Random random(602);
  const double radius = 0.01;
  const BodyPtr probe = ball(radius);
  int near = 0;
  for (int i = 0; i < rubicon::test::cases(600); ++i) {
    const Solid solid = random_solid(random);
    const Motion motion = any_motion(random);
    const SweptVolume volume(solid.body, motion, kGrowth);
    for (int k = 0; k < 12; ++k) {
      const Vec3 point = motion.pose(random.unit()) * solid.point(random) + random.vector(0.3);
      const Pose X = at(point.x(), point.y(), point.z());
      const double apart = distance(*solid.body, motion, probe, X, 1, 1e-6);
      // As large a ball as there is room for, but for the growth.
      const double room = radius + apart - kGrowth - 1e-5;
      if (apart <= 0 || apart > 0.6 || room <= 0) continue;
      ++near;
      EXPECT_FALSE(meets_at(volume, *ball(room), point, 0)) << "case " << i << ", " << apart;
    }
  }
  EXPECT_GT(near, rubicon::test::at_least(1000));
}

/// How far a point of a random solid gets per unit of s (m): corners of a box around all of them,
/// at small steps, and a tenth more.
double speed(const Motion& motion) {
  const int steps = 64;
  double fastest = 0;
  for (int i = 0; i < steps; ++i) {
    const Pose from = motion.pose(static_cast<double>(i) / steps);
    const Pose to = motion.pose(static_cast<double>(i + 1) / steps);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p((corner & 1) ? 2.5 : -2.5, (corner & 2) ? 2.5 : -2.5, (corner & 4) ? 2.5 : -2.5);
      fastest = std::max(fastest, steps * (from * p - to * p).norm());
    }
  }
  return 1.1 * fastest;
}

TEST(SweptVolumeProperty, StepsThatKeepOutOfItNeverOverlapItAtAnyTwoMoments) {
  Random random(603);
  int free = 0;
  int refused_in_time = 0;
  int deep = 0;
  for (int i = 0; i < rubicon::test::cases(1500); ++i) {
    const Solid first = random_solid(random);
    const Solid second = random_solid(random);
    const Motion motion_a = any_motion(random);
    const Motion motion_b = any_motion(random);
    const SweptVolume volume(first.body, motion_a, kGrowth);
    const bool met = meets(volume, *second.body, motion_b, kTolerance);
    if (!met) ++free;
    for (int k = 0; k < 60; ++k) {
      // For equal moments too, which is what happens.
      const double u = k < 2 ? k : random.unit();
      const double v = k % 3 == 0 ? u : random.unit();
      if (!overlaps(*first.body, motion_a.pose(u), *second.body, motion_b.pose(v),
                    kTolerance + 1e-8)) {
        continue;
      }
      ++deep;
      if (u == v) ++refused_in_time;
      EXPECT_TRUE(met) << "case " << i << " at " << u << ", " << v;
    }
  }
  EXPECT_GT(free, rubicon::test::at_least(150));
  EXPECT_GT(deep, rubicon::test::at_least(5000));
  EXPECT_GT(refused_in_time, rubicon::test::at_least(1000));
}

TEST(SweptVolumeProperty, StepsThatKeepApartAreNotRefused) {
  Random random(604);
  int apart = 0;
  for (int i = 0; i < rubicon::test::cases(400); ++i) {
    const Solid first = random_solid(random);
    const Solid second = random_solid(random);
    const Motion motion_a = any_motion(random);
    const Motion motion_b = any_motion(random);
    // The second one at many moments, each with room for what it moves until the next.
    const int moments = 64;
    const double between = 0.5 * speed(motion_b) / moments;
    double least = 1;
    for (int k = 0; k <= moments && least > 0; ++k) {
      const Pose X = motion_b.pose(static_cast<double>(k) / moments);
      const double found = distance(*first.body, motion_a, second.body, X, 1, 1e-2);
      least = std::min(least, found - between);
    }
    if (least <= kGrowth + 1e-4) continue;
    ++apart;
    const SweptVolume volume(first.body, motion_a, kGrowth);
    EXPECT_FALSE(meets(volume, *second.body, motion_b, 0)) << "case " << i << ", " << least;
  }
  EXPECT_GT(apart, rubicon::test::at_least(40));
}

TEST(SweptVolumeProperty, AnswersDoNotDependOnWhatWasAskedBefore) {
  Random random(605);
  for (int i = 0; i < 60; ++i) {
    const Solid solid = random_solid(random);
    const Motion motion = any_motion(random);
    const SweptVolume volume(solid.body, motion, kGrowth);
    std::vector<std::pair<BodyPtr, Motion>> steps;
    std::vector<bool> answers;
    for (int k = 0; k < 12; ++k) {
      steps.emplace_back(random_solid(random).body, any_motion(random));
      answers.push_back(meets(volume, *steps.back().first, steps.back().second, kTolerance));
    }
    for (std::size_t k = steps.size(); k-- > 0;) {
      const SweptVolume fresh(solid.body, motion, kGrowth);
      const auto& [body, step] = steps[k];
      EXPECT_EQ(meets(volume, *body, step, kTolerance), answers[k]);
      EXPECT_EQ(meets(fresh, *body, step, kTolerance), answers[k]);
    }
  }
}

}  // namespace
}  // namespace rubicon::collision::test
