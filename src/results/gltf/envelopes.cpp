#include "src/results/gltf/envelopes.hpp"

#include <algorithm>

#include "src/results/gltf/triangles.hpp"
#include "src/results/verify/input/mechanism.hpp"
#include "src/results/verify/replay/step_rules.hpp"

namespace rubicon::gltf {

namespace {

using Box = Eigen::AlignedBox3d;

Box bounds_of(const std::vector<verify::ShapeData>& shapes,
              const std::vector<verify::MeshData>& meshes, const Pose& X_WB) {
  Box box;
  for (const Triangle& triangle : triangles_of(shapes, meshes)) {
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

std::vector<bool> envelopes_of(const verify::SceneRobot& robot,
                               const std::vector<verify::MeshData>& meshes) {
  std::vector<bool> envelopes(robot.bodies.size(), false);
  if (robot.touching.empty()) return envelopes;
  const verify::Mechanism mechanism(robot);
  const std::vector<double> q = verify::start_values(robot);
  std::vector<Pose> X_WB;
  std::vector<Box> bounds;
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    X_WB.push_back(mechanism.pose(static_cast<int>(i), q));
    bounds.push_back(bounds_of(robot.bodies[i].shapes, meshes, X_WB[i]));
  }
  // One shape of it must do it alone: a block and a length of rope above it are no column.
  const auto is_round = [&](std::size_t outer, std::size_t inner) {
    const auto& shapes = robot.bodies[outer].shapes;
    return std::any_of(shapes.begin(), shapes.end(), [&](const verify::ShapeData& shape) {
      return holds(bounds_of({shape}, meshes, X_WB[outer]), bounds[inner]);
    });
  };
  for (const auto& [first, second] : robot.touching) {
    const auto a = static_cast<std::size_t>(first);
    const auto b = static_cast<std::size_t>(second);
    if (is_round(a, b)) envelopes[a] = true;
    if (is_round(b, a)) envelopes[b] = true;
  }
  return envelopes;
}

}  // namespace rubicon::gltf
