#include "bench/our_world.hpp"

#include <utility>

namespace rubicon::bench {

OurWorld::OurWorld(const SweptScene& scene)
    : load(body_of(scene.load)), queries(queries_of(*load, scene.steps)) {
  std::vector<collision::BodyPtr> bodies;
  for (const geometry::Solid& solid : scene.solids) bodies.push_back(body_of(solid));
  for (const Standing& standing : scene.standing) {
    world.insert(bodies[standing.solid], standing.X_WB);
  }
}

std::vector<collision::SweptQuery> queries_of(const collision::Body& load,
                                              const std::vector<geometry::ScrewMotion>& steps) {
  std::vector<collision::SweptQuery> queries;
  for (const geometry::ScrewMotion& step : steps) {
    collision::SweptQuery query;
    query.items.push_back({{&load, {step}}, true});
    queries.push_back(std::move(query));
  }
  return queries;
}

collision::BodyPtr body_of(const geometry::Solid& solid) {
  return collision::prepare({{solid, Pose::Identity()}});
}

}  // namespace rubicon::bench
