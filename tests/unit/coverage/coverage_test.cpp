#include "src/motion/coverage/coverage.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "src/motion/math/angles.hpp"
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

TEST(Coverage, FinishesCellsWhereThatIsAsked) {
  CoverageOptions options = tool(1, 0.25);
  options.whole_cells = true;
  const CoverageWay way = plan_coverage(anchor(), options);
  EXPECT_EQ(measure(anchor(), options, way.points).coverage, 1);
  std::vector<int> visited;
  for (const CoverageLine& line : way.lines) {
    if (visited.empty() || visited.back() != line.cell) visited.push_back(line.cell);
  }
  EXPECT_EQ(visited, way.order);
  EXPECT_EQ(way.order.size(), way.cells.size());
}

TEST(Coverage, BeginsWhereItIsTold) {
  CoverageOptions options = tool(1, 0.25);
  options.from = Place{17, 3};
  const CoverageWay way = plan_coverage(anchor(), options);
  EXPECT_EQ(way.points[0].place.x, 17);
  EXPECT_EQ(way.points[0].place.y, 3);
  EXPECT_EQ(measure(anchor(), options, way.points).coverage, 1);
  options.from.reset();
  options.inlet = Place{0, 0};
  const Place far = plan_coverage(anchor(), options).points[0].place;
  EXPECT_GT(far.x + far.y, 30);
}

TEST(Coverage, OfBeamsHasACellForEveryRectangle) {
  FloorDescription floor = anchor();
  floor.beams = {{"", {20, 0}, {20, 20}}};
  CoverageOptions options = tool(1, 0.25);
  options.partition = Partition::kBeams;
  const CoverageWay way = plan_coverage(floor, options);
  double area = 0;
  for (const CoverageCell& cell : way.cells) area += cell.area;
  EXPECT_NEAR(area, 800 - 9 - 12.5, 1e-9);
  EXPECT_EQ(way.cells.size(), 8U);
  EXPECT_GT(measure(floor, options, way.points).coverage, 0.999);
  EXPECT_EQ(way.hypergraph.faces.size(), 2U);
  floor.outline[0] = {1, 1};
  floor.outline[1] = {39, 0};
  EXPECT_THROW(plan_coverage(floor, options), std::invalid_argument);
}

TEST(Coverage, IsTheSameEveryTime) {
  const CoverageOptions options = tool(1, 0.25);
  const CoverageWay first = plan_coverage(anchor(), options);
  const CoverageWay second = plan_coverage(anchor(), options);
  ASSERT_EQ(first.points.size(), second.points.size());
  for (std::size_t i = 0; i < first.points.size(); ++i) {
    EXPECT_EQ(first.points[i].place.x, second.points[i].place.x);
    EXPECT_EQ(first.points[i].place.y, second.points[i].place.y);
  }
}

TEST(Coverage, OfAFloorTheToolCannotEnterIsEmpty) {
  FloorDescription floor;
  floor.outline = box(0, 0, 1, 1);
  floor.columns = {{"", {0.5, 0.5}, 0.5, false}};
  const CoverageWay way = plan_coverage(floor, tool(1, 0.5));
  EXPECT_TRUE(way.points.empty());
}

TEST(Measure, SeesWaysThroughHolesAndOutside) {
  const std::vector<WayPoint> way{{{9, 6.5}, 0, true}, {{14, 6.5}, 0, true}, {{14, -2}, 0, false}};
  const Measures measures = measure(anchor(), tool(1, 0.25), way);
  EXPECT_NEAR(measures.inside_holes, 3.5, 0.002);
  EXPECT_NEAR(measures.outside, 2, 0.002);
  EXPECT_NEAR(measures.length, 13.5, 1e-9);
  EXPECT_NEAR(measures.coverage * 777, 2, 0.01);
  EXPECT_EQ(measures.turns, 1);
}

TEST(Coverage, OfTenFloorsStaysNearItsBound) {
  const std::vector<FloorCase> floors = ten_floors();
  const CoverageOptions options = tool(1, 0.25);
  for (std::size_t i = 0; i < floors.size(); ++i) {
    const CoverageWay way = plan_coverage(floors[i].floor, options);
    const Measures measures = measure(floors[i].floor, options, way.points);
    EXPECT_GT(measures.coverage, 0.9995) << i;
    EXPECT_EQ(measures.inside_holes, 0) << i;
    EXPECT_EQ(measures.outside, 0) << i;
    EXPECT_LE(measures.length, floors[i].most * measures.lower_bound) << i;
    RecordProperty("floor_" + std::to_string(i + 1),
                   std::to_string(measures.length) + " of " + std::to_string(measures.lower_bound) +
                       ", coverage " + std::to_string(measures.coverage));
  }
}

