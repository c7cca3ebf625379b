#include <gtest/gtest.h>

#include <cmath>

#include "src/motion/travel/travel.hpp"
#include "tests/unit/travel/travel_worlds.hpp"

namespace rubicon::travel {
namespace {

TravelSettings seeing(double vision, double stride = 0.25) {
  TravelSettings settings;
  settings.vision = vision;
  settings.stride = stride;
  return settings;
}

TEST(VisBug, TheFurtherItSeesTheShorterItsWay) {
  const TravelQuery of_box = query_of({box(-10, 0, 20, 10)}, {0, -20}, {0, 30});
  const TravelQuery of_u = query_of({u_shape(-10, 0, 20, 20, 3)}, {0, -30}, {0, 40});
  const double visions[] = {2, 10, 40};
  const double box_lengths[] = {67.7, 57.9, 55.0};
  const double u_lengths[] = {120.4, 97.0, 74.8};
  for (int i = 0; i < 3; ++i) {
    const TravelResult round_box = travel(Method::kVisBug21, of_box, seeing(visions[i]));
    EXPECT_EQ(round_box.verdict, Verdict::kReached) << told(round_box);
    EXPECT_NEAR(round_box.length, box_lengths[i], 0.5);
    const TravelResult round_u = travel(Method::kVisBug21, of_u, seeing(visions[i]));
    EXPECT_EQ(round_u.verdict, Verdict::kReached) << told(round_u);
    EXPECT_NEAR(round_u.length, u_lengths[i], 0.5);
  }
}

TEST(VisBug, ADestinationInABoxIsUnreachable) {
  const TravelResult result =
      travel(Method::kVisBug21, query_of({box(-10, 0, 20, 10)}, {0, -40}, {0, 5}), seeing(10));
  EXPECT_EQ(result.verdict, Verdict::kUnreachable);
}

TEST(VisBug, StartsOnACornerAsItStartsBesideIt) {
  const double shortest = 4 + 2 * std::sqrt(10);
  for (const Vec2& start : {Vec2(0, 0), Vec2(-0.001, -0.001)}) {
    const TravelResult result =
        travel(Method::kVisBug21, query_of({box(0, 0, 4, 4)}, start, {6, 6}), seeing(10));
    EXPECT_EQ(result.verdict, Verdict::kReached);
    EXPECT_GT(result.length, shortest - 1e-9) << told(result);
    EXPECT_LT(result.length, shortest + 2) << told(result);
  }
}

TEST(VisBug, DecidesLikeBug2WithAShorterWay) {
  TestRandom random(41);
  double bug2_sum = 0;
  double sums[2] = {0, 0};
  for (int i = 0; i < cases(1000); ++i) {
    SCOPED_TRACE(i);
    const auto world = random_world(random, static_cast<WorldKind>(i % 4), random.whole(3, 20), 20);
    const Vec2 start(random.whole(-30, 30), -40);
    const TravelQuery query =
        query_of(world, start, Vec2(random.whole(-25, 25), random.whole(-25, 45)));
    const TravelResult bug2 = travel(Method::kBug2, query);
    for (int k = 0; k < 2; ++k) {
      const TravelResult result = travel(Method::kVisBug21, query, seeing(k == 0 ? 5 : 40, 0.5));
      EXPECT_EQ(result.verdict, bug2.verdict) << told(result) << " | " << told(bug2);
      if (bug2.verdict == Verdict::kReached) sums[k] += result.length;
    }
    if (bug2.verdict == Verdict::kReached) bug2_sum += bug2.length;
  }
  EXPECT_LE(sums[0], bug2_sum);
  EXPECT_LE(sums[1], 0.95 * bug2_sum);
  RecordProperty("share_5_m", std::to_string(sums[0] / bug2_sum));
  RecordProperty("share_40_m", std::to_string(sums[1] / bug2_sum));
}

}  // namespace
}  // namespace rubicon::travel
