#pragma once

#include <vector>

#include "bench/swept_scene.hpp"
#include "src/motion/collision/swept_query.hpp"

namespace rubicon::bench {

/// The same scene in the engine of the project, with one query a step made ready.
struct OurWorld {
  explicit OurWorld(const SweptScene& scene);

  collision::CollisionWorld world;
  collision::BodyPtr load;
  std::vector<collision::SweptQuery> queries;
};

/// One query a step.
std::vector<collision::SweptQuery> queries_of(const collision::Body& load,
                                              const std::vector<geometry::ScrewMotion>& steps);

/// The engine's form of a solid.
collision::BodyPtr body_of(const geometry::Solid& solid);

}  // namespace rubicon::bench
