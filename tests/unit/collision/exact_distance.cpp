#include "tests/unit/collision/exact_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rubicon::collision::test {
namespace {

Vec3 corner(const OracleBox& box, int which) {
  const Vec3 signs((which & 1) ? 1 : -1, (which & 2) ? 1 : -1, (which & 4) ? 1 : -1);
  return box.X_WC * Vec3(signs.cwiseProduct(box.half));
}

double point_segment_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  const double length = way.squaredNorm();
  const double share = length > 0 ? std::clamp((p - a).dot(way) / length, 0.0, 1.0) : 0;
  return (p - a - share * way).norm();
}

constexpr std::array<std::array<int, 2>, 12> kEdges = {{{0, 1},
                                                        {2, 3},
                                                        {4, 5},
                                                        {6, 7},
                                                        {0, 2},
                                                        {1, 3},
                                                        {4, 6},
                                                        {5, 7},
                                                        {0, 4},
                                                        {1, 5},
                                                        {2, 6},
                                                        {3, 7}}};

}  // namespace

double point_box_distance(const Vec3& point, const OracleBox& box) {
  const Vec3 local = box.X_WC.inverse() * point;
  return (local.cwiseAbs() - box.half).cwiseMax(0.0).norm();
}

double segment_distance(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  double least = std::min({point_segment_distance(a0, b0, b1), point_segment_distance(a1, b0, b1),
                           point_segment_distance(b0, a0, a1), point_segment_distance(b1, a0, a1)});
  // Inner points of both: where the connecting line is perpendicular to both.
  const Vec3 u = a1 - a0;
  const Vec3 v = b1 - b0;
  const Vec3 w = a0 - b0;
  const double denominator = u.squaredNorm() * v.squaredNorm() - u.dot(v) * u.dot(v);
  if (denominator <= 1e-12 * u.squaredNorm() * v.squaredNorm()) return least;
  const double s = (u.dot(v) * v.dot(w) - v.squaredNorm() * u.dot(w)) / denominator;
  const double t = (u.squaredNorm() * v.dot(w) - u.dot(v) * u.dot(w)) / denominator;
  if (s >= 0 && s <= 1 && t >= 0 && t <= 1) least = std::min(least, (w + s * u - t * v).norm());
  return least;
}

double box_distance(const OracleBox& a, const OracleBox& b) {
  if (box_depth(a, b) >= 0) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 8; ++i) {
    least =
        std::min({least, point_box_distance(corner(a, i), b), point_box_distance(corner(b, i), a)});
  }
  for (const auto& [a0, a1] : kEdges) {
    for (const auto& [b0, b1] : kEdges) {
      least = std::min(
          least, segment_distance(corner(a, a0), corner(a, a1), corner(b, b0), corner(b, b1)));
    }
  }
  return least;
}

}  // namespace rubicon::collision::test
