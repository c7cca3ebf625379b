#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "src/motion/travel/ring.hpp"

namespace rubicon::travel {

/// A polygon of an obstacle. Obstacles whose shape is not convex have several where they were grown
/// part by part.
struct Piece {
  Ring ring;
  int obstacle = 0;  ///< whose it is; any number, not negative
};

/// An edge of a piece.
struct Owner {
  int piece = 0;
  int edge = 0;
  friend auto operator<=>(const Owner&, const Owner&) = default;
};

/// A stretch of the outline between two nodes, walked with the obstacle on the right.
struct Edge {
  int from = 0;  ///< nodes of the composite
  int to = 0;
  int next = 0;  ///< edges of the composite
  int previous = 0;
  int loop = 0;
  double length = 0;             ///< m
  Vec2 heading{0, 0};            ///< of length 1
  LatticePoint line_a, line_b;   ///< corners, a before b in walking: the edge is a part of a to b
  Owner owner;                   ///< the lowest of those that have this stretch
  std::vector<Owner> co_owners;  ///< the others
};

/// A closed line of the outline.
struct Loop {
  int first = 0;      ///< an edge
  double length = 0;  ///< m
  bool hole = false;  ///< goes round free space that obstacles enclose
};

/// Obstacles that touch, overlap or contain one another, and the outline of their union.
struct Composite {
  std::vector<int> pieces;  ///< ascending; empty: there is none of this number
  Box box;
  std::vector<ExactPoint> nodes;  ///< in the order of `compare`
  std::vector<bool> pinch;        ///< of each node: more than one edge leaves it
  std::vector<Edge> edges;
  std::vector<Loop> loops;
  std::uint64_t version = 0;  ///< changes whenever it is built anew
};

/// Where the border of a piece meets that of another one.
struct Contact {
  int a = 0;  ///< pieces, a < b
  int b = 0;
  std::vector<Meeting> meetings;  ///< empty: one contains the other
};

/// The outline of the union of pieces that are in contact. `rings` are all pieces; `contacts` those
/// between members of `members`. Where two edges cross, both have the same node, found exactly; of
/// a stretch that two pieces share one edge remains, or none if they touch from both sides. Where
/// obstacles meet in a point, the walk turns left: there is no way through.
Composite build_composite(const std::vector<Piece>& pieces, std::vector<int> members,
                          const std::vector<const Contact*>& contacts);

/// Directions at a node, between the edge that arrives and the one that leaves.
struct Corner {
  LatticePoint in_a, in_b;    ///< line of the edge that arrives
  LatticePoint out_a, out_b;  ///< line of the edge that leaves

  /// Whether the way from the node to the aim starts in free space, not along an edge.
  bool opens_to(const Aim& aim) const;
  /// The same, along an edge too; `backward`: of the opposite direction.
  bool admits(const Aim& aim, bool backward = false) const;
};
/// At the node where an edge starts.
Corner corner_before(const Composite& composite, int edge);

/// The outlines of all obstacles. After a change only composites that it touches are built anew;
/// the others keep their numbers, nodes and edges.
class Outline {
 public:
  explicit Outline(std::vector<Piece> pieces);

  struct Change {
    int piece = 0;
    Ring ring;
  };
  void replace(std::span<const Change> changes);

  const std::vector<Piece>& pieces() const { return pieces_; }
  const std::vector<Composite>& composites() const { return composites_; }
  /// The composite that a piece is part of.
  int composite_of(int piece) const { return composite_of_[static_cast<std::size_t>(piece)]; }

  /// Where a point is: 1 inside the union of the pieces, 0 on the outline, -1 in free space. Exact.
  int place_of(const ExactPoint& p) const;
  bool covers(const ExactPoint& p) const { return place_of(p) > 0; }

  /// Contacts that were computed and composites that were built so far: what changes cost.
  struct Work {
    std::int64_t pairs = 0;
    std::int64_t built = 0;
  };
  const Work& work() const { return work_; }

 private:
  void find_contacts(int a, int b);
  void forget_contacts(int piece);
  void rebuild(const std::vector<int>& stale);

  std::vector<Piece> pieces_;
  std::vector<Box> boxes_;
  std::map<std::pair<int, int>, Contact> contacts_;
  std::vector<std::vector<int>> neighbours_;  ///< ascending
  std::vector<int> composite_of_;
  std::vector<Composite> composites_;
  std::uint64_t version_ = 0;
  Work work_;
};

}  // namespace rubicon::travel
