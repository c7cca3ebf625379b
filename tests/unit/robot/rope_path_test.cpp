#include "src/motion/robot/rope_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/unit/robot/robots.hpp"

namespace rubicon::robot {
namespace {

constexpr double kRadius = 0.02;

/// Adds a rope between two bodies; its index.
int add_rope(RobotModel& model, int from, const Vec3& p_from, int to, const Vec3& p_to) {
  const int index = add_body(model, "rope", to);
  model.bodies.back().rope = Rope{kRadius, from, p_from, p_to};
  return index;
}

double distance_to_axis(const Vec3& p, const RopePiece& piece) {
  const Vec3 along = piece.b - piece.a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - piece.a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p - piece.a - t * along).norm();
}

/// By how much (m) the rope leaves its volume at worst, at many moments and points of it.
double worst_miss(const RobotModel& model, const Mounting& mounting, int rope,
                  const std::vector<double>& q0, const std::vector<double>& q1) {
  double worst = -1;
  for (const RopePiece& piece : RopePath(model, mounting, rope).pieces(q0, q1)) {
    for (int i = 0; i <= 16; ++i) {
      const double s = piece.s0 + (piece.s1 - piece.s0) * i / 16;
      std::vector<double> q = q0;
      for (std::size_t k = 0; k < q.size(); ++k) q[k] += s * (q1[k] - q0[k]);
      std::vector<Pose> X_WB;
      body_poses(model, mounting, q, X_WB);
      const auto [from, to] = rope_ends(model, mounting, rope, q);
      const Pose X_BW = X_WB[static_cast<std::size_t>(piece.body)].inverse(Eigen::Isometry);
      for (int j = 0; j <= 16; ++j) {
        const Vec3 p = X_BW * (from + (to - from) * j / 16);
        worst = std::max(worst, distance_to_axis(p, piece) + kRadius - piece.radius);
      }
    }
  }
  return worst;
}

TEST(RopePath, OfACraneIsExact) {
  RobotModel model = crane();
  const int hook = static_cast<int>(model.bodies.size()) - 1;
  const int rope = add_rope(model, 1, {20, 0, 30}, hook, {0, 0, 0.5});
  const Mounting mounting = mounting_of(model, math::translation(3, 4, 0));
  const std::vector<double> q0 = {30, 20, 10};
  for (const std::vector<double>& q1 :
       {std::vector<double>{32, 20, 10}, std::vector<double>{30, 20, 11}}) {
    const auto pieces = RopePath(model, mounting, rope).pieces(q0, q1);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_EQ(pieces[0].radius, kRadius);
    EXPECT_LT(worst_miss(model, mounting, rope, q0, q1), 1e-9);
  }
  // The rope of a load that is raised is as long as at the start, and hangs where it did.
  const std::vector<double> higher = {30, 20, 11};
  const RopePiece raised = RopePath(model, mounting, rope).pieces(q0, higher).front();
  EXPECT_EQ(raised.body, 1);
  EXPECT_LT((raised.b - Vec3(20, 0, 10.5)).norm(), 1e-9);
}

TEST(RopePath, HoldsTheRopeOfAnyMachine) {
  std::mt19937 random(4711);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  const auto point = [&] {
    return Vec3(3 * anywhere(random), 3 * anywhere(random), 3 * anywhere(random));
  };
  int in_parts = 0;
  for (const RobotModel& machine :
       {crane(), crane_with_turning_hook(), planar_arm(), excavator()}) {
    const int bodies = static_cast<int>(machine.bodies.size());
    for (int trial = 0; trial < 60; ++trial) {
      RobotModel model = machine;
      const int to = bodies - 1 - trial % 2;
      const int from = trial / 2 % to;
      const int rope = add_rope(model, from, point(), to, point());
      const Mounting mounting = mounting_of(model, math::translation(1, 2, 3));
      std::vector<double> q0, q1;
      for (const Parameter& parameter : model.parameters) {
        const double size = parameter.rotation ? 180.0 : 10.0;
        q0.push_back(size * anywhere(random));
        q1.push_back(q0.back() + (trial % 3 == 0 ? 0.02 : 0.1) * size * anywhere(random));
      }
      const auto pieces = RopePath(model, mounting, rope).pieces(q0, q1);
      EXPECT_LT(worst_miss(model, mounting, rope, q0, q1), 1e-9);
      EXPECT_EQ(pieces.front().s0, 0);
      EXPECT_EQ(pieces.back().s1, 1);
      for (std::size_t i = 1; i < pieces.size(); ++i) EXPECT_EQ(pieces[i - 1].s1, pieces[i].s0);
      in_parts += pieces.size() > 1;
    }
  }
  EXPECT_GT(in_parts, 100);
}

}  // namespace
}  // namespace rubicon::robot
