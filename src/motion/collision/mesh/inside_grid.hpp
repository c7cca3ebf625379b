#pragma once

#include <cstdint>
#include <vector>

#include "src/motion/collision/mesh/triangle_soup.hpp"

namespace rubicon::collision {

/// What is known at a glance of the inside of a closed soup: its box cut into cells, each wholly
/// outside, wholly inside (winding number not 0), or near the surface.
class InsideGrid {
 public:
  enum class Cell : std::uint8_t { kOutside, kInside, kUnknown };

  /// Of a soup that is not closed everything is outside.
  explicit InsideGrid(const TriangleSoup& soup);

  /// In the frame of the soup; outside of its box is outside.
  Cell at(const Vec3& point) const;

 private:
  /// Cells along each axis.
  static constexpr int kCells = 32;

  int coordinate(double value, int axis) const;
  Vec3 centre(int x, int y, int z) const;
  static std::size_t index(int x, int y, int z) {
    return static_cast<std::size_t>((z * kCells + y) * kCells + x);
  }
  void fill(const TriangleSoup& soup, int x, int y, int z);

  Bounds bounds_;
  Vec3 cells_per_metre_ = Vec3::Zero();
  std::vector<Cell> cells_;
  std::vector<bool> known_;
};

}  // namespace rubicon::collision