/// What must hold of every way, whatever the floor. Returns its measures.
Measures expect_sound(const FloorDescription& floor, const CoverageOptions& options,
                      const CoverageWay& way) {
  const Measures measures = measure(floor, options, way.points);
  EXPECT_EQ(measures.inside_holes, 0);
  EXPECT_EQ(measures.outside, 0);
  EXPECT_GE(measures.length, measures.coverage * measures.lower_bound - 1e-3 * measures.length);
  EXPECT_EQ(std::set<int>(way.order.begin(), way.order.end()).size(), way.order.size());
  std::set<int> worked;
  for (const CoverageLine& line : way.lines) worked.insert(line.cell);
  EXPECT_EQ(worked.size(), way.order.size());
  return measures;
}

/// Coverage over random floors; of those without parts that no way leads to.
struct Shares {
  double least = 1;
  double sum = 0;
  int whole = 0;
  int count = 0;
};

template <typename MakeFloor>
Shares random_shares(std::uint32_t seed, const MakeFloor& make) {
  FloorRandom random(seed);
  Shares shares;
  for (int i = 0; i < cases(1000); ++i) {
    CoverageOptions options = tool(random.between(0.4, 1.5), random.between(0, 0.2));
    options.whole_cells = i % 3 == 0;
    options.tries = 5;
    const FloorDescription floor = make(random, options);
    const CoverageWay way = plan_coverage(floor, options);
    const Measures measures = expect_sound(floor, options, way);
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << "case " << i;
      break;
    }
    if (way.cut_off > 0) continue;
    shares.least = std::min(shares.least, measures.coverage);
    shares.sum += measures.coverage;
    shares.whole += measures.coverage > 0.99999 ? 1 : 0;
    ++shares.count;
  }
  testing::Test::RecordProperty("least", std::to_string(shares.least));
  testing::Test::RecordProperty("mean", std::to_string(shares.sum / shares.count));
  testing::Test::RecordProperty("whole", shares.whole);
  testing::Test::RecordProperty("count", shares.count);
  return shares;
}

TEST(Coverage, OfRandomOrthogonalFloors) {
  const Shares shares = random_shares(11, random_orthogonal_floor);
  EXPECT_GT(shares.least, 0.99);
  EXPECT_GT(shares.sum, 0.9999 * shares.count);
  EXPECT_GT(shares.whole, 0.9 * shares.count);
}

TEST(Coverage, OfRandomGeneralFloors) {
  const Shares shares = random_shares(12, random_general_floor);
  EXPECT_GT(shares.least, 0.98);
  EXPECT_GT(shares.sum, 0.999 * shares.count);
}

/// The distance, the larger of those in x and in y, of a place from a segment.
double square_distance(const Place& p, const Place& a, const Place& b) {
  const double ax = a.x - p.x;
  const double ay = a.y - p.y;
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  double least = 1e9;
  const auto ask = [&](double share) {
    share = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0;
    least = std::min(least, std::max(std::abs(ax + share * dx), std::abs(ay + share * dy)));
  };
  for (const double share :
       {0.0, 1.0, -ax / dx, -ay / dy, (ay - ax) / (dx - dy), -(ax + ay) / (dx + dy)}) {
    ask(share);
  }
  return least;
}

/// How many of the random places of a floor lie farther than width/2 from every line at work, in
/// the directions along and across the lines; what round columns stand on is left out.
template <typename MakeFloor>
int places_left_out(std::uint32_t seed, const MakeFloor& make) {
  FloorRandom random(seed);
  int missed = 0;
  for (int i = 0; i < cases(1000); ++i) {
    CoverageOptions options = tool(random.between(0.5, 1.5), random.between(0, 0.2));
    options.tries = 0;
    options.lines = LineRule::kFewestTurns;
    FloorDescription floor = make(random, options);
    std::erase_if(floor.columns, [](const ColumnDescription& column) { return column.round; });
    const CoverageWay way = plan_coverage(floor, options);
    if (way.cut_off > 0) continue;
    const double c = math::cos_deg(way.direction_deg);
    const double s = math::sin_deg(way.direction_deg);
    const auto turned = [&](const Place& p) { return Place{c * p.x + s * p.y, c * p.y - s * p.x}; };
    const Floor snapped = make_floor(floor, options);
    const Box around = box_of(snapped.outline);
    for (int k = 0; k < 60; ++k) {
      const Place place{random.between(in_metres(around.low.x), in_metres(around.high.x)),
                        random.between(in_metres(around.low.y), in_metres(around.high.y))};
      bool is_floor = place_in(snapped.outline, snap(place)) > 0;
      for (const Hole& hole : snapped.holes) {
        is_floor = is_floor && place_in(hole.ring, snap(place)) < 0;
      }
      if (!is_floor) continue;
      double least = 1e9;
      for (std::size_t n = 1; n < way.points.size(); ++n) {
        if (!way.points[n].working) continue;
        least = std::min(least, square_distance(turned(place), turned(way.points[n - 1].place),
                                                turned(way.points[n].place)));
      }
      if (least > options.width / 2 + kMeasureTolerance) ++missed;
    }
  }
  return missed;
}

TEST(Coverage, EveryPlaceIsNearALineAtWork) {
  EXPECT_EQ(places_left_out(21, random_orthogonal_floor), 0);
  EXPECT_EQ(places_left_out(22, random_general_floor), 0);
}

}  // namespace
}  // namespace rubicon::coverage
