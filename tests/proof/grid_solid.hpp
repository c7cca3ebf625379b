#pragma once

#include <array>
#include <vector>

#include "tests/proof/case.hpp"

namespace rubicon::collision::proof {

/// A solid of cells between axis-parallel planes. Everything about it is counted in whole cells, so
/// it is known exactly, up to the rounding of the planes' places.
struct GridSolid {
  std::array<std::vector<double>, 3> planes;  ///< m, ascending, along each axis
  std::vector<bool> cells;                    ///< x runs fastest

  int count(int axis) const { return static_cast<int>(planes[axis].size()) - 1; }
  std::size_t index(const std::array<int, 3>& cell) const;
  /// False beyond the planes.
  bool has(const std::array<int, 3>& cell) const;
  bool empty() const;
  /// The middle of a cell (m).
  Vec3 middle(const std::array<int, 3>& cell) const;
};

/// Visits every cell as an array of three indices.
template <typename Visit>
void for_each_cell(const GridSolid& solid, const Visit& visit) {
  std::array<int, 3> cell{};
  for (cell[2] = 0; cell[2] < solid.count(2); ++cell[2]) {
    for (cell[1] = 0; cell[1] < solid.count(1); ++cell[1]) {
      for (cell[0] = 0; cell[0] < solid.count(0); ++cell[0]) visit(cell);
    }
  }
}

/// Planes at distances of 2 to 1,024 units of 2^-10 m.
std::array<std::vector<double>, 3> random_planes(Random& random);
/// Some boxes between the planes less some others; never empty.
GridSolid random_grid_solid(Random& random, const std::array<std::vector<double>, 3>& planes);

GridSolid shifted(const GridSolid& solid, const Vec3& by);
/// All that the solid covers while it is shifted along an axis by `way` (m, of either sign).
GridSolid swept(const GridSolid& solid, int axis, double way);
/// The points that are the middle of a cube of half an edge `by` (m) inside the solid.
GridSolid eroded(const GridSolid& solid, double by);
/// What two solids have in common.
GridSolid common(const GridSolid& a, const GridSolid& b);
/// The least length (m) of the solid along an axis, through any cell.
double thinnest(const GridSolid& solid);
/// The least length (m) of the solid along the axes through a point inside it.
double thickness_at(const GridSolid& solid, const Vec3& point);
bool holds_cube(const GridSolid& solid, const Vec3& middle, double half);

/// What is allowed.
struct GridRules {
  double tolerance = 1e-3;  ///< m
  double finest = 1e-3;     ///< m, the most that the triangles allow
  double doubt = 0;         ///< m, how much the bodies may differ from the solids
  bool thin = true;         ///< less is allowed where the solids are thin
};

/// Whether two solids are deeper in each other than the rules of docs/collision.md allow: a hit if
/// some cube in both is larger than the tolerance (less where they are thin), or a point of one is
/// deeper in the other; free if no point of one is half as deep.
Truth grid_truth(const GridSolid& a, const GridSolid& b, const GridRules& rules);
/// The same for `a` being shifted along an axis.
Truth grid_truth_along(const GridSolid& a, int axis, double way, const GridSolid& b,
                       const GridRules& rules);

}  // namespace rubicon::collision::proof
