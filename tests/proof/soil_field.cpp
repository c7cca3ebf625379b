#include "tests/proof/soil_field.hpp"

#include <algorithm>
#include <cmath>

namespace rubicon::collision::proof {
namespace {

/// m: strips narrower than this are rounding.
constexpr double kNoStrip = 1e-9;

std::vector<double> borders(int count, double cell, double by) {
  std::vector<double> all;
  for (int i = 0; i <= count; ++i) {
    all.push_back(i * cell - by);
    all.push_back(i * cell + by);
  }
  std::sort(all.begin(), all.end());
  std::vector<double> apart;
  for (const double border : all) {
    if (apart.empty() || border - apart.back() > kNoStrip) apart.push_back(border);
  }
  return apart;
}

void add_quad(geometry::TriangleMesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c,
              const Vec3& d) {
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {a, b, c, d});
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

}  // namespace

double Columns::thinnest() const {
  std::int64_t least = INT64_MAX;
  for (std::size_t i = 0; i < top.size(); ++i) {
    if (!is_empty(i)) least = std::min(least, top[i] - bottom[i]);
  }
  return static_cast<double>(least) * 1e-3;
}

OffsetSoil::OffsetSoil(const Columns& soil, double by) {
  const double cell = static_cast<double>(soil.cell) * 1e-3;
  const double reach = std::fabs(by);
  x_ = borders(soil.columns, cell, reach);
  y_ = borders(soil.rows, cell, reach);
  const auto cells_near = [&](double middle, int& first, int& last) {
    first = static_cast<int>(std::floor((middle - reach) / cell));
    last = static_cast<int>(std::floor((middle + reach) / cell));
  };
  for (std::size_t j = 0; j + 1 < y_.size(); ++j) {
    int row0 = 0;
    int row1 = 0;
    cells_near(0.5 * (y_[j] + y_[j + 1]), row0, row1);
    for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
      int column0 = 0;
      int column1 = 0;
      cells_near(0.5 * (x_[i] + x_[i + 1]), column0, column1);
      Strip strip = by > 0 ? Strip{1e9, -1e9} : Strip{-1e9, 1e9};
      for (int row = row0; row <= row1; ++row) {
        for (int column = column0; column <= column1; ++column) {
          const bool exists = row >= 0 && row < soil.rows && column >= 0 && column < soil.columns &&
                              !soil.is_empty(soil.index(column, row));
          if (!exists && by > 0) continue;
          const std::size_t at = exists ? soil.index(column, row) : 0;
          const double bottom = exists ? static_cast<double>(soil.bottom[at]) * 1e-3 - by : 1e9;
          const double top = exists ? static_cast<double>(soil.top[at]) * 1e-3 + by : -1e9;
          strip.bottom = by > 0 ? std::min(strip.bottom, bottom) : std::max(strip.bottom, bottom);
          strip.top = by > 0 ? std::max(strip.top, top) : std::min(strip.top, top);
        }
      }
      strips_.push_back(strip);
    }
  }
  make_surface();
}

OffsetSoil::Strip OffsetSoil::strip(std::size_t i, std::size_t j) const {
  const std::size_t columns = x_.size() - 1;
  // Before the first: a number that wraps round.
  if (i >= columns || j >= y_.size() - 1) return {};
  return strips_[j * columns + i];
}

bool OffsetSoil::has(const Vec3& point) const {
  const auto i = std::upper_bound(x_.begin(), x_.end(), point.x()) - x_.begin() - 1;
  const auto j = std::upper_bound(y_.begin(), y_.end(), point.y()) - y_.begin() - 1;
  if (i < 0 || j < 0) return false;
  const Strip here = strip(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  return point.z() > here.bottom && point.z() < here.top;
}

/// Tops and bottoms in runs along x, and the walls between strips that differ.
void OffsetSoil::make_surface() {
  geometry::TriangleMesh mesh;
  const auto same = [](const Strip& a, const Strip& b) {
    return a.bottom == b.bottom && a.top == b.top;
  };
  const auto wall = [&](const Strip& a, const Strip& b, const Vec3& p, const Vec3& q) {
    // What is in one of them and not in the other.
    const auto piece = [&](double low, double high) {
      if (high <= low) return;
      add_quad(mesh, Vec3(p.x(), p.y(), low), Vec3(q.x(), q.y(), low), Vec3(q.x(), q.y(), high),
               Vec3(p.x(), p.y(), high));
    };
    for (const bool swapped : {false, true}) {
      const Strip& one = swapped ? b : a;
      const Strip& other = swapped ? a : b;
      if (one.is_empty()) continue;
      if (other.is_empty()) {
        piece(one.bottom, one.top);
        continue;
      }
      piece(one.bottom, std::min(one.top, other.bottom));
      piece(std::max(one.bottom, other.top), one.top);
    }
  };
  for (std::size_t j = 0; j + 1 < y_.size(); ++j) {
    for (std::size_t i = 0; i + 1 < x_.size();) {
      const Strip here = strip(i, j);
      std::size_t end = i + 1;
      while (end + 1 < x_.size() && same(strip(end, j), here)) ++end;
      if (!here.is_empty()) {
        for (const double z : {here.bottom, here.top}) {
          add_quad(mesh, Vec3(x_[i], y_[j], z), Vec3(x_[end], y_[j], z),
                   Vec3(x_[end], y_[j + 1], z), Vec3(x_[i], y_[j + 1], z));
        }
      }
      i = end;
    }
  }
  for (std::size_t j = 0; j < y_.size(); ++j) {
    for (std::size_t i = 0; i < x_.size(); ++i) {
      if (j + 1 < y_.size()) {
        wall(strip(i - 1, j), strip(i, j), Vec3(x_[i], y_[j], 0), Vec3(x_[i], y_[j + 1], 0));
      }
      if (i + 1 < x_.size()) {
        wall(strip(i, j - 1), strip(i, j), Vec3(x_[i], y_[j], 0), Vec3(x_[i + 1], y_[j], 0));
      }
    }
  }
  if (!mesh.triangles.empty()) surface_ = fcl_mesh(mesh);
}

const OffsetSoil& SoilOffsets::by(double offset) {
  const auto found = made_.find(offset);
  if (found != made_.end()) return found->second;
  return made_.emplace(offset, OffsetSoil(soil_, offset)).first->second;
}

}  // namespace rubicon::collision::proof
