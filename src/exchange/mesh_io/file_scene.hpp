#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "src/motion/math/pose.hpp"

namespace rubicon::mesh_io {

/// One node of a mesh file. Nodes without triangles are kept: they give names and ancestry.
struct FileNode {
  std::string name;
  int parent = -1;                   ///< index of an earlier node; -1: none
  std::vector<math::Vec3> vertices;  ///< world coordinates of the file behind FileScene::origin, in
                                     ///< its units
  std::vector<std::array<int, 3>> triangles;
  std::string note = {};  ///< where the triangles differ from the file; empty: nowhere
};

/// A mesh file as the helper program hands it over.
struct FileScene {
  /// Metres that one unit of the numbers written in the file stands for; 0: the format has no unit.
  double declared_metres_per_unit = 0;
  /// Whether the unit above has been applied to the vertices already (DAE, IFC, glTF).
  bool in_metres = false;
  /// Whether the vertices have Y up by the declaration of the format or the file.
  bool y_up = false;
  /// Files beside the mesh that were asked for, there or not: its own content does not say all
  /// then. As the file names them; not trusted.
  std::vector<std::string> files_beside;
  /// Vertices count from here: far from the origin of the file the difference keeps its digits.
  math::Vec3 origin = math::Vec3::Zero();
  std::vector<FileNode> nodes;
};

/// What a file may hold at most. A larger one is refused whatever it contains: these bound what a
/// hostile file can make the caller allocate, and are far beyond what a swept test is used with.
struct SceneLimits {
  std::uint64_t triangles = 2'000'000;
  std::uint64_t nodes = 200'000;
};

}  // namespace rubicon::mesh_io
