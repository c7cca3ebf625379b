#include "src/motion/travel/plan_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "src/motion/travel/ring.hpp"
#include "tests/unit/travel/travel_worlds.hpp"

namespace rubicon::travel {
namespace {

using math::Vec3;

/// Where a point is in a polygon, its border and 1e-9 m about it included (crossing number).
bool holds(const std::vector<Vec2>& polygon, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const Vec2 along = b - a;
    const double share = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    if ((p - a - share * along).norm() < 1e-9) return true;
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * along.x()) {
      inside = !inside;
    }
  }
  return inside;
}

double area_of(const std::vector<Vec2>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return std::fabs(sum) / 2;
}

math::Pose random_pose(TestRandom& random) {
  const Vec3 axis(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
  math::Pose X =
      math::translation(random.between(-3, 3), random.between(-3, 3), random.between(-1, 1));
  X.rotate(Eigen::AngleAxisd(random.between(-3, 3), axis.normalized()));
  return X;
}

geometry::Shape shape_of(int kind) {
  const math::Pose I = math::Pose::Identity();
  switch (kind) {
    case 0:
      return {geometry::Box{Vec3(-1, -0.4, -0.2), Vec3(0.7, 0.5, 0.9)}, I};
    case 1:
      return {geometry::Cylinder{0.6, -0.5, 1}, I};
    case 2:
      return {geometry::Sphere{Vec3(0.2, 0.1, 0), 0.8}, I};
    case 3:
      return {geometry::Capsule{Vec3(-0.5, 0, 0), Vec3(0.8, 0.3, 0.6), 0.3}, I};
    default:
      return {geometry::Prism{-0.3, 0.8, {{-1, -1}, {1, -1}, {1, 1}, {0, -0.2}, {-1, 1}}}, I};
  }
}

/// Whether a point in the frame of the shape is in it.
bool is_in(const geometry::Solid& solid, const Vec3& p) {
  if (const auto* box = std::get_if<geometry::Box>(&solid)) {
    return (p.array() >= box->lower.array()).all() && (p.array() <= box->upper.array()).all();
  }
  if (const auto* cylinder = std::get_if<geometry::Cylinder>(&solid)) {
    return p.head<2>().norm() <= cylinder->radius && p.z() >= cylinder->z0 && p.z() <= cylinder->z1;
  }
  if (const auto* sphere = std::get_if<geometry::Sphere>(&solid)) {
    return (p - sphere->centre).norm() <= sphere->radius;
  }
  if (const auto* capsule = std::get_if<geometry::Capsule>(&solid)) {
    const Vec3 along = capsule->b - capsule->a;
    const double share = std::clamp((p - capsule->a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (p - capsule->a - share * along).norm() <= capsule->radius;
  }
  const auto& prism = std::get<geometry::Prism>(solid);
  return p.z() >= prism.z0 && p.z() <= prism.z1 && holds(prism.polygon, p.head<2>());
}

TEST(PlanView, HoldsEveryPointOfAShapeThatIsBetweenTheHeights) {
  TestRandom random(29);
  int inside = 0;
  for (int i = 0; i < 400; ++i) {
    const geometry::Shape shape = shape_of(i % 5);
    const math::Pose X = random_pose(random);
    const double low = random.between(-2, 2);
    const Heights heights{low, low + random.between(0.1, 2)};
    const auto seen = plan_view(shape, X, heights);
    for (const std::vector<Vec2>& polygon : seen) EXPECT_NO_THROW(ring_of(polygon));
    for (int k = 0; k < 300; ++k) {
      const Vec3 p(random.between(-1.6, 1.6), random.between(-1.6, 1.6), random.between(-1.6, 1.6));
      if (!is_in(shape.solid, p)) continue;
      const Vec3 p_W = X * p;
      if (p_W.z() < heights.low + 0.002 || p_W.z() > heights.high - 0.002) continue;
      ++inside;
      ASSERT_FALSE(seen.empty()) << "case " << i;
      EXPECT_TRUE(holds(seen.front(), p_W.head<2>())) << "case " << i;
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(PlanView, IsExactWhereItSaysSo) {
  const Heights all{-10, 10};
  const math::Pose turned = math::translation(2, 3, 0.5) * math::rotation_z_deg(30);
  EXPECT_NEAR(area_of(plan_view(shape_of(0), turned, all).front()), 1.7 * 0.9, 1e-9);
  EXPECT_NEAR(area_of(plan_view(shape_of(4), turned, all).front()), 4 - 1.2, 1e-9);
  const double round = std::acos(-1.0) * 0.36;
  const double seen = area_of(plan_view(shape_of(1), turned, all).front());
  EXPECT_GE(seen, round);
  EXPECT_LE(seen, round * 1.01);
  // A board that leans at 45 degrees, cut at a quarter and at half of its height.
  const geometry::Shape board{geometry::Box{Vec3(0, 0, 0), Vec3(1, 4, 1e-6)},
                              math::Pose::Identity()};
  math::Pose leaning = math::Pose::Identity();
  leaning.rotate(Eigen::AngleAxisd(std::acos(-1.0) / 4, Vec3::UnitX()));
  const double top = 4 * std::sqrt(0.5);
  EXPECT_NEAR(area_of(plan_view(board, leaning, {top / 4, top / 2}).front()), top / 4, 0.003);
}

TEST(PlanView, HasNothingOfWhatOnlyTouchesTheHeights) {
  const geometry::Shape ground{geometry::Box{Vec3(-9, -9, -1), Vec3(9, 9, 0)},
                               math::Pose::Identity()};
  EXPECT_TRUE(plan_view(ground, math::Pose::Identity(), {0, 2}).empty());
  EXPECT_FALSE(plan_view(ground, math::Pose::Identity(), {-0.1, 2}).empty());
  EXPECT_TRUE(plan_view(ground, math::Pose::Identity(), {-5, -1}).empty());
}

TEST(PlanView, ReachAndHeightsAreThoseOfTheShapes) {
  const std::vector<geometry::Shape> shapes{shape_of(0), shape_of(2)};
  const Heights heights = heights_of(shapes, math::translation(0, 0, 5));
  EXPECT_NEAR(heights.low, 4.2, 1e-12);
  EXPECT_NEAR(heights.high, 5.9, 1e-12);
  EXPECT_NEAR(reach_about({0, 0}, shapes, math::Pose::Identity()), std::hypot(1, 0.5), 1e-12);
}

}  // namespace
}  // namespace rubicon::travel
