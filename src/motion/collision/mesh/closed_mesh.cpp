#include "src/motion/collision/mesh/closed_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/convex/convex_pieces.hpp"

namespace rubicon::collision {
namespace {

using Triangle = TriangleSoup::Triangle;

/// A part may bulge inwards by this (m) and still be taken for its hull, which is larger: never
/// optimistic.
constexpr double kConvexSlack = 1e-7;
/// Faces with a smaller altitude (m) have no reliable plane and bound nothing that matters.
constexpr double kSliver = 1e-6;
/// Solids need this width (m) to be told from a doubled sheet.
constexpr double kThinnestSolid = 1e-6;
constexpr std::size_t kMaxCorners = 256;

double six_volumes(const std::vector<Vec3>& vertices, const std::vector<Triangle>& part) {
  const Vec3& origin = vertices[part.front()[0]];
  double sum = 0;
  for (const Triangle& triangle : part) {
    sum += (vertices[triangle[0]] - origin)
               .dot((vertices[triangle[1]] - origin).cross(vertices[triangle[2]] - origin));
  }
  return sum;
}

std::vector<Vec3> corners_of(const std::vector<Vec3>& vertices, const std::vector<Triangle>& part) {
  std::vector<int> indices;
  for (const Triangle& triangle : part)
    indices.insert(indices.end(), triangle.begin(), triangle.end());
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  std::vector<Vec3> corners;
  for (const int index : indices) corners.push_back(vertices[index]);
  return corners;
}

bool all_on_one_side(const std::vector<Vec3>& corners, const Vec3& normal, const Vec3& on_plane) {
  double least = 0;
  double greatest = 0;
  for (const Vec3& corner : corners) {
    const double height = normal.dot(corner - on_plane);
    least = std::min(least, height);
    greatest = std::max(greatest, height);
  }
  return least >= -kConvexSlack || greatest <= kConvexSlack;
}

/// Directions of the edges between faces that are not in one plane.
void add_edges(ConvexPiece& piece, const std::vector<Vec3>& vertices,
               const std::vector<Triangle>& part) {
  std::map<std::pair<int, int>, std::optional<Vec3>> first_normal;
  for (const Triangle& triangle : part) {
    const Vec3& a = vertices[triangle[0]];
    const Vec3 cross = (vertices[triangle[1]] - a).cross(vertices[triangle[2]] - a);
    const double length = cross.norm();
    const Vec3 normal = length > 0 ? Vec3(cross / length) : Vec3(Vec3::Zero());
    for (int k = 0; k < 3; ++k) {
      const int from = triangle[k];
      const int to = triangle[(k + 1) % 3];
      std::optional<Vec3>& other = first_normal[std::minmax(from, to)];
      if (!other) {
        other = normal;
        continue;
      }
      const Vec3 edge = vertices[to] - vertices[from];
      const bool flat =
          other->cross(normal).norm() < kSameDirection && length > 0 && other->dot(normal) > 0;
      if (!flat && edge.norm() > kDegenerateAltitude) add_direction(piece.edges, edge.normalized());
    }
  }
}

std::optional<ConvexPiece> convex_part(const std::vector<Vec3>& vertices,
                                       const std::vector<Triangle>& part) {
  ConvexPiece piece;
  piece.vertices = corners_of(vertices, part);
  if (piece.vertices.size() > kMaxCorners) return std::nullopt;
  for (const Triangle& triangle : part) {
    const Vec3& a = vertices[triangle[0]];
    const Vec3& b = vertices[triangle[1]];
    const Vec3& c = vertices[triangle[2]];
    if (smallest_altitude(a, b, c) < kSliver) continue;
    const Vec3 normal = (b - a).cross(c - a).normalized();
    if (!all_on_one_side(piece.vertices, normal, a)) return std::nullopt;
    add_direction(piece.normals, normal);
  }
  if (piece.normals.empty()) return std::nullopt;
  add_edges(piece, vertices, part);
  finish_polytope(piece);
  if (piece.width < kThinnestSolid) return std::nullopt;
  return piece;
}

}  // namespace

MeshParts split_mesh(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                     bool closed) {
  MeshParts result;
  std::vector<Triangle> rest;
  if (closed) {
    const std::vector<int> part_of = connected_parts(vertices.size(), triangles);
    std::vector<std::vector<Triangle>> parts;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (part_of[i] >= static_cast<int>(parts.size())) parts.emplace_back();
      parts[part_of[i]].push_back(triangles[i]);
    }
    const auto is_outward = [&](const auto& part) { return six_volumes(vertices, part) > 0; };
    const bool has_cavities = std::any_of(parts.begin(), parts.end(), is_outward) &&
                              !std::all_of(parts.begin(), parts.end(), is_outward);
    for (const std::vector<Triangle>& part : parts) {
      std::optional<ConvexPiece> piece = has_cavities ? std::nullopt : convex_part(vertices, part);
      if (piece) {
        result.convex.push_back(std::move(*piece));
      } else {
        rest.insert(rest.end(), part.begin(), part.end());
      }
    }
  } else {
    rest = triangles;
  }
  TriangleSoup soup(vertices, std::move(rest), closed);
  if (!soup.empty()) result.soups.push_back(std::move(soup));
  return result;
}

}  // namespace rubicon::collision
