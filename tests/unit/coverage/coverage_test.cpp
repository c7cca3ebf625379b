#include "src/motion/coverage/coverage.hpp"

#include <gmock/gmock.h>

#include <set>

#include "src/motion/math/index.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/coverage/random_floors.hpp"

namespace rubicon::coverage {
namespace {

using math::at;
using test::cases;

/// 40 x 20 m, six columns of 0.5 m, shafts of 3 x 3 and 2.5 x 5 m: 777 m2.
FloorDescription anchor() {
  FloorDescription floor;
  floor.outline = box(0, 0, 40, 20);
  floor.shafts = {{"stairs", box(10, 5, 13, 8)}, {"lift", box(25, 10, 27.5, 15)}};
  for (const double x : {5.0, 20.0, 35.0}) {
    for (const double y : {5.0, 15.0}) floor.columns.push_back({"", {x, y}, 0.5, false});
  }
  return floor;
}

CoverageOptions tool(double width, double clearance) {
  CoverageOptions options;
  options.width = width;
  options.clearance = clearance;
  return options;
}

TEST(Coverage, OfTheAnchorSlab) {
  const CoverageOptions options = tool(1, 0.25);
  const CoverageWay way = plan_coverage(anchor(), options);
  const Measures measures = measure(anchor(), options, way.points);
  EXPECT_NEAR(measures.floor_area, 777, 1e-9);
  EXPECT_NEAR(measures.reachable_area, 777, 1e-9);
  EXPECT_EQ(measures.coverage, 1);
  EXPECT_EQ(measures.inside_holes, 0);
  EXPECT_EQ(measures.outside, 0);
  EXPECT_LE(measures.length, 824);
  EXPECT_EQ(way.cut_off, 0);
  RecordProperty("length", std::to_string(measures.length));
  RecordProperty("working", std::to_string(measures.working_length));
  RecordProperty("turns", std::to_string(measures.turns));
}

/// What must hold of every way, whatever the floor. Returns its measures.
Measures expect_sound(const FloorDescription& floor, const CoverageOptions& options,
                      const CoverageWay& way) {
  const Measures measures = measure(floor, options, way.points);
  EXPECT_EQ(measures.inside_holes, 0);
  EXPECT_EQ(measures.outside, 0);
  EXPECT_GE(measures.length, measures.coverage * measures.lower_bound - 1e-3 * measures.length);
  EXPECT_EQ(std::set<int>(way.order.begin(), way.order.end()).size(), way.order.size());
  return measures;
}

TEST(Coverage, OfRandomOrthogonalFloors) {
  FloorRandom random(11);
  double least = 1;
  double sum = 0;
  int whole = 0;
  int missed = 0;
  const int count = cases(1000);
  for (int i = 0; i < count; ++i) {
    CoverageOptions options = tool(random.between(0.4, 1.5), random.between(0, 0.2));
    options.whole_cells = i % 3 == 0;
    const FloorDescription floor = random_orthogonal_floor(random, options);
    const CoverageWay way = plan_coverage(floor, options);
    const Measures measures = expect_sound(floor, options, way);
    if (::testing::Test::HasFailure()) {
      ADD_FAILURE() << "case " << i;
      return;
    }
    if (way.cut_off > 0) {
      ++missed;
      continue;
    }
    least = std::min(least, measures.coverage);
    sum += measures.coverage;
    whole += measures.coverage > 0.99999;
  }
  RecordProperty("least", std::to_string(least));
  printf("orthogonal: least %g mean %g whole %d cut off %d\n", least, sum / (count - missed), whole,
         missed);
}

TEST(Coverage, OfRandomGeneralFloors) {
  FloorRandom random(12);
  double least = 1;
  double sum = 0;
  int missed = 0;
  const int count = cases(1000);
  for (int i = 0; i < count; ++i) {
    CoverageOptions options = tool(random.between(0.5, 1.5), random.between(0, 0.2));
    const FloorDescription floor = random_general_floor(random, options);
    const CoverageWay way = plan_coverage(floor, options);
    const Measures measures = expect_sound(floor, options, way);
    if (::testing::Test::HasFailure()) {
      ADD_FAILURE() << "case " << i;
      return;
    }
    if (way.cut_off > 0) {
      ++missed;
      continue;
    }
    least = std::min(least, measures.coverage);
    sum += measures.coverage;
  }
  printf("general: least %g mean %g cut off %d\n", least, sum / (count - missed), missed);
}

}  // namespace
}  // namespace rubicon::coverage
