#include "src/simulation/site/ground_under.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace rubicon::site {

bool has_cell_under(const PlanRegion& region, const math::Pose& X_WE, const soil::Terrain& earth,
                    const std::function<bool(std::size_t cell)>& asks) {
  if (region.polygons.empty()) return false;
  const math::Pose X_EW = X_WE.inverse(Eigen::Isometry);
  Eigen::AlignedBox2d around;
  for (int corner = 0; corner < 4; ++corner) {
    const Eigen::Vector2d p =
        region.bounds.corner(static_cast<Eigen::AlignedBox2d::CornerType>(corner));
    around.extend((X_EW * math::Vec3(p.x(), p.y(), 0)).head<2>());
  }
  const double side = static_cast<double>(earth.cell) * 1e-3;
  if (around.max().x() < 0 || around.max().y() < 0 || around.min().x() > earth.columns * side ||
      around.min().y() > earth.rows * side) {
    return false;
  }
  const auto index = [&](double value, int count) {
    return static_cast<int>(std::clamp(std::floor(value / side), 0.0, count - 1.0));
  };
  for (int row = index(around.min().y(), earth.rows); row <= index(around.max().y(), earth.rows);
       ++row) {
    for (int column = index(around.min().x(), earth.columns);
         column <= index(around.max().x(), earth.columns); ++column) {
      if (!asks(earth.index(column, row))) continue;
      std::vector<Eigen::Vector2d> corners;
      for (const auto& [x, y] : {std::pair(column, row), std::pair(column + 1, row),
                                 std::pair(column + 1, row + 1), std::pair(column, row + 1)}) {
        corners.push_back((X_WE * math::Vec3(x * side, y * side, 0)).head<2>());
      }
      PlanRegion cell;
      cell.add(std::move(corners));
      if (region.overlaps(cell)) return true;
    }
  }
  return false;
}

}  // namespace rubicon::site
