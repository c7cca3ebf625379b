#pragma once

#include <memory>
#include <vector>

#include "tests/proof/fcl_voice.hpp"
#include "tests/proof/mesh_truth.hpp"

namespace rubicon::collision::proof {

/// A mesh as all parties see it.
struct MeshModel {
  std::string name;
  geometry::TriangleMesh mesh;
  Pieces pieces;
  BodyPtr body;
  FclGeometry fcl;
  double inner_radius = 0;  ///< m, of a ball about the origin inside it, where known
};

MeshModel mesh_model(std::string name, geometry::TriangleMesh mesh, double inner_radius = 0);

/// About a thousand triangles each: a lumpy ball, an L, open ground, a cube with a cavity.
const std::vector<MeshModel>& fine_models();
/// The same kinds with some hundred triangles.
const std::vector<MeshModel>& coarse_models();

/// A closed lumpy ball: each corner of a sphere of radius 1 m drawn in or out.
geometry::TriangleMesh lumpy_ball(Random& random, int fineness, double least, double greatest);
/// Open ground about the origin, `cells` squares of `cell` m each way, with heights to `height` m.
geometry::TriangleMesh open_ground(Random& random, int cells, double cell, double height);
geometry::TriangleMesh scaled(geometry::TriangleMesh mesh, double factor);

}  // namespace rubicon::collision::proof
