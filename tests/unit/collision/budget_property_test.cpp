#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <vector>

#include "tests/support/random_cases.hpp"
#include "tests/unit/collision/bodies.hpp"
#include "tests/unit/collision/two_joint_motion.hpp"

namespace rubicon::collision::test {
namespace {

bool same(const SweptResult& a, const SweptResult& b) {
  if (a.hit.has_value() != b.hit.has_value()) return false;
  return !a.hit || (a.hit->item == b.hit->item && a.hit->obstacle == b.hit->obstacle &&
                    a.hit->other_item == b.hit->other_item);
}

/// The next step of a walk from X: small or large, straight, turning or with two joints.
Motion next_step(Random& random, const Pose& X) {
  const double size = random.below(8) ? 0.05 : 1;
  switch (random.below(4)) {
    case 0:
      return turning(X, random.direction(), X.translation() + random.vector(10),
                     size * random.between(-3, 3), random.below(2) * size * random.between(-1, 1));
    case 1: {
      TwoJointMotion crane;
      crane.theta1 = size * random.between(-3, 3);
      crane.place0 = X.translation();
      crane.place1 = crane.place0 + random.vector(size);
      return crane.motion();
    }
    default:
      return geometry::translating(X, random.vector(size));
  }
}

TEST(ClearanceBudget, NeverChangesAnAnswerOnAWalkThroughAChangingSite) {
  Random random(401);
  const std::vector<BodyPtr> bodies = site_bodies();
  const auto any_body = [&] { return bodies[random.below(static_cast<int>(bodies.size()))]; };
  int hits = 0;
  int free = 0;
  for (int walk = 0; walk < 40; ++walk) {
    CollisionWorld world;
    std::vector<ObstacleId> ids;
    const double size = walk % 2 ? 4 : 12;
    for (int i = 0; i < 60; ++i) ids.push_back(world.insert(any_body(), random.pose(size)));
    ClearanceBudget budget;
    std::vector<BodyPtr> movers = {any_body(), any_body()};
    std::vector<Pose> poses = {random.pose(size), random.pose(size)};
    for (int step = 0; step < rubicon::test::cases(400); ++step) {
      SweptQuery query;
      query.contact_tolerance = step % 3 ? 1e-3 : 1e-2;
      for (int k = 0; k < 2; ++k)
        query.items.push_back(item(*movers[k], next_step(random, poses[k]), random.below(9) != 0));
      if (random.below(2)) query.pairs = {{0, 1}};
      if (random.below(4) == 0) query.ignore = {ids[random.below(static_cast<int>(ids.size()))]};
      const SweptResult plain = world.test(query);
      ASSERT_TRUE(same(plain, world.test(query, budget))) << "walk " << walk << " step " << step;
      (plain.hit ? hits : free) += 1;
      // Refused steps are sometimes taken all the same: the site may be left and entered anyhow.
      if (!plain.hit || random.below(4) == 0) {
        for (int k = 0; k < 2; ++k) poses[k] = query.items[k].moving.motion.pose(1);
      }
      for (Pose& pose : poses) {
        if (pose.translation().norm() > 2 * size) pose = random.pose(size);
      }
      if (random.below(20) == 0) movers[random.below(2)] = any_body();
      if (random.below(10) == 0) {
        // Right where a mover is, where a budget that did not notice would be wrong.
        Pose X = random.pose(0.5);
        X.translation() += poses[random.below(2)].translation();
        ids.push_back(world.insert(any_body(), X));
      }
      if (random.below(10) == 0) {
        const int victim = random.below(static_cast<int>(ids.size()));
        world.remove(ids[victim]);
        ids.erase(ids.begin() + victim);
      }
    }
  }
  EXPECT_GT(hits, rubicon::test::at_least(2000));
  EXPECT_GT(free, rubicon::test::at_least(1000));
}

TEST(ClearanceBudget, NoticesAnotherWorld) {
  const BodyPtr cube = box(Vec3::Constant(0.5));
  CollisionWorld empty;
  CollisionWorld full;
  full.insert(cube, at(0, 0, 0));
  ClearanceBudget budget;
  SweptQuery query;
  query.items = {item(*cube, geometry::translating(at(0, 0, 0), Vec3(1e-3, 0, 0)))};
  EXPECT_FALSE(empty.test(query, budget).hit);
  EXPECT_TRUE(full.test(query, budget).hit);
  EXPECT_FALSE(empty.test(query, budget).hit);
  // A world that takes the place of another.
  empty = std::move(full);
  EXPECT_TRUE(empty.test(query, budget).hit);
}

TEST(ClearanceBudget, NoticesAnotherBodyAtTheAddressOfOneThatIsGone) {
  // On both sides: what is beside the box around all obstacles needs no budget.
  CollisionWorld world;
  world.insert(box(Vec3::Constant(0.1)), at(2, 0, 0));
  world.insert(box(Vec3::Constant(0.1)), at(-2, 0, 0));
  ClearanceBudget budget;
  const auto step_of = [](const Body& body) {
    SweptQuery query;
    query.items = {item(body, geometry::translating(at(0, 0, 0), Vec3(1e-3, 0, 0)))};
    return query;
  };
  int reused = 0;
  for (int i = 0; i < 50; ++i) {
    BodyPtr small = box(Vec3::Constant(0.1));
    const Body* address = small.get();
    for (int k = 0; k < 4; ++k) ASSERT_FALSE(world.test(step_of(*small), budget).hit);
    small.reset();
    const BodyPtr large = box(Vec3::Constant(2));
    reused += large.get() == address;
    ASSERT_TRUE(world.test(step_of(*large), budget).hit) << "case " << i;
  }
  // The budget keeps the body it remembers, so its address was not given to another.
  EXPECT_EQ(reused, 0);
}

TEST(ClearanceBudget, RefusesBadMotionsInFreeSpaceToo) {
  CollisionWorld world;
  world.insert(box(Vec3::Constant(0.1)), at(50, 0, 0));
  const BodyPtr cube = box(Vec3::Constant(0.1));
  ClearanceBudget budget;
  const auto ask = [&](const Motion& motion) {
    SweptQuery query;
    query.items = {item(*cube, motion)};
    return world.test(query, budget);
  };
  for (int k = 0; k < 4; ++k)
    ASSERT_FALSE(ask(geometry::translating(at(0, 0, 0), Vec3(1, 0, 0))).hit);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ask(geometry::translating(at(1, 0, 0), Vec3(nan, 0, 0))), std::invalid_argument);
  Pose skewed = at(1, 0, 0);
  skewed.linear()(0, 1) = 0.1;
  EXPECT_THROW(ask(geometry::translating(skewed, Vec3(0.1, 0, 0))), std::invalid_argument);
  EXPECT_THROW(ask(turning(at(1, 0, 0), Vec3(0, 0, 1.1), Vec3::Zero(), 1)), std::invalid_argument);
  geometry::ScrewMotion across;
  across.X0 = at(1, 0, 0);
  across.angle_deg = 1;
  across.slide = Vec3(0.1, 0, 0);
  EXPECT_THROW(ask(Motion{across}), std::invalid_argument);
}

}  // namespace
}  // namespace rubicon::collision::test
