#pragma once

#include <utility>
#include <vector>

#include "src/motion/collision/sweep/body.hpp"
#include "src/motion/collision/sweep/relative_motion.hpp"

namespace rubicon::collision {

/// Names the pairs of convex pieces (triangles of meshes included) of two bodies that may meet
/// within a slice of their motion.
class PartPairs {
 public:
  PartPairs(const Body& a, const Body& b, const RelativeMotion& motion)
      : a_(a), b_(b), motion_(motion) {}

  /// Calls `visit(piece of A, piece of B)` for the pairs whose boxes come as near as `reach` (m)
  /// to each other, until one returns true; whether one did. `reach` may shrink between calls.
  template <typename Visit>
  bool any(const Slice& slice, const double& reach, const Visit& visit) const {
    if (swept_a(a_.bounds(), slice, reach).disjoint(b_.bounds())) return false;
    for (const Convex& piece_a : a_.convexes()) {
      const Bounds swept_piece = swept_a(piece_a.bounds, slice, reach);
      for (const Convex& piece_b : b_.convexes()) {
        if (!swept_piece.disjoint(piece_b.bounds) && visit(piece_a, piece_b)) return true;
      }
      for (const TriangleSoup& soup_b : b_.soups()) {
        const auto with_triangle = [&](const Convex& triangle) { return visit(piece_a, triangle); };
        if (any_triangle(soup_b, swept_piece, with_triangle)) return true;
      }
    }
    for (const TriangleSoup& soup_a : a_.soups()) {
      for (const Convex& piece_b : b_.convexes()) {
        const auto with_triangle = [&](const Convex& triangle) { return visit(triangle, piece_b); };
        if (any_triangle(soup_a, swept_b(piece_b.bounds, slice, reach), with_triangle)) return true;
      }
      for (const TriangleSoup& soup_b : b_.soups()) {
        if (any_of_soups(soup_a, soup_b, slice, reach, visit)) return true;
      }
    }
    return false;
  }

 private:
  Bounds swept_a(const Bounds& bounds, const Slice& slice, double reach) const {
    return swept_bounds(bounds, slice.a_in_b, slice, motion_.axis_in_b(), motion_.axis_in_a(),
                        reach);
  }
  Bounds swept_b(const Bounds& bounds, const Slice& slice, double reach) const {
    return swept_bounds(bounds, slice.b_in_a, slice, motion_.axis_in_a(), motion_.axis_in_b(),
                        reach);
  }
  static Bounds swept_bounds(const Bounds& bounds, const View& view, const Slice& slice,
                             const RelativeMotion::Axis& axis_here,
                             const RelativeMotion::Axis& axis_there, double reach);

  /// Calls `test(triangle)` for the triangles of `soup` in boxes that meet `swept`.
  template <typename Test>
  static bool any_triangle(const TriangleSoup& soup, const Bounds& swept, const Test& test) {
    return soup.any_triangle(
        [&](const Bounds& bounds) { return !swept.disjoint(bounds); },
        [&](int i) {
          const TrianglePiece triangle(soup.corner(i, 0), soup.corner(i, 1), soup.corner(i, 2));
          return !swept.disjoint(triangle.view().bounds) && test(triangle.view());
        });
  }

  template <typename Visit>
  bool any_of_soups(const TriangleSoup& soup_a, const TriangleSoup& soup_b, const Slice& slice,
                    const double& reach, const Visit& visit) const {
    std::vector<std::pair<int, int>> open = {{0, 0}};
    while (!open.empty()) {
      const auto [index_a, index_b] = open.back();
      open.pop_back();
      const TriangleSoup::Node& node_a = soup_a.nodes()[index_a];
      const TriangleSoup::Node& node_b = soup_b.nodes()[index_b];
      if (swept_a(node_a.bounds, slice, reach).disjoint(node_b.bounds)) continue;
      if (node_a.count > 0 && node_b.count > 0) {
        if (any_of_leaves(soup_a, node_a, soup_b, node_b, slice, reach, visit)) return true;
        continue;
      }
      const bool open_a =
          node_b.count > 0 || (node_a.count == 0 && node_a.bounds.half().squaredNorm() >=
                                                        node_b.bounds.half().squaredNorm());
      for (int child = 1; child >= 0; --child) {
        open.emplace_back(open_a ? node_a.first + child : index_a,
                          open_a ? index_b : node_b.first + child);
      }
    }
    return false;
  }

  template <typename Visit>
  bool any_of_leaves(const TriangleSoup& soup_a, const TriangleSoup::Node& node_a,
                     const TriangleSoup& soup_b, const TriangleSoup::Node& node_b,
                     const Slice& slice, const double& reach, const Visit& visit) const {
    for (int i = node_a.first; i < node_a.first + node_a.count; ++i) {
      const TrianglePiece a(soup_a.corner(i, 0), soup_a.corner(i, 1), soup_a.corner(i, 2));
      const Bounds swept = swept_a(a.view().bounds, slice, reach);
      for (int j = node_b.first; j < node_b.first + node_b.count; ++j) {
        const TrianglePiece b(soup_b.corner(j, 0), soup_b.corner(j, 1), soup_b.corner(j, 2));
        if (!swept.disjoint(b.view().bounds) && visit(a.view(), b.view())) return true;
      }
    }
    return false;
  }

  const Body& a_;
  const Body& b_;
  const RelativeMotion& motion_;
};

/// Into how many equal slices to cut a step so that bounding boxes of slices are useful; `size` is
/// that of the two bodies (m).
int useful_slices(const RelativeMotion& motion, double size);

}  // namespace rubicon::collision
