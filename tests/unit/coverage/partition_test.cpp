#include <gmock/gmock.h>

#include "src/motion/coverage/cells.hpp"
#include "src/motion/coverage/hypergraph.hpp"
#include "src/motion/coverage/rectangles.hpp"
#include "src/motion/math/index.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/coverage/random_floors.hpp"

namespace rubicon::coverage {
namespace {

using math::at;
using test::cases;

std::size_t fewest(const FloorDescription& floor) {
  return fewest_rectangles(slab_rings(make_floor(floor))).size();
}

FloorDescription outlined(std::vector<Place> outline) {
  FloorDescription floor;
  floor.outline = std::move(outline);
  return floor;
}

TEST(FewestRectangles, KnownShapes) {
  EXPECT_EQ(fewest(outlined({{0, 0}, {4, 0}, {4, 3}, {0, 3}})), 1U);
  EXPECT_EQ(fewest(outlined({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}})), 2U);
  EXPECT_EQ(fewest(outlined({{1, 0},
                             {2, 0},
                             {2, 1},
                             {3, 1},
                             {3, 2},
                             {2, 2},
                             {2, 3},
                             {1, 3},
                             {1, 2},
                             {0, 2},
                             {0, 1},
                             {1, 1}})),
            3U);
  FloorDescription ring = outlined({{0, 0}, {3, 0}, {3, 3}, {0, 3}});
  ring.shafts.push_back({"", {{1, 1}, {2, 1}, {2, 2}, {1, 2}}});
  EXPECT_EQ(fewest(ring), 4U);
}

TEST(FewestRectangles, AChordBetweenCornersOnOneLineSavesOne) {
  // Two notches: on one line a chord joins them, else each costs a cut of its own.
  EXPECT_EQ(fewest(outlined({{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}})), 3U);
  const auto floor = [](double right) {
    return outlined({{0, 0}, {6, 0}, {6, right}, {5, right}, {5, 4}, {1, 4}, {1, 2}, {0, 2}});
  };
  EXPECT_EQ(fewest(floor(2)), 2U);
  EXPECT_EQ(fewest(floor(3)), 3U);
}

void expect_parted(const std::vector<Box>& boxes, std::int64_t twice_area_of_floor) {
  std::int64_t area = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    area += boxes[i].width() * boxes[i].height();
    for (std::size_t j = 0; j < i; ++j) ASSERT_FALSE(boxes[i].overlaps(boxes[j]));
  }
  ASSERT_EQ(2 * area, twice_area_of_floor);
}

TEST(FewestRectangles, AreAsFewAsTryingAllFinds) {
  FloorRandom random(1);
  for (int i = 0; i < cases(1000); ++i) {
    const Chequer chequer = random_chequer(random, 2 + random.below(4), 2 + random.below(4), 5);
    const Floor floor = make_floor(floor_of(chequer));
    const std::vector<Box> boxes = fewest_rectangles(slab_rings(floor));
    ASSERT_EQ(static_cast<int>(boxes.size()), fewest_by_trying(chequer)) << "case " << i;
    expect_parted(boxes, floor.twice_area_of_slab());
  }
}

TEST(FewestRectangles, AddUpExactlyAndAreDisjoint) {
  FloorRandom random(2);
  for (int i = 0; i < cases(1000); ++i) {
    const Floor floor =
        make_floor(floor_of(random_chequer(random, 3 + random.below(8), 3 + random.below(5), 9)));
    expect_parted(fewest_rectangles(slab_rings(floor)), floor.twice_area_of_slab());
  }
}

