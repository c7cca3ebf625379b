#include "src/motion/collision/mesh/triangle_soup.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/convex/convex.hpp"

namespace rubicon::collision {
namespace {

constexpr int kTrianglesPerLeaf = kPack;

}  // namespace

TriangleSoup::TriangleSoup(std::vector<Vec3> vertices, std::vector<Triangle> triangles, bool closed)
    : vertices_(std::move(vertices)), closed_(closed) {
  for (const Triangle& triangle : triangles) {
    if (smallest_altitude(vertices_[triangle[0]], vertices_[triangle[1]], vertices_[triangle[2]]) >=
        kDegenerateAltitude) {
      triangles_.push_back(triangle);
    }
  }
  if (triangles_.empty()) return;
  find_probes();
  nodes_.emplace_back();
  build(0, 0, static_cast<int>(triangles_.size()));
  for (const Node& node : nodes_) {
    if (node.count == 0) continue;
    add_pack(node.first, node.first + node.count);
    pack_bounds_.push_back(node.bounds);
    pack_boxes_.push_back(close_box(node));
  }
  pack_tree_ = WideTree(pack_bounds_);
}

void TriangleSoup::add_pack(int begin, int end) {
  TrianglePack& pack = packs_.emplace_back();
  pack.first = begin;
  pack.count = end - begin;
  for (int i = 0; i < kPack; ++i) {
    const int triangle = i < pack.count ? begin + i : begin;
    for (int k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 3; ++axis) pack.corner[k][axis][i] = corner(triangle, k)[axis];
    }
    const double altitude =
        smallest_altitude(corner(triangle, 0), corner(triangle, 1), corner(triangle, 2));
    pack.tolerance[i] = thickness_tolerance(altitude);
  }
}

/// A box along the face of its triangles, or one along the axes if that is no larger.
OrientedBox TriangleSoup::close_box(const Node& leaf) const {
  OrientedBox best;
  best.centre = leaf.bounds.centre();
  best.half = leaf.bounds.half() + Vec3::Constant(kBoundsMargin);
  Vec3 normal = Vec3::Zero();
  Vec3 longest = Vec3::Zero();
  for (int i = leaf.first; i < leaf.first + leaf.count; ++i) {
    normal += (corner(i, 1) - corner(i, 0)).cross(corner(i, 2) - corner(i, 0));
    for (int k = 0; k < 3; ++k) {
      const Vec3 edge = corner(i, (k + 1) % 3) - corner(i, k);
      if (edge.squaredNorm() > longest.squaredNorm()) longest = edge;
    }
  }
  const Vec3 side = normal.cross(longest);
  if (!(side.norm() > kSameDirection * normal.norm() * longest.norm())) return best;
  OrientedBox box;
  const Vec3 n = normal.normalized();
  const Vec3 v = side.normalized();
  box.R << v.cross(n), v, n;
  Bounds along;
  for (int i = leaf.first; i < leaf.first + leaf.count; ++i) {
    for (int k = 0; k < 3; ++k) along.add(box.R.transpose() * corner(i, k));
  }
  box.centre = box.R * along.centre();
  box.half = along.half() + Vec3::Constant(kBoundsMargin);
  return box.half.prod() < best.half.prod() ? box : best;
}

void TriangleSoup::build(int node, int begin, int end) {
  Bounds bounds;
  Bounds centres;
  const auto centre_of = [this](const Triangle& triangle) {
    return Vec3(vertices_[triangle[0]] + vertices_[triangle[1]] + vertices_[triangle[2]]);
  };
  for (int i = begin; i < end; ++i) {
    for (int k = 0; k < 3; ++k) bounds.add(corner(i, k));
    centres.add(centre_of(triangles_[i]));
  }
  nodes_[node].bounds = bounds;
  if (end - begin <= kTrianglesPerLeaf) {
    nodes_[node].first = begin;
    nodes_[node].count = end - begin;
    return;
  }
  int axis = 0;
  centres.half().maxCoeff(&axis);
  // Stable: equal centres keep the order of the file, so that the tree is the same everywhere.
  std::stable_sort(triangles_.begin() + begin, triangles_.begin() + end,
                   [&](const Triangle& a, const Triangle& b) {
                     return centre_of(a)[axis] < centre_of(b)[axis];
                   });
  const int children = static_cast<int>(nodes_.size());
  nodes_[node].first = children;
  nodes_.emplace_back();
  nodes_.emplace_back();
  const int middle = begin + (end - begin) / 2;
  build(children, begin, middle);
  build(children + 1, middle, end);
}

/// The extreme corners of every connected part along the axes.
void TriangleSoup::find_probes() {
  const std::vector<int> part_of = connected_parts(vertices_.size(), triangles_);
  std::map<int, std::array<Vec3, 6>> extremes;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    for (const int index : triangles_[i]) {
      const Vec3& point = vertices_[index];
      auto [found, is_new] = extremes.try_emplace(part_of[i]);
      std::array<Vec3, 6>& points = found->second;
      if (is_new) points.fill(point);
      for (int axis = 0; axis < 3; ++axis) {
        const auto least = static_cast<std::size_t>(2 * axis);
        if (point[axis] < points[least][axis]) points[least] = point;
        if (point[axis] > points[least + 1][axis]) points[least + 1] = point;
      }
    }
  }
  for (const auto& [part, points] : extremes)
    probes_.insert(probes_.end(), points.begin(), points.end());
}

std::vector<int> connected_parts(std::size_t vertex_count,
                                 const std::vector<TriangleSoup::Triangle>& triangles) {
  std::vector<int> root(vertex_count);
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](int vertex) {
    while (root[vertex] != vertex) {
      root[vertex] = root[root[vertex]];
      vertex = root[vertex];
    }
    return vertex;
  };
  for (const auto& triangle : triangles) {
    root[find(triangle[1])] = find(triangle[0]);
    root[find(triangle[2])] = find(triangle[0]);
  }
  std::vector<int> number(vertex_count, -1);
  std::vector<int> part_of;
  int count = 0;
  for (const auto& triangle : triangles) {
    int& part = number[find(triangle[0])];
    if (part < 0) part = count++;
    part_of.push_back(part);
  }
  return part_of;
}

}  // namespace rubicon::collision
