#include "src/results/gltf/polygon_parts.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace rubicon::gltf {

namespace {

/// m^2, twice the area of a triangle: less is a straight line.
constexpr double kStraight = 1e-12;

using Ring = std::vector<int>;  ///< corners, anticlockwise

class PolygonCutter {
 public:
  explicit PolygonCutter(const Polygon& polygon) : points_(polygon) {}

  std::vector<Polygon> cut() {
    const Ring outline = anticlockwise();
    if (convex(outline)) return {corners(outline)};
    std::vector<Ring> rings = ears(outline);
    join(rings);
    std::vector<Polygon> parts;
    for (const Ring& ring : rings) {
      if (!ring.empty()) parts.push_back(corners(ring));
    }
    return parts;
  }

 private:
  const Eigen::Vector2d& point(int i) const { return points_[static_cast<std::size_t>(i)]; }

  /// Twice the area of the triangle, positive if it runs anticlockwise.
  double turn(int a, int b, int c) const {
    const Eigen::Vector2d u = point(b) - point(a);
    const Eigen::Vector2d v = point(c) - point(a);
    return u.x() * v.y() - u.y() * v.x();
  }

  Ring anticlockwise() const {
    Ring ring;
    double area = 0;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) {
      ring.push_back(i);
      area += turn(0, i, (i + 1) % static_cast<int>(points_.size()));
    }
    if (area < 0) std::reverse(ring.begin(), ring.end());
    return ring;
  }

  int around(const Ring& ring, std::size_t i, std::size_t ahead) const {
    return ring[(i + ahead) % ring.size()];
  }

  bool convex(const Ring& ring) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (turn(ring[i], around(ring, i, 1), around(ring, i, 2)) < -kStraight) return false;
    }
    return true;
  }

  bool holds(int a, int b, int c, int p) const {
    return turn(a, b, p) >= -kStraight && turn(b, c, p) >= -kStraight &&
           turn(c, a, p) >= -kStraight;
  }

  bool is_ear(const Ring& ring, std::size_t i) const {
    const int a = ring[i];
    const int b = around(ring, i, 1);
    const int c = around(ring, i, 2);
    if (turn(a, b, c) <= kStraight) return false;
    return std::none_of(ring.begin(), ring.end(), [&](int p) {
      const bool corner = point(p) == point(a) || point(p) == point(b) || point(p) == point(c);
      return !corner && holds(a, b, c, p);
    });
  }

  std::vector<Ring> ears(Ring ring) const {
    std::vector<Ring> triangles;
    while (ring.size() > 3) {
      std::size_t i = 0;
      while (i < ring.size() && !is_ear(ring, i)) ++i;
      if (i < ring.size()) {
        triangles.push_back({ring[i], around(ring, i, 1), around(ring, i, 2)});
      } else {
        i = straight_corner(ring);
      }
      ring.erase(ring.begin() + static_cast<Ring::difference_type>((i + 1) % ring.size()));
    }
    if (turn(ring[0], ring[1], ring[2]) > kStraight) triangles.push_back(ring);
    return triangles;
  }

  /// A corner that is none can go without an ear.
  std::size_t straight_corner(const Ring& ring) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (std::abs(turn(ring[i], around(ring, i, 1), around(ring, i, 2))) <= kStraight) return i;
    }
    throw std::invalid_argument("expected a simple polygon of a prism");
  }

  /// Joins neighbours over their common edge where the whole is convex; what was joined to another
  /// is left empty.
  void join(std::vector<Ring>& rings) const {
    for (std::size_t i = 0; i < rings.size(); ++i) {
      bool joined = true;
      while (joined) {
        joined = false;
        for (std::size_t j = i + 1; j < rings.size() && !joined; ++j) {
          joined = join_pair(rings[i], rings[j]);
        }
      }
    }
  }

  bool join_pair(Ring& into, Ring& other) const {
    for (std::size_t i = 0; i < into.size(); ++i) {
      for (std::size_t j = 0; j < other.size(); ++j) {
        if (into[i] != around(other, j, 1) || around(into, i, 1) != other[j]) continue;
        Ring whole;
        for (std::size_t k = 1; k <= into.size(); ++k) whole.push_back(around(into, i, k));
        for (std::size_t k = 2; k < other.size(); ++k) whole.push_back(around(other, j, k));
        if (!convex(whole)) return false;
        into = std::move(whole);
        other.clear();
        return true;
      }
    }
    return false;
  }

  Polygon corners(const Ring& ring) const {
    Polygon polygon;
    for (const int i : ring) polygon.push_back(point(i));
    return polygon;
  }

  const Polygon& points_;
};

}  // namespace

std::vector<Polygon> convex_parts(const Polygon& polygon) { return PolygonCutter(polygon).cut(); }

}  // namespace rubicon::gltf
