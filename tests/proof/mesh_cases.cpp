#include <fmt/format.h>

#include <cmath>

#include "tests/proof/generators.hpp"
#include "tests/proof/graze.hpp"
#include "tests/proof/mesh_models.hpp"
#include "tests/proof/solid.hpp"
#include "tests/unit/collision/meshes.hpp"

namespace rubicon::collision::proof {
namespace {

constexpr double kMeshTolerance = 1e-3;

/// Corners and middle: the points by which a solid is found inside a closed mesh.
std::vector<Vec3> probes_of(const Polytope& polytope) {
  std::vector<Vec3> probes = polytope.vertices;
  probes.emplace_back(Vec3::Zero());
  return probes;
}

/// A step or pose that is bent on meeting something: near the surface of the model.
Pose near_surface(Random& random, const MeshModel& model, const Pose& X_WM, double offset) {
  const Vec3& corner =
      model.mesh.vertices[random.below(static_cast<int>(model.mesh.vertices.size()))];
  Pose X = Pose::Identity();
  X.linear() = random.rotation();
  X.translation() = X_WM * corner + random.vector(offset);
  return X;
}

Path mesh_path(Random& random, const Pose& X) {
  PathSizes sizes;
  sizes.travel = 0.3;
  sizes.radius = random.below(2) ? 3 : 30;
  sizes.angle_deg = sizes.radius > 3 ? 1 : 15;
  sizes.may_be_tiny = true;
  return random_path(random, X, sizes);
}

void note_paths(CaseRecord& record, const std::string& a, const Path& path_a, const std::string& b,
                const Path& path_b) {
  record.note([&] {
    return fmt::format("a: {} from {} to {}\nb: {} from {} to {}\ntolerance {} m", a,
                       text_of(path_a.pose(0)), text_of(path_a.pose(1)), b, text_of(path_b.pose(0)),
                       text_of(path_b.pose(1)), kMeshTolerance);
  });
}

Truth solid_mesh_truth(const Polytope& a, const Path& path_a, const MeshModel& model,
                       const Path& path_m, Random& random) {
  Truth truth = pieces_truth(pieces_of(a), path_a, model.pieces, path_m, kMeshTolerance);
  for (const double s : {0.0, 1.0}) {
    if (truth == Truth::kHit) break;
    truth =
        worse(truth, any_inside(model.mesh, probes_of(a), path_m.pose(s).inverse() * path_a.pose(s),
                                kMeshTolerance, random));
  }
  return truth;
}

/// A box or prism against a mesh; which of them moves is left to chance.
void judge_solid(const Solid& solid, const MeshModel& model, Random& random, CaseRecord& record) {
  const Polytope a = solid.polytope();
  const bool mesh_moves = random.below(4) == 0;
  const Pose X_WM = mesh_moves ? Pose::Identity() : random.pose(0.5);
  const Pose X_WA = near_surface(random, model, X_WM, solid.reach() + 0.1);
  const Path path = mesh_path(random, mesh_moves ? X_WM : X_WA);
  Pose X_still = mesh_moves ? X_WA : X_WM;
  const auto truth_at = [&](const Vec3& offset) {
    const Path still = standing(shifted(X_still, offset));
    return mesh_moves ? solid_mesh_truth(a, still, model, path, random)
                      : solid_mesh_truth(a, path, model, still, random);
  };
  Outcome outcome;
  outcome.motion = path.kind;
  outcome.grazes = random.below(kGrazeEvery) == 0;
  if (outcome.grazes) {
    const Vec3 towards = path.pose(random.unit()).translation() - X_still.translation();
    const double finest = path.translates() ? 4 * kExactBand : 4 * kBand;
    X_still = shifted(X_still, grazing_offset(random, towards, finest, truth_at));
  }
  outcome.truth = truth_at(Vec3::Zero());
  const BodyPtr body = prepare({solid.shape()});
  const BodyPtr& mover = mesh_moves ? model.body : body;
  const BodyPtr& met = mesh_moves ? body : model.body;
  outcome.engine_hit = test::blocked(*mover, path.motion, met, X_still, kMeshTolerance);
  outcome.fcl_hit = mesh_moves ? fcl_continuous(model.fcl, path, solid.fcl(), X_still)
                               : fcl_continuous(solid.fcl(), path, model.fcl, X_still);
  record.outcomes.push_back(outcome);
  const std::string names[] = {text_of(solid), model.name};
  note_paths(record, names[mesh_moves], path, names[!mesh_moves], standing(X_still));
}

Solid random_polytope(Random& random) {
  if (random.below(4) == 0) return random_prism(random, random.between(0.1, 0.5));
  return box_solid(
      Vec3{random.between(0.02, 0.4), random.between(0.02, 0.4), random.between(0.02, 0.4)});
}

void box_mesh(Random& random, CaseRecord& record) {
  const auto& models = fine_models();
  const MeshModel& model = models[random.below(static_cast<int>(models.size()))];
  judge_solid(random_polytope(random), model, random, record);
}

/// Zero-area triangles, needles, triangles given twice and triangles that name a corner twice.
void degenerate(Random& random, CaseRecord& record) {
  geometry::TriangleMesh mesh =
      random.below(2) ? scaled(test::l_mesh(1), 0.5) : lumpy_ball(random, 1, 0.5, 0.8);
  for (int i = 1 + random.below(6); i > 0; --i) {
    const int t = random.below(static_cast<int>(mesh.triangles.size()));
    const auto [a, b, c] = mesh.triangles[t];
    const int fresh = static_cast<int>(mesh.vertices.size());
    switch (random.below(4)) {
      case 0:  // a corner in the middle of an edge; the gap is closed by a triangle without area
        mesh.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
        mesh.triangles[t] = {a, fresh, c};
        mesh.triangles.push_back({fresh, b, c});
        mesh.triangles.push_back({a, b, fresh});
        break;
      case 1:  // encloses nothing
        mesh.triangles.push_back({a, a, b});
        break;
      case 2:
        mesh.triangles.push_back(mesh.triangles[t]);
        mesh.closed = false;
        break;
      default: {  // a needle of any thinness
        double thinness = 1e-2;
        for (int k = random.below(12); k > 0; --k) thinness *= 0.1;
        mesh.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]) +
                                thinness * random.direction());
        mesh.triangles.push_back({a, b, fresh});
        mesh.closed = false;
      }
    }
  }
  judge_solid(random_polytope(random), mesh_model("degenerate mesh", std::move(mesh)), random,
              record);
}

