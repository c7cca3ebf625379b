#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

#include "src/earth/soil/bucket.hpp"
#include "src/earth/soil/heap.hpp"
#include "src/motion/math/pose.hpp"

namespace rubicon::soil {
namespace {

constexpr double kRepose_deg = 35;
constexpr double kDownPerCell = 175.0519;  ///< mm: at that slope from one cell to the next

/// RUBICON_SOIL_ROUNDS=100000 is the long form.
int rounds() {
  const char* const text = std::getenv("RUBICON_SOIL_ROUNDS");
  return text == nullptr ? 1'500 : std::max(1, std::atoi(text));
}

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  double between(double least, double most) {
    return least + (most - least) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }

 private:
  std::mt19937_64 random_;
};

CubicMillimetres volume_of(const Terrain& terrain) {
  CubicMillimetres sum = 0;
  for (std::size_t i = 0; i < terrain.heights.size(); ++i) sum += terrain.heights[i];
  return sum * terrain.cell * terrain.cell;
}

/// A floor and two sides, as buckets have.
std::vector<BucketBox> bucket(Dice& dice) {
  const double width = dice.between(0.3, 0.8);
  const double length = dice.between(0.6, 1.5);
  std::vector<BucketBox> boxes(3);
  boxes[0].lower = {0, -width, -0.1};
  boxes[0].upper = {length, width, 0};
  for (const int side : {1, 2}) {
    const double y = side == 1 ? -width : width - 0.05;
    boxes[static_cast<std::size_t>(side)].lower = {0, y, 0};
    boxes[static_cast<std::size_t>(side)].upper = {length, y + 0.05, 0.6};
  }
  return boxes;
}

/// The lowest point of a box over (x, y), by another way than the engine's: the vertical line is
/// cut by each of the six faces.
class FaceOracle {
 public:
  FaceOracle(const BucketBox& box, const math::Pose& X_EB)
      : box_(box), X_ES_(X_EB * box.X_BS), X_SE_(X_ES_.inverse(Eigen::Isometry)) {
    middle_ = X_ES_ * math::Vec3((box.lower + box.upper) / 2);
    reach_ = (box.upper - box.lower).norm() / 2;
  }

  double lowest(double x, double y) const {
    double lowest = 1e300;
    if (std::hypot(x - middle_.x(), y - middle_.y()) > reach_) return lowest;
    for (int axis = 0; axis < 3; ++axis) {
      const math::Vec3 normal = X_ES_.linear().col(axis);
      if (std::fabs(normal.z()) < 1e-9) continue;
      for (const double level : {box_.lower[axis], box_.upper[axis]}) {
        const math::Vec3 p = X_ES_.translation() + normal * level;
        const double z = p.z() - ((x - p.x()) * normal.x() + (y - p.y()) * normal.y()) / normal.z();
        const math::Vec3 q = X_SE_ * math::Vec3(x, y, z);
        bool inside = true;
        for (int i = 0; i < 3; ++i) {
          if (i == axis) continue;
          inside = inside && q[i] >= box_.lower[i] - 1e-9 && q[i] <= box_.upper[i] + 1e-9;
        }
        if (inside) lowest = std::min(lowest, z);
      }
    }
    return lowest;
  }

