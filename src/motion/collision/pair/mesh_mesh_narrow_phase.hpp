#pragma once

#include <vector>

#include "src/motion/collision/base/verdict.hpp"
#include "src/motion/collision/sweep/box_passage.hpp"
#include "src/motion/collision/sweep/sweep.hpp"
#include "src/motion/collision/tree/triangle_pack.hpp"

namespace rubicon::collision {

/// A moving mesh against one that stands, triangle against four triangles.
class MeshMeshNarrowPhase {
 public:
  /// `fixed_part` is the part of `fixed`, `X_WB` places its body.
  MeshMeshNarrowPhase(const Sweep& sweep, const TriangleSoup& moving, const BodyPart& fixed_part,
                      const TriangleSoup& fixed, const Placement& X_WB, double contact_tolerance);

  Verdict verdict(SweepSlice& slice) const;

 private:
  /// A triangle of the moving mesh and four of the standing one that are not yet proved free.
  struct Open {
    int triangle = 0;
    int pack = 0;
  };
  /// The poses of a slice as the standing body sees them.
  struct Seen;

  void own_packs(SweepSlice& slice, ItemList& found) const;
  BoxPassage passage(const Seen& poses, int own) const;
  void packs_near(const Seen& poses, int own, ItemList& found) const;
  Seen seen(SweepSlice& slice) const;
  TrianglePass pass(const Seen& poses, int triangle) const;
  TrianglePass still(const Placement& pose, int triangle) const;
  bool meets(const TrianglePass& moving, int pack) const;
  bool deep_at_a_pose(const Open& pair, const Seen& poses, bool start_too) const;
  Verdict in_halves(SweepSlice& slice, const std::vector<Open>& open, int halvings) const;

  const Sweep& sweep_;
  const TriangleSoup& moving_;
  const BodyPart& fixed_part_;
  const TriangleSoup& fixed_;
  const Placement& X_WB_;
  double contact_tolerance_;
};

}  // namespace rubicon::collision
