#include <fmt/format.h>

#include "tests/proof/generators.hpp"
#include "tests/proof/mesh_models.hpp"
#include "tests/proof/solid.hpp"
#include "tests/unit/collision/meshes.hpp"

namespace rubicon::collision::proof {
namespace {

/// Deeper than the tolerance by this much (m), a body that rests must be refused.
constexpr double kTooDeep = 2e-4;

/// A body that can stand on the plane z = 0.
struct Standing {
  BodyPtr body;
  FclGeometry fcl;
  Mat3 rotation = Mat3::Identity();  ///< from its frame to one that stands
  double height = 0;                 ///< m, of the origin of its frame above the plane
};

Standing random_standing(Random& random) {
  if (random.below(6) == 0) {
    // The L has its foot in z = 0 of its own frame.
    const MeshModel model = mesh_model("L", scaled(test::l_mesh(1), 0.5));
    return {model.body, model.fcl, Mat3::Identity(), 0};
  }
  const Solid solid = random_solid(random, 0.1, 0.6);
  Standing standing{prepare({solid.shape()}), solid.fcl(), Mat3::Identity(), 0};
  switch (solid.kind) {
    case Solid::Kind::kBox:
    case Solid::Kind::kPrism:
      standing.height = solid.half.z();
      break;
    case Solid::Kind::kSphere:
      standing.height = solid.radius;
      break;
    default: {
      const bool lies = random.below(2);
      const double upright = solid.kind == Solid::Kind::kCylinder
                                 ? solid.half_length
                                 : solid.half_length + solid.radius;
      standing.height = lies ? solid.radius : upright;
      if (lies) standing.rotation = math::rotation_x_deg(90).linear();
    }
  }
  return standing;
}

struct Slab {
  BodyPtr body;
  FclGeometry fcl;
};

/// 80 m across, its top in z = 0: a box, or ground of two hundred flat triangles.
const std::vector<Slab>& slabs() {
  static const std::vector<Slab> result = [] {
    Random random(CaseEngine(1, "slabs", 0));
    const Vec3 half(40, 40, 0.1);
    geometry::Shape shape = test::box_shape(Vec3(-40, -40, -0.2), Vec3(40, 40, 0));
    const Solid as_solid = box_solid(half);
    const MeshModel ground = mesh_model("flat ground", open_ground(random, 40, 2, 0));
    return std::vector<Slab>{{prepare({shape}), as_solid.fcl()}, {ground.body, ground.fcl}};
  }();
  return result;
}

/// Rests, slides and turns on a slab: free while no deeper than the tolerance, whatever the step.
void touch(Random& random, CaseRecord& record) {
  const Standing standing = random_standing(random);
  const bool on_box = random.below(3) != 0;
  const Slab& slab = slabs()[on_box ? 0 : 1];
  // The whole scene: as it is, turned anyhow, or turned and 100 km away.
  Pose X_WS = Pose::Identity();
  const int place = random.below(4);
  if (place > 0) X_WS.linear() = random.rotation();
  if (place == 2) X_WS.translation() = random.vector(10);
  if (place == 3) X_WS.translation() = 1e5 * random.direction();

  const double tolerance = random.below(3) ? 1e-3 : 1e-6;
  constexpr double kShares[] = {0, 0, 0, 0.5, 0.9};
  const int which = random.below(6);
  const double pressed = which == 5 ? tolerance + kTooDeep : kShares[which] * tolerance;
  Pose X_S0 = math::rotation_z_deg(random.between(0, 360));
  X_S0.linear() = X_S0.linear() * standing.rotation;
  X_S0.translation() =
      Vec3{random.between(-3, 3), random.between(-3, 3), standing.height - pressed};
  const Vec3 normal = X_WS.linear().col(2);
  const Pose X_W0 = X_WS * X_S0;

  Path path;
  switch (random.below(4)) {
    case 0:
      path = proof::standing(X_W0);
      break;
    case 1: {
      const Vec3 way{random.between(-0.5, 0.5), random.between(-0.5, 0.5), 0};
      path = translating(X_W0, X_WS.linear() * way);
      break;
    }
    case 2: {
      const Vec3 pivot{random.between(-20, 20), random.between(-20, 20), random.between(-5, 5)};
      path = turning(X_W0, normal, X_WS * pivot, random.between(-5, 5));
      break;
    }
    default:
      if (place > 0) {
        path = turning(X_W0, normal, X_W0.translation(), random.between(-90, 90));
      } else {
        const Vec3 way{random.between(-0.5, 0.5), random.between(-0.5, 0.5), 0};
        path = crane(X_S0.translation(), way, 0, random.between(-5, 5));
        // The crane carries its load unturned at the start: what lies would stand.
        if (!standing.rotation.isIdentity(0)) path = translating(X_W0, X_WS.linear() * way);
      }
  }
  Outcome outcome;
  outcome.motion = path.kind;
  outcome.truth = pressed > tolerance ? Truth::kHit : Truth::kFree;
  outcome.engine_hit = test::blocked(*standing.body, path.motion, slab.body, X_WS, tolerance);
  // Its centre is its origin for FCL.
  Pose X_slab = X_WS;
  if (on_box) X_slab.translation() -= 0.1 * normal;
  outcome.fcl_hit = fcl_collide(standing.fcl, path.pose(1), slab.fcl, X_slab);
  record.outcomes.push_back(outcome);
  record.note([&] {
    return fmt::format("on {}: pressed {} m, tolerance {} m, from {} to {}, slab {}",
                       on_box ? "a box" : "a mesh", pressed, tolerance, text_of(path.pose(0)),
                       text_of(path.pose(1)), text_of(X_WS));
  });
}

constexpr Generator kTouchGenerators[] = {
    {"touch", "resting, sliding, turning on a slab", 8, 1, touch},
};

}  // namespace

std::span<const Generator> touch_generators() { return kTouchGenerators; }

}  // namespace rubicon::collision::proof
