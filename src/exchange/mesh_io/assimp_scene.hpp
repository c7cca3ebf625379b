#pragma once

#include <assimp/IOSystem.hpp>
#include <memory>
#include <string>

#include "src/exchange/mesh_io/mesh_format.hpp"
#include "src/exchange/mesh_io/scene_wire.hpp"

namespace rubicon::mesh_io {

/// How a file is to be understood.
struct AssimpQuery {
  std::string name;  ///< what `files` calls the mesh; its extension is that of `format`
  MeshFormat format;
  /// The numbers as they are written, whatever up axis the file declares.
  bool ignore_declared_up = false;
  /// Without the transform of the root, by which an importer turns and scales all it has read.
  bool ignore_root = false;
  SceneLimits limits;
};

/// Parses a mesh file with assimp: triangles of all nodes, world transforms applied. Runs in the
/// helper program alone: damaged files make assimp crash, hang and swell. The failure is for
/// people.
SceneMessage read_with_assimp(const AssimpQuery& query, std::unique_ptr<Assimp::IOSystem> files);

/// The failure for a file with more triangles than the limit.
std::string too_many_triangles(const SceneLimits& limits);
/// The same for nodes.
std::string too_many_nodes(const SceneLimits& limits);

}  // namespace rubicon::mesh_io
