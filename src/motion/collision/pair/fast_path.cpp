#include "src/motion/collision/pair/fast_path.hpp"

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/pair/box_mesh_narrow_phase.hpp"
#include "src/motion/collision/pair/containment.hpp"
#include "src/motion/collision/pair/mesh_mesh_narrow_phase.hpp"

namespace rubicon::collision {
namespace {

/// A mesh that goes farther in a slice than this share of half the diagonal of its box is looked at
/// in halves, so many times at most.
constexpr double kFarWay = 0.6;
constexpr int kMeshHalvings = 3;

/// The tolerance for the boxes around two parts. Soups: their triangles may be too small to be
/// allowed more.
double part_tolerance(const BodyPart& a, const BodyPart& b, double contact_tolerance) {
  if (a.soup >= 0 || b.soup >= 0) return kRoundingDepth;
  return pair_tolerance(a.width, b.width, contact_tolerance);
}

/// One moving part against one that stands.
class PartBoxes {
 public:
  /// `fixed_box` is that of the standing part, world.
  PartBoxes(const Sweep& sweep, const BodyPart& moving, const BodyPart& fixed,
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
    const TurnedBoxAxes axes(box, fixed_, tolerance_);
    if (axes.free_along_fixed_normals()) return Verdict::kFree;
    if (both_boxes_ && deep_at(slice.start())) return Verdict::kHit;
    return on_slice(slice, axes, kHalvings);
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
    if (slice.unit_sagitta() > 0) {
      const double radius =
          slice.axis().cross(box.start - slice.point()).norm() + moving_.box.half.norm();
      box.axial_growth = slice.unit_sagitta() * radius;
    }
    return box;
  }

  /// For a slice that is not free along the normals of the standing box. A pose that is deep is
  /// looked for before the many products of edges are tried.
  Verdict on_slice(SweepSlice& slice, const TurnedBoxAxes& axes, int halvings) const {
    const Mat3 R_middle = part_rotation(slice.middle());
    if (axes.free_along_moving_normals(R_middle)) return Verdict::kFree;
    if (both_boxes_ && (deep_at(slice.middle()) || deep_at(slice.end()))) return Verdict::kHit;
    // For the box around a mesh the many other axes are not worth it: its triangles are asked next.
    if (around_mesh_) return Verdict::kUndecided;
    if (axes.free_along_edges(R_middle)) return Verdict::kFree;
    if (!both_boxes_ || halvings == 0) return Verdict::kUndecided;
    for (SweepSlice* half : {&slice.first_half(), &slice.second_half()}) {
      const TurnedBox box = turned(*half);
      const TurnedBoxAxes half_axes(box, fixed_, tolerance_);
      if (half_axes.free_along_fixed_normals()) continue;
      const Verdict found = on_slice(*half, half_axes, halvings - 1);
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

/// Whether a mesh goes so far in a slice, beside its size, that most of its triangles are near
/// those of the other only in a part of it. Then halves are less work than the whole.
bool goes_far(const SweepSlice& slice, const BodyPart& moving) {
  const Vec3 way = slice.end() * moving.box.centre - slice.start() * moving.box.centre;
  return way.squaredNorm() > kFarWay * kFarWay * moving.box.half.squaredNorm();
}

/// Over one slice, two parts.
Verdict part_verdict(Sweep& sweep, SweepSlice& slice, const BodyPart& moving, const Body& standing,
                     const BodyPart& fixed, const OrientedBox& fixed_box, const Placement& X_WB,
                     double contact_tolerance, int halvings) {
  const PartBoxes boxes(sweep, moving, fixed, fixed_box,
                        part_tolerance(moving, fixed, contact_tolerance));
  const Verdict found = boxes.verdict(slice);
  if (found != Verdict::kUndecided) return found;
  const TriangleSoup* moving_soup = moving.soup < 0 ? nullptr : &sweep.body().soups()[moving.soup];
  const TriangleSoup* fixed_soup = fixed.soup < 0 ? nullptr : &standing.soups()[fixed.soup];
  if (moving_soup != nullptr && fixed_soup != nullptr) {
    // Most steps that hit end inside: then nobody need look where the surfaces cross.
    if (!sweep.is_translation() && slice.s0() == 0 && halvings == kMeshHalvings &&
        surely_contained(sweep.body(), standing,
                         relative(sweep.slice(sweep.slice_count() - 1).end(), X_WB),
                         contact_tolerance)) {
      return Verdict::kHit;
    }
    if (halvings > 0 && !sweep.is_translation() && goes_far(slice, moving)) {
      Verdict result = Verdict::kFree;
      for (SweepSlice* half : {&slice.first_half(), &slice.second_half()}) {
        const Verdict of_half = part_verdict(sweep, *half, moving, standing, fixed, fixed_box, X_WB,
                                             contact_tolerance, halvings - 1);
        if (of_half == Verdict::kHit) return of_half;
        if (of_half == Verdict::kUndecided) result = of_half;
      }
      return result;
    }
    return MeshMeshNarrowPhase(sweep, *moving_soup, fixed, *fixed_soup, X_WB, contact_tolerance)
        .verdict(slice);
  }
  if (moving_soup != nullptr) {
    return BoxMeshNarrowPhase(sweep, fixed, *moving_soup, true, X_WB, contact_tolerance)
        .verdict(slice);
  }
  if (fixed_soup != nullptr) {
    return BoxMeshNarrowPhase(sweep, moving, *fixed_soup, false, X_WB, contact_tolerance)
        .verdict(slice);
  }
  return found;
}

}  // namespace

Verdict fast_path_verdict(Sweep& sweep, const Body& standing, const Placement& X_WB,
                          double contact_tolerance) {
  Verdict result = Verdict::kFree;
  const auto look_at = [&](const BodyPart& fixed) {
    const OrientedBox fixed_box = placed(fixed.box, X_WB);
    for (const BodyPart& moving : sweep.body().parts()) {
      for (int i = 0; i < sweep.slice_count() && result != Verdict::kHit; ++i) {
        const Verdict found = part_verdict(sweep, sweep.slice(i), moving, standing, fixed,
                                           fixed_box, X_WB, contact_tolerance, kMeshHalvings);
        if (found != Verdict::kFree) result = found;
      }
    }
  };
  if (standing.part_tree().size() == 0) {
    for (const BodyPart& part : standing.parts()) look_at(part);
    return result;
  }
  ItemList near;
  standing.part_tree().collect(placed(sweep.bounds(), X_WB.inverse()), near);
  for (const int part : near) look_at(standing.parts()[static_cast<std::size_t>(part)]);
  return result;
}

}  // namespace rubicon::collision
