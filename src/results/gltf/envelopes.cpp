#include "src/results/gltf/envelopes.hpp"

#include <algorithm>

#include "src/results/gltf/triangles.hpp"

namespace rubicon::gltf {

namespace {

using Box = Eigen::AlignedBox3d;

Box bounds_of(const std::vector<geometry::Shape>& shapes, const Pose& X_WB) {
  Box box;
  for (const Triangle& triangle : triangles_of(shapes)) {
    for (const Vec3& corner : triangle) box.extend(Vec3(X_WB * corner));
  }
  return box;
}

/// Whether one is round the other, seen from above, and at least half of its height. A hook block
/// on the end of a rope is not.
bool holds(const Box& outer, const Box& inner) {
  if (outer.isEmpty() || inner.isEmpty()) return false;
  const double common =
      std::min(outer.max().z(), inner.max().z()) - std::max(outer.min().z(), inner.min().z());
  return (outer.min().head<2>().array() < inner.min().head<2>().array()).all() &&
         (outer.max().head<2>().array() > inner.max().head<2>().array()).all() &&
         2 * common >= inner.sizes().z();
}

}  // namespace

std::vector<bool> envelopes_of(const replay::Machine& machine) {
  const robot::RobotModel& model = machine.model;
  std::vector<bool> envelopes(model.bodies.size(), false);
  if (model.touching.empty()) return envelopes;
  std::vector<Pose> X_WB;
  robot::body_poses(model, machine.mounting, replay::start_values(machine), X_WB);
  std::vector<Box> bounds;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    bounds.push_back(bounds_of(model.bodies[i].shapes, X_WB[i]));
  }
  // One shape of it must do it alone: a block and a length of rope above it are no column.
  const auto is_round = [&](std::size_t outer, std::size_t inner) {
    const auto& shapes = model.bodies[outer].shapes;
    return std::any_of(shapes.begin(), shapes.end(), [&](const geometry::Shape& shape) {
      return holds(bounds_of({shape}, X_WB[outer]), bounds[inner]);
    });
  };
  for (const auto& [first, second] : model.touching) {
    const auto a = static_cast<std::size_t>(first);
    const auto b = static_cast<std::size_t>(second);
    if (is_round(a, b)) envelopes[a] = true;
    if (is_round(b, a)) envelopes[b] = true;
  }
  return envelopes;
}

}  // namespace rubicon::gltf
