#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "src/motion/guides/space.hpp"
#include "src/motion/math/turns.hpp"

namespace rubicon::guides {

/// A tree of points, each reached from its parent by a free leg. The nearest node is found by
/// looking at all: of the trees that guides grow (some thousand nodes) that is fast.
class Tree {
 public:
  Tree(const Space& space, Point root) : space_(space) {
    for (std::size_t d = 0; d < root.size(); ++d) {
      weights_.push_back(space.weight(d));
      straight_.push_back(space.parameter(d).cyclic ? math::kHalfTurn_deg
                                                    : std::numeric_limits<double>::infinity());
    }
    add(std::move(root), -1);
  }

  int add(Point point, int parent) {
    coordinates_.insert(coordinates_.end(), point.begin(), point.end());
    points_.push_back(std::move(point));
    parents_.push_back(parent);
    return static_cast<int>(points_.size()) - 1;
  }
  std::size_t size() const { return points_.size(); }
  const Point& point(int node) const { return points_[static_cast<std::size_t>(node)]; }
  int parent(int node) const { return parents_[static_cast<std::size_t>(node)]; }

  /// Of equally near nodes the first.
  int nearest(std::span<const double> point) const {
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    const double* own = coordinates_.data();
    for (std::size_t i = 0; i < points_.size(); ++i, own += point.size()) {
      double sum = 0;
      for (std::size_t d = 0; d < point.size() && sum < least; ++d) {
        const double way = point[d] - own[d];
        const bool straight = way > -straight_[d] && way < straight_[d];
        const double off = straight ? way * weights_[d] : space_.offset(points_[i], point, d);
        sum += off * off;
      }
      if (sum >= least) continue;
      least = sum;
      best = static_cast<int>(i);
    }
    return best;
  }

  /// From the root to a node.
  std::vector<Point> way_to(int node) const {
    std::vector<Point> way;
    for (; node >= 0; node = parent(node)) way.push_back(point(node));
    return {way.rbegin(), way.rend()};
  }

 private:
  const Space& space_;
  std::vector<double> weights_;
  std::vector<double> straight_;     ///< differences below this need no whole turns taken away
  std::vector<double> coordinates_;  ///< of all points, one after the other
  std::vector<Point> points_;
  std::vector<int> parents_;
};

}  // namespace rubicon::guides
