#include "src/collision/quick_test.hpp"

#include <algorithm>

#include "src/collision/pair_test.hpp"
#include "src/collision/tolerances.hpp"

namespace rubicon::collision {
namespace {

/// Times a slice is halved for boxes that are neither proved free nor seen to hit; the growth falls
/// to a quarter each time.
constexpr int kHalvings = 4;

/// The tolerance of two parts. Soups: their triangles may be too small to be allowed more.
double part_tolerance(const BodyPart& a, const BodyPart& b, double contact_tolerance) {
  if (a.soup >= 0 || b.soup >= 0) return kRoundingDepth;
  return pair_tolerance(a.width, b.width, contact_tolerance);
}

/// One moving part against one that stands.
class PartTest {
 public:
  PartTest(const Sweep& sweep, const BodyPart& moving, const OrientedBox& fixed, bool fixed_is_box,
           double tolerance)
      : sweep_(sweep),
        moving_(moving),
        fixed_(fixed),
        both_boxes_(moving.is_box && fixed_is_box),
        tolerance_(tolerance) {}

  Verdict verdict(SweepSlice& slice) const {
    if (sweep_.is_translation()) {
      return exact_or_undecided(translated_box_verdict(
          placed(moving_.box, slice.start()), slice.end().t - slice.start().t, fixed_, tolerance_));
    }
    const Verdict whole = turned(slice);
    if (whole == Verdict::kFree || !both_boxes_) return whole;
    if (deep_at(slice.start())) return Verdict::kHit;
    return halved(slice, kHalvings);
  }

 private:
  /// Whatever a box around a part hits, the part may miss.
  Verdict exact_or_undecided(Verdict found) const {
    return found == Verdict::kHit && !both_boxes_ ? Verdict::kUndecided : found;
  }

  Verdict turned(SweepSlice& slice) const {
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
    const TurnedBoxTest test(box, fixed_, tolerance_);
    const bool free =
        test.free_along_fixed_normals() || test.free_along_others(part_rotation(slice.middle()));
    return free ? Verdict::kFree : Verdict::kUndecided;
  }

  Mat3 part_rotation(const Placement& pose) const {
    return moving_.aligned ? pose.R : Mat3(pose.R * moving_.box.R);
  }

  bool deep_at(const Placement& pose) const {
    return translated_box_verdict(placed(moving_.box, pose), Vec3::Zero(), fixed_, tolerance_) ==
           Verdict::kHit;
  }

  Verdict halved(SweepSlice& slice, int halvings) const {
    if (deep_at(slice.middle())) return Verdict::kHit;
    if (halvings == 0) return Verdict::kUndecided;
    for (SweepSlice* half : {&slice.first_half(), &slice.second_half()}) {
      if (turned(*half) == Verdict::kFree) continue;
      const Verdict found = halved(*half, halvings - 1);
      if (found != Verdict::kFree) return found;
    }
    return Verdict::kFree;
  }

  const Sweep& sweep_;
  const BodyPart& moving_;
  const OrientedBox& fixed_;
  bool both_boxes_;
  double tolerance_;
};

}  // namespace

Verdict quick_verdict(Sweep& sweep, const Body& standing, const Placement& X_WB,
                      double contact_tolerance) {
  Verdict result = Verdict::kFree;
  for (const BodyPart& fixed : standing.parts()) {
    const OrientedBox fixed_box = placed(fixed.box, X_WB);
    for (const BodyPart& moving : sweep.body().parts()) {
      const PartTest test(sweep, moving, fixed_box, fixed.is_box,
                          part_tolerance(moving, fixed, contact_tolerance));
      for (int i = 0; i < sweep.slice_count(); ++i) {
        const Verdict found = test.verdict(sweep.slice(i));
        if (found == Verdict::kHit) return found;
        if (found == Verdict::kUndecided) result = found;
      }
    }
  }
  return result;
}

}  // namespace rubicon::collision