void mesh_mesh(Random& random, CaseRecord& record) {
  const auto& models = coarse_models();
  const int count = static_cast<int>(models.size());
  const MeshModel& a = models[random.below(count)];
  const MeshModel& b = models[random.below(count)];
  const Pose X_WB = random.pose(0.5);
  const Vec3& corner = a.mesh.vertices[random.below(static_cast<int>(a.mesh.vertices.size()))];
  Pose X_WA = near_surface(random, b, X_WB, 0.5);
  X_WA.translation() -= X_WA.linear() * corner;
  const Path path = mesh_path(random, X_WA);
  const Path still = standing(X_WB);
  Outcome outcome;
  outcome.motion = path.kind;
  outcome.truth = pieces_truth(a.pieces, path, b.pieces, still, kMeshTolerance);
  for (const double s : {0.0, 1.0}) {
    if (outcome.truth == Truth::kHit) break;
    const Pose X_BA = X_WB.inverse() * path.pose(s);
    outcome.truth =
        worse(outcome.truth, all_inside(b.mesh, a.mesh.vertices, X_BA, kMeshTolerance, random));
    outcome.truth = worse(
        outcome.truth, all_inside(a.mesh, b.mesh.vertices, X_BA.inverse(), kMeshTolerance, random));
  }
  outcome.engine_hit = test::blocked(*a.body, path.motion, b.body, X_WB, kMeshTolerance);
  outcome.fcl_hit = fcl_continuous(a.fcl, path, b.fcl, X_WB);
  record.outcomes.push_back(outcome);
  note_paths(record, a.name, path, b.name, still);
}

/// What is put into, or taken out of, or driven through something closed.
struct Inner {
  BodyPtr body;
  FclGeometry fcl;
  double reach = 0;
};

