#include "src/collision/quick_test.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "src/collision/box_mesh_test.hpp"
#include "src/collision/kernels.hpp"
#include "src/collision/tolerances.hpp"

namespace rubicon::collision {
namespace {

/// Times a slice is halved for boxes that are neither proved free nor seen to hit; the growth falls
/// to a quarter each time.
constexpr int kHalvings = 8;

/// The tolerance for the boxes around two parts. Soups: their triangles may be too small to be
/// allowed more.
double part_tolerance(const BodyPart& a, const BodyPart& b, double contact_tolerance) {
  if (a.soup >= 0 || b.soup >= 0) return kRoundingDepth;
  return pair_tolerance(a.width, b.width, contact_tolerance);
}

/// One moving part against one that stands.
class PartTest {
 public:
  /// `fixed_box` is that of the standing part, world.
  PartTest(const Sweep& sweep, const BodyPart& moving, const BodyPart& fixed,
           const OrientedBox& fixed_box, double tolerance)
      : sweep_(sweep),
        moving_(moving),
        fixed_(fixed_box),
        both_boxes_(moving.is_box && fixed.is_box),
        around_mesh_(moving.soup >= 0 || fixed.soup >= 0),
        tolerance_(tolerance) {}

  Verdict verdict(SweepSlice& slice) const {
    if (sweep_.is_translation()) {
      return exact_or_undecided(translated_box_verdict(
          placed(moving_.box, slice.start()), slice.end().t - slice.start().t, fixed_, tolerance_));
    }
    const TurnedBox box = turned(slice);
    const TurnedBoxTest test(box, fixed_, tolerance_);
    if (test.free_along_fixed_normals()) return Verdict::kFree;
    if (both_boxes_ && deep_at(slice.start())) return Verdict::kHit;
    return on_slice(slice, test, kHalvings);
  }

 private:
  /// Whatever a box around a part hits, the part may miss.
  Verdict exact_or_undecided(Verdict found) const {
    return found == Verdict::kHit && !both_boxes_ ? Verdict::kUndecided : found;
  }

  TurnedBox turned(SweepSlice& slice) const {
    TurnedBox box;
    box.R_start = part_rotation(slice.start());
    box.R_end = part_rotation(slice.end());
    box.start = slice.start() * moving_.box.centre;
    box.end = slice.end() * moving_.box.centre;
    box.half = moving_.box.half;
    box.growth_axis = slice.axis();
    box.uniform_growth = slice.uniform_growth();
    if (slice.bulge() > 0) {
      const double lever =
          slice.axis().cross(box.start - slice.point()).norm() + moving_.box.half.norm();
      box.axial_growth = slice.bulge() * lever;
    }
    return box;
  }

  /// For a slice that is not free along the normals of the standing box. A pose that is deep is
  /// looked for before the many products of edges are tried.
  Verdict on_slice(SweepSlice& slice, const TurnedBoxTest& test, int halvings) const {
    const Mat3 R_middle = part_rotation(slice.middle());
    if (test.free_along_moving_normals(R_middle)) return Verdict::kFree;
    if (both_boxes_ && (deep_at(slice.middle()) || deep_at(slice.end()))) return Verdict::kHit;
    // For the box around a mesh the many other axes are not worth it: its triangles are asked next.
    if (around_mesh_) return Verdict::kUndecided;
    if (test.free_along_edges(R_middle)) return Verdict::kFree;
    if (!both_boxes_ || halvings == 0) return Verdict::kUndecided;
    for (SweepSlice* half : {&slice.first_half(), &slice.second_half()}) {
      const TurnedBox box = turned(*half);
      const TurnedBoxTest half_test(box, fixed_, tolerance_);
      if (half_test.free_along_fixed_normals()) continue;
      const Verdict found = on_slice(*half, half_test, halvings - 1);
      if (found != Verdict::kFree) return found;
    }
    return Verdict::kFree;
  }

  Mat3 part_rotation(const Placement& pose) const {
    return moving_.aligned ? pose.R : Mat3(pose.R * moving_.box.R);
  }

  bool deep_at(const Placement& pose) const {
    return translated_box_verdict(placed(moving_.box, pose), Vec3::Zero(), fixed_, tolerance_) ==
           Verdict::kHit;
  }

  const Sweep& sweep_;
  const BodyPart& moving_;
  const OrientedBox& fixed_;
  bool both_boxes_;
  bool around_mesh_;
  double tolerance_;
};

/// A moving box against a mesh that stands, or a moving mesh against a box that stands; in the
/// frame of the mesh it is always the box that moves.
class MeshTest {
 public:
  /// `mesh_moves`: the soup belongs to the moving body; `X_WB` places the standing one.
  MeshTest(const Sweep& sweep, const BodyPart& box, const TriangleSoup& soup, bool mesh_moves,
           const Placement& X_WB, double contact_tolerance)
      : sweep_(sweep),
        box_(box),
        soup_(soup),
        mesh_moves_(mesh_moves),
        X_WB_(X_WB),
        tolerance_(pair_tolerance(box.width, box.width, contact_tolerance)) {}

