#pragma once

#include <optional>
#include <vector>

#include "src/ifc/solid.hpp"

namespace rubicon::ifc {

/// Where something of a part of a body comes from.
inline constexpr int kFromCut = -1;

/// A part of a body: of each triangle the one of the body that it lies in, or kFromCut.
struct SolidPart {
  Solid solid;
  std::vector<int> source;
};

/// The whole of a body as a part of it.
SolidPart whole(const Solid& solid);

/// A part cut in two. Corners keep their numbers; new ones, the same for both sides, come behind.
struct SplitSolid {
  SolidPart inside, outside;  ///< without triangles: nothing is there
};

/// Cuts a closed body with a plane and closes both parts. What lies on the plane within kOnPlane
/// belongs to the part it bounds. Nothing if the section cannot be closed.
std::optional<SplitSolid> split(const SolidPart& part, const HalfSpace& plane, WorkBudget& budget);

}  // namespace rubicon::ifc
