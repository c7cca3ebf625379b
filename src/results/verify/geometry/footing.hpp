#pragma once

#include <array>
#include <vector>

#include "src/results/verify/input/scene.hpp"

namespace rubicon::verify {

/// A body by the triangles of its surface, seen from outside counter-clockwise, and its centre of
/// mass (uniform density). Metres, its own frame.
struct Hull {
  struct Triangle {
    std::array<Vec3, 3> corners;
    bool two_sided = false;  ///< of a mesh that is not closed
  };
  std::vector<Triangle> triangles;
  Vec3 centre_of_mass = Vec3::Zero();
  bool is_round = false;  ///< some triangles are inside of what they stand for
};
Hull hull_of(const std::vector<ShapeData>& shapes, const std::vector<MeshData>& meshes);

/// A body where it stands: what looks down, or up, as triangles in {W}.
using Faces = std::vector<std::array<Vec3, 3>>;
Faces faces_looking(const Hull& hull, const Pose& X_WS, bool up);

/// Where the sides of the triangles of `over`, seen from above, are from `depth` below to `gap`
/// above those of `under`, and the other way round: their ends are the corners of the contact.
std::vector<Eigen::Vector2d> footing(const Faces& over, const Faces& under, double gap,
                                     double depth);

/// The same, on the lower face, with its normal (unit, upwards).
struct FootingPoint {
  Vec3 point, normal;
};
std::vector<FootingPoint> footing_points(const Faces& over, const Faces& under, double gap,
                                         double depth);

/// What is left of where a body rests if in each plane only what is `margin` (m) inside carries:
/// the corners. Where that is narrower than twice the margin it is less of it.
std::vector<FootingPoint> drawn_in(const std::vector<FootingPoint>& points, double margin);

/// Whether some point is `margin` (m) inside of what is around the points.
bool is_as_wide(const std::vector<Eigen::Vector2d>& points, double margin);

/// Whether no line through p has all points on one side of it, nor does one that is nearer than
/// `margin` (m).
bool is_between(const Eigen::Vector2d& p, const std::vector<Eigen::Vector2d>& points,
                double margin);

}  // namespace rubicon::verify
