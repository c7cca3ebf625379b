#pragma once

#include <optional>
#include <vector>

#include "src/exchange/ifc/solid.hpp"

namespace rubicon::ifc {

/// A convex region: what is inside of all its half spaces. It need not be bounded.
using Cell = std::vector<HalfSpace>;

/// A closed body as convex cells that touch: cut along its own faces until nothing sticks out.
/// Nothing if that takes too many cells, or the body cannot be cut.
std::optional<std::vector<Cell>> convex_cells(const Solid& body, WorkBudget& budget);

/// What of a closed body lies outside of a cell; without triangles: nothing does. Nothing if it
/// cannot be worked out. Where a cut fails because corners lie too near to a plane, the plane is
/// moved by up to kShift.
std::optional<Solid> subtract(const Solid& body, const Cell& cell, WorkBudget& budget);

/// What of a closed body lies inside of a cell; as above.
std::optional<Solid> intersect(const Solid& body, const Cell& cell, WorkBudget& budget);

/// Metres: far below what a building is measured in, a few times what is taken for touching.
inline constexpr double kShift = 1e-4;

}  // namespace rubicon::ifc
