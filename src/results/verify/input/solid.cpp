#include "src/results/verify/input/solid.hpp"

#include <utility>

#include "src/results/verify/input/mesh_parts.hpp"
#include "src/results/verify/input/polygon_parts.hpp"

namespace rubicon::verify {

namespace {

/// Triangles of a mesh under which a point is looked for in other meshes.
constexpr std::size_t kInnerPoints = 512;

void add_mesh(const MeshData& mesh, const Pose& X_BS, Solid& solid) {
  MeshParts parts = parts_of(mesh);
  for (Convex& piece : parts.solids) {
    solid.pieces.push_back(placed(std::move(piece), X_BS));
    solid.inner_points.push_back({solid.pieces.back().centre(), solid.pieces.back().width});
  }
  for (Convex& piece : parts.triangles) solid.pieces.push_back(placed(std::move(piece), X_BS));
  if (parts.closed_rest.empty()) return;
  for (Vec3& vertex : parts.vertices) vertex = X_BS * vertex;
  ClosedSurface surface(std::move(parts.vertices), std::move(parts.closed_rest));
  for (const InnerPoint& p : surface.inner_points(kInnerPoints)) solid.inner_points.push_back(p);
  solid.surfaces.push_back(std::move(surface));
}

void add_shape(const ShapeData& shape, const std::vector<MeshData>& meshes, Solid& solid) {
  const auto add = [&](Convex piece) {
    solid.pieces.push_back(placed(std::move(piece), shape.X_BS));
    solid.inner_points.push_back({solid.pieces.back().centre(), solid.pieces.back().width});
  };
  switch (shape.kind) {
    case ShapeData::Kind::box:
      return add(box_piece(shape.a, shape.b));
    case ShapeData::Kind::cylinder:
      return add(cylinder_piece(shape.radius, shape.z0, shape.z1));
    case ShapeData::Kind::sphere:
    case ShapeData::Kind::capsule:
      return add(capsule_piece(shape.a, shape.b, shape.radius));
    case ShapeData::Kind::prism:
      for (const Polygon& part : convex_parts(shape.polygon)) {
        add(prism_piece(part, shape.z0, shape.z1));
      }
      return;
    case ShapeData::Kind::mesh:
      return add_mesh(meshes[static_cast<std::size_t>(shape.mesh)], shape.X_BS, solid);
  }
}

/// Fills in what follows from the pieces.
void measure(Solid& solid) {
  std::vector<Bounds> boxes;
  for (const Convex& piece : solid.pieces) {
    boxes.push_back(bounds_of(piece));
    solid.bounds.add(boxes.back());
  }
  solid.tree = BoxTree(boxes);
  solid.centre = solid.bounds.centre();
  solid.radius = (solid.bounds.upper - solid.centre).norm();
}

}  // namespace

std::shared_ptr<const Solid> make_solid(const std::vector<ShapeData>& shapes,
                                        const std::vector<MeshData>& meshes) {
  auto solid = std::make_shared<Solid>();
  for (const ShapeData& shape : shapes) add_shape(shape, meshes, *solid);
  if (solid->pieces.empty()) return nullptr;
  measure(*solid);
  return solid;
}

std::shared_ptr<const Solid> grown(const Solid& solid, double by) {
  auto larger = std::make_shared<Solid>();
  for (Convex piece : solid.pieces) {
    piece.ball += by;
    piece.width += 2 * by;
    // Round now: its own directions no longer tell how deep it is.
    piece.normals.clear();
    piece.edges.clear();
    larger->pieces.push_back(std::move(piece));
    larger->inner_points.push_back({larger->pieces.back().centre(), larger->pieces.back().width});
  }
  measure(*larger);
  return larger;
}

std::shared_ptr<const Solid> make_capsule(const Vec3& a, const Vec3& b, double radius) {
  auto solid = std::make_shared<Solid>();
  solid->pieces.push_back(capsule_piece(a, b, radius));
  solid->inner_points.push_back({solid->pieces.back().centre(), solid->pieces.back().width});
  measure(*solid);
  return solid;
}

}  // namespace rubicon::verify
