#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "src/exchange/ifc/solid.hpp"

namespace rubicon::ifc {

/// Where something of a part of a body comes from.
inline constexpr int kFromCut = -1;

/// A part of a body: where its triangles and its new corners come from.
struct SolidPart {
  Solid solid;
  std::vector<int> source;  ///< of each triangle the one of the body that it lies in, or kFromCut
  /// Of new corners that lie on an edge of the body: its ends, the smaller number first.
  std::map<int, std::pair<int, int>> edge_of;
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
