#include <fmt/format.h>

#include "tests/proof/convex_truth.hpp"
#include "tests/proof/generators.hpp"
#include "tests/proof/graze.hpp"

namespace rubicon::collision::proof {
namespace {

Truth truth_of(const Solid& a, const Path& path, const Solid& b, const Pose& X_WB,
               double tolerance) {
  return a.is_polytope() && b.is_polytope()
             ? polytopes_truth(a.polytope(), path, b.polytope(), standing(X_WB), tolerance)
             : fcl_truth(a, path, b, X_WB, tolerance);
}

/// Boxes, prisms, spheres, capsules and cylinders; two polytopes are judged by their axes, anything
/// round by fcl::collide.
void convex(Random& random, CaseRecord& record) {
  const Solid a = random_solid(random, 0.05, 0.8);
  const Solid b = random_solid(random, 0.05, 0.8);
  PathSizes sizes;
  sizes.angle_deg = random.below(2) ? 60 : 5;
  sizes.may_be_tiny = true;
  const Path path = random_path(random, random.pose(0.9), sizes);
  Pose X_WB = random.pose(0.9);
  constexpr double kTolerances[] = {1e-3, 1e-3, 1e-2};
  const double tolerance = kTolerances[random.below(3)];
  const bool has_axes = a.is_polytope() && b.is_polytope();
  const bool grazes = random.below(kGrazeEvery) == 0;
  if (grazes) {
    const auto shifted = [&](const Vec3& offset) {
      Pose X = X_WB;
      X.translation() += offset;
      return X;
    };
    const Vec3 towards = path.pose(random.unit()).translation() - X_WB.translation();
    X_WB = shifted(grazing_offset(
        random, towards, has_axes && path.translates() ? 4 * kExactBand : 4 * kBand,
        [&](const Vec3& offset) { return truth_of(a, path, b, shifted(offset), tolerance); }));
  }
  Outcome outcome;
  outcome.motion = path.kind;
  outcome.grazes = grazes;
  outcome.truth = truth_of(a, path, b, X_WB, tolerance);
  if (has_axes && random.below(kThirdVoiceEvery) == 0)
    outcome.third = fcl_truth(a, path, b, X_WB, tolerance);
  outcome.engine_hit =
      test::blocked(*prepare({a.shape()}), path.motion, prepare({b.shape()}), X_WB, tolerance);
  outcome.fcl_hit = fcl_continuous(a.fcl(), path, b.fcl(), X_WB);
  record.outcomes.push_back(outcome);
  record.note([&] {
    return fmt::format("a: {} from {} to {}\nb: {} {}\ntolerance {} m", text_of(a),
                       text_of(path.pose(0)), text_of(path.pose(1)), text_of(b), text_of(X_WB),
                       tolerance);
  });
}

constexpr Generator kConvexGenerators[] = {
    {"convex", "prisms, cylinders, spheres, capsules, boxes", 12, 1, convex},
};

}  // namespace

std::span<const Generator> convex_generators() { return kConvexGenerators; }

}  // namespace rubicon::collision::proof
