#include "src/motion/travel/plan_view.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "src/motion/geometry/extent.hpp"
#include "src/motion/travel/grow.hpp"

namespace rubicon::travel {

namespace {

using math::Vec3;

/// Sides of the polygon about something round.
constexpr int kSides = 32;

/// m: what reaches less far into the slab is not in it. Things stand on the ground that a robot
/// drives on, and it is no obstacle.
constexpr double kTouching = 1e-3;

/// An axis that is off the vertical by no more than this share stands upright.
constexpr double kUpright = 1e-9;

double cross(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 ab = b - a;
  const Vec2 ac = c - a;
  return ab.x() * ac.y() - ab.y() * ac.x();
}

/// The convex hull, counter-clockwise (Andrew 1979).
std::vector<Vec2> hull(std::vector<Vec2> points) {
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> result;
  for (int half = 0; half < 2; ++half) {
    const std::size_t first = result.size();
    for (const Vec2& point : points) {
      while (result.size() >= first + 2 &&
             cross(result[result.size() - 2], result.back(), point) <= 0) {
        result.pop_back();
      }
      result.push_back(point);
    }
    result.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return result;
}

/// What of the hull of some corners lies between the heights, seen from above: of the corners those
/// between, and where the lines from one to another pass through a height.
std::vector<Vec2> slice(const std::vector<Vec3>& corners, const Heights& heights) {
  std::vector<Vec2> seen;
  for (const Vec3& a : corners) {
    if (a.z() >= heights.low && a.z() <= heights.high) seen.emplace_back(a.x(), a.y());
    for (const Vec3& b : corners) {
      if (!(a.z() < b.z())) continue;
      for (const double level : {heights.low, heights.high}) {
        if (!(a.z() < level && level < b.z())) continue;
        const Vec3 at = a + (level - a.z()) / (b.z() - a.z()) * (b - a);
        seen.emplace_back(at.x(), at.y());
      }
    }
  }
  return hull(std::move(seen));
}

/// Corners whose hull holds the disc of a radius across the z axis of X, at height z.
void add_round(double radius, double z, const math::Pose& X, std::vector<Vec3>& corners) {
  for (const Vec2& corner : disc(radius, kSides)) {
    corners.push_back(X * Vec3(corner.x(), corner.y(), z));
  }
}

/// The corners of a solid, or of what is convex about it.
class Corners {
 public:
  explicit Corners(const math::Pose& X) : X_(X) {}

  void operator()(const geometry::Box& box) {
    for (int i = 0; i < 8; ++i) {
      add({(i & 1 ? box.upper : box.lower).x(), (i & 2 ? box.upper : box.lower).y(),
           (i & 4 ? box.upper : box.lower).z()});
    }
  }
  void operator()(const geometry::Cylinder& cylinder) {
    for (const double z : {cylinder.z0, cylinder.z1}) add_round(cylinder.radius, z, X_, corners);
  }
  void operator()(const geometry::Prism& prism) {
    for (const Eigen::Vector2d& p : prism.polygon) {
      for (const double z : {prism.z0, prism.z1}) add({p.x(), p.y(), z});
    }
  }
  void operator()(const geometry::Mesh& mesh) {
    for (const Vec3& vertex : mesh.mesh->vertices) add(vertex);
  }
  void operator()(const geometry::Sphere&) {}
  void operator()(const geometry::Capsule&) {}

  std::vector<Vec3> corners;

 private:
  void add(const Vec3& p) { corners.push_back(X_ * p); }
  const math::Pose& X_;
};

/// Balls about two points, which may be the same: the disc of each where it is widest in the slab.
struct Balls {
  Vec3 a, b;
  double radius = 0;
};

std::optional<Balls> balls_of(const geometry::Solid& solid, const math::Pose& X) {
  if (const auto* sphere = std::get_if<geometry::Sphere>(&solid)) {
    return Balls{X * sphere->centre, X * sphere->centre, sphere->radius};
  }
  if (const auto* capsule = std::get_if<geometry::Capsule>(&solid)) {
    return Balls{X * capsule->a, X * capsule->b, capsule->radius};
  }
  return std::nullopt;
}

/// A ball at its height, else what is convex about the part of the capsule near the slab.
std::vector<Vec2> slice(const Balls& balls, const Heights& heights) {
  Vec3 a = balls.a;
  Vec3 b = balls.b;
  if (a.z() > b.z()) std::swap(a, b);
  if (b.z() + balls.radius <= heights.low || a.z() - balls.radius >= heights.high) return {};
  double radius = balls.radius;
  if (a == b) {
    const double off = std::max({heights.low - a.z(), a.z() - heights.high, 0.0});
    radius = std::sqrt(std::max(radius * radius - off * off, 0.0));
  } else if (b.z() > a.z()) {
    // Of the axis only what is no farther from the slab than the radius.
    const Vec3 along = (b - a) / (b.z() - a.z());
    const double low = std::max(a.z(), heights.low - radius);
    const double high = std::min(b.z(), heights.high + radius);
    b = a + (high - a.z()) * along;
    a = a + (low - a.z()) * along;
  }
  if (!(radius > 0)) return {};
  std::vector<Vec2> seen;
  for (const Vec2& corner : disc(radius, kSides)) {
    for (const Vec3& end : {a, b}) seen.emplace_back(end.head<2>() + corner);
  }
  return hull(std::move(seen));
}

bool stands_upright(const math::Pose& X) { return X.linear().col(2).head<2>().norm() <= kUpright; }

Heights heights_of(const geometry::Shape& shape, const math::Pose& X_WB) {
  const Eigen::AlignedBox3d box = geometry::extent_of({shape.solid, X_WB * shape.X_BS});
  return {box.min().z(), box.max().z()};
}

}  // namespace

std::vector<std::vector<Vec2>> plan_view(const geometry::Shape& shape, const math::Pose& X_WB,
                                         const Heights& heights) {
  const Heights inner{heights.low + kTouching, heights.high - kTouching};
  const Heights own = heights_of(shape, X_WB);
  if (own.high <= inner.low || own.low >= inner.high) return {};
  const math::Pose X = X_WB * shape.X_BS;
  std::vector<Vec2> seen;
  const auto* prism = std::get_if<geometry::Prism>(&shape.solid);
  if (prism != nullptr && stands_upright(X)) {
    for (const Eigen::Vector2d& p : prism->polygon) {
      seen.emplace_back((X * Vec3(p.x(), p.y(), 0)).head<2>());
    }
  } else if (const auto balls = balls_of(shape.solid, X)) {
    seen = slice(*balls, inner);
  } else {
    Corners all(X);
    std::visit(all, shape.solid);
    seen = slice(all.corners, inner);
  }
  if (seen.size() < 3) return {};
  return {std::move(seen)};
}

Heights heights_of(const std::vector<geometry::Shape>& shapes, const math::Pose& X_WB) {
  Heights all{HUGE_VAL, -HUGE_VAL};
  for (const geometry::Shape& shape : shapes) {
    const Heights each = heights_of(shape, X_WB);
    all.low = std::min(all.low, each.low);
    all.high = std::max(all.high, each.high);
  }
  return all;
}

namespace {

/// Calls `add` with points and the radii of balls about them, whose hull holds the shapes.
template <typename Add>
void for_each_ball(const std::vector<geometry::Shape>& shapes, const math::Pose& X_WB,
                   const Add& add) {
  for (const geometry::Shape& shape : shapes) {
    const math::Pose X = X_WB * shape.X_BS;
    if (const auto balls = balls_of(shape.solid, X)) {
      add(balls->a, balls->radius);
      add(balls->b, balls->radius);
      continue;
    }
    Corners all(X);
    std::visit(all, shape.solid);
    for (const Vec3& corner : all.corners) add(corner, 0);
  }
}

}  // namespace

double reach_about(const Vec2& axis, const std::vector<geometry::Shape>& shapes,
                   const math::Pose& X_WB) {
  double reach = 0;
  for_each_ball(shapes, X_WB, [&](const Vec3& p, double radius) {
    reach = std::max(reach, (p.head<2>() - axis).norm() + radius);
  });
  return reach;
}

Heights extent_along(const Vec2& direction, const std::vector<geometry::Shape>& shapes,
                     const math::Pose& X_WB) {
  Heights extent{HUGE_VAL, -HUGE_VAL};
  for_each_ball(shapes, X_WB, [&](const Vec3& p, double radius) {
    const double along = direction.dot(p.head<2>());
    extent.low = std::min(extent.low, along - radius);
    extent.high = std::max(extent.high, along + radius);
  });
  return extent;
}

}  // namespace rubicon::travel
