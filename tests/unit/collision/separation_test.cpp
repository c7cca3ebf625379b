#include "src/motion/collision/convex/separation.hpp"

#include <gtest/gtest.h>

#include "src/motion/collision/convex/expanding_polytope.hpp"
#include "src/motion/collision/convex/gjk.hpp"
#include "src/motion/collision/convex/separating_axes.hpp"
#include "src/motion/collision/sweep/body.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/collision/random_scene.hpp"

namespace rubicon::collision::test {
namespace {

BodyPtr random_polytope(Random& random) {
  if (random.below(2))
    return box(
        Vec3(random.between(0.05, 0.6), random.between(0.05, 0.6), random.between(0.05, 0.6)));
  std::vector<Eigen::Vector2d> polygon;
  const int corners = 3 + random.below(6);
  for (int i = 0; i < corners; ++i) {
    const double heading = 360.0 * (i + random.between(0, 0.5)) / corners;
    polygon.emplace_back(0.5 * math::cos_deg(heading), 0.5 * math::sin_deg(heading));
  }
  return prepare({{geometry::Prism{-0.3, random.between(0, 0.5), polygon}, Pose::Identity()}});
}

SweptPair random_pair(Random& random, const Body& a, const Body& b, double tolerance) {
  SweptPair pair;
  pair.moving = a.convexes().front();
  pair.fixed = b.convexes().front();
  pair.start = Placement(random.pose(0.9));
  pair.end = pair.start;
  pair.standing = random.below(2) == 0;
  if (!pair.standing) pair.end.t += random.vector(0.4);
  pair.middle = pair.start;
  pair.tolerance = tolerance;
  return pair;
}

/// The way round shapes and polytopes of many faces take.
bool separated_by_search(const SweptPair& pair) {
  const GjkResult result = gjk(pair);
  return result.free || (result.cores_meet && shallow_direction_exists(pair, result.simplex));
}

TEST(Separation, TheSearchAndTheCompleteSetOfAxesAgree) {
  Random random(91);
  int free = 0;
  int hit = 0;
  for (int i = 0; i < rubicon::test::cases(6000); ++i) {
    const BodyPtr a = random_polytope(random);
    const BodyPtr b = random_polytope(random);
    const double tolerances[] = {1e-6, 1e-3, 1e-2, 5e-2};
    SweptPair pair = random_pair(random, *a, *b, tolerances[i % 4]);
    const bool answer = separating_axis_exists(pair);
    pair.tolerance += 1e-8;
    const bool with_more = separating_axis_exists(pair);
    pair.tolerance -= 2e-8;
    const bool with_less = separating_axis_exists(pair);
    pair.tolerance += 1e-8;
    if (answer != with_more || answer != with_less) continue;
    ++(answer ? free : hit);
    EXPECT_EQ(separated_by_search(pair), answer) << "case " << i;
    EXPECT_EQ(separated(pair), answer) << "case " << i;
  }
  EXPECT_GT(free, rubicon::test::at_least(500));
  EXPECT_GT(hit, rubicon::test::at_least(500));
}

TEST(Separation, PolytopesThatTouchExactlyAreFoundBySearchToo) {
  // Faces, edges and corners in contact on a lattice: where simplices degenerate.
  const BodyPtr cube = box(Vec3::Constant(0.5));
  for (int x = -4; x <= 4; ++x) {
    for (int y = -4; y <= 4; ++y) {
      for (int z = -4; z <= 4; ++z) {
        SweptPair pair;
        pair.moving = cube->convexes().front();
        pair.fixed = pair.moving;
        pair.start.t = 0.25 * Vec3(x, y, z);
        pair.end = pair.middle = pair.start;
        pair.standing = true;
        pair.tolerance = 1e-6;
        const bool apart = std::max({std::abs(x), std::abs(y), std::abs(z)}) == 4;
        EXPECT_EQ(separated_by_search(pair), apart) << x << " " << y << " " << z;
      }
    }
  }
}

}  // namespace
}  // namespace rubicon::collision::test
