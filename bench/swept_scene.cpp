#include "bench/swept_scene.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "src/motion/math/angles.hpp"

namespace rubicon::bench {
namespace {

/// A point on its way about an axis: centre + cos(t) a + sin(t) b, t in [0, angle].
struct Arc {
  Vec3 centre;
  Vec3 a;
  Vec3 b;

  Arc(const Vec3& start, const geometry::ScrewMotion& step) {
    const Vec3 arm = start - step.point;
    centre = step.point + arm.dot(step.axis) * step.axis;
    a = start - centre;
    b = step.axis.cross(a);
  }
};

}  // namespace

std::vector<Vec3> corners_of(const geometry::Solid& solid) {
  if (const auto* mesh = std::get_if<geometry::Mesh>(&solid)) return mesh->mesh->vertices;
  const auto* box = std::get_if<geometry::Box>(&solid);
  if (box == nullptr) throw std::invalid_argument("scenes are made of boxes and meshes");
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1) != 0 ? box->upper.x() : box->lower.x(),
                         (i & 2) != 0 ? box->upper.y() : box->lower.y(),
                         (i & 4) != 0 ? box->upper.z() : box->lower.z());
  }
  return corners;
}

Eigen::AlignedBox3d swept_bounds(const std::vector<Vec3>& points,
                                 const geometry::ScrewMotion& step) {
  const geometry::Motion motion{step};
  const Pose X_end = motion.pose(1);
  const double angle = math::radians(step.angle_deg);
  Eigen::AlignedBox3d bounds;
  for (const Vec3& p_B : points) {
    const Vec3 start = step.X0 * p_B;
    bounds.extend(start);
    bounds.extend(X_end * p_B);
    if (angle == 0) continue;
    const Arc arc(start, step);
    for (int i = 0; i < 3; ++i) {
      const double crest = std::atan2(arc.b[i], arc.a[i]);
      for (const double turn : {crest, crest - math::kPi, crest + math::kPi}) {
        if (turn < 0 || turn > angle) continue;
        const Vec3 extreme = arc.centre + std::cos(turn) * arc.a + std::sin(turn) * arc.b;
        bounds.extend(extreme);
      }
    }
  }
  return bounds;
}

double longest_way(const std::vector<Vec3>& points, const geometry::ScrewMotion& step) {
  double longest = 0;
  for (const Vec3& p_B : points) {
    const double arc = Arc(step.X0 * p_B, step).a.norm() * math::radians(step.angle_deg);
    longest = std::max(longest, std::hypot(arc, step.slide.norm()));
  }
  return longest;
}

geometry::Box centred_box(const Vec3& half) { return {-half, half}; }

}  // namespace rubicon::bench
