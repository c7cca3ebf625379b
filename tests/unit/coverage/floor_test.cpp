#include "src/motion/coverage/floor.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "tests/unit/coverage/random_floors.hpp"

namespace rubicon::coverage {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

FloorDescription slab() {
  FloorDescription floor;
  floor.outline = box(0, 0, 40, 20);
  floor.shafts = {{"lift", box(10, 5, 13, 8)}, {"", box(25, 10, 27.5, 15)}};
  floor.columns = {{"", {20, 10}, 0.5, false}, {"C2", {30, 5}, 0.5, true}};
  return floor;
}

TEST(FloorFaults, AFloorWithShaftsAndColumnsHasNone) {
  EXPECT_THAT(faults_of(slab(), {}), IsEmpty());
  const Floor floor = make_floor(slab());
  EXPECT_EQ(floor.holes.size(), 4U);
  EXPECT_EQ(floor.twice_area_of_slab(),
            2 * (800 - 9) * kUnitsPerMetre * kUnitsPerMetre - 25 * kUnitsPerMetre * kUnitsPerMetre);
}

TEST(FloorFaults, NumbersAreFiniteAndSmallEnough) {
  FloorDescription floor = slab();
  floor.outline[2].x = std::nan("");
  floor.columns[1].centre.y = 1e9;
  CoverageOptions options;
  options.width = 0;
  options.clearance = -1;
  EXPECT_THAT(
      faults_of(floor, options),
      ElementsAre("the width of the tool is 0 m; it must be 1 mm or more",
                  "the clearance is -1 m; it must be 0 or more",
                  "corner 3 of the outline is (nan, 20); places are numbers within 10000 m of the "
                  "origin",
                  "column 'C2' stands at (30, 1000000000); places are numbers within 10000 m of "
                  "the origin"));
  options.width = std::numeric_limits<double>::infinity();
  EXPECT_EQ(faults_of(slab(), options).size(), 2U);
  options.width = std::nan("");
  EXPECT_EQ(faults_of(slab(), options).size(), 2U);
}

TEST(FloorFaults, PolygonsHaveThreeCornersAndDoNotCross) {
  FloorDescription floor = slab();
  floor.outline = {{0, 0}, {40, 0}};
  EXPECT_THAT(faults_of(floor, {}),
              ElementsAre("the outline has 2 corners; a polygon has 3 or more"));
  floor.outline = {{0, 0}, {40, 0}, {40, 0.00001}, {0, 0}};
  EXPECT_THAT(
      faults_of(floor, {}),
      ElementsAre("the outline has 2 corners that are 0.1 mm apart; a polygon has 3 or more"));
  floor.outline = {{0, 0}, {40, 20}, {40, 0}, {0, 20}};
  EXPECT_THAT(faults_of(floor, {}),
              ElementsAre("the outline crosses itself: its edge from corner 1 to 2 meets that from "
                          "corner 3 to 4"));
  floor.outline = {{0, 0}, {40, 0}, {40, 20}, {50, 20}, {30, 20}, {0, 20}};
  EXPECT_THAT(faults_of(floor, {}),
              ElementsAre("the outline crosses itself: its edge from corner 2 to 3 meets that from "
                          "corner 4 to 5"));
  floor = slab();
  floor.shafts[1].corners = {{25, 10}, {26, 10}, {27, 10}};
  EXPECT_THAT(faults_of(floor, {}),
              ElementsAre("shaft 2 crosses itself: its edge from corner 1 to 2 meets that from "
                          "corner 3 to 1"));
}

TEST(FloorFaults, ShaftsLieInsideAndApart) {
  FloorDescription floor = slab();
  floor.shafts.push_back({"", box(50, 5, 53, 8)});
  floor.shafts.push_back({"", box(0, 5, 3, 8)});
  floor.shafts.push_back({"", box(11, 6, 12, 7)});
  floor.shafts.push_back({"", box(27.5, 15, 28, 16)});
  EXPECT_THAT(faults_of(floor, {}), ElementsAre("shaft 3 lies outside the outline",
                                                "shaft 4 touches or crosses the outline",
                                                "shaft 'lift' and shaft 5 touch or overlap",
                                                "shaft 2 and shaft 6 touch or overlap"));
}

TEST(FloorFaults, ColumnsStandInside) {
  FloorDescription floor = slab();
  floor.columns = {{"", {0.25, 10}, 0.5, false}, {"", {0.2, 12}, 0.5, false},
                   {"", {41, 12}, 0.5, true},    {"", {11, 6}, 0.5, true},
                   {"", {9.8, 6}, 0.5, false},   {"", {20, 10}, 1, false},
                   {"", {20.9, 10}, 1, true},    {"", {5, 5}, 0, true}};
  floor.columns.pop_back();
  EXPECT_THAT(
      faults_of(floor, {}),
      ElementsAre("column 2 at (0.2, 12) does not stand wholly inside the outline",
                  "column 3 at (41, 12) does not stand wholly inside the outline",
                  "column 4 at (11, 6) stands in shaft 'lift'",
                  "column 5 at (9.8, 6) stands in shaft 'lift'", "column 6 and column 7 overlap"));
  floor.columns = {{"", {5, 5}, 0, true}};
  EXPECT_THAT(faults_of(floor, {}),
              ElementsAre("column 1 has a size of 0 m; it must be 1 mm or more"));
}

TEST(FloorFaults, StartAndInletLieInNoShaft) {
  CoverageOptions options;
  options.clearance = 0.25;
  options.from = Place{9.8, 6};
  options.inlet = Place{11, 6};
  EXPECT_THAT(faults_of(slab(), options),
              ElementsAre("the start (9.8, 6) lies within the clearance of shaft 'lift'",
                          "the inlet (11, 6) lies in shaft 'lift'"));
  options.from = Place{-1, 6};
  options.inlet = Place{-1, 6};
  EXPECT_THAT(faults_of(slab(), options),
              ElementsAre("the start (-1, 6) lies outside the outline"));
  options.from = Place{20, 10};
  EXPECT_THAT(faults_of(slab(), options), ElementsAre("the start (20, 10) lies in column 1"));
  options.from = Place{9.75, 6};
  EXPECT_THAT(faults_of(slab(), options), IsEmpty());
}

TEST(FloorFaults, BeamsThatPartAFloorAreParallelToAnAxis) {
  FloorDescription floor = slab();
  floor.beams = {{"", {0, 10}, {40, 10}}, {"B2", {0, 0}, {40, 20}}, {"", {1, 1}, {1, 1}}};
  EXPECT_THAT(faults_of(floor, {}), ElementsAre("beam 3 has no length"));
  CoverageOptions options;
  options.partition = Partition::kBeams;
  EXPECT_THAT(faults_of(floor, options),
              ElementsAre("beam 'B2' is parallel to neither x nor y: a floor cannot be parted "
                          "along it",
                          "beam 3 has no length"));
}

TEST(FloorFaults, ThrownByWhoeverMakesTheFloorAnyway) {
  EXPECT_THROW(make_floor(FloorDescription{}), std::invalid_argument);
}

}  // namespace
}  // namespace rubicon::coverage
