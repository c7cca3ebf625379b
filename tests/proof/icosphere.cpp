#include "tests/proof/icosphere.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace rubicon::collision::proof {
namespace {

geometry::TriangleMesh icosahedron() {
  const double g = 0.5 * (1 + std::sqrt(5.0));
  geometry::TriangleMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (math::Vec3& vertex : mesh.vertices) vertex.normalize();
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  mesh.closed = true;
  return mesh;
}

}  // namespace

geometry::TriangleMesh icosphere(int fineness) {
  geometry::TriangleMesh mesh = icosahedron();
  for (int i = 0; i < fineness; ++i) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [found, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
      if (is_new) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
      return found->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = middle(a, b);
      const int bc = middle(b, c);
      const int ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

const geometry::TriangleMesh& icosphere42() {
  static const geometry::TriangleMesh mesh = icosphere(1);
  return mesh;
}

double icosphere42_inner_radius() {
  static const double radius = [] {
    double least = 1;
    for (const auto& [a, b, c] : icosphere42().triangles) {
      const math::Vec3& corner = icosphere42().vertices[a];
      const math::Vec3 normal = (icosphere42().vertices[b] - corner)
                                    .cross(icosphere42().vertices[c] - corner)
                                    .normalized();
      least = std::min(least, std::fabs(normal.dot(corner)));
    }
    return least;
  }();
  return radius;
}

}  // namespace rubicon::collision::proof
