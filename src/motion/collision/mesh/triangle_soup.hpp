#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "src/motion/collision/base/bounds.hpp"
#include "src/motion/collision/base/oriented_box.hpp"
#include "src/motion/collision/tree/triangle_pack.hpp"
#include "src/motion/collision/tree/wide_tree.hpp"

namespace rubicon::collision {

/// Triangles of a mesh that is not convex, in the (centred) frame of their body, with a tree of
/// axis-parallel boxes. If `closed`, the triangles bound solids: a point with a winding number
/// other than 0 is inside.
class TriangleSoup {
 public:
  using Triangle = std::array<int, 3>;

  /// A node of the tree: a leaf holds `count` triangles from `first`, an inner node (count 0) the
  /// nodes `first` and `first` + 1.
  struct Node {
    Bounds bounds;
    std::int32_t first = 0;
    std::int32_t count = 0;
  };

  /// Sorts the triangles into the tree; degenerate ones are left out of it. `vertices` and indices
  /// must be valid.
  TriangleSoup(std::vector<Vec3> vertices, std::vector<Triangle> triangles, bool closed);

  bool empty() const { return triangles_.empty(); }
  bool closed() const { return closed_; }
  const std::vector<Vec3>& vertices() const { return vertices_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  const Bounds& bounds() const { return nodes_.front().bounds; }
  const Vec3& corner(int triangle, int k) const { return vertices_[triangles_[triangle][k]]; }

  /// Calls `visit(triangle)` for the triangles in nodes whose bounds `enters`, until one returns
  /// true; whether one did.
  template <typename Enters, typename Visit>
  bool any_triangle(const Enters& enters, const Visit& visit) const {
    std::vector<int> open = {0};
    while (!open.empty()) {
      const Node& node = nodes_[open.back()];
      open.pop_back();
      if (!enters(node.bounds)) continue;
      if (node.count == 0) {
        open.push_back(node.first + 1);
        open.push_back(node.first);
        continue;
      }
      for (int i = node.first; i < node.first + node.count; ++i) {
        if (visit(i)) return true;
      }
    }
    return false;
  }

  /// The leaves of the tree, each as one pack of triangles side by side, and a wide tree over them.
  const std::vector<TrianglePack>& packs() const { return packs_; }
  const std::vector<Bounds>& pack_bounds() const { return pack_bounds_; }
  /// A close box around each pack, flat where its triangles are; a little larger than they are, so
  /// that no rounding counts.
  const std::vector<OrientedBox>& pack_boxes() const { return pack_boxes_; }
  const WideTree& pack_tree() const { return pack_tree_; }

  /// A few points of every connected part, for tests of containment.
  const std::vector<Vec3>& probes() const { return probes_; }

 private:
  void build(int node, int begin, int end);
  void find_probes();
  void add_pack(int begin, int end);
  OrientedBox close_box(const Node& leaf) const;

  std::vector<Vec3> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
  std::vector<TrianglePack> packs_;
  std::vector<Bounds> pack_bounds_;
  std::vector<OrientedBox> pack_boxes_;
  WideTree pack_tree_;
  std::vector<Vec3> probes_;
  bool closed_ = false;
};

/// The connected part each triangle belongs to (parts share no vertex), numbered from 0 in the
/// order of the triangles.
std::vector<int> connected_parts(std::size_t vertex_count,
                                 const std::vector<TriangleSoup::Triangle>& triangles);

}  // namespace rubicon::collision
