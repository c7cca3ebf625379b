#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "src/motion/collision/base/placement.hpp"

namespace rubicon::collision {

using Vec2 = Eigen::Vector2d;
/// A convex polygon (m), counter-clockwise.
using FlatPolygon = std::vector<Vec2>;

/// A triangle as it is seen from a plane: where its corners are along the plane (m), and how high
/// above it (m).
struct SeenTriangle {
  std::array<Vec2, 3> at;
  std::array<double, 3> height;
};

/// A convex region of a plane: the points near a triangle, as what some half planes have in common.
class FlatRegion {
 public:
  /// Points of the plane that are certainly within a distance of a triangle: those within
  /// `along` of the part of it that is not higher or lower than `height`. `fullness` (0.5 to 1):
  /// how much of `along` the sides get; the more, the less the corners do.
  FlatRegion(const SeenTriangle& triangle, double height, double along, double fullness);

  bool empty() const { return count_ == 0; }
  /// Adds what of a polygon is outside the region to `rest`, in convex pieces.
  void cut_from(const FlatPolygon& polygon, std::vector<FlatPolygon>& rest) const;

 private:
  struct Side {
    Vec2 normal = Vec2::UnitX();
    double offset = 0;  ///< inside: normal.p <= offset
  };
  void add_side(const Vec2& normal, double offset) { sides_[count_++] = {normal, offset}; }

  /// A triangle between two heights has five corners, by rounding perhaps more; each makes a side
  /// and a cut.
  std::array<Side, 16> sides_;
  std::size_t count_ = 0;
  double negligible_ = 0;  ///< m, pieces that stick out by less are nothing
};

/// The part of a polygon where normal.p <= offset.
FlatPolygon part_below(const FlatPolygon& polygon, const Vec2& normal, double offset);
/// What a polygon and a triangle (of either orientation) have in common.
FlatPolygon common_part(const FlatPolygon& polygon, const std::array<Vec2, 3>& triangle);
double area_of(const FlatPolygon& polygon);
Vec2 mean_of(const FlatPolygon& polygon);

}  // namespace rubicon::collision
