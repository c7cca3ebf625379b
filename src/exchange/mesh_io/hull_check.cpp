#include "src/exchange/mesh_io/hull_check.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace rubicon::mesh_io {

namespace {

using geometry::Vec3;

constexpr std::size_t kLeafPoints = 16;

/// Boxes and points that are looked at before a hull is given up: about a second.
constexpr std::uint64_t kMostWork = 300'000'000;

/// Points in an order in which every node is a range, cut at its middle.
class PointTree {
 public:
  explicit PointTree(std::vector<Vec3> points) : points_(std::move(points)) {
    nodes_.reserve(2 * points_.size() / kLeafPoints + 2);
    if (!points_.empty()) build(0, points_.size());
  }

  /// Whether any point lies farther than `limit` along `direction`. Takes its work off `work`.
  bool any_beyond(const Vec3& direction, double limit, std::uint64_t& work) const {
    std::vector<std::size_t> pending;
    if (!nodes_.empty()) pending.push_back(0);
    const Vec3 across = direction.cwiseAbs();
    while (!pending.empty()) {
      const Node& node = nodes_[pending.back()];
      const std::size_t index = pending.back();
      pending.pop_back();
      const std::uint64_t cost = node.second_child == 0 ? node.end - node.begin + 1 : 1;
      if (work < cost) {
        work = 0;
        return false;
      }
      work -= cost;
      if (direction.dot(node.middle) + across.dot(node.half) <= limit) continue;
      if (node.second_child != 0) {
        pending.push_back(node.second_child);
        pending.push_back(index + 1);
        continue;
      }
      for (std::size_t i = node.begin; i < node.end; ++i) {
        if (direction.dot(points_[i]) > limit) return true;
      }
    }
    return false;
  }

 private:
  struct Node {
    Vec3 middle;
    Vec3 half;
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t second_child = 0;  // 0: a leaf; the first child stands behind its parent
  };

  void build(std::size_t begin, std::size_t end) {
    Vec3 lower = points_[begin];
    Vec3 upper = points_[begin];
    for (std::size_t i = begin; i < end; ++i) {
      lower = lower.cwiseMin(points_[i]);
      upper = upper.cwiseMax(points_[i]);
    }
    const std::size_t index = nodes_.size();
    nodes_.push_back({(lower + upper) / 2, (upper - lower) / 2, begin, end, 0});
    if (end - begin <= kLeafPoints) return;
    int axis = 0;
    (upper - lower).maxCoeff(&axis);
    const std::size_t half = begin + (end - begin) / 2;
    const auto place = [&](std::size_t i) {
      return points_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(place(begin), place(half), place(end),
                     [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
    build(begin, half);
    nodes_[index].second_child = nodes_.size();
    build(half, end);
  }

  std::vector<Vec3> points_;
  std::vector<Node> nodes_;
};

}  // namespace

HullCheck hull_contains(const geometry::TriangleMesh& hull, const std::vector<Vec3>& points) {
  if (hull.vertices.empty()) return HullCheck::kSticksOut;
  // Relative to one of its corners: far from the origin nothing is lost.
  const Vec3 origin = hull.vertices.front();
  std::vector<Vec3> moved;
  moved.reserve(points.size());
  for (const Vec3& p : points) moved.push_back(p - origin);
  const PointTree tree(std::move(moved));
  std::uint64_t work = kMostWork;
  for (const std::array<int, 3>& triangle : hull.triangles) {
    const auto corner = [&](std::size_t k) -> Vec3 {
      return hull.vertices[static_cast<std::size_t>(triangle[k])] - origin;
    };
    const Vec3 a = corner(0);
    const Vec3 ab = corner(1) - a;
    const Vec3 ac = corner(2) - a;
    const Vec3 cross = ab.cross(ac);
    const double area2 = cross.norm();
    const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
    if (!(area2 >= kHullSliver * longest)) continue;
    const Vec3 normal = cross / area2;
    if (tree.any_beyond(normal, normal.dot(a) + kHullSlack, work)) return HullCheck::kSticksOut;
    if (work == 0) return HullCheck::kTooMuchWork;
  }
  return HullCheck::kContains;
}

}  // namespace rubicon::mesh_io