TEST(Doors, JoinRectanglesThatTouchAlongALine) {
  FloorRandom random(3);
  for (int i = 0; i < cases(300); ++i) {
    const Floor floor = make_floor(floor_of(random_chequer(random, 6, 5, 5)));
    const std::vector<Box> boxes = fewest_rectangles(slab_rings(floor));
    std::size_t pairs = 0;
    for (std::size_t a = 0; a < boxes.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const Box box{
            {std::max(boxes[a].low.x, boxes[b].low.x), std::max(boxes[a].low.y, boxes[b].low.y)},
            {std::min(boxes[a].high.x, boxes[b].high.x),
             std::min(boxes[a].high.y, boxes[b].high.y)}};
        pairs += box.width() >= 0 && box.height() >= 0 && box.width() + box.height() > 0;
      }
    }
    const std::vector<Door> doors = doors_between(boxes);
    ASSERT_EQ(doors.size(), pairs);
    // The floor is connected, so is the graph.
    std::vector<int> part(boxes.size());
    for (std::size_t k = 0; k < part.size(); ++k) part[k] = static_cast<int>(k);
    const auto root = [&](int k) {
      while (part[at(k)] != k) k = part[at(k)];
      return k;
    };
    for (const Door& door : doors) part[at(root(door.a))] = root(door.b);
    for (std::size_t k = 0; k < part.size(); ++k) ASSERT_EQ(root(static_cast<int>(k)), root(0));
  }
}

TEST(CellsBySweep, OfOrthogonalFloorsAreRectanglesThatAddUp) {
  FloorRandom random(4);
  for (int i = 0; i < cases(1000); ++i) {
    const Floor floor = make_floor(floor_of(random_chequer(random, 6, 5, 5)));
    std::vector<Box> boxes;
    for (const Cell& cell : cells_by_sweep(slab_rings(floor)).cells) {
      ASSERT_TRUE(cell.is_rectangle());
      boxes.push_back(box_of(cell.ring()));
    }
    expect_parted(boxes, floor.twice_area_of_slab());
  }
}

/// Each edge of the floor is a side of cells that follow each other without gap: then the areas
/// between the sides, as fractions, add up to that of the floor.
void expect_sides_whole(const std::vector<Ring>& rings, const CellGraph& graph) {
  std::map<std::pair<Point, Point>, std::vector<std::pair<std::int64_t, std::int64_t>>> used;
  for (const Cell& cell : graph.cells) {
    ASSERT_LT(cell.bottom, cell.top);
    for (const auto* chain : {&cell.left, &cell.right}) {
      std::int64_t y = cell.bottom;
      for (const Side& side : *chain) {
        const std::int64_t end = std::min(side.high.y, cell.top);
        ASSERT_LE(side.low.y, y);
        ASSERT_LT(y, end);
        used[{side.low, side.high}].emplace_back(y, end);
        y = end;
      }
      ASSERT_EQ(y, cell.top);
    }
    for (const std::int64_t y : {cell.bottom + 1, (cell.bottom + cell.top) / 2, cell.top - 1}) {
      ASSERT_LE(cell.left_at(y), cell.right_at(y) + 2);
    }
  }
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& a = ring[i];
      const Point& b = next_corner(ring, i);
      if (a.y == b.y) continue;
      auto ranges = a.y < b.y ? used[{a, b}] : used[{b, a}];
      std::sort(ranges.begin(), ranges.end());
      std::int64_t y = std::min(a.y, b.y);
      for (const auto& [low, high] : ranges) {
        ASSERT_EQ(low, y);
        y = high;
      }
      ASSERT_EQ(y, std::max(a.y, b.y));
    }
  }
}

TEST(CellsBySweep, UseEverySideOfAnyFloorOnce) {
  FloorRandom random(5);
  for (int i = 0; i < cases(1000); ++i) {
    const Floor floor = make_floor(random_general_floor(random, {}));
    const std::vector<Ring> rings = slab_rings(floor);
    for (const bool trapezoids : {false, true}) {
      const CellGraph graph = cells_by_sweep(rings, trapezoids);
      expect_sides_whole(rings, graph);
      double area = 0;
      for (const Cell& cell : graph.cells)
        area += 0.5 * static_cast<double>(twice_area(cell.ring()));
      const double whole = 0.5 * static_cast<double>(floor.twice_area_of_slab());
      // Corners of cells that are no corners of the floor are rounded to the grid.
      ASSERT_NEAR(area, whole, 1e-4 * whole);
    }
  }
}

