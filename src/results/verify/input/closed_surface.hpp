#pragma once

#include <array>
#include <optional>
#include <vector>

#include "src/results/verify/input/box_tree.hpp"

namespace rubicon::verify {

/// A point well inside of something, and how thick that is there (m).
struct InnerPoint {
  Vec3 p = Vec3::Zero();
  double width = 0;
};

/// A surface of triangles that encloses a volume, triangles facing outwards. What is inside is told
/// by winding numbers, so a part that is turned inside out is a cavity.
class ClosedSurface {
 public:
  ClosedSurface() = default;
  ClosedSurface(std::vector<Vec3> vertices, std::vector<std::array<int, 3>> triangles);

  bool empty() const { return triangles_.empty(); }
  const Bounds& bounds() const { return tree_.nodes().front().bounds; }

  /// Whether p is inside and farther than `depth` from the surface.
  bool holds(const Vec3& p, double depth) const;

  /// Points well inside: under triangles, half way to the other side; of at most `count` triangles.
  std::vector<InnerPoint> inner_points(std::size_t count) const;

 private:
  struct Crossings {
    int winding = 0;
    double nearest = 0;    ///< along the ray
    bool grazing = false;  ///< too near to an edge to tell
  };
  std::array<Vec3, 3> corners(int triangle) const;
  Crossings cross(const Vec3& from, const Vec3& direction) const;
  int winding(const Vec3& p) const;
  int winding_by_angles(const Vec3& p) const;
  bool nearer_than(const Vec3& p, double distance) const;

  std::vector<Vec3> vertices_;
  std::vector<std::array<int, 3>> triangles_;
  BoxTree tree_;
};

/// The point of a triangle that is nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
Vec3 nearest_of_triangle(const Vec3& p, const std::array<Vec3, 3>& triangle);

}  // namespace rubicon::verify
