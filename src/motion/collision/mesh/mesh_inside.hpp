#pragma once

#include <limits>
#include <vector>

#include "src/motion/collision/mesh/inside_grid.hpp"
#include "src/motion/collision/mesh/triangle_soup.hpp"

namespace rubicon::collision {

/// What is known of the inside of a mesh, found once. A mesh that is not closed has none. The soup
/// must outlive it.
class MeshInside {
 public:
  explicit MeshInside(const TriangleSoup& soup);

  const TriangleSoup& soup() const { return *soup_; }
  /// Whether a point that is not on the surface is inside.
  bool holds(const Vec3& point) const;
  /// Whether it is inside and farther than `depth` (m) from the surface.
  bool holds_deep(const Vec3& point, double depth) const;
  /// Whether it is in a cell that is known to be wholly inside; false says nothing. Quick.
  bool surely_holds(const Vec3& point) const {
    return grid_.at(point) == InsideGrid::Cell::kInside;
  }
  /// The unit normal of a triangle that points out of the solid; zero for triangles that are almost
  /// needles, whose normals are noise.
  const Vec3& outwards(int triangle) const { return outwards_[static_cast<std::size_t>(triangle)]; }
  /// The most (m) that a triangle may be deep in anything: less than the contact tolerance where
  /// the solid under it is thin.
  double allowed(int triangle, double contact_tolerance) const;
  /// The least of them.
  double least_allowed(double contact_tolerance) const;

  /// Whether its surface bounds the solid everywhere: as far as is seen, nothing of it lies inside,
  /// as where parts overlap.
  bool is_plain() const { return is_plain_; }

  /// A point half way from the surface to the surface on the other side.
  struct Middle {
    Vec3 point = Vec3::Zero();
    double width = 0;  ///< m, from surface to surface
  };
  /// Such points under the triangles; of large meshes under some, evenly taken.
  const std::vector<Middle>& middles() const { return middles_; }

 private:
  void look_under(int triangle, const Vec3& from, bool keep);

  const TriangleSoup* soup_;
  InsideGrid grid_;
  bool is_plain_ = true;
  std::vector<Vec3> outwards_;
  std::vector<double> widths_;
  double least_width_ = std::numeric_limits<double>::infinity();
  std::vector<Middle> middles_;
};

}  // namespace rubicon::collision
