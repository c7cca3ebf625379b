#include "src/collision/body_pair.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "src/collision/containment.hpp"
#include "src/collision/pair_test.hpp"
#include "src/collision/tolerances.hpp"

namespace rubicon::collision {
namespace {

/// A slice's bounding boxes are useful while its bulge is below this share of the body's size.
constexpr double kUsefulGrowth = 0.05;
/// Slices a step is cut into at most before boxes are compared.
constexpr int kMaxSlices = 64;

double lever_of(const Bounds& bounds, const RelativeMotion::Axis& axis) {
  return axis.axis.cross(bounds.centre() - axis.point).norm() + bounds.half().norm();
}

/// The box around a moving box over a slice, in the frame of the other body. `axis_here` is the
/// screw's axis in that frame, `axis_there` in the moving one.
Bounds swept(const Bounds& bounds, const View& view, const Slice& slice,
             const RelativeMotion::Axis& axis_here, const RelativeMotion::Axis& axis_there) {
  Bounds result = placed(bounds, view.start);
  result.add(placed(bounds, view.end));
  Vec3 growth = Vec3::Constant(view.uniform_growth + kBoundsMargin);
  if (slice.bulge > 0) {
    const double sagitta = slice.bulge * lever_of(bounds, axis_there);
    for (int i = 0; i < 3; ++i) {
      growth[i] += sagitta * axis_here.axis.cross(Vec3::Unit(i)).norm();
    }
  }
  result.grow(growth);
  return result;
}

class BodyPair {
 public:
  BodyPair(const Body& a, const Body& b, const RelativeMotion& motion, double tolerance)
      : a_(a), b_(b), motion_(motion), tolerance_(tolerance) {}

  bool blocked(MotionTree& tree) const {
    const Slice& slice = tree.slice();
    if (swept_a(a_.bounds(), slice).disjoint(b_.bounds())) return false;
    for (const Convex& piece_a : a_.convexes()) {
      const Bounds swept_piece = swept_a(piece_a.bounds, slice);
      for (const Convex& piece_b : b_.convexes()) {
        if (!swept_piece.disjoint(piece_b.bounds) && meets(piece_a, piece_b, tree)) return true;
      }
      for (const TriangleSoup& soup_b : b_.soups()) {
        if (piece_meets_soup_of_b(piece_a, swept_piece, soup_b, tree)) return true;
      }
    }
    for (const TriangleSoup& soup_a : a_.soups()) {
      for (const Convex& piece_b : b_.convexes()) {
        if (piece_meets_soup_of_a(piece_b, soup_a, tree)) return true;
      }
      for (const TriangleSoup& soup_b : b_.soups()) {
        if (soups_meet(soup_a, soup_b, tree)) return true;
      }
    }
    return false;
  }

 private:
  Bounds swept_a(const Bounds& bounds, const Slice& slice) const {
    return swept(bounds, slice.a_in_b, slice, motion_.axis_in_b(), motion_.axis_in_a());
  }
  Bounds swept_b(const Bounds& bounds, const Slice& slice) const {
    return swept(bounds, slice.b_in_a, slice, motion_.axis_in_a(), motion_.axis_in_b());
  }

  bool meets(const Convex& a, const Convex& b, MotionTree& tree) const {
    return pair_blocked(a, b, tree, pair_tolerance(a.width, b.width, tolerance_));
  }

  /// Calls `test(triangle)` for the triangles of `soup` in boxes that meet `swept_bounds`, until
  /// one is true.
  template <typename Test>
  static bool any_triangle(const TriangleSoup& soup, const Bounds& swept_bounds, const Test& test) {
    std::vector<int> open = {0};
    while (!open.empty()) {
      const TriangleSoup::Node& node = soup.nodes()[open.back()];
      open.pop_back();
      if (swept_bounds.disjoint(node.bounds)) continue;
      if (node.count == 0) {
        open.push_back(node.first + 1);
        open.push_back(node.first);
        continue;
      }
      for (int i = node.first; i < node.first + node.count; ++i) {
        const TrianglePiece triangle(soup.corner(i, 0), soup.corner(i, 1), soup.corner(i, 2));
        if (!swept_bounds.disjoint(triangle.view().bounds) && test(triangle.view())) return true;
      }
    }
    return false;
  }

