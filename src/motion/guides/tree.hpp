#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "src/motion/guides/nearest_index.hpp"
#include "src/motion/guides/space.hpp"
#include "src/motion/math/turns.hpp"

namespace rubicon::guides {

/// A tree of points, each reached from its parent by a free leg.
class Tree {
 public:
  Tree(const Space& space, Point root) : space_(space) {
    std::vector<double> weights;
    std::vector<double> turns;
    for (std::size_t d = 0; d < root.size(); ++d) {
      const bool cyclic = space.parameter(d).cyclic;
      weights.push_back(space.weight(d));
      turns.push_back(cyclic ? math::kTurn_deg : 0);
      half_turns_.push_back(cyclic ? math::kHalfTurn_deg : std::numeric_limits<double>::infinity());
    }
    index_ = NearestIndex(std::move(weights), std::move(turns));
    add(std::move(root), -1);
  }

  int add(Point point, int parent) {
    reduced_ = reduced_ && is_reduced(point);
    if (reduced_ && !space_.leg().steers()) index_.add(point);
    points_.push_back(std::move(point));
    parents_.push_back(parent);
    return static_cast<int>(points_.size()) - 1;
  }
  std::size_t size() const { return points_.size(); }
  const Point& point(int node) const { return points_[static_cast<std::size_t>(node)]; }
  int parent(int node) const { return parents_[static_cast<std::size_t>(node)]; }

  struct Near {
    int node = 0;
    double distance = std::numeric_limits<double>::infinity();
  };
  /// Of equally near nodes the first.
  Near nearest(std::span<const double> point) const {
    if (space_.leg().steers()) return nearest_steered(point);
    if (reduced_ && is_reduced(point)) {
      const NearestIndex::Found found = index_.nearest(point);
      return {found.index, std::sqrt(found.square)};
    }
    Near near;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double sum = square_of_way(i, point);
      if (sum >= least) continue;
      least = sum;
      near = {static_cast<int>(i), std::sqrt(sum)};
    }
    return near;
  }

  /// Its legs, parent first, behind those of others.
  void tell(std::vector<std::pair<Point, Point>>& legs) const {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (parents_[i] >= 0) legs.emplace_back(point(parents_[i]), points_[i]);
    }
  }

  /// From the root to a node.
  std::vector<Point> way_to(int node) const {
    std::vector<Point> way;
    for (; node >= 0; node = parent(node)) way.push_back(point(node));
    return {way.rbegin(), way.rend()};
  }

 private:
  /// Whether all angles that turn freely are within half a turn.
  bool is_reduced(std::span<const double> point) const {
    for (std::size_t d = 0; d < point.size(); ++d) {
      if (!(std::fabs(point[d]) <= half_turns_[d])) return false;
    }
    return true;
  }

  /// By the ways that a vehicle steers. None is shorter than the straight line between two places:
  /// where that is farther than the nearest so far the way is not looked for.
  Near nearest_steered(std::span<const double> point) const {
    Near near;
    const std::vector<int>& parameters = space_.leg().parameters();
    const auto place = space_.leg().place();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      double square = 0;
      for (std::size_t d = 0; d < point.size(); ++d) {
        if (parameters[d] != place[0] && parameters[d] != place[1]) continue;
        const double off = (point[d] - points_[i][d]) * kWeightOfPlace;
        square += off * off;
      }
      if (std::sqrt(square) >= near.distance) continue;
      const double distance = space_.distance(points_[i], point);
      if (distance < near.distance) near = {static_cast<int>(i), distance};
    }
    return near;
  }

  double square_of_way(std::size_t node, std::span<const double> point) const {
    double sum = 0;
    for (std::size_t d = 0; d < point.size(); ++d) {
      const double off = space_.offset(points_[node], point, d);
      sum += off * off;
    }
    return sum;
  }

  /// Of a metre, in distances of a vehicle that steers.
  static constexpr double kWeightOfPlace = 10;

  const Space& space_;
  std::vector<double> half_turns_;  ///< of an angle that turns freely; else infinite
  bool reduced_ = true;             ///< all points are
  NearestIndex index_{{}, {}};      ///< of points that are reduced
  std::vector<Point> points_;
  std::vector<int> parents_;
};

}  // namespace rubicon::guides
