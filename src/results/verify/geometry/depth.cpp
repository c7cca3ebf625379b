#include "src/results/verify/geometry/depth.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "src/results/verify/geometry/inner_polytope.hpp"

namespace rubicon::verify {

namespace {

/// The sine of an angle below which two edges are parallel: their product gives no direction.
constexpr double kParallel = 1e-9;

/// Separating axes: of two solids with corners only, the least overlap is along a normal of a face
/// of one of them or a product of two edges (the faces of their difference).
class AxisTest {
 public:
  AxisTest(const std::vector<Vec3>& a, const std::vector<Vec3>& b, const DepthQuery& query)
      : a_(a), b_(b), query_(query) {}

  /// Whether this direction proves them free.
  bool frees(const Vec3& n) {
    double a_least = std::numeric_limits<double>::infinity();
    double b_least = a_least;
    double a_most = -a_least;
    double b_most = -a_least;
    for (const Vec3& p : a_) {
      a_least = std::min(a_least, n.dot(p));
      a_most = std::max(a_most, n.dot(p));
    }
    for (const Vec3& p : b_) {
      b_least = std::min(b_least, n.dot(p));
      b_most = std::max(b_most, n.dot(p));
    }
    const double overlap = std::min(a_most - b_least, b_most - a_least);
    depth_ = std::min(depth_, overlap);
    return overlap + query_.reach.along(n) <= query_.limit;
  }

  DepthResult rest() const {
    if (depth_ > query_.alarm) return {Nearness::deep, depth_};
    return {Nearness::unsure, depth_};
  }

 private:
  const std::vector<Vec3>& a_;
  const std::vector<Vec3>& b_;
  const DepthQuery& query_;
  double depth_ = std::numeric_limits<double>::infinity();
};

DepthResult test_by_axes(const Convex& a, const Pose& X_BA, const Convex& b,
                         const DepthQuery& query) {
  std::vector<Vec3> corners;
  corners.reserve(a.corners.size());
  for (const Vec3& corner : a.corners) corners.push_back(X_BA * corner);
  AxisTest test(corners, b.corners, query);
  for (const Vec3& n : b.normals) {
    if (test.frees(n)) return {Nearness::free, 0};
  }
  for (const Vec3& n : a.normals) {
    if (test.frees(X_BA.linear() * n)) return {Nearness::free, 0};
  }
  for (const Vec3& edge_a : a.edges) {
    const Vec3 edge = X_BA.linear() * edge_a;
    for (const Vec3& edge_b : b.edges) {
      const Vec3 n = edge.cross(edge_b);
      const double length = n.norm();
      if (length > kParallel && test.frees(n / length)) return {Nearness::free, 0};
    }
  }
  return test.rest();
}

}  // namespace

DepthResult depth_test(const Convex& a, const Pose& X_BA, const Convex& b,
                       const DepthQuery& query) {
  if (a.has_axes() && b.has_axes()) return test_by_axes(a, X_BA, b, query);
  return test_by_inner_polytope(a, X_BA, b, query);
}

}  // namespace rubicon::verify
