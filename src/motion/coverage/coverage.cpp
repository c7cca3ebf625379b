#include "src/motion/coverage/coverage.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "src/motion/coverage/frame.hpp"
#include "src/motion/coverage/lines.hpp"
#include "src/motion/coverage/order.hpp"
#include "src/motion/coverage/rectangles.hpp"
#include "src/motion/coverage/turning.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/math/turns.hpp"

namespace rubicon::coverage {
namespace {

using math::at;

/// Up to so many lines and obstacles every direction is planned to the end.
constexpr std::int64_t kMostToCompare = 150;

bool is_orthogonal_floor(const Floor& floor) {
  for (const Ring& ring : slab_rings(floor)) {
    if (!is_orthogonal(ring)) return false;
  }
  return true;
}

/// One direction of lines, planned.
struct Draft {
  Frame frame;
  Floor floor;  ///< turned, so that lines run along x
  CellGraph cells;
  std::vector<WorkLine> lines;
  OrderResult order;
  std::vector<std::pair<Point, bool>> way;  ///< places; whether the stretch to each is worked
  double length = 0;                        ///< units
  std::optional<TurningResult> turning;     ///< with a turning radius: then this is the way
  double worked = 0;                        ///< m, of its lines
};

CellGraph cells_of(const Floor& floor, const CoverageOptions& options) {
  const std::vector<Ring> rings = slab_rings(floor);
  if (!is_orthogonal_floor(floor)) {
    if (options.partition == Partition::kBeams) hypergraph_of(floor, options.clearance);  // throws
    return cells_by_sweep(rings);
  }
  std::vector<Box> boxes;
  if (options.partition == Partition::kBeams) {
    for (const SlabFace& face : hypergraph_of(floor, options.clearance).faces) {
      std::vector<Ring> face_rings{face.outline};
      face_rings.insert(face_rings.end(), face.islands.begin(), face.islands.end());
      for (const Box& box : fewest_rectangles(face_rings)) boxes.push_back(box);
    }
  } else {
    boxes = fewest_rectangles(rings);
  }
  CellGraph graph;
  for (const Box& box : boxes) graph.cells.push_back(cell_of(box));
  graph.doors = doors_between(boxes);
  return graph;
}

/// The way of a machine that turns with a radius, over lines that are in the order of their cells.
void turn(Draft& draft, const CoverageOptions& options, const FreeSpace& space, int tries) {
  std::vector<WorkLine> lines;
  for (const int cell : draft.order.cells) {
    for (const WorkLine& line : draft.lines) {
      if (line.cell == cell) lines.push_back(line);
    }
  }
  TurningQuery query;
  query.lines = &lines;
  query.cells = &draft.cells.cells;
  query.space = &space;
  query.width = in_units(options.width);
  query.radius = options.turn_radius;
  query.tries = tries;
  if (options.from) query.from = draft.frame.turned(*options.from);
  if (options.inlet) query.inlet = draft.frame.turned(*options.inlet);
  draft.turning = plan_turning(query);
  draft.length = draft.turning->length * static_cast<double>(kUnitsPerMetre);
  draft.worked = 0;
  for (const WorkLine& line : draft.turning->lines) {
    draft.worked += in_metres(1) * distance(line.points.front(), line.points.back());
  }
}

/// Whether of two drafts this one is to be taken: the one that leaves out less, else the shorter.
bool is_better(const Draft& draft, const Draft& other) {
  constexpr double kAsMuch = 0.99;
  if (draft.turning) {
    if (draft.worked < kAsMuch * other.worked) return false;
    return other.worked < kAsMuch * draft.worked || draft.length < other.length;
  }
  return std::pair(draft.order.cut_off, draft.length) <
         std::pair(other.order.cut_off, other.length);
}

/// Lines, order and way of a draft that has its cells.
void finish(Draft& draft, const CoverageOptions& options, int tries) {
  draft.way.clear();
  draft.length = 0;
  const FreeSpace space(draft.floor, options.clearance);
  draft.lines = lines_of(draft.cells.cells, draft.floor.outline, space, in_units(options.width));
  OrderQuery query;
  query.lines = &draft.lines;
  query.cell_count = draft.cells.cells.size();
  query.space = &space;
  query.rule = options.order;
  query.whole_cells = options.whole_cells;
  query.tries = tries;
  if (options.from) query.from = draft.frame.turned(*options.from);
  if (options.inlet) query.inlet = draft.frame.turned(*options.inlet);
  draft.order = order_lines(query);
  if (options.turn_radius > 0) return turn(draft, options, space, tries);
  if (query.from) draft.way.emplace_back(*query.from, false);
  const auto go = [&](const Point& p, bool working) {
    if (!draft.way.empty()) {
      if (draft.way.back().first == p) return;
      draft.length += distance(draft.way.back().first, p);
    }
    draft.way.emplace_back(p, working);
  };
  for (const DirectedLine& directed : draft.order.lines) {
    std::vector<Point> points = draft.lines[at(directed.line)].points;
    if (directed.reversed) std::reverse(points.begin(), points.end());
    if (!draft.way.empty()) {
      const Point here = draft.way.back().first;
      for (const Point& p : space.shortest_way(here, points.front())) go(p, false);
    }
    go(points.front(), false);
    for (std::size_t i = 1; i < points.size(); ++i) go(points[i], true);
  }
}

/// Directions that lines may well run in: the axes, and along and across the longest edge.
std::vector<Frame> likely_frames(const Floor& floor, const CoverageOptions& options) {
  if (options.lines == LineRule::kAlongX) return {Frame::of_quarter(0)};
  if (options.lines == LineRule::kAlongY) return {Frame::of_quarter(1)};
  std::vector<Frame> frames{Frame::of_quarter(0), Frame::of_quarter(1)};
  if (is_orthogonal_floor(floor) || options.partition == Partition::kBeams) return frames;
  double longest = 0;
  Point direction{1, 0};
  for (std::size_t i = 0; i < floor.outline.size(); ++i) {
    const Point& a = floor.outline[i];
    const Point& b = next_corner(floor.outline, i);
    if (distance(a, b) <= longest) continue;
    longest = distance(a, b);
    direction = {b.x - a.x, b.y - a.y};
  }
  if (direction.x == 0 || direction.y == 0) return frames;
  frames.push_back(Frame::along(direction));
  frames.push_back(Frame::along({-direction.y, direction.x}));
  return frames;
}

Draft best_draft(const Floor& floor, const CoverageOptions& options) {
  std::vector<Draft> drafts;
  std::vector<std::int64_t> counts;
  for (const Frame& frame : likely_frames(floor, options)) {
    Draft draft;
    draft.frame = frame;
    draft.floor = frame.turned(floor);
    if (!frame.is_exact() && !is_sound(draft.floor)) continue;  // turned, corners fall together
    draft.cells = cells_of(draft.floor, options);
    counts.push_back(count_lines(draft.cells.cells, in_units(options.width)));
    drafts.push_back(std::move(draft));
  }
  const auto fewest =
      static_cast<std::size_t>(std::min_element(counts.begin(), counts.end()) - counts.begin());
  if (options.lines == LineRule::kFewestTurns ||
      counts[fewest] + static_cast<std::int64_t>(floor.holes.size()) > kMostToCompare) {
    finish(drafts[fewest], options, options.tries);
    return std::move(drafts[fewest]);
  }
  std::size_t best = drafts.size();
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    if (counts[i] > 2 * counts[fewest] + 20) continue;
    finish(drafts[i], options, 0);
    if (best == drafts.size() || is_better(drafts[i], drafts[best])) best = i;
  }
  if (options.tries > 0 && drafts[best].lines.size() <= kMostLinesForTries) {
    finish(drafts[best], options, options.tries);
  }
  return std::move(drafts[best]);
}

/// In the plan view, each place with the heading of the way there.
void add_turning_way(const Draft& draft, CoverageWay& result) {
  const TurningResult& turning = *draft.turning;
  const Place x = draft.frame.back({kUnitsPerMetre, 0});
  const double turned_deg = math::atan2_deg(x.y, x.x);
  result.cut_off += turning.cut_off;
  result.arcs = {turning.length, turning.turns};
  for (const WorkLine& line : turning.lines) {
    CoverageLine drawn{line.cell, line.is_pass, {}};
    for (const Point& p : line.points) drawn.points.push_back(draft.frame.back(p));
    result.lines.push_back(std::move(drawn));
  }
  for (const TurningPoint& each : turning.points) {
    result.points.push_back({draft.frame.back(snap(each.at.place)),
                             math::normalised_deg(each.at.heading_deg + turned_deg), each.working});
  }
  if (result.points.size() > 1) result.points[0].working = result.points[1].working;
}

}  // namespace

