#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "src/motion/geometry/shape.hpp"
#include "src/results/gltf/binary_data.hpp"

namespace rubicon::gltf {

/// m: what is farther from its origin would lose more than 0.1 mm as floats.
inline constexpr double kFar = 1000;

/// What things are made to look like: a material of the document.
struct Look {
  std::string name;                ///< equal looks have equal names
  std::array<double, 3> colour{};  ///< linear
  double opacity = 1;              ///< less than 1: what is inside and behind is seen
};

/// A mesh of the document, to hang under the frame of its body.
struct MeshUse {
  int mesh = -1;               ///< number in `meshes`
  Vec3 offset = Vec3::Zero();  ///< where its origin stands in the frame (m)
};

/// The meshes of a document: equal shapes share their corners, and their mesh where they look
/// alike.
class Meshes {
 public:
  explicit Meshes(BinaryData& data) : data_(data) {}

  /// Nothing for shapes without a surface.
  std::optional<MeshUse> use(const std::vector<geometry::Shape>& shapes, const Look& look);

  /// Writes `meshes` and `materials`.
  void finish(Json& document);

 private:
  struct Corners {
    int positions = -1;
    int normals = -1;
    Vec3 offset = Vec3::Zero();
  };
  const std::optional<Corners>& corners_of(const std::vector<geometry::Shape>& shapes);

  BinaryData& data_;
  std::size_t triangles_ = 0;                              ///< of all corners
  std::map<std::string, std::optional<Corners>> corners_;  ///< by the numbers of the shapes
  std::map<std::pair<int, int>, int> meshes_;              ///< by positions and material
  std::map<std::string, int> materials_;                   ///< by name
  Json mesh_list_ = Json::array();
  Json material_list_ = Json::array();
};

}  // namespace rubicon::gltf
