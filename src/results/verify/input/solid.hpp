#pragma once

#include <memory>
#include <vector>

#include "src/results/verify/input/box_tree.hpp"
#include "src/results/verify/input/closed_surface.hpp"
#include "src/results/verify/input/scene.hpp"

namespace rubicon::verify {

/// A body as it is tested for contact: convex pieces, and the insides of closed meshes that are not
/// convex. Metres, in its own frame.
struct Solid {
  std::vector<Convex> pieces;
  BoxTree tree;  ///< of the pieces
  std::vector<ClosedSurface> surfaces;
  std::vector<InnerPoint> inner_points;
  Bounds bounds;
  Vec3 centre = Vec3::Zero();
  double radius = 0;  ///< no point is farther from the centre
};

/// A capsule from a to b (m). Throws nothing.
std::shared_ptr<const Solid> make_capsule(const Vec3& a, const Vec3& b, double radius);

/// The solid of some shapes; null if there are none. Throws UnreadableInput for shapes that are
/// none.
std::shared_ptr<const Solid> make_solid(const std::vector<ShapeData>& shapes,
                                        const std::vector<MeshData>& meshes);

/// All points nearer than `by` (m) to pieces of the solid; of a mesh that is not convex those near
/// its surface.
std::shared_ptr<const Solid> grown(const Solid& solid, double by);

}  // namespace rubicon::verify
