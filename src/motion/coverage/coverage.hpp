#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/motion/coverage/floor.hpp"
#include "src/motion/coverage/hypergraph.hpp"
#include "src/motion/coverage/measure.hpp"

namespace rubicon::coverage {

/// A cell of the partition, as it is drawn.
struct CoverageCell {
  std::vector<Place> outline;  ///< m, counter-clockwise
  double area = 0;             ///< m2
};

/// Two cells that touch, along which line, and which columns, grown, obstruct it.
struct CoverageDoor {
  int a = 0;
  int b = 0;
  Place from;
  Place to;
  std::vector<int> columns;  ///< numbers in the description, ascending
};

/// A line or a pass in the direction it is driven.
struct CoverageLine {
  int cell = 0;
  bool is_pass = false;  ///< beside a border or a hole
  std::vector<Place> points;
};

/// A way that covers a floor, and every step of the method that found it.
struct CoverageWay {
  std::vector<WayPoint> points;
  double direction_deg = 0;  ///< of the lines, from x towards y; 0 or more, below 180
  /// Beams, edges and faces; empty where the floor is not orthogonal. Places in units of the grid.
  Hypergraph hypergraph;
  std::vector<CoverageCell> cells;
  std::vector<CoverageDoor> doors;  ///< the adjacency of cells
  std::vector<int> order;           ///< of cells; those without a line of their own are left out
  std::vector<CoverageLine> lines;  ///< as they are driven
  int cut_off = 0;                  ///< lines that no allowed way leads to; they are left out
  /// With a turning radius: the length with arcs as arcs, m, and how many they are.
  struct Arcs {
    double length = 0;
    int turns = 0;
  };
  std::optional<Arcs> arcs;
};

/// The way of a tool that works a line of `width` across its travel, over all of a floor that it
/// can reach, steps 1 to 9: hypergraph of beams and slab faces; cells (rectangles of an orthogonal
/// floor, else by a sweep); their adjacency; their order; lines in each, and passes beside what
/// lines leave out; shortest ways between them. With a turning radius lines end where the machine
/// can turn, and ways between them are those of Dubins (`turning.hpp`). Throws
/// std::invalid_argument with the first fault of the input, and where a floor that is not
/// orthogonal is to be parted along beams. The same input gives the same way, bit for bit.
CoverageWay plan_coverage(const FloorDescription& floor, const CoverageOptions& options);

}  // namespace rubicon::coverage
