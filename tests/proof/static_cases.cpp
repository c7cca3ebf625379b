#include <fmt/format.h>

#include "tests/proof/convex_truth.hpp"
#include "tests/proof/generators.hpp"
#include "tests/proof/mesh_models.hpp"

namespace rubicon::collision::proof {
namespace {

/// The third voice speaks in one of so many cases of polytopes.
constexpr int kThirdVoiceAtPosesEvery = 64;

/// Half of the cases through `overlaps`, half through a world.
bool engine_blocked(const BodyPtr& a, const Pose& X_WA, const BodyPtr& b, const Pose& X_WB,
                    double tolerance, Random& random) {
  if (random.below(2)) return overlaps(*a, X_WA, *b, X_WB, tolerance);
  CollisionWorld world;
  world.insert(b, X_WB);
  return world.blocked_at(*a, X_WA, tolerance, {}).has_value();
}

void note_poses(CaseRecord& record, const std::string& a, const Pose& X_WA, const std::string& b,
                const Pose& X_WB, double tolerance) {
  record.note([&] {
    return fmt::format("a: {} {}\nb: {} {}\ntolerance {} m", a, text_of(X_WA), b, text_of(X_WB),
                       tolerance);
  });
}

Pose random_pose(Random& random) {
  Pose X = random.pose(0.9);
  const int aligned = random.below(4);
  if (aligned == 0) {
    X.linear() = math::rotation_about_deg(Vec3::Unit(random.below(3)), 90.0 * random.below(4));
    X.translation() = random.lattice_vector(1);
  }
  return X;
}

void static_boxes(Random& random, CaseRecord& record) {
  const auto half = [&] {
    return random.below(4) ? Vec3{random.between(0.02, 0.8), random.between(0.02, 0.8),
                                  random.between(0.02, 0.8)}
                           : Vec3{0.125 * (1 + random.below(6)), 0.125 * (1 + random.below(6)),
                                  0.125 * (1 + random.below(6))};
  };
  const Vec3 half_a = half();
  const Vec3 half_b = half();
  const Pose X_WA = random_pose(random);
  const Pose X_WB = random_pose(random);
  const double tolerance = random.below(2) ? 1e-3 : 1e-6;
  Outcome outcome;
  const double depth_m = test::box_depth({X_WA, half_a}, {X_WB, half_b});
  if (std::fabs(depth_m - tolerance) > kExactBand)
    outcome.truth = depth_m > tolerance ? Truth::kHit : Truth::kFree;
  outcome.engine_hit =
      engine_blocked(test::box(half_a), X_WA, test::box(half_b), X_WB, tolerance, random);
  outcome.fcl_hit = fcl_collide(fcl_box(half_a), X_WA, fcl_box(half_b), X_WB);
  record.outcomes.push_back(outcome);
  note_poses(record, text_of(box_solid(half_a)), X_WA, text_of(box_solid(half_b)), X_WB, tolerance);
}

void static_convexes(Random& random, CaseRecord& record) {
  const Solid a = random_solid(random, 0.05, 0.8);
  const Solid b = random_solid(random, 0.05, 0.8);
  const Pose X_WA = random_pose(random);
  const Pose X_WB = random_pose(random);
  const double tolerance = 1e-3;
  Outcome outcome;
  if (a.is_polytope() && b.is_polytope()) {
    outcome.truth =
        polytopes_truth(a.polytope(), standing(X_WA), b.polytope(), standing(X_WB), tolerance);
    if (random.below(kThirdVoiceAtPosesEvery) == 0)
      outcome.third = fcl_truth(a, standing(X_WA), b, X_WB, tolerance);
  } else {
    outcome.truth = fcl_truth(a, standing(X_WA), b, X_WB, tolerance);
  }
  outcome.engine_hit =
      engine_blocked(prepare({a.shape()}), X_WA, prepare({b.shape()}), X_WB, tolerance, random);
  outcome.fcl_hit = fcl_collide(a.fcl(), X_WA, b.fcl(), X_WB);
  record.outcomes.push_back(outcome);
  note_poses(record, text_of(a), X_WA, text_of(b), X_WB, tolerance);
}

void static_meshes(Random& random, CaseRecord& record) {
  const auto& models = fine_models();
  const MeshModel& model = models[random.below(static_cast<int>(models.size()))];
  const Solid solid = box_solid(
      Vec3{random.between(0.02, 0.4), random.between(0.02, 0.4), random.between(0.02, 0.4)});
  const Polytope polytope = solid.polytope();
  const Pose X_WM = random_pose(random);
  Pose X_WA = random_pose(random);
  X_WA.translation() =
      X_WM * model.mesh.vertices[random.below(static_cast<int>(model.mesh.vertices.size()))] +
      random.vector(0.5 * solid.reach() + 0.1);
  const double tolerance = 1e-3;
  Outcome outcome;
  outcome.truth =
      pieces_truth(pieces_of(polytope), standing(X_WA), model.pieces, standing(X_WM), tolerance);
  std::vector<Vec3> probes = polytope.vertices;
  probes.emplace_back(Vec3::Zero());
  if (outcome.truth != Truth::kHit)
    outcome.truth = worse(outcome.truth,
                          any_inside(model.mesh, probes, X_WM.inverse() * X_WA, tolerance, random));
  outcome.engine_hit =
      engine_blocked(prepare({solid.shape()}), X_WA, model.body, X_WM, tolerance, random);
  outcome.fcl_hit = fcl_collide(solid.fcl(), X_WA, model.fcl, X_WM);
  record.outcomes.push_back(outcome);
  note_poses(record, text_of(solid), X_WA, model.name, X_WM, tolerance);
}

constexpr Generator kStaticGenerators[] = {
    {"static_boxes", "pairs of boxes", 10, 1, static_boxes},
    {"static_convexes", "pairs of convex bodies", 1, 1, static_convexes},
    {"static_meshes", "a box and 1,000 triangles", 1, 1, static_meshes},
};

}  // namespace

std::span<const Generator> static_generators() { return kStaticGenerators; }

}  // namespace rubicon::collision::proof
