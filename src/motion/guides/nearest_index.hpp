#pragma once

#include <cstddef>
#include <limits>
#include <span>
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
  NearestIndex(std::vector<double> weights, std::vector<double> turns);

  void add(std::span<const double> point);

  struct Found {
    int index = -1;  ///< the first of equally near points; -1: there is none
    double square = std::numeric_limits<double>::infinity();  ///< of the distance
  };
  Found nearest(std::span<const double> point) const;

 private:
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
  void search(const Tree& tree, std::span<const double> point, Found& found) const;
  /// No point of the node is nearer, but for rounding, which is on the safe side.
  double square_to(const Tree& tree, int node, std::span<const double> point) const;
  double square_of(int i, std::span<const double> point) const;
  double coordinate(int i, std::size_t d) const;

  std::vector<double> weights_, turns_;
  std::vector<double> blocks_;  ///< of each four points the four first coordinates, then the next
  std::vector<Tree> trees_;     ///< the smallest first; some are empty
  int count_ = 0, in_trees_ = 0;
};

}  // namespace rubicon::guides