CoverageWay plan_coverage(const FloorDescription& description, const CoverageOptions& options) {
  const Floor floor = make_floor(description, options);
  const Draft draft = best_draft(floor, options);
  CoverageWay result;
  result.direction_deg = draft.frame.direction_deg();
  if (is_orthogonal_floor(floor)) {
    Floor drawn = floor;
    std::erase_if(drawn.beams, [](const BeamLine& beam) {
      return beam.from.x != beam.to.x && beam.from.y != beam.to.y;
    });
    result.hypergraph = hypergraph_of(drawn, options.clearance);
  }
  for (const Cell& cell : draft.cells.cells) {
    CoverageCell drawn;
    const Ring ring = cell.ring();
    for (const Point& p : ring) drawn.outline.push_back(draft.frame.back(p));
    constexpr double kUnit = 1.0 / static_cast<double>(kUnitsPerMetre);
    drawn.area = 0.5 * static_cast<double>(twice_area(ring)) * kUnit * kUnit;
    result.cells.push_back(std::move(drawn));
  }
  const FreeSpace columns(draft.floor, options.clearance);
  for (const Door& door : draft.cells.doors) {
    CoverageDoor drawn{door.a, door.b, draft.frame.back(door.from), draft.frame.back(door.to), {}};
    columns.for_each_near(box_of(door.from, door.to), [&](int item) {
      const Obstacle& obstacle = columns.obstacles()[at(item)];
      const Hole& hole = draft.floor.holes[at(obstacle.hole)];
      if (hole.is_shaft || !enters_convex(obstacle.grown, door.from, door.to)) return;
      drawn.columns.push_back(hole.number);
    });
    std::sort(drawn.columns.begin(), drawn.columns.end());
    drawn.columns.erase(std::unique(drawn.columns.begin(), drawn.columns.end()),
                        drawn.columns.end());
    result.doors.push_back(std::move(drawn));
  }
  result.order = draft.order.cells;
  result.cut_off = draft.order.cut_off;
  if (draft.turning) {
    add_turning_way(draft, result);
    return result;
  }
  for (const DirectedLine& directed : draft.order.lines) {
    const WorkLine& line = draft.lines[at(directed.line)];
    CoverageLine drawn{line.cell, line.is_pass, {}};
    for (const Point& p : line.points) drawn.points.push_back(draft.frame.back(p));
    if (directed.reversed) std::reverse(drawn.points.begin(), drawn.points.end());
    result.lines.push_back(std::move(drawn));
  }
  for (const auto& [point, working] : draft.way) {
    result.points.push_back({draft.frame.back(point), 0, working});
  }
  for (std::size_t i = 1; i < result.points.size(); ++i) {
    const Place& a = result.points[i - 1].place;
    const Place& b = result.points[i].place;
    result.points[i].heading_deg = math::atan2_deg(b.y - a.y, b.x - a.x);
  }
  if (result.points.size() > 1) {
    result.points[0].heading_deg = result.points[1].heading_deg;
    result.points[0].working = result.points[1].working;
  }
  return result;
}

}  // namespace rubicon::coverage
