#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

#include "src/motion/collision/convex/convex_pieces.hpp"
#include "src/motion/collision/mesh/closed_mesh.hpp"
#include "src/motion/collision/sweep/body.hpp"
#include "src/motion/collision/swept_query.hpp"

namespace rubicon::collision {
namespace {

/// Everything in the frame of the shapes, before it is moved to the body's centre.
struct Parts {
  std::vector<ConvexPiece> pieces;
  struct Triangles {
    std::vector<Vec3> vertices;
    std::vector<TriangleSoup::Triangle> triangles;
    bool closed = false;
  };
  std::vector<Triangles> meshes;
  Bounds bounds;
};

void require_valid_mesh(const geometry::Mesh& mesh) {
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument(fmt::format("mesh \"{}\" {}", mesh.file, what));
  };
  if (!mesh.mesh || mesh.mesh->triangles.empty()) refuse("has no triangle");
  for (const Vec3& vertex : mesh.mesh->vertices) {
    if (!vertex.allFinite()) refuse("has a vertex that is not finite");
  }
  const int count = static_cast<int>(mesh.mesh->vertices.size());
  for (const auto& triangle : mesh.mesh->triangles) {
    for (const int index : triangle) {
      if (index < 0 || index >= count) {
        refuse(fmt::format("has a triangle with vertex {}, but only {} vertices", index, count));
      }
    }
  }
}

void add(Parts& parts, const geometry::Mesh& mesh, const Placement& X) {
  require_valid_mesh(mesh);
  Parts::Triangles triangles;
  for (const Vec3& vertex : mesh.mesh->vertices) triangles.vertices.push_back(X * vertex);
  triangles.triangles = mesh.mesh->triangles;
  triangles.closed = mesh.mesh->closed;
  for (const auto& triangle : triangles.triangles) {
    for (const int index : triangle) parts.bounds.add(triangles.vertices[index]);
  }
  parts.meshes.push_back(std::move(triangles));
}

template <typename Solid>
void add(Parts& parts, const Solid& solid, const Placement& X) {
  for (ConvexPiece& piece : pieces_of(solid, X)) {
    parts.bounds.add(piece.bounds);
    parts.pieces.push_back(std::move(piece));
  }
}

/// Near the middle, on a grid of 1/1024 m: subtracting it is then exact for coordinates on a binary
/// lattice.
Vec3 rounded_centre(const Bounds& bounds) {
  const Vec3 scaled = bounds.centre() * 1024.0;
  return Vec3(std::floor(scaled.x()), std::floor(scaled.y()), std::floor(scaled.z())) / 1024.0;
}

/// The triangles of a mesh as flat pieces.
void add_triangles(const TriangleSoup& soup, std::vector<ConvexPiece>& pieces) {
  for (int i = 0; i < static_cast<int>(soup.triangles().size()); ++i) {
    const Vec3 &a = soup.corner(i, 0), &b = soup.corner(i, 1), &c = soup.corner(i, 2);
    ConvexPiece& piece = pieces.emplace_back();
    piece.vertices = {a, b, c};
    piece.normals = {(b - a).cross(c - a).normalized()};
    piece.edges = {(b - a).normalized(), (c - b).normalized(), (a - c).normalized()};
  }
}

void grow(std::vector<ConvexPiece>& pieces, double by) {
  for (ConvexPiece& piece : pieces) {
    piece.ball += by;
    piece.width += 2 * by;
    piece.update_bounds();
  }
}

}  // namespace

BodyPtr prepare(const std::vector<geometry::Shape>& shapes, double grown_by) {
  if (shapes.empty()) throw std::invalid_argument("a body needs at least one shape");
  Parts parts;
  parts.pieces.reserve(shapes.size());
  for (const geometry::Shape& shape : shapes) {
    require_rigid(shape.X_BS, "the pose of a shape");
    const Placement X(shape.X_BS);
    std::visit([&](const auto& solid) { add(parts, solid, X); }, shape.solid);
  }
  const Vec3 centre = rounded_centre(parts.bounds);
  if (!centre.allFinite()) throw std::invalid_argument("a shape is too large to be represented");
  for (ConvexPiece& piece : parts.pieces) {
    for (Vec3& vertex : piece.vertices) vertex -= centre;
    piece.update_bounds();
  }
  std::vector<TriangleSoup> soups;
  for (Parts::Triangles& mesh : parts.meshes) {
    for (Vec3& vertex : mesh.vertices) vertex -= centre;
    MeshParts split = split_mesh(mesh.vertices, mesh.triangles, mesh.closed);
    for (ConvexPiece& piece : split.convex) parts.pieces.push_back(std::move(piece));
    for (TriangleSoup& soup : split.soups) soups.push_back(std::move(soup));
  }
  if (parts.pieces.empty() && soups.empty()) {
    throw std::invalid_argument("a mesh has only triangles without area");
  }
  if (grown_by > 0) {
    for (const TriangleSoup& soup : soups) add_triangles(soup, parts.pieces);
    soups.clear();
    grow(parts.pieces, grown_by);
  }
  return std::make_shared<const Body>(std::move(parts.pieces), std::move(soups), centre);
}

}  // namespace rubicon::collision
