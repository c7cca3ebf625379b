#pragma once

#include <span>
#include <vector>

#include "src/motion/coverage/grid.hpp"

namespace rubicon::coverage {

/// An edge of the outline or of a shaft, from its lower end to its upper one.
struct Side {
  Point low;
  Point high;

  /// x where the side has this y, which lies in its range; rounded down or up.
  std::int64_t x_below(std::int64_t y) const;
  std::int64_t x_above(std::int64_t y) const;
};

/// A part of a floor that every line along x meets in one stretch. Its sides are whole edges of the
/// floor, bottom up; the cell has the part of them between its bottom and its top.
struct Cell {
  std::int64_t bottom = 0;
  std::int64_t top = 0;
  std::vector<Side> left;
  std::vector<Side> right;

  /// Where the line at y, bottom <= y <= top, has the cell: rounded towards its inside.
  std::int64_t left_at(std::int64_t y) const;
  std::int64_t right_at(std::int64_t y) const;
  /// Its corners; those that no corner of the floor is are rounded.
  Ring ring() const;
  bool is_rectangle() const;
};
Cell cell_of(const Box& box);

/// Where two cells touch along a line of positive length.
struct Door {
  int a = 0;
  int b = 0;
  Point from;
  Point to;
};

struct CellGraph {
  std::vector<Cell> cells;
  std::vector<Door> doors;
};

/// Cuts along x at every corner where the stretches of lines along x part, join or jump
/// (boustrophedon cells: Choset, Autonomous Robots 9, 2000); with `trapezoids` at every corner.
/// The inside of the rings is on their left: the outline counter-clockwise, holes clockwise. They
/// are simple and do not touch. What is above what is decided exactly; O(n log n).
CellGraph cells_by_sweep(std::span<const Ring> rings, bool trapezoids = false);

/// Which rectangles with disjoint interiors touch along a line: the rectangle adjacency graph.
/// Doors in the order of rectangles.
std::vector<Door> doors_between(std::span<const Box> rectangles);

}  // namespace rubicon::coverage
