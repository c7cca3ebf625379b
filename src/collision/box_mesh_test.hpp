#pragma once

#include "src/collision/swept_box.hpp"
#include "src/collision/triangle_soup.hpp"

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

/// Keeps those of the packs `first` to `last` whose triangles the box is not proved to be free of
/// (for a translation, those it meets by more than the tolerance) in front; the end of these.
/// `contact_tolerance` (m) is what the box allows.
int* packs_in_the_way(const BoxPassage& passage, const TriangleSoup& soup, double contact_tolerance,
                      int* first, int* last);

}  // namespace rubicon::collision