  Verdict verdict(SweepSlice& slice) const {
    // Seen from a moving mesh a general motion has another bound.
    if (mesh_moves_ && slice.uniform_growth() > 0) return Verdict::kUndecided;
    const BoxPassage whole = passage(slice);
    ItemList packs;
    collect_packs(whole, soup_, packs);
    if (packs.size() == 0) return Verdict::kFree;
    return on_slice(slice, whole, packs, kHalvings);
  }

 private:
  /// The box at a pose of the moving body, in the frame of the mesh.
  OrientedBox box_at(const Placement& pose) const {
    const Placement& mesh = mesh_moves_ ? pose : X_WB_;
    const Placement& other = mesh_moves_ ? X_WB_ : pose;
    const Mat3 to_mesh = mesh.R.transpose();
    const Mat3 R = to_mesh * other.R;
    return {box_.aligned ? R : Mat3(R * box_.box.R),
            to_mesh * (other.t - mesh.t) + R * box_.box.centre, box_.box.half};
  }

  BoxPassage passage(SweepSlice& slice) const {
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
    if (slice.bulge() > 0) {
      const Vec3 centre = mesh * start.centre;
      const double lever = slice.axis().cross(centre - slice.point()).norm() + box_.box.half.norm();
      result.box.axial_growth = slice.bulge() * lever;
    }
    return result;
  }

  BoxPass still_at(const Placement& pose) const {
    const OrientedBox box = box_at(pose);
    BoxPassage still;
    still.box.R_start = still.box.R_end = still.R_middle = box.R;
    still.box.start = still.box.end = still.middle = box.centre;
    still.box.half = box.half;
    still.translation = true;
    return box_pass(still, tolerance_);
  }

  bool meets(const BoxPass& pass, int pack) const {
    return kernels().meeting_triangles(pass, soup_.packs()[static_cast<std::size_t>(pack)]) != 0;
  }

  template <typename Packs>
  Verdict on_slice(SweepSlice& slice, const BoxPassage& whole, const Packs& packs,
                   int halvings) const {
    const BoxPass sweep = box_pass(whole, tolerance_);
    std::optional<BoxPass> middle;
    std::optional<BoxPass> end;
    std::vector<int> open;
    for (const int pack : packs) {
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
      const Verdict found = on_slice(*half, passage(*half), open, halvings - 1);
      if (found != Verdict::kFree) return found;
    }
    return Verdict::kFree;
  }

  const Sweep& sweep_;
  const BodyPart& box_;
  const TriangleSoup& soup_;
  bool mesh_moves_;
  const Placement& X_WB_;
  double tolerance_;
};

/// Over one slice, two parts of which at most one is a mesh.
Verdict part_verdict(Sweep& sweep, SweepSlice& slice, const BodyPart& moving, const Body& standing,
                     const BodyPart& fixed, const OrientedBox& fixed_box, const Placement& X_WB,
                     double contact_tolerance) {
  const PartTest boxes(sweep, moving, fixed, fixed_box,
                       part_tolerance(moving, fixed, contact_tolerance));
  const Verdict found = boxes.verdict(slice);
  const bool one_mesh = (moving.soup >= 0) != (fixed.soup >= 0);
  if (found != Verdict::kUndecided || !one_mesh) return found;
  const bool mesh_moves = moving.soup >= 0;
  const TriangleSoup& soup =
      mesh_moves ? sweep.body().soups()[moving.soup] : standing.soups()[fixed.soup];
  return MeshTest(sweep, mesh_moves ? fixed : moving, soup, mesh_moves, X_WB, contact_tolerance)
      .verdict(slice);
}

}  // namespace

Verdict quick_verdict(Sweep& sweep, const Body& standing, const Placement& X_WB,
                      double contact_tolerance) {
  Verdict result = Verdict::kFree;
  for (const BodyPart& fixed : standing.parts()) {
    const OrientedBox fixed_box = placed(fixed.box, X_WB);
    for (const BodyPart& moving : sweep.body().parts()) {
      for (int i = 0; i < sweep.slice_count(); ++i) {
        const Verdict found = part_verdict(sweep, sweep.slice(i), moving, standing, fixed,
                                           fixed_box, X_WB, contact_tolerance);
        if (found == Verdict::kHit) return found;
        if (found == Verdict::kUndecided) result = found;
      }
    }
  }
  return result;
}

}  // namespace rubicon::collision