  bool piece_meets_soup_of_b(const Convex& piece_a, const Bounds& swept_piece,
                             const TriangleSoup& soup_b, MotionTree& tree) const {
    return any_triangle(soup_b, swept_piece,
                        [&](const Convex& triangle) { return meets(piece_a, triangle, tree); });
  }

  bool piece_meets_soup_of_a(const Convex& piece_b, const TriangleSoup& soup_a,
                             MotionTree& tree) const {
    return any_triangle(soup_a, swept_b(piece_b.bounds, tree.slice()),
                        [&](const Convex& triangle) { return meets(triangle, piece_b, tree); });
  }

  bool soups_meet(const TriangleSoup& soup_a, const TriangleSoup& soup_b, MotionTree& tree) const {
    std::vector<std::pair<int, int>> open = {{0, 0}};
    while (!open.empty()) {
      const auto [index_a, index_b] = open.back();
      open.pop_back();
      const TriangleSoup::Node& node_a = soup_a.nodes()[index_a];
      const TriangleSoup::Node& node_b = soup_b.nodes()[index_b];
      if (swept_a(node_a.bounds, tree.slice()).disjoint(node_b.bounds)) continue;
      if (node_a.count > 0 && node_b.count > 0) {
        if (leaves_meet(soup_a, node_a, soup_b, node_b, tree)) return true;
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

  bool leaves_meet(const TriangleSoup& soup_a, const TriangleSoup::Node& node_a,
                   const TriangleSoup& soup_b, const TriangleSoup::Node& node_b,
                   MotionTree& tree) const {
    for (int i = node_a.first; i < node_a.first + node_a.count; ++i) {
      const TrianglePiece a(soup_a.corner(i, 0), soup_a.corner(i, 1), soup_a.corner(i, 2));
      const Bounds swept_triangle = swept_a(a.view().bounds, tree.slice());
      for (int j = node_b.first; j < node_b.first + node_b.count; ++j) {
        const TrianglePiece b(soup_b.corner(j, 0), soup_b.corner(j, 1), soup_b.corner(j, 2));
        if (!swept_triangle.disjoint(b.view().bounds) && meets(a.view(), b.view(), tree))
          return true;
      }
    }
    return false;
  }

  const Body& a_;
  const Body& b_;
  const RelativeMotion& motion_;
  double tolerance_;
};

/// Into how many equal slices to cut a step so that bounding boxes of slices are useful.
int slice_count(const RelativeMotion& motion, double size) {
  if (motion.kind() == RelativeMotion::Kind::kStill ||
      motion.kind() == RelativeMotion::Kind::kTranslation)
    return 1;
  int count = 1;
  while (count < kMaxSlices) {
    const Slice first = motion.slice(0, 1.0 / count);
    const double growth = std::max(
        first.bulge, std::max(first.a_in_b.uniform_growth, first.b_in_a.uniform_growth) / size);
    if (growth <= kUsefulGrowth) break;
    count *= 2;
  }
  return count;
}

}  // namespace

bool bodies_blocked(const Body& a, const Motion& motion_a, const Body& b, const Motion& motion_b,
                    double contact_tolerance) {
  const RelativeMotion motion(motion_a, a.extent(), motion_b, b.extent());
  const int count = slice_count(motion, a.extent().radius + b.extent().radius);
  const BodyPair pair(a, b, motion, contact_tolerance);
  for (int i = 0; i < count; ++i) {
    MotionTree tree(motion, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    // From outside a closed mesh one must cross its surface, so the ends of the step are enough.
    if (i == 0 && contained(a, b, tree.slice().a_in_b.start, contact_tolerance)) return true;
    if (pair.blocked(tree)) return true;
    if (i + 1 == count && motion.kind() != RelativeMotion::Kind::kStill &&
        contained(a, b, tree.slice().a_in_b.end, contact_tolerance)) {
      return true;
    }
  }
  return false;
}

}  // namespace rubicon::collision
