#include "src/earth/soil/excavation.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/math/angles.hpp"

namespace rubicon::soil {

namespace {

using Point = Eigen::Vector2d;

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0;
  return (p - a - t * along).norm();
}

bool is_inside(const Point& p, const std::vector<Point>& outline) {
  bool inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Point& a = outline[i];
    const Point& b = outline[j];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

double distance_to(const Point& p, const std::vector<Point>& outline) {
  double least = (p - outline.front()).norm();
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    least = std::min(least, distance_to_segment(p, outline[j], outline[i]));
  }
  return least;
}

}  // namespace

Excavation excavate(const Terrain& terrain, const Pit& pit, double stands_deg) {
  Excavation result;
  result.after = terrain;
  const bool upright = stands_deg >= 90;
  const double rise =
      upright ? 0 : math::sin_deg(stands_deg) / math::cos_deg(stands_deg);  // m per m
  const Millimetres highest = terrain.heights.highest();
  const double depth = static_cast<double>(std::max<Millimetres>(highest - pit.bottom, 0)) * 1e-3;
  const double reach = upright ? 0 : depth / rise;
  Point low = pit.outline.front();
  Point high = low;
  for (const Point& each : pit.outline) low = low.cwiseMin(each), high = high.cwiseMax(each);
  const double side = static_cast<double>(terrain.cell) * 1e-3;
  const auto first = [&](double x, int count) {
    return static_cast<int>(std::clamp(std::floor((x - reach) / side), 0.0, double(count)));
  };
  const auto last = [&](double x, int count) {
    return static_cast<int>(std::clamp(std::ceil((x + reach) / side), 0.0, double(count)));
  };
  const std::int64_t area = terrain.cell * terrain.cell;
  const int end_row = last(high.y(), terrain.rows);
  const int end_column = last(high.x(), terrain.columns);
  for (int row = first(low.y(), terrain.rows); row < end_row; ++row) {
    for (int column = first(low.x(), terrain.columns); column < end_column; ++column) {
      const std::size_t at = terrain.index(column, row);
      if (terrain.heights[at] <= pit.bottom) continue;
      const Point middle(terrain.middle(column), terrain.middle(row));
      const bool inside = is_inside(middle, pit.outline);
      if (!inside && upright) continue;
      const double allowed = inside ? 0 : distance_to(middle, pit.outline) * rise * 1e3;
      const double room = static_cast<double>(terrain.heights[at] - pit.bottom);
      if (allowed >= room) continue;
      const Millimetres height = pit.bottom + static_cast<Millimetres>(std::floor(allowed));
      const CubicMillimetres taken = (terrain.heights[at] - height) * area;
      if (taken == 0) continue;
      result.after.heights.set(at, height);
      result.volume += taken;
      if (inside) result.in_outline += taken;
      ++result.cells;
      result.reaches_border = result.reaches_border || row == 0 || column == 0 ||
                              row + 1 == terrain.rows || column + 1 == terrain.columns;
    }
  }
  return result;
}

}  // namespace rubicon::soil
