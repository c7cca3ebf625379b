#include "src/motion/collision/mesh/inside_grid.hpp"

#include <algorithm>
#include <array>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/mesh/winding.hpp"

namespace rubicon::collision {

InsideGrid::InsideGrid(const TriangleSoup& soup) {
  if (!soup.closed() || soup.empty()) return;
  bounds_ = soup.bounds();
  bounds_.grow(Vec3::Constant(kBoundsMargin));
  cells_per_metre_ = (bounds_.upper - bounds_.lower).cwiseInverse() * kCells;
  cells_.assign(static_cast<std::size_t>(kCells) * kCells * kCells, Cell::kOutside);
  known_.assign(cells_.size(), false);
  for (int i = 0; i < static_cast<int>(soup.triangles().size()); ++i) {
    Bounds near;
    for (int k = 0; k < 3; ++k) near.add(soup.corner(i, k));
    near.grow(Vec3::Constant(kBoundsMargin));
    for (int z = coordinate(near.lower.z(), 2); z <= coordinate(near.upper.z(), 2); ++z) {
      for (int y = coordinate(near.lower.y(), 1); y <= coordinate(near.upper.y(), 1); ++y) {
        for (int x = coordinate(near.lower.x(), 0); x <= coordinate(near.upper.x(), 0); ++x) {
          cells_[index(x, y, z)] = Cell::kUnknown;
          known_[index(x, y, z)] = true;
        }
      }
    }
  }
  for (int z = 0; z < kCells; ++z) {
    for (int y = 0; y < kCells; ++y) {
      for (int x = 0; x < kCells; ++x) fill(soup, x, y, z);
    }
  }
  known_ = {};
}

/// No surface lies in cells that are not near it: those that touch have the same winding number.
void InsideGrid::fill(const TriangleSoup& soup, int x, int y, int z) {
  if (known_[index(x, y, z)]) return;
  const Cell cell = winding_number(soup, centre(x, y, z)) == 0 ? Cell::kOutside : Cell::kInside;
  std::vector<std::array<int, 3>> open = {{x, y, z}};
  known_[index(x, y, z)] = true;
  while (!open.empty()) {
    const std::array<int, 3> at = open.back();
    open.pop_back();
    cells_[index(at[0], at[1], at[2])] = cell;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int step : {-1, 1}) {
        std::array<int, 3> next = at;
        next[axis] += step;
        if (next[axis] < 0 || next[axis] >= kCells) continue;
        if (known_[index(next[0], next[1], next[2])]) continue;
        known_[index(next[0], next[1], next[2])] = true;
        open.push_back(next);
      }
    }
  }
}

int InsideGrid::coordinate(double value, int axis) const {
  const double cell = (value - bounds_.lower[axis]) * cells_per_metre_[axis];
  return static_cast<int>(std::clamp(cell, 0.0, kCells - 1.0));
}

Vec3 InsideGrid::centre(int x, int y, int z) const {
  return bounds_.lower + Vec3(x + 0.5, y + 0.5, z + 0.5).cwiseQuotient(cells_per_metre_);
}

InsideGrid::Cell InsideGrid::at(const Vec3& point) const {
  if (cells_.empty() || !bounds_.contains(point)) return Cell::kOutside;
  return cells_[index(coordinate(point.x(), 0), coordinate(point.y(), 1),
                      coordinate(point.z(), 2))];
}

}  // namespace rubicon::collision
