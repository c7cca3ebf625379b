#include "bench/near_steps.hpp"

#include <stdexcept>

namespace rubicon::bench {
namespace {

constexpr double kSlide = 0.5;       // m
constexpr double kTurn = 5;          // degrees
constexpr double kLeastRadius = 2;   // m, from the axis to the centre of the load
constexpr double kGreatRadius = 30;  // m
constexpr int kTriesForAStep = 1000;

Vec3 random_direction(Random& random) {
  for (;;) {
    const Vec3 v(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    if (v.norm() > 0.1 && v.norm() <= 1) return v.normalized();
  }
}

}  // namespace

const char* name_of(StepKind kind) { return kind == StepKind::kTranslation ? "T" : "R"; }

geometry::ScrewMotion random_step(StepKind kind, const Pose& X0, Random& random) {
  geometry::ScrewMotion step;
  step.X0 = X0;
  const Vec3 direction = random_direction(random);
  if (kind == StepKind::kTranslation) {
    step.slide = kSlide * direction;
    return step;
  }
  const bool vertical = random.below(2) == 0;
  step.axis = vertical ? Vec3::UnitZ() : direction;
  Vec3 across = random_direction(random).cross(step.axis);
  while (across.norm() < 0.1) across = random_direction(random).cross(step.axis);
  step.point = X0.translation() + random.between(kLeastRadius, kGreatRadius) * across.normalized();
  step.angle_deg = kTurn;
  return step;
}

std::vector<geometry::ScrewMotion> steps_from_free_places(
    StepKind kind, int count, Random& random, const std::function<Pose()>& start,
    const std::function<bool(const Pose&)>& blocked) {
  std::vector<geometry::ScrewMotion> steps;
  for (int tries = 0; static_cast<int>(steps.size()) < count; ++tries) {
    if (tries > kTriesForAStep * count) throw std::runtime_error("there is no free place");
    const Pose X0 = start();
    if (!blocked(X0)) steps.push_back(random_step(kind, X0, random));
  }
  return steps;
}

}  // namespace rubicon::bench
