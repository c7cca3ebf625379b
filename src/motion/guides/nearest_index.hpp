#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace rubicon::guides {

/// The nearest of points that are added one by one. Trees over 1, 2, 4 ... times so many points,
/// each over the box of its points; two of one size become one of the next (Bentley and Saxe, J.
/// Algorithms 1, 1980), so that n points cost n log^2 n in all.
///
/// Distances are weighted by coordinate. A coordinate may be an angle, which comes round after its
/// turn; points are within half a turn.
class NearestIndex {
 public:
  /// `turns`: 0 for coordinates that do not come round.
  NearestIndex(std::vector<double> weights, std::vector<double> turns)
      : weights_(std::move(weights)), turns_(std::move(turns)) {}

  void add(std::span<const double> point);
  /// Its coordinates, one after the other.
  const double* point(std::size_t i) const { return points_.data() + i * weights_.size(); }

  /// The number of the point with the least `square(i)`, the first of equal ones; -1 if there is
  /// none. `square(i)` is the square of the distance of point i from `point`.
  template <typename Square>
  int nearest(std::span<const double> point, const Square& square) const {
    Best best;
    for (int i = in_trees_; i < count_; ++i) best.take(square(i), i);
    std::vector<std::pair<double, int>> open;
    for (auto tree = trees_.rbegin(); tree != trees_.rend(); ++tree) {
      if (tree->nodes.empty()) continue;
      open.assign(1, {square_to(*tree, 0, point), 0});
      while (!open.empty()) {
        const auto [bound, at] = open.back();
        open.pop_back();
        if (bound > best.square) continue;
        const Node& node = tree->nodes[static_cast<std::size_t>(at)];
        if (node.right < 0) {
          for (int k = node.first; k < node.last; ++k) {
            const int i = tree->order[static_cast<std::size_t>(k)];
            best.take(square(i), i);
          }
          continue;
        }
        std::pair<double, int> near{square_to(*tree, at + 1, point), at + 1};
        std::pair<double, int> far{square_to(*tree, node.right, point), node.right};
        if (far.first < near.first) std::swap(near, far);
        open.push_back(far);
        open.push_back(near);
      }
    }
    return best.index;
  }

 private:
  struct Best {
    double square = std::numeric_limits<double>::infinity();
    int index = -1;
    void take(double other, int i) {
      if (other > square || (other == square && index >= 0 && index < i)) return;
      square = other;
      index = i;
    }
  };
  /// The left half stands behind its node.
  struct Node {
    int first = 0, last = 0;  ///< of `order`
    int right = -1;           ///< -1: a leaf
  };
  struct Tree {
    std::vector<int> order;  ///< points
    std::vector<Node> nodes;
    std::vector<double> boxes;  ///< of each node the lowest and the highest of each coordinate
  };

  void build(Tree& tree, int first, int last);
  /// No point of the node is nearer, but for rounding, which is on the safe side.
  double square_to(const Tree& tree, int node, std::span<const double> point) const;
  double coordinate(int i, std::size_t d) const { return point(static_cast<std::size_t>(i))[d]; }

  std::vector<double> weights_, turns_;
  std::vector<double> points_;  ///< one after the other
  std::vector<Tree> trees_;     ///< the smallest first; some are empty
  int count_ = 0, in_trees_ = 0;
};

}  // namespace rubicon::guides
