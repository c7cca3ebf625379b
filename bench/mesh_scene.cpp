#include "bench/mesh_scene.hpp"

#include <cmath>

#include "bench/bench_meshes.hpp"
#include "bench/fcl_world.hpp"

namespace rubicon::bench {
namespace {

constexpr int kSteps = 512;
constexpr double kGround = 16;  // m2 of ground an instance
constexpr double kHeight = 12;  // m
const Vec3 kLoadHalf(1.5, 0.075, 1.3);

Pose anywhere(double side, Random& random) {
  const double x = random.between(0, side);
  const double y = random.between(0, side);
  const double z = random.between(0, kHeight);
  const double yaw = random.between(0, 360);
  const double tilt = random.between(-30, 30);
  return math::translation(x, y, z) * math::rotation_z_deg(yaw) * math::rotation_x_deg(tilt);
}

}  // namespace

SweptScene mesh_scene(int count, StepKind kind, MeshLoad load_kind) {
  SweptScene scene;
  for (const MeshPtr& mesh : {corrugated_panel(), boulder(), ring()}) {
    scene.solids.emplace_back(geometry::Mesh{"", mesh});
  }
  if (load_kind == MeshLoad::kBox) {
    scene.load = centred_box(kLoadHalf);
  } else {
    scene.load = scene.solids.front();
  }
  Random random(4);
  const double side = std::sqrt(kGround * count);
  for (int i = 0; i < count; ++i) {
    const int solid = random.below(static_cast<int>(scene.solids.size()));
    scene.standing.push_back({solid, anywhere(side, random)});
  }
  const FclWorld site(scene);
  const FclWorld::LoadPtr load = FclWorld::make_load(scene.load);
  scene.steps = steps_from_free_places(
      kind, kSteps, random, [&] { return anywhere(side, random); },
      [&](const Pose& X) { return site.blocked_at(*load, X); });
  return scene;
}

}  // namespace rubicon::bench
