#include "src/earth/soil/bites.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/earth/soil/excavation.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/math/random.hpp"

namespace rubicon::soil {
namespace {

/// From `least` to `most`.
int whole(math::Random& random, int least, int most) {
  return least + static_cast<int>(random.index(static_cast<std::size_t>(most - least + 1)));
}

CubicMillimetres between(const Terrain& bottom, const Terrain& surface) {
  CubicMillimetres sum = 0;
  for (std::size_t i = 0; i < surface.heights.size(); ++i) {
    sum += (surface.heights[i] - bottom.heights[i]) * surface.cell * surface.cell;
  }
  return sum;
}

TEST(BucketFill, LowersTheCellsThatItIsOver) {
  const Terrain surface = flat(10, 10, 200, 0);
  const Terrain bottom = flat(10, 10, 200, -1000);
  const BucketBox box{{-0.3, -0.2, -0.5}, {0.3, 0.2, 0.5}};
  BucketFill bucket(surface, bottom, {box}, 1'000'000'000, 50);
  bucket.pass(math::translation(1, 1, 0.2));    // from x 0.7 to 1.3, y 0.8 to 1.2, z -0.3
  EXPECT_EQ(bucket.changes().size(), 4U * 2U);  // the first and last column by half of it
  for (const auto& [cell, height] : bucket.changes()) EXPECT_EQ(height, -300) << cell;
  EXPECT_EQ(bucket.volume(), 8LL * 200 * 200 * 300);
  bucket.pass(math::translation(1, 1, -0.46));  // within the tolerance of the bottom
  for (const auto& [cell, height] : bucket.changes()) EXPECT_EQ(height, -1000) << cell;
}

TEST(BucketFill, TakesWholeMillimetresUpToItsRoom) {
  const Terrain surface = flat(10, 10, 200, 0);
  const Terrain bottom = flat(10, 10, 200, -1000);
  const BucketBox box{{-0.3, -0.2, -0.5}, {0.3, 0.2, 0.5}};
  const CubicMillimetres room = 200LL * 200 * (300 + 300 + 123) + 17;
  BucketFill bucket(surface, bottom, {box}, room, 50);
  bucket.pass(math::translation(1, 1, 0.2));
  EXPECT_TRUE(bucket.is_full());
  EXPECT_EQ(bucket.volume(), room - 17);
  ASSERT_EQ(bucket.changes().size(), 3U);
  EXPECT_EQ(bucket.changes().rbegin()->second, -123);
}

TEST(BucketFill, FollowsATurnedBox) {
  const BucketBox box{{0, -1, -0.5}, {2, 1, 0}};
  const math::Pose X = math::translation(0, 0, 1) * math::rotation_y_deg(30);
  const auto low = lowest_over(box, X, 0.5, 0);
  ASSERT_TRUE(low);
  // the lower face, half a metre along its normal below the upper one
  EXPECT_NEAR(*low, 1 - 0.5 * std::tan(math::kPi / 6) - 0.5 / std::cos(math::kPi / 6), 1e-12);
  EXPECT_FALSE(lowest_over(box, X, 0.5, 1.01));
}

/// A machine digs a pit: what its cuts take is found at places along them, as the tool would go.
struct Machine {
  BiteRules rules;
  Terrain surface, bottom;
  std::vector<int> cells;
  int buckets = 0;

  Machine(const Terrain& ground, const Pit& pit, double stands) : surface(ground) {
    bottom = excavate(ground, pit, stands).after;
    for (std::size_t i = 0; i < bottom.heights.size(); ++i) {
      if (bottom.heights[i] == surface.heights[i]) continue;
      cells.push_back(static_cast<int>(i));
      rules.top = std::max(rules.top, surface.heights[i]);
    }
  }

  /// Whether the tool there is in ground that stays: a column of it, by its corners and its middle.
  bool hits_ground(const math::Pose& X_ET) const {
    const double side = static_cast<double>(surface.cell) * 1e-3;
    for (std::size_t i = 0; i < bottom.heights.size(); ++i) {
      const math::Vec3 p = place_of_cell(bottom, static_cast<int>(i), bottom.heights[i]);
      for (const double u : {-0.49, 0.0, 0.49}) {
        for (const double v : {-0.49, 0.0, 0.49}) {
          const auto low =
              lowest_over(rules.boxes.front(), X_ET, p.x() + u * side, p.y() + v * side);
          if (low && *low < p.z()) return true;
        }
      }
    }
    return false;
  }

  void dig() {
    const CubicMillimetres all = between(bottom, surface);
    CubicMillimetres dug = 0;
    std::set<int> put_off;
    while (const auto target = next_target(surface, bottom, cells, put_off, rules)) {
      rules.spread = target->is_last ? kTrimmed : 0;
      const std::vector<Bite> bites = bites_for(surface, bottom, *target, rules);
      if (bites.empty() && put_off.insert(target->cell).second) continue;
      put_off.erase(target->cell);
      ASSERT_FALSE(bites.empty()) << "bucket " << buckets << ", cell " << target->cell;
      const Bite& bite = bites.front();
      BucketFill bucket(surface, bottom, rules.boxes, rules.room, rules.tolerance, rules.spread);
      const int steps = 1 + static_cast<int>((bite.far - bite.near) / 0.03);
      for (int i = 0; i <= steps; ++i) {
        const double distance = bite.far - (bite.far - bite.near) * i / steps;
        const math::Pose X_ET = bite.X_ET(rules, distance, bite.low);
        bucket.pass(X_ET);
        if (buckets % 8 == 0 && i % 8 == 0) {
          ASSERT_FALSE(hits_ground(X_ET)) << buckets;
        }
      }
      for (const auto& [cell, height] : bucket.changes()) {
        const auto index = static_cast<std::size_t>(cell);
        ASSERT_LT(height, surface.heights[index]);
        ASSERT_GE(height, bottom.heights[index]);
        surface.heights.set(index, height);
      }
      ASSERT_LE(bucket.volume(), rules.room);
      ASSERT_GT(bucket.volume(), 0);
      dug += bucket.volume();
      ASSERT_EQ(dug + between(bottom, surface), all);
      ASSERT_LT(++buckets, 3000);
    }
    EXPECT_EQ(surface.heights.next_difference(bottom.heights, 0), surface.heights.size());
  }
};

TEST(Bites, DigAPitToItsBottom) {
  math::Random random(3);
  for (int i = 0; i < 6; ++i) {
    const Terrain ground = flat(60, 50, 200, 0);
    const double stands = i % 2 == 0 ? 90 : random.between(45, 70);
    const double length = random.between(2, 4);
    const double width = random.between(1.4, 3);
    const Pit pit{{{4, 4}, {4 + length, 4}, {4 + length, 4 + width}, {4, 4 + width}},
                  -whole(random, 600, 1600)};
    Machine machine(ground, pit, stands);
    machine.rules.p_EM = {random.between(-2, 1), random.between(2, 7), 0};
    machine.rules.boxes = {{{-0.4, -0.5, -0.1}, {0.2, 0.5, 1.3}}};
    machine.rules.layer = 400;
    machine.rules.room = 700'000'000;
    machine.dig();
    if (HasFatalFailure()) FAIL() << "case " << i;
    const double full = static_cast<double>(between(machine.bottom, ground)) / 700e6;
    EXPECT_LT(machine.buckets, 8 * full + 20) << "case " << i;
  }
}

}  // namespace
}  // namespace rubicon::soil