 private:
  BucketBox box_;
  math::Pose X_ES_, X_SE_;
  math::Vec3 middle_;
  double reach_ = 0;
};

/// A pit, a bucket that digs in it at random, and a tip where it is emptied: no mm3 is lost, a
/// bucket that is not full has nothing above its underside but the bottom of the pit, what it was
/// not over stays, and nothing that was tipped is steeper than loose soil lies.
TEST(RandomDigs, KeepVolumeSlopeAndRoom) {
  Dice dice(20261127);
  const Terrain flat_pit = flat(40, 32, 250, 0);
  const Terrain flat_tip = flat(160, 160, 250, 0);
  Terrain ground = flat_pit;
  Terrain bottom = flat_pit;
  Terrain tip = flat_tip;
  CubicMillimetres dug = 0;
  CubicMillimetres tipped = 0;
  CubicMillimetres at_first = 0;
  int digs = 0;
  for (int round = 0; round < rounds(); ++round) {
    if (round % 400 == 0) {
      for (std::size_t i = 0; i < ground.heights.size(); ++i) {
        ground.heights.set(i, static_cast<Millimetres>(dice.below(900)));
        bottom.heights.set(i, ground.heights[i] - 500 - static_cast<Millimetres>(dice.below(2500)));
      }
      tip = flat_tip;
      dug = tipped = 0;
      at_first = volume_of(ground);
    }
    const std::vector<BucketBox> boxes = bucket(dice);
    const auto room = static_cast<CubicMillimetres>(dice.between(0.2e9, 2e9));
    const Millimetres tolerance = static_cast<Millimetres>(dice.below(60));
    BucketFill fill(ground, bottom, boxes, room, tolerance);
    const math::Vec3 from(dice.between(-0.5, 10.5), dice.between(-0.5, 8.5), dice.between(-1.5, 1));
    const double heading = dice.between(-180, 180);
    const double pitch = dice.between(-70, 70);
    std::vector<FaceOracle> oracles;
    for (int i = 0; i < 12; ++i) {
      math::Pose X = math::rotation_z_deg(heading) * math::rotation_y_deg(pitch);
      X.pretranslate(from + X.linear().col(0) * (0.1 * i));
      for (const BucketBox& box : boxes) oracles.emplace_back(box, X);
      fill.pass(X);
    }
    for (int row = 0; row < ground.rows; ++row) {
      for (int column = 0; column < ground.columns; ++column) {
        const auto cell = static_cast<int>(ground.index(column, row));
        const auto index = static_cast<std::size_t>(cell);
        const auto change = fill.changes().find(cell);
        const Millimetres now =
            change == fill.changes().end() ? ground.heights[index] : change->second;
        // Far from it: quick.
        const Eigen::Vector2d off(ground.middle(column) - from.x(), ground.middle(row) - from.y());
        if (off.norm() > 4) {
          ASSERT_EQ(now, ground.heights[index]);
          continue;
        }
        double lowest = 1e300;
        for (const FaceOracle& oracle : oracles) {
          for (const double u : kQuarters) {
            for (const double v : kQuarters) {
              lowest = std::min(lowest, oracle.lowest((column + u) * 0.25, (row + v) * 0.25));
            }
          }
        }
        ASSERT_LE(now, ground.heights[index]);
        ASSERT_GE(now, std::min(ground.heights[index], bottom.heights[index]));
        if (now < ground.heights[index]) {
          ASSERT_LT(lowest, 1e299) << "it took what it was not over, round " << round;
          ASSERT_GE(static_cast<double>(now) + static_cast<double>(tolerance) + 1e-3, lowest * 1e3);
        } else if (!fill.is_full()) {
          // Nothing stands where it went.
          ASSERT_LE(static_cast<double>(std::min(now, ground.heights[index])),
                    std::max(lowest * 1e3 + 1, static_cast<double>(bottom.heights[index])))
              << "round " << round;
        }
      }
    }
    ASSERT_LE(fill.volume(), room);
    for (const auto& [cell, height] : fill.changes()) {
      ground.heights.set(static_cast<std::size_t>(cell), height);
    }
    dug += fill.volume();
    ASSERT_EQ(volume_of(ground) + dug, at_first) << "round " << round;
    const std::int64_t units = fill.volume() / (tip.cell * tip.cell);
    if (units == 0) continue;
    ++digs;
    const int place = static_cast<int>(
        tip.index(50 + static_cast<int>(dice.below(60)), 50 + static_cast<int>(dice.below(60))));
    const HeapGrowth growth = tip_over(tip, place, units, kRepose_deg);
    ASSERT_FALSE(growth.reaches_border);
    for (const auto& [cell, height] : growth.heights) {
      tip.heights.set(static_cast<std::size_t>(cell), height);
    }
    tipped += units * tip.cell * tip.cell;
    ASSERT_EQ(volume_of(tip), tipped) << "round " << round;
    for (const auto& each : growth.heights) {
      const int column = each.first % tip.columns;
      const int row = each.first / tip.columns;
      for (int r = row - 1; r <= row + 1; ++r) {
        for (int c = column - 1; c <= column + 1; ++c) {
          const double apart = std::hypot(c - column, r - row) * kDownPerCell;
          ASSERT_LE(static_cast<double>(each.second - tip.heights[tip.index(c, r)]), apart + 2);
        }
      }
    }
  }
  EXPECT_GT(digs, rounds() / 4);
  RecordProperty("rounds", rounds());
  RecordProperty("digs", digs);
}

}  // namespace
}  // namespace rubicon::soil
