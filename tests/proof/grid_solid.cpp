#include "tests/proof/grid_solid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubicon::collision::proof {
namespace {

/// Planes nearer to each other than this (m) are one: they differ by rounding.
constexpr double kSamePlane = 1e-12;
/// What docs/collision.md allows of what is thin, written down once more.
constexpr double kThinnestTolerance = 10e-6;
constexpr double kLeastTolerance = 1e-9;

double tolerance_of(double width, double contact_tolerance) {
  return std::max(std::min(contact_tolerance, std::max(0.25 * width, kThinnestTolerance)),
                  kLeastTolerance);
}

std::vector<double> sorted(std::vector<double> planes) {
  std::sort(planes.begin(), planes.end());
  const auto same = [](double a, double b) { return b - a < kSamePlane; };
  planes.erase(std::unique(planes.begin(), planes.end(), same), planes.end());
  return planes;
}

/// The cell that holds a coordinate; -1 or the count beyond the planes.
int cell_at(const std::vector<double>& planes, double coordinate) {
  return static_cast<int>(std::upper_bound(planes.begin(), planes.end(), coordinate) -
                          planes.begin()) -
         1;
}

std::array<int, 3> cell_at(const GridSolid& solid, const Vec3& point) {
  return {cell_at(solid.planes[0], point.x()), cell_at(solid.planes[1], point.y()),
          cell_at(solid.planes[2], point.z())};
}

GridSolid with_planes(const std::array<std::vector<double>, 3>& planes) {
  GridSolid result;
  result.planes = planes;
  result.cells.assign(static_cast<std::size_t>(result.count(0)) * result.count(1) * result.count(2),
                      false);
  return result;
}

/// A new solid whose cells ask all cells of the old one within [lower, upper] of theirs along an
/// axis: any of them or all of them.
GridSolid spread(const GridSolid& solid, int axis, double lower, double upper, bool any) {
  std::array<std::vector<double>, 3> planes = solid.planes;
  for (const double plane : solid.planes[axis]) {
    planes[axis].push_back(plane - lower);
    planes[axis].push_back(plane - upper);
  }
  planes[axis] = sorted(planes[axis]);
  GridSolid result = with_planes(planes);
  for_each_cell(result, [&](const std::array<int, 3>& cell) {
    std::array<int, 3> old = cell;
    const double middle = 0.5 * (planes[axis][cell[axis]] + planes[axis][cell[axis] + 1]);
    const int first = cell_at(solid.planes[axis], middle + lower);
    const int last = cell_at(solid.planes[axis], middle + upper);
    bool found = !any;
    for (old[axis] = first; old[axis] <= last; ++old[axis]) {
      if (solid.has(old) == any) found = any;
    }
    result.cells[result.index(cell)] = found;
  });
  return result;
}

bool overlap(const GridSolid& a, const GridSolid& b) { return !common(a, b).empty(); }

}  // namespace

std::size_t GridSolid::index(const std::array<int, 3>& cell) const {
  return static_cast<std::size_t>((cell[2] * count(1) + cell[1]) * count(0) + cell[0]);
}

bool GridSolid::has(const std::array<int, 3>& cell) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (cell[axis] < 0 || cell[axis] >= count(axis)) return false;
  }
  return cells[index(cell)];
}

bool GridSolid::empty() const { return std::find(cells.begin(), cells.end(), true) == cells.end(); }

Vec3 GridSolid::middle(const std::array<int, 3>& cell) const {
  Vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    result[axis] = 0.5 * (planes[axis][cell[axis]] + planes[axis][cell[axis] + 1]);
  }
  return result;
}

std::array<std::vector<double>, 3> random_planes(Random& random) {
  constexpr std::array<int, 6> kThinAndThick = {2, 8, 40, 256, 256, 1024};
  constexpr std::array<int, 6> kThick = {40, 40, 160, 256, 256, 1024};
  const std::array<int, 6>& steps = random.below(2) ? kThinAndThick : kThick;
  std::array<std::vector<double>, 3> planes;
  for (std::vector<double>& along : planes) {
    int at = 0;
    along.push_back(0);
    for (int i = 2 + random.below(4); i > 0; --i) {
      at += steps[static_cast<std::size_t>(random.below(6))];
      along.push_back(at * 0x1p-10);
    }
  }
  return planes;
}

GridSolid random_grid_solid(Random& random, const std::array<std::vector<double>, 3>& planes) {
  GridSolid result = with_planes(planes);
  const auto set_box = [&](bool value) {
    std::array<int, 3> first{};
    std::array<int, 3> last{};
    for (int axis = 0; axis < 3; ++axis) {
      const int one = random.below(result.count(axis));
      const int other = random.below(result.count(axis));
      first[axis] = std::min(one, other);
      last[axis] = std::max(one, other);
    }
    for_each_cell(result, [&](const std::array<int, 3>& cell) {
      for (int axis = 0; axis < 3; ++axis) {
        if (cell[axis] < first[axis] || cell[axis] > last[axis]) return;
      }
      result.cells[result.index(cell)] = value;
    });
  };
  while (result.empty()) {
    for (int i = 1 + random.below(3); i > 0; --i) set_box(true);
    for (int i = random.below(3); i > 0; --i) set_box(false);
  }
  return result;
}

