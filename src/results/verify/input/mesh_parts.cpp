#include "src/results/verify/input/mesh_parts.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace rubicon::verify {

namespace {

/// m: how far a corner of a convex part may stand out before a face. Far below the band between
/// contact and fault.
constexpr double kDent = 1e-5;

/// m: triangles with a smaller altitude are dropped, their neighbours cover the place.
constexpr double kDegenerate = 1e-9;

constexpr double kSameFace = 1e-6;  ///< sine of the angle of two faces that are one

using Triangle = std::array<int, 3>;

class MeshCutter {
 public:
  explicit MeshCutter(const MeshData& mesh) : mesh_(mesh), part_of_(mesh.vertices.size()) {
    std::iota(part_of_.begin(), part_of_.end(), 0);
    for (const Triangle& triangle : mesh.triangles) {
      unite(triangle[0], triangle[1]);
      unite(triangle[0], triangle[2]);
    }
  }

  MeshParts cut() {
    MeshParts parts;
    std::map<int, std::vector<Triangle>> groups;
    for (const Triangle& triangle : mesh_.triangles) groups[part(triangle[0])].push_back(triangle);
    const bool solid =
        mesh_.closed && std::all_of(groups.begin(), groups.end(),
                                    [&](const auto& g) { return volume(g.second) > 0; });
    for (const auto& [root, triangles] : groups) {
      if (solid && add_solid(triangles, parts)) continue;
      for (const Triangle& triangle : triangles) add_triangle(triangle, parts);
    }
    if (!mesh_.closed) parts.closed_rest.clear();
    parts.vertices = mesh_.vertices;
    return parts;
  }

 private:
  const Vec3& vertex(int i) const { return mesh_.vertices[static_cast<std::size_t>(i)]; }

  int part(int i) {
    while (part_of_[static_cast<std::size_t>(i)] != i) {
      int& above = part_of_[static_cast<std::size_t>(i)];
      above = part_of_[static_cast<std::size_t>(above)];
      i = above;
    }
    return i;
  }
  void unite(int a, int b) { part_of_[static_cast<std::size_t>(part(a))] = part(b); }

  double volume(const std::vector<Triangle>& triangles) const {
    const Vec3 origin = vertex(triangles.front()[0]);
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
      sum += (vertex(a) - origin).dot((vertex(b) - origin).cross(vertex(c) - origin));
    }
    return sum;
  }

  void add_triangle(const Triangle& triangle, MeshParts& parts) const {
    const auto& [a, b, c] = triangle;
    parts.closed_rest.push_back(triangle);
    Convex piece = triangle_piece(vertex(a), vertex(b), vertex(c));
    if (piece.width >= kDegenerate) parts.triangles.push_back(std::move(piece));
  }

  Vec3 normal(const Triangle& triangle) const {
    const auto& [a, b, c] = triangle;
    const Vec3 n = (vertex(b) - vertex(a)).cross(vertex(c) - vertex(a));
    return n.norm() > 0 ? Vec3(n.normalized()) : Vec3(Vec3::Zero());
  }

  /// Adds the triangles as one solid if they are convex.
  bool add_solid(const std::vector<Triangle>& triangles, MeshParts& parts) const {
    std::set<int> used;
    for (const Triangle& triangle : triangles) used.insert(triangle.begin(), triangle.end());
    Convex piece;
    for (const int i : used) piece.corners.push_back(vertex(i));
    piece.width = std::numeric_limits<double>::infinity();
    std::map<std::pair<int, int>, Vec3> normal_of_edge;
    std::vector<Vec3> normals;
    for (const Triangle& triangle : triangles) {
      const Vec3 n = normal(triangle);
      if (n.isZero()) return false;
      double deepest = 0;
      for (const Vec3& corner : piece.corners) {
        const double above = n.dot(corner - vertex(triangle[0]));
        if (above > kDent) return false;
        deepest = std::max(deepest, -above);
      }
      piece.width = std::min(piece.width, deepest);
      add_direction(normals, n);
      for (std::size_t i = 0; i < 3; ++i) {
        normal_of_edge[{triangle[i], triangle[(i + 1) % 3]}] = n;
      }
    }
    std::vector<Vec3> edges;
    for (const auto& [edge, n] : normal_of_edge) {
      const auto other = normal_of_edge.find({edge.second, edge.first});
      const bool flat = other != normal_of_edge.end() && other->second.cross(n).norm() < kSameFace;
      if (!flat) add_direction(edges, (vertex(edge.second) - vertex(edge.first)).normalized());
    }
    if (normals.size() + edges.size() <= kMostDirections) {
      piece.normals = std::move(normals);
      piece.edges = std::move(edges);
    }
    parts.solids.push_back(std::move(piece));
    return true;
  }

  static void add_direction(std::vector<Vec3>& list, const Vec3& n) {
    if (list.size() > kMostDirections) return;
    const bool known = std::any_of(list.begin(), list.end(), [&](const Vec3& each) {
      return each.cross(n).norm() < kSameFace;
    });
    if (!known) list.push_back(n);
  }

  const MeshData& mesh_;
  std::vector<int> part_of_;
};

}  // namespace

MeshParts parts_of(const MeshData& mesh) { return MeshCutter(mesh).cut(); }

}  // namespace rubicon::verify
