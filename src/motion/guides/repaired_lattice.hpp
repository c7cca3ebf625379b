#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "src/motion/guides/lattice.hpp"

namespace rubicon::guides {

/// The search of D* Lite (Koenig, Likhachev, AAAI 2002) over the lattice about a goal, from the
/// goal back to where the robot stands. It is kept while the robot goes on and the site changes,
/// and repaired where it has to be. A leg is taken for free until the way needs it; then it is
/// tested. What was found blocked is tested again at each search, so that the way is the cheapest
/// of the site as it is now, as that of `astar`.
class RepairedLattice {
 public:
  explicit RepairedLattice(Point goal) : goal_(std::move(goal)) {
    vertices_.resize(2);
    vertices_[kGoal].rhs = 0;
  }

  /// The points of the cheapest way, start first; none: there is no way, or the limit of nodes or
  /// checks is reached. `goal` as before; else begin anew.
  std::vector<Point> search(Space& space, const Point& start);

  /// Whether what it knows holds for a search from there: parameters that the lattice does not span
  /// stand as before.
  bool lies_about(const Space& space, const Point& start) const;
  const Point& goal() const { return goal_; }
  double cost() const { return vertices_[kStart].g; }
  /// Vertices that the last search looked at, some more than once.
  std::size_t expansions() const { return expansions_; }

 private:
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();
  static constexpr std::size_t kGoal = 0;
  static constexpr std::size_t kStart = 1;  ///< where the robot stands: no node of the lattice

  struct Vertex {
    Lattice::Node node;
    Point point;
    double g = kInfinite;    ///< cost to the goal as it was found
    double rhs = kInfinite;  ///< the same by what is next to it
    std::pair<double, double> key;
    bool queued = false;
  };
  using Leg = std::pair<std::size_t, std::size_t>;

  class Repair;

  Point goal_;
  Point start_;                   ///< of the last search
  double moved_ = 0;              ///< k_m: how far the starts were apart, together
  std::vector<Vertex> vertices_;  ///< goal, start, nodes in the order in which they were met
  std::map<Lattice::Node, std::size_t> numbers_;
  std::set<std::tuple<double, double, std::size_t>> queue_;  ///< key, vertex
  std::set<Leg> blocked_;
  std::set<std::size_t> blocked_vertices_;  ///< where the robot may not stand
  std::size_t expansions_ = 0;
};

}  // namespace rubicon::guides
