#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "src/motion/guides/space.hpp"

namespace rubicon::guides {

/// The configurations that lie whole pitches from the goal, in the parameters that a guide spans
/// (`over`, else all of a leg); the others stand as they do at the start. A pitch is the `step` of
/// the guide by the weight of the parameter; that of a cyclic angle divides the whole turn.
///
/// Of a vehicle the lattice spans the place alone: at each node it faces the way it has come, one
/// of as many directions as there are neighbours.
class Lattice {
 public:
  /// A node: pitches from the goal, and of a vehicle the direction that it faces.
  struct Node {
    std::array<std::int32_t, kMostSpanned> pitches{};
    std::int32_t facing = 0;
    auto operator<=>(const Node&) const = default;
  };

  /// The space must outlive it. It spans at most `kMostSpanned` parameters.
  Lattice(const Space& space, const Point& start, const Point& goal);

  Point point(const Node& node) const;
  /// Where the spanned parameters have the values of the goal.
  bool is_at_goal(const Node& node) const { return node.pitches == goal_.pitches; }

  /// Nodes less than two pitches from the start in each parameter: a first leg leads to one of
  /// them.
  std::vector<Node> about_start() const;
  /// Where one leg of the lattice leads to.
  std::vector<Node> next_to(const Node& node) const;
  /// From where one leg of the lattice leads to a node.
  std::vector<Node> leading_to(const Node& node) const;
  /// The nodes where the spanned parameters have the values of the goal.
  std::vector<Node> at_goal() const { return facing_all_ways({goal_}); }
  /// A pitch away in one parameter, facing the same way.
  std::vector<Node> beside(const Node& node) const;

  /// Estimates the weighted distance to the goal, as the spec says (Heuristic).
  double left(const Node& node) const;

 private:
  struct Axis {
    std::size_t coordinate = 0;  ///< of points
    double pitch = 0;            ///< m or degrees
    double weighted = 0;         ///< the same in distances
    std::int32_t least = 0;      ///< pitches; of a cyclic angle it has `turn` of them
    std::int32_t most = 0;
    std::int32_t turn = 0;  ///< pitches of a whole turn; 0: the parameter is not cyclic
  };

  void add_axis(std::size_t coordinate);
  void find_directions();
  bool moved(Node& node, std::size_t axis, std::int32_t by) const;
  std::vector<Node> facing_all_ways(std::vector<Node> nodes) const;

  const Space& space_;
  Point start_;
  Point target_;
  Node goal_;
  std::vector<Axis> axes_;
  std::vector<std::vector<std::int32_t>> directions_;  ///< pitches along the axes
  int heading_ = -1;                                   ///< of a vehicle: its coordinate
  std::vector<double> headings_;                       ///< of a vehicle: by direction
};

}  // namespace rubicon::guides
