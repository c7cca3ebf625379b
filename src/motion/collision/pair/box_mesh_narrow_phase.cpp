#include "src/motion/collision/pair/box_mesh_narrow_phase.hpp"

#include <optional>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/tree/kernels.hpp"

namespace rubicon::collision {

BoxMeshNarrowPhase::BoxMeshNarrowPhase(const Sweep& sweep, const BodyPart& box,
                                       const TriangleSoup& soup, bool mesh_moves,
                                       const Placement& X_WB, double contact_tolerance)
    : sweep_(sweep),
      box_(box),
      soup_(soup),
      mesh_moves_(mesh_moves),
      X_WB_(X_WB),
      tolerance_(pair_tolerance(box.width, box.width, contact_tolerance)) {}

Verdict BoxMeshNarrowPhase::verdict(SweepSlice& slice) const {
  // Seen from a moving mesh a general motion has another bound.
  if (mesh_moves_ && slice.uniform_growth() > 0) return Verdict::kUndecided;
  const BoxPassage whole = passage(slice);
  ItemList packs;
  collect_packs(whole, soup_, packs);
  if (packs.size() == 0) return Verdict::kFree;
  return on_slice(slice, whole, packs.begin(), packs.end(), kHalvings);
}

/// The box at a pose of the moving body, in the frame of the mesh.
OrientedBox BoxMeshNarrowPhase::box_at(const Placement& pose) const {
  const Placement& mesh = mesh_moves_ ? pose : X_WB_;
  const Placement& other = mesh_moves_ ? X_WB_ : pose;
  const Mat3 to_mesh = mesh.R.transpose();
  const Mat3 R = to_mesh * other.R;
  return {box_.aligned ? R : Mat3(R * box_.box.R),
          to_mesh * (other.t - mesh.t) + R * box_.box.centre, box_.box.half};
}

BoxPassage BoxMeshNarrowPhase::passage(SweepSlice& slice) const {
  BoxPassage result;
  const OrientedBox start = box_at(slice.start());
  const OrientedBox end = box_at(slice.end());
  result.box.R_start = start.R;
  result.box.start = start.centre;
  result.box.end = end.centre;
  result.box.half = box_.box.half;
  result.translation = sweep_.is_translation();
  if (result.translation) {
    result.box.R_end = start.R;
    result.R_middle = start.R;
    result.middle = 0.5 * (start.centre + end.centre);
    return result;
  }
  const OrientedBox middle = box_at(slice.middle());
  result.box.R_end = end.R;
  result.R_middle = middle.R;
  result.middle = middle.centre;
  const Placement& mesh = mesh_moves_ ? slice.start() : X_WB_;
  result.box.growth_axis = mesh.R.transpose() * slice.axis();
  result.box.uniform_growth = slice.uniform_growth();
  if (slice.unit_sagitta() > 0) {
    const Vec3 centre = mesh * start.centre;
    const double radius = slice.axis().cross(centre - slice.point()).norm() + box_.box.half.norm();
    result.box.axial_growth = slice.unit_sagitta() * radius;
  }
  return result;
}

BoxPass BoxMeshNarrowPhase::still_at(const Placement& pose) const {
  const OrientedBox box = box_at(pose);
  BoxPassage still;
  still.box.R_start = still.box.R_end = still.R_middle = box.R;
  still.box.start = still.box.end = still.middle = box.centre;
  still.box.half = box.half;
  still.translation = true;
  return box_pass(still, tolerance_);
}

bool BoxMeshNarrowPhase::meets(const BoxPass& pass, int pack) const {
  return kernels().meeting_triangles(pass, soup_.packs()[static_cast<std::size_t>(pack)]) != 0;
}

Verdict BoxMeshNarrowPhase::on_slice(SweepSlice& slice, const BoxPassage& whole, const int* first,
                                     const int* last, int halvings) const {
  const BoxPass sweep = box_pass(whole, tolerance_);
  std::optional<BoxPass> middle;
  std::optional<BoxPass> end;
  std::vector<int> open;
  for (const int* at = first; at != last; ++at) {
    const int pack = *at;
    if (!meets(sweep, pack)) continue;
    if (sweep_.is_translation()) return box_.is_box ? Verdict::kHit : Verdict::kUndecided;
    if (box_.is_box) {
      if (!middle) middle = still_at(slice.middle());
      if (!end) end = still_at(slice.end());
      if (meets(*middle, pack) || meets(*end, pack)) return Verdict::kHit;
      if (halvings == kHalvings && meets(still_at(slice.start()), pack)) return Verdict::kHit;
    }
    open.push_back(pack);
  }
  if (open.empty()) return Verdict::kFree;
  if (halvings == 0) return Verdict::kUndecided;
  for (SweepSlice* half : {&slice.first_half(), &slice.second_half()}) {
    const Verdict found =
        on_slice(*half, passage(*half), open.data(), open.data() + open.size(), halvings - 1);
    if (found != Verdict::kFree) return found;
  }
  return Verdict::kFree;
}

}  // namespace rubicon::collision
