#include "tests/proof/mesh_models.hpp"

#include "tests/proof/icosphere.hpp"
#include "tests/unit/collision/meshes.hpp"

namespace rubicon::collision::proof {

MeshModel mesh_model(std::string name, geometry::TriangleMesh mesh, double inner_radius) {
  MeshModel model;
  model.name = std::move(name);
  model.pieces = pieces_of(mesh);
  model.body = test::mesh_body(mesh);
  model.fcl = fcl_mesh(mesh);
  model.mesh = std::move(mesh);
  model.inner_radius = inner_radius;
  return model;
}

const std::vector<MeshModel>& fine_models() {
  static const std::vector<MeshModel> models = [] {
    Random random(CaseEngine(1, "fine models", 0));
    std::vector<MeshModel> result;
    // A ball of radius 0.6 has room between corners that are at least 0.75 away.
    result.push_back(mesh_model("lumpy ball", lumpy_ball(random, 3, 0.75, 1), 0.6));
    result.push_back(mesh_model("L", test::l_mesh(3)));
    result.push_back(mesh_model("ground", open_ground(random, 22, 0.15, 0.3)));
    result.push_back(mesh_model("hollow cube", test::hollow_cube_mesh()));
    return result;
  }();
  return models;
}

const std::vector<MeshModel>& coarse_models() {
  static const std::vector<MeshModel> models = [] {
    Random random(CaseEngine(1, "coarse models", 0));
    std::vector<MeshModel> result;
    result.push_back(mesh_model("lumpy ball", scaled(lumpy_ball(random, 2, 0.75, 1), 0.5), 0.25));
    result.push_back(mesh_model("L", scaled(test::l_mesh(1), 0.5)));
    result.push_back(mesh_model("ground", open_ground(random, 8, 0.2, 0.2)));
    result.push_back(mesh_model("hollow cube", scaled(test::hollow_cube_mesh(), 0.5)));
    return result;
  }();
  return models;
}

geometry::TriangleMesh lumpy_ball(Random& random, int fineness, double least, double greatest) {
  geometry::TriangleMesh mesh = icosphere(fineness);
  for (Vec3& vertex : mesh.vertices) vertex *= random.between(least, greatest);
  return mesh;
}

geometry::TriangleMesh open_ground(Random& random, int cells, double cell, double height) {
  geometry::TriangleMesh mesh;
  const int side = cells + 1;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      mesh.vertices.emplace_back((column - 0.5 * cells) * cell, (row - 0.5 * cells) * cell,
                                 random.between(0, height));
    }
  }
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const int corner = row * side + column;
      mesh.triangles.push_back({corner, corner + 1, corner + side + 1});
      mesh.triangles.push_back({corner, corner + side + 1, corner + side});
    }
  }
  return mesh;
}

geometry::TriangleMesh scaled(geometry::TriangleMesh mesh, double factor) {
  for (Vec3& vertex : mesh.vertices) vertex *= factor;
  return mesh;
}

}  // namespace rubicon::collision::proof
