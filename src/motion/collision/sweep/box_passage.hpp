#pragma once

#include "src/motion/collision/mesh/triangle_soup.hpp"
#include "src/motion/collision/sweep/swept_box.hpp"
#include "src/motion/collision/tree/triangle_pack.hpp"

namespace rubicon::collision {

/// A box that moves over an interval, in the frame of a mesh.
struct BoxPassage {
  TurnedBox box;
  Mat3 R_middle = Mat3::Identity();
  Vec3 middle = Vec3::Zero();  ///< of the centre
  bool translation = false;    ///< R_start, R_middle and R_end are the same
};

/// The packs of a soup that a moving box may come near, in the order of the tree.
void collect_packs(const BoxPassage& passage, const TriangleSoup& soup, ItemList& found);

/// The same passage as the kernels want it; `contact_tolerance` (m) is what the box allows.
BoxPass box_pass(const BoxPassage& passage, double contact_tolerance);

}  // namespace rubicon::collision