Inner random_inner(Random& random, double room) {
  if (random.below(4) == 0) {
    MeshModel model =
        mesh_model("lump", scaled(lumpy_ball(random, 1, 0.5, 1), random.between(0.2, 1) * room));
    return {model.body, model.fcl, room};
  }
  Solid solid = random_solid(random, 0.1 * room, 0.5 * room);
  return {prepare({solid.shape()}), solid.fcl(), solid.reach()};
}

/// A body wholly inside a closed mesh at start or end, or driven through it, or in its cavity.
/// What is true follows from how the case is made.
void contained(Random& random, CaseRecord& record) {
  const bool in_cavity = random.below(4) == 0;
  const MeshModel& outer = fine_models()[in_cavity ? 3 : 0];
  const double inner_radius = in_cavity ? 0.5 : outer.inner_radius;
  Inner inner = random_inner(random, 0.4 * inner_radius);
  while (inner.reach > 0.6 * inner_radius) inner = random_inner(random, 0.4 * inner_radius);
  const Pose X_WM = random.pose(random.below(2) ? 1 : 1000);
  Pose X_in = random.pose(0);
  X_in.translation() = random.between(0, 0.9 * (inner_radius - inner.reach)) * random.direction();
  const Vec3 beyond = 3 * random.direction();

  Outcome outcome;
  Path path;  // of the inner body in the frame of the mesh
  outcome.truth = Truth::kHit;
  const double room = 0.05 * (inner_radius - inner.reach);
  switch (random.below(4)) {
    case 0: {  // stays inside
      const Vec3 axis = random.direction();
      path = random.below(2) ? translating(X_in, room * random.direction())
                             : turning(X_in, axis, X_in.translation(), random.between(-170, 170));
      if (in_cavity) outcome.truth = Truth::kFree;
      break;
    }
    case 1:  // leaves
      path = translating(X_in, beyond);
      break;
    case 2: {  // comes in
      Pose X0 = X_in;
      X0.translation() += beyond;
      path = translating(X0, -beyond);
      break;
    }
    default: {  // goes through
      Pose X0 = X_in;
      X0.translation() += beyond;
      path = translating(X0, -2 * beyond);
    }
  }
  const auto& screw = std::get<geometry::ScrewMotion>(path.motion.kind);
  outcome.motion = path.kind;
  if (random.below(2)) {
    // The mesh moves instead, by the inverse motion; the inner body stands where it started.
    const Path mesh_path = path.translates() ? translating(X_WM, X_WM.linear() * -screw.slide)
                                             : turning(X_WM, X_WM.linear() * screw.axis,
                                                       X_WM * screw.point, -screw.angle_deg);
    const Pose X_WI = X_WM * path.pose(0);
    outcome.engine_hit =
        test::blocked(*outer.body, mesh_path.motion, inner.body, X_WI, kMeshTolerance);
    outcome.fcl_hit = fcl_continuous(outer.fcl, mesh_path, inner.fcl, X_WI);
  } else {
    const Path in_world = path.translates()
                              ? translating(X_WM * path.pose(0), X_WM.linear() * screw.slide)
                              : turning(X_WM * screw.X0, X_WM.linear() * screw.axis,
                                        X_WM * screw.point, screw.angle_deg);
    outcome.engine_hit =
        test::blocked(*inner.body, in_world.motion, outer.body, X_WM, kMeshTolerance);
    outcome.fcl_hit = fcl_continuous(inner.fcl, in_world, outer.fcl, X_WM);
  }
  record.outcomes.push_back(outcome);
  note_paths(record, "inner body", path, outer.name, standing(Pose::Identity()));
}

constexpr Generator kMeshGenerators[] = {
    {"contained", "inside closed meshes, and through them", 4, 1, contained},
    {"degenerate", "meshes with needles and triangles without area", 4, 1, degenerate},
    {"box_mesh", "boxes and prisms against 1,000 triangles", 8, 1, box_mesh},
    {"mesh_mesh", "meshes of some 100 triangles", 4, 1, mesh_mesh},
};

}  // namespace

std::span<const Generator> mesh_generators() { return kMeshGenerators; }

}  // namespace rubicon::collision::proof
