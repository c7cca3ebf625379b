#include "src/exchange/ifc/solid_split.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "src/motion/math/index.hpp"

namespace rubicon::ifc {

namespace {

using math::Vec3;
using Triangle = std::array<int, 3>;

using math::at;

class Splitter {
 public:
  Splitter(const SolidPart& part, const HalfSpace& plane)
      : part_(part), plane_(plane), points_(part.solid.points), edge_of_(part.edge_of) {}

  std::optional<SplitSolid> split(WorkBudget& budget) {
    if (!budget.spend(points_.size() + 4 * part_.solid.triangles.size())) return std::nullopt;
    measure();
    for (std::size_t i = 0; i < part_.solid.triangles.size(); ++i) {
      sort_triangle(part_.solid.triangles[i], part_.source[i]);
    }
    SplitSolid result;
    if (!close(inside_, plane_.n, budget) || !close(outside_, -plane_.n, budget)) {
      return std::nullopt;
    }
    for (auto* side : {&inside_, &outside_}) {
      side->solid.points = points_;
      side->edge_of = edge_of_;
    }
    result.inside = std::move(inside_);
    result.outside = std::move(outside_);
    return result;
  }

 private:
  void measure() {
    for (const Vec3& p : points_) {
      const double d = plane_.n.dot(p) - plane_.w;
      distance_.push_back(d);
      side_.push_back(d > kOnPlane ? 1 : d < -kOnPlane ? -1 : 0);
    }
  }

  static void put(SolidPart& part, const Triangle& t, int source) {
    part.solid.triangles.push_back(t);
    part.source.push_back(source);
  }

  void sort_triangle(const Triangle& t, int source) {
    const std::array<int, 3> s{side_[at(t[0])], side_[at(t[1])], side_[at(t[2])]};
    const int low = *std::min_element(s.begin(), s.end());
    const int high = *std::max_element(s.begin(), s.end());
    if (low == 0 && high == 0) {
      const Vec3 n = loop_normal(points_, {t[0], t[1], t[2]});
      put(n.dot(plane_.n) > 0 ? inside_ : outside_, t, source);
    } else if (low >= 0) {
      put(outside_, t, source);
    } else if (high <= 0) {
      put(inside_, t, source);
    } else {
      cut_triangle(t, source);
    }
  }

  void cut_triangle(const Triangle& t, int source) {
    Loop below;
    Loop above;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k];
      const int b = t[(k + 1) % 3];
      if (side_[at(a)] <= 0) below.push_back(a);
      if (side_[at(a)] >= 0) above.push_back(a);
      if (side_[at(a)] * side_[at(b)] < 0) {
        const int crossing = crossing_of(a, b);
        below.push_back(crossing);
        above.push_back(crossing);
      }
    }
    put_fan(inside_, below, source);
    put_fan(outside_, above, source);
  }

  static void put_fan(SolidPart& part, const Loop& corners, int source) {
    for (std::size_t i = 2; i < corners.size(); ++i) {
      put(part, {corners[0], corners[i - 1], corners[i]}, source);
    }
  }

  /// The corner where an edge meets the plane, one for both triangles of the edge.
  int crossing_of(int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    const auto [found, is_new] =
        crossings_.try_emplace({low, high}, static_cast<int>(points_.size()));
    if (is_new) {
      const double d = distance_[at(low)];
      const double t = d / (d - distance_[at(high)]);
      const Vec3 p = points_[at(low)] + t * (points_[at(high)] - points_[at(low)]);
      points_.push_back(p);
      side_.push_back(0);
      if (const auto edge = edge_along(low, high)) edge_of_.emplace(found->second, *edge);
    }
    return found->second;
  }

  /// The edge of the body that the line between two corners may be a piece of. Decided by where
  /// they come from, not where they are: thin triangles have three edges at one place.
  std::optional<std::pair<int, int>> edge_along(int a, int b) const {
    const auto of_a = edge_of_.find(a);
    const auto of_b = edge_of_.find(b);
    const auto ends = [](const std::pair<int, int>& edge, int corner) {
      return edge.first == corner || edge.second == corner;
    };
    if (of_a != edge_of_.end()) {
      const bool same = of_b != edge_of_.end() && of_b->second == of_a->second;
      if (same || ends(of_a->second, b)) return of_a->second;
      return std::nullopt;
    }
    if (of_b != edge_of_.end()) {
      if (ends(of_b->second, a)) return of_b->second;
      return std::nullopt;
    }
    return std::pair(std::min(a, b), std::max(a, b));
  }

  /// Puts in what is missing on the plane.
  bool close(SolidPart& part, const Vec3& normal, WorkBudget& budget) const {
    std::vector<std::pair<int, int>> missing;
    for (const Triangle& t : part.solid.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = t[k];
        const int b = t[(k + 1) % 3];
        if (side_[at(a)] == 0 && side_[at(b)] == 0) missing.emplace_back(b, a);
      }
    }
    const auto loops = border_loops(points_, std::move(missing), normal);
    if (!loops) return false;
    if (loops->empty()) return true;
    const auto cap = triangulate(points_, *loops, normal, budget, 2 * kOnPlane);
    if (!cap) return false;
    for (const Triangle& t : *cap) put(part, t, kFromCut);
    return true;
  }

  const SolidPart& part_;
  const HalfSpace& plane_;
  std::vector<Vec3> points_;
  std::vector<double> distance_;
  std::vector<int> side_;
  std::map<std::pair<int, int>, int> crossings_;
  std::map<int, std::pair<int, int>> edge_of_;
  SolidPart inside_, outside_;
};

}  // namespace

SolidPart whole(const Solid& solid) {
  SolidPart part{solid, {}, {}};
  for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
    part.source.push_back(static_cast<int>(i));
  }
  return part;
}

std::optional<SplitSolid> split(const SolidPart& part, const HalfSpace& plane, WorkBudget& budget) {
  return Splitter(part, plane).split(budget);
}

}  // namespace rubicon::ifc