GridSolid shifted(const GridSolid& solid, const Vec3& by) {
  GridSolid result = solid;
  for (int axis = 0; axis < 3; ++axis) {
    for (double& plane : result.planes[axis]) plane += by[axis];
  }
  return result;
}

GridSolid swept(const GridSolid& solid, int axis, double way) {
  return spread(solid, axis, std::min(0.0, -way), std::max(0.0, -way), true);
}

GridSolid eroded(const GridSolid& solid, double by) {
  GridSolid result = solid;
  for (int axis = 0; axis < 3; ++axis) result = spread(result, axis, -by, by, false);
  return result;
}

GridSolid common(const GridSolid& a, const GridSolid& b) {
  std::array<std::vector<double>, 3> planes = a.planes;
  for (int axis = 0; axis < 3; ++axis) {
    planes[axis].insert(planes[axis].end(), b.planes[axis].begin(), b.planes[axis].end());
    planes[axis] = sorted(planes[axis]);
  }
  GridSolid result = with_planes(planes);
  for_each_cell(result, [&](const std::array<int, 3>& cell) {
    const Vec3 middle = result.middle(cell);
    result.cells[result.index(cell)] = a.has(cell_at(a, middle)) && b.has(cell_at(b, middle));
  });
  return result;
}

double thickness_at(const GridSolid& solid, const Vec3& point) {
  const std::array<int, 3> cell = cell_at(solid, point);
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    std::array<int, 3> first = cell;
    std::array<int, 3> last = cell;
    while (solid.has(first)) --first[axis];
    while (solid.has(last)) ++last[axis];
    least = std::min(least, solid.planes[axis][last[axis]] - solid.planes[axis][first[axis] + 1]);
  }
  return least;
}

double thinnest(const GridSolid& solid) {
  double least = std::numeric_limits<double>::infinity();
  for_each_cell(solid, [&](const std::array<int, 3>& cell) {
    if (solid.has(cell)) least = std::min(least, thickness_at(solid, solid.middle(cell)));
  });
  return least;
}

bool holds_cube(const GridSolid& solid, const Vec3& middle, double half) {
  const std::array<int, 3> first = cell_at(solid, middle - Vec3::Constant(half));
  const std::array<int, 3> last = cell_at(solid, middle + Vec3::Constant(half));
  std::array<int, 3> cell{};
  for (cell[0] = first[0]; cell[0] <= last[0]; ++cell[0]) {
    for (cell[1] = first[1]; cell[1] <= last[1]; ++cell[1]) {
      for (cell[2] = first[2]; cell[2] <= last[2]; ++cell[2]) {
        if (!solid.has(cell)) return false;
      }
    }
  }
  return true;
}

Truth grid_truth(const GridSolid& a, const GridSolid& b, const GridRules& rules) {
  const GridSolid both = common(a, b);
  bool hit = false;
  for_each_cell(both, [&](const std::array<int, 3>& cell) {
    if (hit || !both.has(cell)) return;
    const Vec3 middle = both.middle(cell);
    const double width = rules.thin ? std::min(thickness_at(a, middle), thickness_at(b, middle))
                                    : std::numeric_limits<double>::infinity();
    hit = holds_cube(both, middle, tolerance_of(width, rules.tolerance) + rules.doubt);
  });
  const double deep =
      tolerance_of(std::numeric_limits<double>::infinity(), rules.tolerance) + rules.doubt;
  if (hit || overlap(a, eroded(b, deep)) || overlap(eroded(a, deep), b)) return Truth::kHit;
  const double width = std::min(thinnest(a), thinnest(b));
  const double shallow = std::min(tolerance_of(width, rules.tolerance), rules.finest) - rules.doubt;
  if (shallow <= 0) return Truth::kNearBoundary;
  if (both.empty()) return Truth::kFree;
  // A point is as deep along the axes as it is deep by the root of 3.
  const double along_axes = shallow / std::sqrt(3.0);
  const bool free = !overlap(a, eroded(b, along_axes)) && !overlap(eroded(a, along_axes), b);
  return free ? Truth::kFree : Truth::kNearBoundary;
}

Truth grid_truth_along(const GridSolid& a, int axis, double way, const GridSolid& b,
                       const GridRules& rules) {
  // Where planes meet, and between.
  std::vector<double> places = {0, way};
  for (const double own : a.planes[axis]) {
    for (const double other : b.planes[axis]) {
      const double place = other - own;
      if (place > std::min(0.0, way) && place < std::max(0.0, way)) places.push_back(place);
    }
  }
  places = sorted(places);
  const std::size_t count = places.size();
  for (std::size_t i = 1; i < count; ++i) places.push_back(0.5 * (places[i - 1] + places[i]));
  for (const double place : places) {
    if (grid_truth(shifted(a, place * Vec3::Unit(axis)), b, rules) == Truth::kHit) {
      return Truth::kHit;
    }
  }
  const Truth all = grid_truth(swept(a, axis, way), b, rules);
  return all == Truth::kFree ? Truth::kFree : Truth::kNearBoundary;
}

}  // namespace rubicon::collision::proof
