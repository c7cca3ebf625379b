#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "src/geometry/motion.hpp"
#include "src/geometry/shape.hpp"

namespace rubicon::collision {

/// A rigid body made of one or more solids, prepared once (convex pieces, triangles with their
/// bounding tree, bounds) and used by value through a shared immutable form. Coordinates in the
/// body's own frame, metres.
using geometry::Motion;
using geometry::Pose;
using geometry::Vec3;

class Body;
using BodyPtr = std::shared_ptr<const Body>;  // shared: a unit's panel stands 40 times on a site

/// Prepares shapes for queries. Throws std::invalid_argument for geometry that is not finite or has
/// no extent.
BodyPtr prepare(const std::vector<geometry::Shape>& shapes);

/// Bodies that stand in the world; ids stay valid until removed.
using ObstacleId = std::uint32_t;

/// One moving body of a query.
struct MovingBody {
  const Body* body = nullptr;
  Motion motion;
};

/// Asks whether moving bodies may make a step. Deeper than `contact_tolerance` (m) is a hit;
/// touching, resting, sliding within it is free. `pairs` lists the moving bodies to test against
/// each other (indices into `moving`); the obstacles are tested against every moving body with
/// `against_world`.
struct SweptQuery {
  struct Item {
    MovingBody moving;
    bool against_world = true;
  };
  std::vector<Item> items;
  std::vector<std::pair<int, int>> pairs;
  std::vector<ObstacleId> ignore;  ///< obstacles that are not tested (a component being gripped)
  double contact_tolerance = 1e-3;
};

/// The first blocking pair in a fixed order: item by item; for each the obstacles by id, then
/// `pairs` in their order.
struct SweptHit {
  int item = 0;                        ///< what moved: index into SweptQuery::items
  std::optional<ObstacleId> obstacle;  ///< what it met: a standing body,
  std::optional<int> other_item;       ///< or another moving one
};
struct SweptResult {
  std::optional<SweptHit> hit;  ///< none: the step is free
};

/// The standing bodies of a site, and the one question of the product: is this step free over its
/// whole swept volume? Never optimistic (see docs/collision.md for the bounds). Const queries may
/// run on several threads at once.
class CollisionWorld {
 public:
  CollisionWorld();
  ~CollisionWorld();
  CollisionWorld(CollisionWorld&&) noexcept;
  CollisionWorld& operator=(CollisionWorld&&) noexcept;

  ObstacleId insert(BodyPtr body, const Pose& X_WB);
  void remove(ObstacleId id);

  SweptResult test(const SweptQuery& query) const;

  /// Poses only: does `body` at X penetrate anything deeper than the tolerance, or stand wholly
  /// inside it (or it inside)?
  std::optional<ObstacleId> blocked_at(const Body& body, const Pose& X_WB, double contact_tolerance,
                                       const std::vector<ObstacleId>& ignore) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Whether two bodies at fixed poses penetrate each other deeper than the tolerance, containment
/// included.
bool overlaps(const Body& a, const Pose& X_WA, const Body& b, const Pose& X_WB,
              double contact_tolerance);

}  // namespace rubicon::collision
