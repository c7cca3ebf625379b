#pragma once

#include <vector>

#include "src/motion/collision/base/verdict.hpp"
#include "src/motion/collision/sweep/box_passage.hpp"
#include "src/motion/collision/sweep/sweep.hpp"

namespace rubicon::collision {

/// A moving box against a mesh that stands, or a moving mesh against a box that stands; in the
/// frame of the mesh it is always the box that moves.
class BoxMeshNarrowPhase {
 public:
  /// `mesh_moves`: the soup belongs to the moving body, the box to the standing one, which `X_WB`
  /// places; otherwise the other way round. The box need not be exact (`BodyPart::is_box`); what is
  /// then met is undecided.
  BoxMeshNarrowPhase(const Sweep& sweep, const BodyPart& box, const TriangleSoup& soup,
                     bool mesh_moves, const Placement& X_WB, double contact_tolerance);

  Verdict verdict(SweepSlice& slice) const;
  /// The box over a slice, in the frame of the mesh. Not for a mesh in general motion.
  BoxPassage passage(SweepSlice& slice) const;

 private:
  OrientedBox box_at(const Placement& pose) const;
  BoxPass still_at(const Placement& pose) const;
  bool meets(const BoxPass& pass, int pack) const;
  Verdict on_slice(SweepSlice& slice, const BoxPassage& whole, const int* first, const int* last,
                   int halvings) const;

  const Sweep& sweep_;
  const BodyPart& box_;
  const TriangleSoup& soup_;
  bool mesh_moves_;
  const Placement& X_WB_;
  double tolerance_;
};

}  // namespace rubicon::collision
