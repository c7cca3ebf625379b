#include "src/motion/collision/convex/separating_axes.hpp"

namespace rubicon::collision {
namespace {

/// Cross products of unit vectors shorter than this have no direction left; any longer one is a
/// valid, if noisy, axis.
constexpr double kNoDirection = 1e-12;

bool free_along_cross(const SweptPair& pair, const Vec3& a, const Vec3& b) {
  const Vec3 axis = a.cross(b);
  const double length = axis.norm();
  return length > kNoDirection && pair.free_along(axis / length);
}

Vec3 displacement_direction(const SweptPair& pair) {
  if (pair.standing) return Vec3::Zero();
  const Vec3 centre = pair.moving.bounds.centre();
  const Vec3 displacement = pair.end * centre - pair.start * centre;
  const double length = displacement.norm();
  return length > 0 ? Vec3(displacement / length) : Vec3::Zero();
}

bool free_along_normals(const SweptPair& pair) {
  for (const Vec3& normal : pair.fixed.normals) {
    if (pair.free_along(normal)) return true;
  }
  for (const Vec3& normal : pair.moving.normals) {
    if (pair.free_along(pair.middle.R * normal)) return true;
  }
  return false;
}

}  // namespace

std::size_t separating_axis_count(const SweptPair& pair) {
  const std::size_t moving = pair.moving.edges.size();
  const std::size_t fixed = pair.fixed.edges.size();
  return pair.moving.normals.size() + pair.fixed.normals.size() + moving * fixed + moving + fixed;
}

bool separating_axis_exists(const SweptPair& pair) {
  if (free_along_normals(pair)) return true;
  const Vec3 displacement = displacement_direction(pair);
  for (const Vec3& fixed_edge : pair.fixed.edges) {
    if (free_along_cross(pair, displacement, fixed_edge)) return true;
  }
  for (const Vec3& edge : pair.moving.edges) {
    const Vec3 moving_edge = pair.middle.R * edge;
    if (free_along_cross(pair, displacement, moving_edge)) return true;
    for (const Vec3& fixed_edge : pair.fixed.edges) {
      if (free_along_cross(pair, moving_edge, fixed_edge)) return true;
    }
  }
  return false;
}

bool contact_axis_exists(const SweptPair& pair) {
  if (free_along_normals(pair)) return true;
  const Vec3 moving_axis = pair.middle.R * pair.moving.disc_axis;
  const Vec3& fixed_axis = pair.fixed.disc_axis;
  if (pair.moving.disc > 0) {
    for (const Vec3& edge : pair.fixed.edges) {
      if (free_along_cross(pair, moving_axis, edge)) return true;
    }
  }
  if (pair.fixed.disc > 0) {
    for (const Vec3& edge : pair.moving.edges) {
      if (free_along_cross(pair, fixed_axis, pair.middle.R * edge)) return true;
    }
  }
  return pair.moving.disc > 0 && pair.fixed.disc > 0 &&
         free_along_cross(pair, moving_axis, fixed_axis);
}

}  // namespace rubicon::collision
