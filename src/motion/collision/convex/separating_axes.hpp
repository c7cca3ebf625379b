#pragma once

#include <cstddef>

#include "src/motion/collision/convex/swept_pair.hpp"

namespace rubicon::collision {

/// Number of axes `separating_axis_exists` may have to try: face normals of both, edge x edge,
/// displacement x edge.
std::size_t separating_axis_count(const SweptPair& pair);

/// Whether one of the separating axes of two polytopes shows that the interval is free. For poses
/// and translations of polytopes without ball or disc the set is complete: false means deeper than
/// the tolerance along every direction (Gottschalk, Lin, Manocha 1996, with the swept edges d x e
/// of docs/collision.md). For a rotation the axes are those of the middle pose and false means
/// undecided.
bool separating_axis_exists(const SweptPair& pair);

/// Only the face normals, cylinder axes and, for cylinders, axis x edge: the directions of ordinary
/// contact.
bool contact_axis_exists(const SweptPair& pair);

}  // namespace rubicon::collision
