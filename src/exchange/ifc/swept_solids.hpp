#pragma once

#include <optional>
#include <vector>

#include "src/exchange/ifc/ifc_profile.hpp"
#include "src/exchange/ifc/solid.hpp"

namespace rubicon::ifc {

// Bodies that an area makes on its way. Closed, outwards, in the units of what goes in. Nothing if
// the area cannot be split into triangles, or the body has no volume.

/// A region in the plane z 0 (or any other) moved along `way`.
std::optional<Solid> extruded(const Region& region, const math::Vec3& way, WorkBudget& budget);

/// A line that things turn about.
struct Axis {
  math::Vec3 point = math::Vec3::Zero();
  math::Vec3 direction = math::Vec3::UnitZ();  ///< of length 1
};

/// A region turned about an axis in its plane, by up to 360 degrees, in chords.
std::optional<Solid> revolved(const Region& region, const Axis& axis, double turn_deg,
                              double metres_per_unit, WorkBudget& budget);

/// A round bar or, with `inner` above zero, a pipe along a line of points, mitred at its corners.
/// Nothing also where it turns back, or a corner is too near to the next to be mitred.
std::optional<Solid> swept_disk(const std::vector<math::Vec3>& line, double radius, double inner,
                                double metres_per_unit, WorkBudget& budget);

}  // namespace rubicon::ifc
