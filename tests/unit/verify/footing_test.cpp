#include "src/results/verify/geometry/footing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>
#include <vector>

#include "src/motion/math/angles.hpp"

namespace rubicon::verify {
namespace {

using Vec2 = Eigen::Vector2d;

/// Points along the sides of 3 m by 0.2 m, turned, each several times and beside its side by
/// rounding, as triangles that meet there give them.
std::vector<Vec2> rounded_sides(double turn_deg) {
  std::vector<Vec2> points;
  const double x = math::cos_deg(turn_deg);
  const double y = math::sin_deg(turn_deg);
  for (int i = 0; i < 400; ++i) {
    const double along = 0.3 * (i % 11);
    const double across = i % 2 == 0 ? 0 : 0.2;
    const double noise = 1e-15 * std::fmod(i * 7.3, 3) - 1.5e-15;
    points.emplace_back(x * along - y * (across + noise), y * along + x * (across + noise));
  }
  return points;
}

TEST(Footing, TheMarginIsFromTheSidesWhateverRoundingDoesToThem) {
  for (double turn = 0; turn < 360; turn += 7.5) {
    const std::vector<Vec2> points = rounded_sides(turn);
    for (const auto& [along, across, inside] : {std::tuple{1.5, 0.1, true},
                                                {0.7, 0.0011, true},
                                                {0.7, 0.0009, false},
                                                {2.9989, 0.15, true},
                                                {2.9991, 0.15, false},
                                                {1.2, -0.0011, false}}) {
      const Vec2 p(math::cos_deg(turn) * along - math::sin_deg(turn) * across,
                   math::sin_deg(turn) * along + math::cos_deg(turn) * across);
      EXPECT_EQ(is_between(p, points, 0.001), inside) << turn << " " << along << " " << across;
    }
    EXPECT_TRUE(is_as_wide(points, 0.0999));
    EXPECT_FALSE(is_as_wide(points, 0.1001));
  }
}

}  // namespace
}  // namespace rubicon::verify
