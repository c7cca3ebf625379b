#include "bench/panel_scene.hpp"

#include <cmath>

#include "bench/fcl_world.hpp"

namespace rubicon::bench {
namespace {

constexpr int kSteps = 1024;
constexpr int kPanelKinds = 32;
constexpr double kGround = 16;  // m2 of ground a panel
constexpr int kStoreys = 4;
constexpr double kStorey = 3;      // m
constexpr double kFarAbove = 100;  // m
const Vec3 kLoadHalf(1.5, 0.075, 1.3);

double side_of(int count) { return std::sqrt(kGround * count); }

double yaw_deg(Random& random) {
  const int quarter = random.below(4);
  const double any = random.between(0, 360);
  return random.below(2) == 0 ? 90.0 * quarter : any;
}

SweptScene panels(int count) {
  Random random(1);
  SweptScene scene;
  for (int i = 0; i < kPanelKinds; ++i) {
    const double length = random.between(0.5, 3);
    const double thickness = random.between(0.05, 0.1);
    const bool slab = i % 4 == 0;
    scene.solids.emplace_back(
        centred_box(slab ? Vec3(length, 0.6, thickness) : Vec3(length, thickness, 1.3)));
  }
  const double side = side_of(count);
  for (int i = 0; i < count; ++i) {
    const int solid = random.below(kPanelKinds);
    const double x = random.between(0, side);
    const double y = random.between(0, side);
    const double floor = kStorey * random.below(kStoreys);
    const double z = floor + (solid % 4 == 0 ? 0 : 1.5);
    scene.standing.push_back(
        {solid, math::translation(x, y, z) * math::rotation_z_deg(yaw_deg(random))});
  }
  scene.load = centred_box(kLoadHalf);
  return scene;
}

}  // namespace

SweptScene panel_scene(int count, StepKind kind) {
  SweptScene scene = panels(count);
  const FclWorld site(scene);
  const FclWorld::LoadPtr load = FclWorld::make_load(scene.load);
  Random random(2);
  const double side = side_of(count);
  const auto start = [&] {
    const double x = random.between(0, side);
    const double y = random.between(0, side);
    const double z = random.between(1, kStorey * kStoreys);
    return Pose(math::translation(x, y, z) * math::rotation_z_deg(yaw_deg(random)));
  };
  scene.steps = steps_from_free_places(kind, kSteps, random, start,
                                       [&](const Pose& X) { return site.blocked_at(*load, X); });
  return scene;
}

SweptScene free_scene(int count, StepKind kind) {
  SweptScene scene = panels(count);
  const double middle = side_of(count) / 2;
  geometry::ScrewMotion step;
  step.X0 = math::translation(middle, middle, kFarAbove);
  for (int i = 0; i < kSteps; ++i) {
    const double sign = i < kSteps / 2 ? 1 : -1;
    if (kind == StepKind::kTranslation) {
      step.slide = sign * 0.5 * Vec3::UnitX();
    } else {
      step.point = Vec3(middle, middle - 30, kFarAbove);
      step.axis = sign * Vec3::UnitZ();
      step.angle_deg = 5;
    }
    scene.steps.push_back(step);
    step.X0 = geometry::Motion{step}.pose(1);
  }
  return scene;
}

}  // namespace rubicon::bench
