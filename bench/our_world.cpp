#include "bench/our_world.hpp"

namespace rubicon::bench {

OurWorld::OurWorld(const SweptScene& scene) : load(body_of(scene.load)) {
  std::vector<collision::BodyPtr> bodies;
  for (const geometry::Solid& solid : scene.solids) bodies.push_back(body_of(solid));
  for (const Standing& standing : scene.standing) {
    world.insert(bodies[standing.solid], standing.X_WB);
  }
  for (const geometry::ScrewMotion& step : scene.steps) {
    collision::SweptQuery query;
    query.items.push_back({{load.get(), {step}}, true});
    queries.push_back(std::move(query));
  }
}

collision::BodyPtr body_of(const geometry::Solid& solid) {
  return collision::prepare({{solid, Pose::Identity()}});
}

}  // namespace rubicon::bench
