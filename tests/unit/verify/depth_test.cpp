#include "src/results/verify/geometry/depth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/results/verify/geometry/inner_polytope.hpp"
#include "tests/unit/verify/random.hpp"

namespace rubicon::verify {
namespace {

constexpr double kAlarm = 1.25e-3;
constexpr double kLimit = 1.5e-3;

DepthQuery query(const Reach& reach = {}) { return {kLimit, kAlarm, reach}; }

double overlap(const Convex& a, const Pose& X_BA, const Convex& b, const Vec3& n) {
  return (X_BA * a.support(X_BA.linear().transpose() * n) - b.support(-n)).dot(n);
}

/// The least overlap that a search from many directions finds: the depth, or a little more.
double searched_depth(const Convex& a, const Pose& X_BA, const Convex& b, Random& random) {
  double best = 1e300;
  std::vector<Vec3> starts = {(X_BA * a.centre() - b.centre()).normalized()};
  for (int i = 0; i < 60; ++i) starts.push_back(random.direction());
  for (Vec3 n : starts) {
    double here = std::min(overlap(a, X_BA, b, n), overlap(a, X_BA, b, -n));
    if (overlap(a, X_BA, b, -n) <= here) n = -n;
    for (double step = 0.5; step > 1e-7; step /= here < best - 1e-9 ? 1.3 : 2) {
      for (int i = 0; i < 12; ++i) {
        const Vec3 tried = (n + step * random.direction()).normalized();
        const double there = overlap(a, X_BA, b, tried);
        if (there < here) {
          here = there;
          n = tried;
        }
      }
    }
    best = std::min(best, here);
  }
  return best;
}

/// Places the pieces so that they are near touching along some direction.
Pose touching_pose(const Convex& a, const Convex& b, Random& random, double depth) {
  Pose X_BA = random.pose(0.5);
  const Vec3 n = random.direction();
  X_BA.translation() -= n * (overlap(a, X_BA, b, n) - depth);
  return X_BA;
}

TEST(Depth, OfBoxesOnEachOther) {
  const Convex slab = box_piece({-1, -1, 0}, {1, 1, 0.2});
  const Convex wall = box_piece({-0.1, -1, 0}, {0.1, 1, 3});
  for (const auto& [z, expected] : {std::pair(0.2, Nearness::free),
                                    {0.2 - 1.4e-3, Nearness::free},
                                    {0.2 - 2e-3, Nearness::deep},
                                    {-1.0, Nearness::deep},
                                    {0.21, Nearness::free}}) {
    EXPECT_EQ(depth_test(wall, math::translation(0, 0, z), slab, query()).nearness, expected) << z;
  }
}

TEST(Depth, OfRoundThingsAtACorner) {
  const Convex box = box_piece({-1, -1, -1}, {1, 1, 1});
  const Convex ball = capsule_piece({0, 0, 0}, {0, 0, 0}, 0.5);
  const Vec3 out = Vec3(1, 1, 1).normalized();
  const auto at = [&](double gap) {
    Pose X = Pose::Identity();
    X.translation() = Vec3(1, 1, 1) + out * (0.5 + gap);
    return depth_test(ball, X, box, query()).nearness;
  };
  EXPECT_EQ(at(1e-4), Nearness::free);
  EXPECT_EQ(at(0), Nearness::free);
  EXPECT_EQ(at(-1.2e-3), Nearness::free);
  EXPECT_EQ(at(-2e-3), Nearness::deep);
  EXPECT_EQ(at(-0.4), Nearness::deep);
}

TEST(Depth, OfACylinderThatRollsOnASlab) {
  const Convex slab = box_piece({-5, -5, -1}, {5, 5, 0});
  const Convex drum = cylinder_piece(0.8, -1, 1);
  const auto at = [&](double z, double turn) {
    const Pose X =
        math::translation(0, 0, z) * math::rotation_x_deg(90) * math::rotation_z_deg(turn);
    return depth_test(drum, X, slab, query()).nearness;
  };
  EXPECT_EQ(at(0.8, 17), Nearness::free);
  EXPECT_EQ(at(0.8 - kAlarm, 40), Nearness::free);
  EXPECT_EQ(at(0.8 - 1.6e-3, 40), Nearness::deep);
}

/// What is called free has a direction that proves it, what is called deep has none however long
/// one searches, and what is neither lies between alarm and limit.
void expect_truth(bool round, std::uint64_t seed, int rounds) {
  Random random(seed);
  int deep = 0, free = 0;
  for (int i = 0; i < rounds; ++i) {
    const Convex a = random_piece(random, round);
    const Convex b = random_piece(random, round);
    const double wanted = random.whole(0, 2) == 0 ? random.real(-0.1, 0.3) : random.real(0, 8e-3);
    const Pose X_BA = touching_pose(a, b, random, wanted);
    const DepthResult result = depth_test(a, X_BA, b, query());
    const double depth = searched_depth(a, X_BA, b, random);
    if (result.nearness == Nearness::free) {
      EXPECT_LE(depth, kLimit + 1e-5) << i;
      ++free;
    } else if (result.nearness == Nearness::deep) {
      EXPECT_GE(depth, kAlarm - 1e-9) << i;
      EXPECT_LE(result.depth, depth + 1e-9) << i;
      ++deep;
    }
    if (depth < kAlarm) {
      EXPECT_EQ(result.nearness, Nearness::free) << i;
    }
  }
  EXPECT_GT(deep, rounds / 40);
  EXPECT_GT(free, rounds / 20);
}

TEST(Depth, OfPolytopesIsTrue) { expect_truth(false, 4, 600); }
TEST(Depth, OfAllKindsIsTrue) { expect_truth(true, 5, 900); }

TEST(Depth, ByBothMethodsAgrees) {
  Random random(6);
  for (int i = 0; i < 5000; ++i) {
    const Convex a = random_piece(random, false);
    const Convex b = random_piece(random, false);
    const Pose X_BA = touching_pose(a, b, random, random.real(-5e-3, 8e-3));
    const auto one = depth_test(a, X_BA, b, query());
    const auto other = test_by_inner_polytope(a, X_BA, b, query());
    const bool opposite = (one.nearness == Nearness::deep && other.nearness == Nearness::free) ||
                          (one.nearness == Nearness::free && other.nearness == Nearness::deep);
    // Between alarm and limit both are true.
    EXPECT_TRUE(!opposite || (one.nearness == Nearness::deep ? one : other).depth <= kLimit) << i;
    EXPECT_NE(one.nearness, Nearness::unsure) << i;
    EXPECT_NE(other.nearness, Nearness::unsure) << i;
  }
}

TEST(Depth, HeedsTheReach) {
  const Convex box = box_piece({-1, -1, -1}, {1, 1, 1});
  const Pose X = math::translation(2.1, 0, 0);
  EXPECT_EQ(depth_test(box, X, box, query({{0, 0, 0}, 0.1})).nearness, Nearness::free);
  EXPECT_EQ(depth_test(box, X, box, query({{0, 0, 0}, 0.11})).nearness, Nearness::unsure);
  EXPECT_EQ(depth_test(box, X, box, query({{0, 5, 5}, 0.1})).nearness, Nearness::free);
  EXPECT_EQ(depth_test(box, X, box, query({{0.2, 0, 0}, 0})).nearness, Nearness::unsure);
}

TEST(Depth, OfAlignedAndFlatThings) {
  // Faces, edges and corners that lie in each other, where products of edges vanish.
  const Convex flat = triangle_piece({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const Convex box = box_piece({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(depth_test(flat, Pose::Identity(), flat, query()).nearness, Nearness::free);
  EXPECT_EQ(depth_test(flat, Pose::Identity(), box, query()).nearness, Nearness::free);
  EXPECT_EQ(depth_test(flat, math::translation(0, 0, 0.5), box, query()).nearness, Nearness::deep);
  EXPECT_EQ(depth_test(box, Pose::Identity(), box, query()).nearness, Nearness::deep);
  EXPECT_EQ(test_by_inner_polytope(flat, Pose::Identity(), flat, query()).nearness, Nearness::free);
  EXPECT_EQ(test_by_inner_polytope(flat, Pose::Identity(), box, query()).nearness, Nearness::free);
  EXPECT_EQ(test_by_inner_polytope(box, Pose::Identity(), box, query()).nearness, Nearness::deep);
  EXPECT_EQ(test_by_inner_polytope(box, math::translation(1, 0, 0), box, query()).nearness,
            Nearness::free);
  EXPECT_EQ(test_by_inner_polytope(box, math::translation(1, 1, 1), box, query()).nearness,
            Nearness::free);
}

}  // namespace
}  // namespace rubicon::verify
