#include "tests/unit/collision/random_scene.hpp"

namespace rubicon::collision::test {

SweptQuery::Item item(const Body& body, const Motion& motion, bool against_world) {
  SweptQuery::Item result;
  result.moving.body = &body;
  result.moving.motion = motion;
  result.against_world = against_world;
  return result;
}

bool blocked(const Body& body, const Motion& motion, const BodyPtr& obstacle, const Pose& X_WB,
             double tolerance) {
  CollisionWorld world;
  world.insert(obstacle, X_WB);
  SweptQuery query;
  query.items = {item(body, motion)};
  query.contact_tolerance = tolerance;
  return world.test(query).hit.has_value();
}

bool pair_blocked(const Body& a, const Motion& motion_a, const Body& b, const Motion& motion_b,
                  double tolerance) {
  SweptQuery query;
  query.items = {item(a, motion_a, false), item(b, motion_b, false)};
  query.pairs.emplace_back(0, 1);
  query.contact_tolerance = tolerance;
  return CollisionWorld().test(query).hit.has_value();
}

}  // namespace rubicon::collision::test
