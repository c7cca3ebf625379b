#include "src/results/gltf/meshes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "src/results/gltf/triangles.hpp"

namespace rubicon::gltf {

namespace {

using geometry::Shape;

/// Writes the numbers of a solid; a mesh of the header is known by its place in memory.
class NumberWriter {
 public:
  explicit NumberWriter(std::string& text) : text_(text) {}

  void operator()(const geometry::Box& box) { add("box", box.lower, box.upper); }
  void operator()(const geometry::Cylinder& cylinder) {
    add("cylinder", cylinder.radius, cylinder.z0, cylinder.z1);
  }
  void operator()(const geometry::Sphere& sphere) { add("sphere", sphere.centre, sphere.radius); }
  void operator()(const geometry::Capsule& capsule) {
    add("capsule", capsule.a, capsule.b, capsule.radius);
  }
  void operator()(const geometry::Prism& prism) {
    add("prism", prism.z0, prism.z1, prism.polygon.size());
    for (const Eigen::Vector2d& corner : prism.polygon) add("", corner.x(), corner.y());
  }
  void operator()(const geometry::Mesh& mesh) {
    add("mesh", static_cast<const void*>(mesh.mesh.get()));
  }

 private:
  template <typename... Values>
  void add(const char* kind, const Values&... values) {
    text_ += kind;
    (add_value(values), ...);
  }
  void add_value(const Vec3& value) {
    for (const double each : value) add_value(each);
  }
  template <typename Number>
  void add_value(Number value) {
    text_ += fmt::format("{} ", value);
  }

  std::string& text_;
};

/// All numbers of some shapes: equal for equal shapes.
std::string numbers_of(const std::vector<Shape>& shapes) {
  std::string text;
  for (const Shape& shape : shapes) {
    std::visit(NumberWriter(text), shape.solid);
    for (int i = 0; i < 12; ++i) text += fmt::format("{} ", shape.X_BS.matrix()(i / 4, i % 4));
  }
  return text;
}

/// The middle of what is far from its origin, else nothing to move by.
Vec3 offset_of(const std::vector<Triangle>& triangles) {
  Eigen::AlignedBox3d box;
  for (const Triangle& triangle : triangles) {
    for (const Vec3& corner : triangle) box.extend(corner);
  }
  const Vec3 middle = box.center();
  if (middle.cwiseAbs().maxCoeff() < kFar) return Vec3::Zero();
  return {std::floor(middle.x()), std::floor(middle.y()), std::floor(middle.z())};
}

}  // namespace

const std::optional<Meshes::Corners>& Meshes::corners_of(const std::vector<Shape>& shapes) {
  const auto [place, added] = corners_.try_emplace(numbers_of(shapes));
  if (!added) return place->second;
  const std::vector<Triangle> triangles = triangles_of(shapes);
  if (triangles.empty()) return place->second;
  triangles_ += triangles.size();
  if (triangles_ > kMostTriangles) {
    throw std::invalid_argument("expected fewer shapes: their triangles fill no film");
  }
  Corners corners;
  corners.offset = offset_of(triangles);
  std::vector<Vec3> positions, normals;
  for (const Triangle& triangle : triangles) {
    const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
    for (const Vec3& corner : triangle) {
      positions.push_back(corner - corners.offset);
      normals.push_back(normal);
    }
  }
  corners.positions = data_.add_corners(positions, true);
  corners.normals = data_.add_corners(normals, false);
  place->second = corners;
  return place->second;
}

std::optional<MeshUse> Meshes::use(const std::vector<Shape>& shapes, const Look& look) {
  const std::optional<Corners>& corners = corners_of(shapes);
  if (!corners) return std::nullopt;
  const auto [material, new_look] =
      materials_.try_emplace(look.name, static_cast<int>(material_list_.size()));
  if (new_look) {
    const auto& [red, green, blue] = look.colour;
    Json entry = {{"name", look.name},
                  {"pbrMetallicRoughness",
                   {{"baseColorFactor", {red, green, blue, look.opacity}},
                    {"metallicFactor", 0.0},
                    {"roughnessFactor", 0.9}}},
                  {"doubleSided", true}};
    if (look.opacity < 1) entry["alphaMode"] = "BLEND";
    material_list_.push_back(std::move(entry));
  }
  const auto [mesh, new_mesh] = meshes_.try_emplace({corners->positions, material->second},
                                                    static_cast<int>(mesh_list_.size()));
  if (new_mesh) {
    const Json attributes = {{"POSITION", corners->positions}, {"NORMAL", corners->normals}};
    mesh_list_.push_back({{"primitives", Json::array({{{"attributes", attributes},
                                                       {"material", material->second}}})}});
  }
  return MeshUse{mesh->second, corners->offset};
}

void Meshes::finish(Json& document) {
  if (mesh_list_.empty()) return;
  document["materials"] = std::move(material_list_);
  document["meshes"] = std::move(mesh_list_);
}

}  // namespace rubicon::gltf
