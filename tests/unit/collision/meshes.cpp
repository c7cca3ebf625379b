#include "tests/unit/collision/meshes.hpp"

#include <map>
#include <utility>

namespace rubicon::collision::test {
namespace {

/// Every triangle into four, edge midpoints shared.
geometry::TriangleMesh refined(const geometry::TriangleMesh& mesh) {
  geometry::TriangleMesh result;
  result.vertices = mesh.vertices;
  result.closed = mesh.closed;
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [found, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<int>(result.vertices.size()));
    if (is_new) result.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
    return found->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const int ab = middle(a, b);
    const int bc = middle(b, c);
    const int ca = middle(c, a);
    result.triangles.insert(result.triangles.end(),
                            {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return result;
}

}  // namespace

geometry::TriangleMesh extruded_mesh(const std::vector<Eigen::Vector2d>& polygon,
                                     const std::vector<std::array<int, 3>>& triangulation,
                                     double z0, double z1, int fineness) {
  geometry::TriangleMesh mesh;
  const int count = static_cast<int>(polygon.size());
  for (const double z : {z0, z1}) {
    for (const Eigen::Vector2d& corner : polygon)
      mesh.vertices.emplace_back(corner.x(), corner.y(), z);
  }
  for (const auto& [a, b, c] : triangulation) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({a + count, b + count, c + count});
  }
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    mesh.triangles.push_back({i, next, next + count});
    mesh.triangles.push_back({i, next + count, i + count});
  }
  mesh.closed = true;
  for (int i = 0; i < fineness; ++i) mesh = refined(mesh);
  return mesh;
}

geometry::TriangleMesh l_mesh(int fineness) {
  return extruded_mesh({{0, 0}, {2, 0}, {2, 0.5}, {0.5, 0.5}, {0.5, 2}, {0, 2}},
                       {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, 0, 1, fineness);
}

geometry::TriangleMesh cuboid_mesh(const Vec3& half, int fineness) {
  return extruded_mesh(
      {{-half.x(), -half.y()}, {half.x(), -half.y()}, {half.x(), half.y()}, {-half.x(), half.y()}},
      {{0, 1, 2}, {0, 2, 3}}, -half.z(), half.z(), fineness);
}

geometry::TriangleMesh hollow_cube_mesh() {
  geometry::TriangleMesh mesh = cuboid_mesh(Vec3::Constant(1));
  const geometry::TriangleMesh cavity = cuboid_mesh(Vec3::Constant(0.5));
  const int offset = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), cavity.vertices.begin(), cavity.vertices.end());
  for (const auto& [a, b, c] : cavity.triangles)
    mesh.triangles.push_back({a + offset, c + offset, b + offset});
  return mesh;
}

BodyPtr mesh_body(const geometry::TriangleMesh& mesh) {
  return prepare({{geometry::Mesh{"test.stl", std::make_shared<geometry::TriangleMesh>(mesh)},
                   Pose::Identity()}});
}

}  // namespace rubicon::collision::test
