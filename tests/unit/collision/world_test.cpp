#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <thread>

#include "tests/unit/collision/meshes.hpp"
#include "tests/unit/collision/random_scene.hpp"

namespace rubicon::collision::test {
namespace {

SweptQuery one(const Body& body, const Motion& motion, double tolerance = 1e-3) {
  SweptQuery query;
  query.items = {item(body, motion)};
  query.contact_tolerance = tolerance;
  return query;
}

TEST(CollisionWorld, NamesTheFirstBlockingPairItemsFirstThenPairs) {
  const BodyPtr cube = box(Vec3::Constant(0.5));
  CollisionWorld world;
  const ObstacleId far = world.insert(cube, at(3, 0, 0));
  const ObstacleId near = world.insert(cube, at(1.2, 0, 0));
  SweptQuery query = one(*cube, geometry::translating(at(0, 0, 0), Vec3(5, 0, 0)));
  SweptResult result = world.test(query);
  ASSERT_TRUE(result.hit);
  EXPECT_EQ(result.hit->item, 0);
  EXPECT_EQ(result.hit->obstacle, far) << "by id, not by distance";

  query.ignore = {far};
  EXPECT_EQ(world.test(query).hit->obstacle, near);
  query.ignore = {near, far};
  EXPECT_FALSE(world.test(query).hit);

  query.items.push_back(item(*cube, geometry::stationary(at(4, 0.2, 0))));
  query.pairs = {{1, 0}};
  result = world.test(query);
  ASSERT_TRUE(result.hit);
  EXPECT_EQ(result.hit->item, 1);
  EXPECT_EQ(result.hit->other_item, 0);
  EXPECT_FALSE(result.hit->obstacle);

  query.ignore = {near};
  EXPECT_EQ(world.test(query).hit->obstacle, far);
  query.items[0].against_world = false;
  query.items[1].against_world = false;
  EXPECT_EQ(world.test(query).hit->other_item, 0);
}

TEST(CollisionWorld, IdsAreNeverUsedAgain) {
  const BodyPtr cube = box(Vec3::Constant(0.5));
  CollisionWorld world;
  const ObstacleId first = world.insert(cube, at(0, 0, 0));
  world.remove(first);
  const ObstacleId second = world.insert(cube, at(0, 0, 0));
  EXPECT_NE(first, second);
  EXPECT_THROW(world.remove(first), std::invalid_argument);
  world.remove(second);
  EXPECT_FALSE(world.blocked_at(*cube, at(0, 0, 0), 1e-3, {}));
}

TEST(CollisionWorld, AReplacedObstacleKeepsItsId) {
  const BodyPtr cube = box(Vec3::Constant(0.5));
  CollisionWorld world;
  const ObstacleId id = world.insert(cube, at(0, 0, 0));
  const ObstacleId other = world.insert(cube, at(9, 0, 0));
  // Smaller, then much larger, then elsewhere.
  world.replace(id, box(Vec3::Constant(0.1)), at(0, 0, 0));
  EXPECT_FALSE(world.blocked_at(*cube, at(0.7, 0, 0), 1e-3, {}));
  EXPECT_EQ(world.blocked_at(*cube, at(0.5, 0, 0), 1e-3, {}), id);
  world.replace(id, box(Vec3::Constant(3)), at(0, 0, 0));
  EXPECT_EQ(world.blocked_at(*cube, at(3.4, 0, 0), 1e-3, {}), id);
  world.replace(id, cube, at(-20, 0, 0));
  EXPECT_FALSE(world.blocked_at(*cube, at(0, 0, 0), 1e-3, {}));
  EXPECT_EQ(world.blocked_at(*cube, at(-20, 0.3, 0), 1e-3, {}), id);
  EXPECT_EQ(world.blocked_at(*cube, at(9, 0.3, 0), 1e-3, {}), other);
  world.remove(id);
  EXPECT_THROW(world.replace(id, cube, at(0, 0, 0)), std::invalid_argument);
  EXPECT_THROW(world.replace(other, nullptr, at(0, 0, 0)), std::invalid_argument);
}

TEST(CollisionWorld, BadQueriesAreRefused) {
  const BodyPtr cube = box(Vec3::Constant(0.5));
  CollisionWorld world;
  world.insert(cube, at(0, 0, 0));
  EXPECT_THROW(world.insert(nullptr, at(0, 0, 0)), std::invalid_argument);
  const Motion still = geometry::stationary(at(0, 0, 0));
  EXPECT_THROW(world.test(one(*cube, still, -1)), std::invalid_argument);
  EXPECT_THROW(world.test(one(*cube, still, kNan)), std::invalid_argument);
  EXPECT_THROW(world.blocked_at(*cube, at(0, 0, 0), kNan, {}), std::invalid_argument);
  SweptQuery query = one(*cube, still);
  query.items[0].moving.body = nullptr;
  EXPECT_THROW(world.test(query), std::invalid_argument);
  for (const int second : {-1, 0, 1}) {
    query = one(*cube, still);
    query.pairs = {{0, second}};
    EXPECT_THROW(world.test(query), std::invalid_argument);
  }
  EXPECT_THROW(world.test(one(*cube, geometry::translating(at(0, 0, 0), Vec3(kNan, 0, 0)))),
               std::invalid_argument);
  EXPECT_THROW(world.test(one(*cube, geometry::stationary(at(kNan, 0, 0)))), std::invalid_argument);
  EXPECT_THROW(world.test(one(*cube, turning(at(0, 0, 0), Vec3(0, 0, 2), Vec3::Zero(), 5))),
               std::invalid_argument);
  EXPECT_THROW(world.test(one(*cube, turning(at(0, 0, 0), Vec3::UnitZ(), Vec3::Zero(), kNan))),
               std::invalid_argument);
  geometry::ScrewMotion skew;
  skew.angle_deg = 5;
  skew.slide = Vec3(1, 0, 0);
  EXPECT_THROW(world.test(one(*cube, Motion{skew})), std::invalid_argument);
}

struct Part {
  BodyPtr body;
  Pose X;
};

std::vector<Part> random_parts(Random& random, int count) {
  std::vector<Part> parts;
  const BodyPtr l = mesh_body(l_mesh());
  const BodyPtr ball = prepare({{geometry::Sphere{Vec3::Zero(), 0.3}, Pose::Identity()}});
  for (int i = 0; i < count; ++i) {
    const BodyPtr bodies[] = {l, ball, box(Vec3(0.2, 0.5, 0.1))};
    parts.push_back({bodies[i % 3], random.pose(4)});
  }
  return parts;
}

Motion random_shift_or_turn(Random& random) {
  const Pose X = random.pose(4);
  return random.below(2)
             ? geometry::translating(X, random.vector(0.5))
             : turning(X, random.direction(), random.vector(5), random.between(-10, 10));
}

TEST(CollisionWorld, TheOrderOfInsertionDoesNotMatterAndRemovalLeavesNoTrace) {
  Random random(71);
  const std::vector<Part> parts = random_parts(random, 40);
  CollisionWorld forwards;
  CollisionWorld backwards;
  CollisionWorld busy;
  std::vector<ObstacleId> passing;
  for (const Part& part : parts) {
    forwards.insert(part.body, part.X);
    passing.push_back(busy.insert(box(Vec3::Constant(2)), part.X));
    busy.insert(part.body, part.X);
  }
  for (auto part = parts.rbegin(); part != parts.rend(); ++part)
    backwards.insert(part->body, part->X);
  for (const ObstacleId id : passing) busy.remove(id);
  const BodyPtr load = box(Vec3(0.3, 0.2, 0.6));
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const SweptQuery query = one(*load, random_shift_or_turn(random));
    const SweptResult result = forwards.test(query);
    hits += result.hit.has_value();
    EXPECT_EQ(result.hit.has_value(), backwards.test(query).hit.has_value());
    const SweptResult after = busy.test(query);
    ASSERT_EQ(result.hit.has_value(), after.hit.has_value());
    if (result.hit) {
      EXPECT_EQ(2 * *result.hit->obstacle, *after.hit->obstacle);
    }
  }
  EXPECT_GT(hits, 100);
  EXPECT_LT(hits, 900);
}

TEST(CollisionWorld, QueriesOnSeveralThreadsGiveTheSameAnswers) {
  Random random(72);
  CollisionWorld world;
  for (const Part& part : random_parts(random, 30)) world.insert(part.body, part.X);
  const BodyPtr load = box(Vec3(0.3, 0.2, 0.6));
  std::vector<SweptQuery> queries;
  for (int i = 0; i < 300; ++i) queries.push_back(one(*load, random_shift_or_turn(random)));
  const auto answers = [&] {
    std::vector<ObstacleId> result;
    for (const SweptQuery& query : queries) {
      const SweptResult answer = world.test(query);
      result.push_back(answer.hit ? *answer.hit->obstacle : 0);
    }
    return result;
  };
  const std::vector<ObstacleId> alone = answers();
  std::vector<std::vector<ObstacleId>> results(4);
  std::vector<std::thread> threads;
  for (auto& result : results) threads.emplace_back([&result, &answers] { result = answers(); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& result : results) EXPECT_EQ(result, alone);
}

TEST(CollisionWorld, ABodyOfManyPartsBlocksWhereItsPartsDo) {
  Random random(77);
  int hits = 0;
  for (int round = 0; round < 40; ++round) {
    // More parts than are looked at one by one; far from the body's own origin.
    std::vector<geometry::Shape> shapes;
    CollisionWorld parts;
    const Pose X_WB = random.pose(5);
    for (int i = 0; i < 30; ++i) {
      const Vec3 corner = Vec3(100, 200, 0) + random.vector(5);
      shapes.push_back(box_shape(corner, corner + Vec3::Constant(0.5) + random.vector(0.4)));
      parts.insert(prepare({shapes.back()}), X_WB);
    }
    CollisionWorld whole;
    whole.insert(prepare(shapes), X_WB);
    const BodyPtr load = box(Vec3(0.3, 0.2, 0.4));
    for (int i = 0; i < 50; ++i) {
      Pose X0 = random.pose(0);
      X0.translation() = X_WB * (Vec3(100, 200, 0) + random.vector(6));
      const Motion motion = i % 2 == 0 ? geometry::translating(X0, random.vector(0.5))
                                       : turning(X0, random.direction(), random.vector(20), 3);
      SweptQuery query;
      query.items = {item(*load, motion)};
      const bool expected = parts.test(query).hit.has_value();
      hits += expected;
      EXPECT_EQ(whole.test(query).hit.has_value(), expected) << "case " << round << " " << i;
    }
  }
  EXPECT_GT(hits, 100);
  EXPECT_LT(hits, 1900);
}

}  // namespace
}  // namespace rubicon::collision::test
