#pragma once

#include <memory>
#include <vector>

#include "src/motion/geometry/shape.hpp"

namespace rubicon::site {

/// A flat convex piece of a surface.
struct SurfaceFacet {
  std::vector<math::Vec3> corners;  ///< in order
  math::Vec3 normal = math::Vec3::Zero();
  bool two_sided = false;  ///< of a mesh that is not closed: nobody knows which side is out
};

/// What a body rests with, and others on it: its surface in flat pieces and its centre of mass
/// (uniform density; of a mesh that is not closed that of its surface). Its own frame, metres.
struct SupportSurface {
  std::vector<SurfaceFacet> facets;
  math::Vec3 centre_of_mass = math::Vec3::Zero();
  math::Vec3 lower = math::Vec3::Zero();  ///< corners of the box around it
  math::Vec3 upper = math::Vec3::Zero();
};
using SupportSurfacePtr = std::shared_ptr<const SupportSurface>;  // shared: panels are many

/// Null without shapes. Round shapes become facets inside of them, nowhere farther from the true
/// surface than 1 mm or a 3000th of the radius.
SupportSurfacePtr make_support_surface(const std::vector<geometry::Shape>& shapes);

}  // namespace rubicon::site
