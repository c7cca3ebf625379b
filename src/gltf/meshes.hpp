#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "src/gltf/binary_data.hpp"
#include "src/verify/scene.hpp"

namespace rubicon::gltf {

/// What things are made to look like.
enum class Material { ground, machine, waiting, carried, placed };
inline constexpr int kMaterials = 5;

/// A mesh of the document, to hang under the frame of its body.
struct MeshUse {
  int mesh = -1;               ///< number in `meshes`
  Vec3 offset = Vec3::Zero();  ///< where its origin stands in the frame (m)
};

/// The meshes of a document: equal shapes share their corners, and their mesh where they look
/// alike.
class Meshes {
 public:
  Meshes(const std::vector<verify::MeshData>& meshes, BinaryData& data)
      : source_(meshes), data_(data) {}

  /// Nothing for shapes without a surface.
  std::optional<MeshUse> use(const std::vector<verify::ShapeData>& shapes, Material material);

  /// Writes `meshes` and `materials`.
  void finish(Json& document);

 private:
  struct Corners {
    int positions = -1;
    int normals = -1;
    Vec3 offset = Vec3::Zero();
  };
  const std::optional<Corners>& corners_of(const std::vector<verify::ShapeData>& shapes);

  const std::vector<verify::MeshData>& source_;
  BinaryData& data_;
  std::size_t triangles_ = 0;                              ///< of all corners
  std::map<std::string, std::optional<Corners>> corners_;  ///< by the numbers of the shapes
  std::map<std::pair<int, Material>, int> meshes_;         ///< by positions
  std::map<Material, int> materials_;
  Json mesh_list_ = Json::array();
  Json material_list_ = Json::array();
};

}  // namespace rubicon::gltf