TEST(CellsBySweep, AConvexFloorIsOneCell) {
  FloorDescription floor = outlined({{0, 0}, {5, 1}, {7, 4}, {3, 9}, {-1, 6}});
  const CellGraph graph = cells_by_sweep(slab_rings(make_floor(floor)));
  EXPECT_EQ(graph.cells.size(), 1U);
  EXPECT_TRUE(graph.doors.empty());
  floor.shafts.push_back({"", {{2, 4}, {3, 3}, {4, 4}, {3, 5}}});
  const CellGraph parted = cells_by_sweep(slab_rings(make_floor(floor)));
  EXPECT_EQ(parted.cells.size(), 4U);
  EXPECT_EQ(parted.doors.size(), 4U);
}

FloorDescription beamed() {
  FloorDescription floor = outlined({{0, 0}, {12, 0}, {12, 8}, {0, 8}});
  floor.shafts.push_back({"", {{7, 5}, {8, 5}, {8, 6}, {7, 6}}});
  floor.columns = {{"", {6, 4}, 0.5, false}, {"", {3, 2}, 0.5, true}};
  floor.beams = {{"", {0, 4}, {12, 4}}, {"", {6, 0}, {6, 8}}, {"", {1, 6}, {2, 6}}};
  return floor;
}

TEST(HypergraphOfBeams, HasFacesPiecesAndNeighbours) {
  const Hypergraph graph = hypergraph_of(make_floor(beamed()), 0.25);
  ASSERT_EQ(graph.faces.size(), 4U);
  std::int64_t area = 0;
  std::size_t islands = 0;
  for (const SlabFace& face : graph.faces) {
    area += twice_area(face.outline);
    for (const Ring& island : face.islands) area += twice_area(island);
    islands += face.islands.size();
  }
  EXPECT_EQ(area, make_floor(beamed()).twice_area_of_slab());
  EXPECT_EQ(islands, 1U);
  ASSERT_EQ(graph.beams.size(), 3U);
  EXPECT_EQ(graph.beams[0].pieces.size(), 2U);
  EXPECT_EQ(graph.beams[2].pieces.size(), 1U);
  const Point middle = snap({6, 4});
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    if (graph.nodes[i] != middle) continue;
    const auto& next = graph.neighbours[i];
    EXPECT_EQ(graph.nodes[at(next[0])], snap({12, 4}));
    EXPECT_EQ(graph.nodes[at(next[1])], snap({6, 8}));
    EXPECT_EQ(graph.nodes[at(next[2])], snap({0, 4}));
    EXPECT_EQ(graph.nodes[at(next[3])], snap({6, 0}));
  }
  int obstructed = 0;
  for (const BeamPiece& piece : graph.pieces) {
    if (piece.columns.empty()) continue;
    ++obstructed;
    EXPECT_EQ(piece.columns, std::vector<int>{0});
  }
  EXPECT_EQ(obstructed, 4);
}

TEST(HypergraphOfBeams, RefusesWhatIsNotOrthogonal) {
  EXPECT_THROW(hypergraph_of(make_floor(outlined({{0, 0}, {4, 0}, {2, 3}})), 0),
               std::invalid_argument);
}

TEST(HypergraphOfBeams, FacesAddUpWhateverTheBeams) {
  FloorRandom random(6);
  for (int i = 0; i < cases(1000); ++i) {
    const Chequer chequer = random_chequer(random, 4, 4, 5);
    FloorDescription description = floor_of(chequer);
    for (int k = random.below(6); k > 0; --k) {
      const double level = random.between(-1, 18);
      const double from = random.between(-1, 10);
      const double to = random.between(11, 20);
      if (random.below(2) == 0) {
        description.beams.push_back({"", {from, level}, {to, level}});
      } else {
        description.beams.push_back({"", {level, from}, {level, to}});
      }
    }
    const Floor floor = make_floor(description);
    const Hypergraph graph = hypergraph_of(floor, 0);
    std::int64_t area = 0;
    std::vector<Box> boxes;
    for (const SlabFace& face : graph.faces) {
      std::vector<Ring> rings{face.outline};
      rings.insert(rings.end(), face.islands.begin(), face.islands.end());
      for (const Ring& ring : rings) area += twice_area(ring);
      for (const Box& box : fewest_rectangles(rings)) boxes.push_back(box);
    }
    ASSERT_EQ(area, floor.twice_area_of_slab()) << "case " << i;
    expect_parted(boxes, floor.twice_area_of_slab());
  }
}

}  // namespace
}  // namespace rubicon::coverage
