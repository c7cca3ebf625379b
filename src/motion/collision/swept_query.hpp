#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "src/motion/geometry/motion.hpp"
#include "src/motion/geometry/shape.hpp"

namespace rubicon::collision {

using geometry::Motion;
using geometry::Pose;
using geometry::Vec3;

/// A rigid body made of one or more solids, prepared once (convex pieces, triangles with their
/// bounding tree, bounds) and used by value through a shared immutable form. Coordinates in the
/// body's own frame, metres.
class Body;
using BodyPtr = std::shared_ptr<const Body>;  // shared: a unit's panel stands 40 times on a site

/// Prepares shapes for queries, grown on all sides by a ball of radius `grown_by` (m): what meets
/// the result is nearer than that to the shapes. A mesh is then its surface only: test what might
/// stand inside it against the shapes themselves. Throws std::invalid_argument for geometry that is
/// not finite or has no extent.
BodyPtr prepare(const std::vector<geometry::Shape>& shapes, double grown_by = 0);

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

/// Where and when a pair first gets deeper than the contact tolerance.
struct Contact {
  /// Share of the step, in [0, 1]: the step is proved free of this pair up to here, and contact
  /// begins within 1e-4 of the step's motion after it.
  double fraction = 0;
  Vec3 point_W = Vec3::Zero();  ///< witness: a point of both bodies, or between them where they
                                ///< only touch (within the contact tolerance), world
};

/// One of all the pairs that block a step.
struct BlockingPair {
  SweptHit hit;
  Contact contact;
};

/// The nearest miss of a step: how near the moving bodies come to anything they are tested against.
struct Clearance {
  /// Certified: over the whole step no two bodies come nearer than this (m); 0 where they touch or
  /// overlap. Infinite if nothing lies within the range that was asked for.
  double lower_bound = 0;
  double upper_bound = 0;        ///< m, between the two points below
  std::optional<SweptHit> pair;  ///< who comes nearest
  double fraction = 0;           ///< when: share of the step
  Vec3 point_moving_W = Vec3::Zero();
  Vec3 point_met_W = Vec3::Zero();
};

/// What is known of the free space around the moving bodies of a series of queries: while they
/// stay inside it, steps are free without a look at the obstacles. It never changes an answer. One
/// for each moving machine, used by one thread at a time; it notices by itself when the world
/// changes.
class ClearanceBudget {
 public:
  ClearanceBudget();
  ~ClearanceBudget();
  ClearanceBudget(ClearanceBudget&&) noexcept;
  ClearanceBudget& operator=(ClearanceBudget&&) noexcept;

 private:
  friend class CollisionWorld;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

struct LegQuery;
struct LegAnswer;
class LegMotion;

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
  /// Inserts an obstacle that was removed again under the id, and so the rank, that it had.
  void put_back(ObstacleId id, BodyPtr body, const Pose& X_WB);
  /// Another body, or another pose, for an obstacle that stands: as if it were removed and put
  /// back.
  void replace(ObstacleId id, BodyPtr body, const Pose& X_WB);

  SweptResult test(const SweptQuery& query) const;
  /// The same answer, sooner where the bodies are far from everything.
  SweptResult test(const SweptQuery& query, ClearanceBudget& budget) const;

  /// When and where the pair of a hit of `test(query)` begins to block.
  Contact contact(const SweptQuery& query, const SweptHit& hit) const;
  /// All pairs that block the step, in the order of `SweptHit`; empty if it is free.
  std::vector<BlockingPair> explain(const SweptQuery& query) const;
  /// The nearest miss within `range` (m) over the whole step, to `resolution` (m): the two bounds
  /// differ by no more, or, for motions about which little is known, by as little as can be shown.
  /// Throws std::invalid_argument unless both are finite, range >= 0 and resolution > 0.
  Clearance clearance(const SweptQuery& query, double range, double resolution = 1e-3) const;

  /// How far bodies may go along a leg (leg_query.hpp): sooner answered than by tests of ever
  /// shorter parts of it. What it calls free or met, `test` does too; it may leave things open.
  LegAnswer look_along(const LegQuery& query, const LegMotion& motion) const;

  /// Poses only: does `body` at X penetrate anything deeper than the tolerance, or stand wholly
  /// inside it (or it inside)?
  std::optional<ObstacleId> blocked_at(const Body& body, const Pose& X_WB, double contact_tolerance,
                                       const std::vector<ObstacleId>& ignore) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Which instructions the inner loops use. All give the same answers, bit by bit.
enum class Simd { kBaseline, kAvx2 };
/// What this processor can do, and what the queries of this process use.
Simd simd_in_use();
/// For tests and benchmarks: uses `level`, or the best there is if the processor lacks it. Not
/// while queries run.
void use_simd(Simd level);

/// Whether two bodies at fixed poses penetrate each other deeper than the tolerance, containment
/// included.
bool overlaps(const Body& a, const Pose& X_WA, const Body& b, const Pose& X_WB,
              double contact_tolerance);

}  // namespace rubicon::collision
