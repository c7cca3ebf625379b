#include "bench/contact_scene.hpp"

#include <cmath>

namespace rubicon::bench {
namespace {

constexpr int kSteps = 1024;
constexpr int kStoreys = 5;
constexpr double kStorey = 3;  // m, from the top of a slab to the top of the next
// All heights are multiples of 1/8 m: what touches, touches exactly.
const Vec3 kSlabHalf(3, 0.625, 0.125);
const Vec3 kLoadHalf(1.5, 0.0625, 1.25);

}  // namespace

SweptScene contact_scene(int count, StepKind kind) {
  SweptScene scene;
  scene.solids.emplace_back(centred_box(kSlabHalf));
  const int a_storey = (count + kStoreys - 1) / kStoreys;
  const double side =
      std::sqrt(a_storey * 4 * kSlabHalf.x() * kSlabHalf.y());  // m, of a square of slabs
  const int along = static_cast<int>(std::ceil(side / (2 * kSlabHalf.x())));
  const int rows = a_storey / along;  // that are complete
  for (int i = 0; i < count; ++i) {
    const int place = i / kStoreys;
    const double x = 2 * kSlabHalf.x() * (place % along);
    const double y = 2 * kSlabHalf.y() * (place / along);
    const double top = kStorey * (i % kStoreys);
    scene.standing.push_back({0, math::translation(x, y, top - kSlabHalf.z())});
  }
  scene.load = centred_box(kLoadHalf);
  Random random(5);
  for (int i = 0; i < kSteps; ++i) {
    const double x = random.between(0, 2 * kSlabHalf.x() * (along - 1));
    const double y = random.between(0, 2 * kSlabHalf.y() * (rows - 1));
    const double top = kStorey * random.below(kStoreys);
    const double yaw = random.between(0, 360);
    const double way = random.between(0, 360);
    geometry::ScrewMotion step;
    step.X0 = math::translation(x, y, top + kLoadHalf.z()) * math::rotation_z_deg(yaw);
    const Vec3 direction = math::rotation_z_deg(way) * Vec3::UnitX();
    if (kind == StepKind::kTranslation) {
      step.slide = 0.5 * direction;
    } else {
      step.point = step.X0.translation() + random.between(2, 30) * direction;
      step.angle_deg = 5;
    }
    scene.steps.push_back(step);
  }
  return scene;
}

}  // namespace rubicon::bench
