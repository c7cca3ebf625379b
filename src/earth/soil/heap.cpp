#include "src/earth/soil/heap.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::soil {

namespace {

using math::at;

/// Cells to either side that are looked at first; twice as many where the heap reaches their rim.
constexpr int kFirstReach = 8;

/// A cell on which soil may come to lie.
struct HeapCell {
  int cell = 0;
  std::int64_t distance2 = 0;  ///< in cells
  Millimetres drop = 0;        ///< the cone is so much lower here than in its middle
  bool on_rim = false;         ///< of those that are looked at
};

/// One try with the cells in reach; nothing: it does not stay within them.
class ConeFitter {
 public:
  ConeFitter(const Terrain& surface, int middle, int reach, double slope) : surface_(surface) {
    const int column = middle % surface.columns;
    const int row = middle / surface.columns;
    for (int r = std::max(row - reach, 0); r <= std::min(row + reach, surface.rows - 1); ++r) {
      for (int c = std::max(column - reach, 0); c <= std::min(column + reach, surface.columns - 1);
           ++c) {
        HeapCell each;
        each.cell = static_cast<int>(surface.index(c, r));
        each.distance2 = static_cast<std::int64_t>(c - column) * (c - column) +
                         static_cast<std::int64_t>(r - row) * (r - row);
        each.drop = static_cast<Millimetres>(
            std::ceil(slope * std::sqrt(static_cast<double>(each.distance2)) *
                      static_cast<double>(surface.cell)));
        each.on_rim =
            c == column - reach || c == column + reach || r == row - reach || r == row + reach;
        cells_.push_back(each);
      }
    }
  }

  /// The highest cone of no more than so much soil.
  Millimetres top(std::int64_t units) const {
    Millimetres low = surface_.heights[at(cells_.front().cell)];
    for (const HeapCell& each : cells_) low = std::min(low, surface_.heights[at(each.cell)]);
    Millimetres step = 1;
    while (raised(low + step) <= units) step *= 2;
    Millimetres high = low + step;  // of more than that
    while (high - low > 1) {
      const Millimetres middle = low + (high - low) / 2;
      (raised(middle) <= units ? low : high) = middle;
    }
    return low;
  }

  HeapGrowth growth(Millimetres top, std::int64_t units) {
    HeapGrowth growth;
    for (const HeapCell& each : cells_) {
      if (height(each, top) > now(each)) growth.heights[each.cell] = height(each, top);
    }
    std::int64_t left = units - raised(top);
    std::stable_sort(cells_.begin(), cells_.end(), [](const HeapCell& a, const HeapCell& b) {
      return std::tie(a.distance2, a.cell) < std::tie(b.distance2, b.cell);
    });
    for (const HeapCell& each : cells_) {
      if (left == 0) break;
      if (height(each, top + 1) <= now(each)) continue;
      growth.heights[each.cell] = height(each, top + 1);
      --left;
    }
    return growth;
  }

  bool reaches_rim(const HeapGrowth& growth) const {
    return std::any_of(cells_.begin(), cells_.end(), [&](const HeapCell& each) {
      return each.on_rim && growth.heights.contains(each.cell);
    });
  }

 private:
  Millimetres now(const HeapCell& each) const { return surface_.heights[at(each.cell)]; }
  static Millimetres height(const HeapCell& each, Millimetres top) { return top - each.drop; }
  std::int64_t raised(Millimetres top) const {
    std::int64_t sum = 0;
    for (const HeapCell& each : cells_) {
      sum += std::max<Millimetres>(height(each, top) - now(each), 0);
    }
    return sum;
  }

  const Terrain& surface_;
  std::vector<HeapCell> cells_;
};

}  // namespace

HeapGrowth tip_over(const Terrain& surface, int cell, std::int64_t units, double repose_deg) {
  const double slope = math::sin_deg(repose_deg) / math::cos_deg(repose_deg);
  for (int reach = kFirstReach;; reach *= 2) {
    ConeFitter fitter(surface, cell, reach, slope);
    HeapGrowth growth = fitter.growth(fitter.top(units), units);
    const bool is_all = reach >= surface.columns && reach >= surface.rows;
    if (fitter.reaches_rim(growth) && !is_all) continue;
    for (const auto& each : growth.heights) {
      const int column = each.first % surface.columns;
      const int row = each.first / surface.columns;
      growth.reaches_border = growth.reaches_border || column == 0 || row == 0 ||
                              column == surface.columns - 1 || row == surface.rows - 1;
    }
    return growth;
  }
}

}  // namespace rubicon::soil
