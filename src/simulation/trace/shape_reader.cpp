#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "src/simulation/trace/shape_reader_simdjson.hpp"

namespace rubicon::trace {

namespace {

constexpr std::size_t kCorners = 3;

/// Numbers of a long list, without a place for each.
template <typename T, typename Take>
std::size_t each_number(const JsonObject& object, std::string_view name, const char* expected,
                        Take take) {
  std::size_t count = 0;
  const JsonValue list = object.at(name);
  for (const simdjson::dom::element element : list.list()) {
    T value{};
    if (element.get(value) != simdjson::SUCCESS) JsonValue{element, list.place}.fail(expected);
    take(count++, value);
  }
  return count;
}

std::shared_ptr<const geometry::TriangleMesh> read_mesh(const JsonObject& object) {
  auto mesh = std::make_shared<geometry::TriangleMesh>();
  const std::size_t numbers =
      each_number<double>(object, "vertices", "a number", [&](std::size_t i, double value) {
        if (i % kCorners == 0) mesh->vertices.emplace_back(math::Vec3::Zero());
        mesh->vertices.back()[static_cast<int>(i % kCorners)] = value;
      });
  if (numbers % kCorners != 0) {
    throw std::invalid_argument(fmt::format(
        "the corners of a mesh have three numbers each; {} has {}", object.what(), numbers));
  }
  const auto vertices = static_cast<std::int64_t>(mesh->vertices.size());
  const std::size_t corners = each_number<std::int64_t>(
      object, "triangles", "a whole number", [&](std::size_t i, std::int64_t corner) {
        if (corner < 0 || corner >= vertices) {
          throw std::invalid_argument(
              fmt::format("a mesh has {} corners and a triangle at number {}", vertices, corner));
        }
        if (i % kCorners == 0) mesh->triangles.emplace_back();
        mesh->triangles.back()[i % kCorners] = static_cast<int>(corner);
      });
  if (corners % kCorners != 0) {
    throw std::invalid_argument(fmt::format(
        "the triangles of a mesh have three corners each; {} has {}", object.what(), corners));
  }
  mesh->closed = object.truth("closed");
  return mesh;
}

geometry::Prism read_prism(const JsonObject& object) {
  geometry::Prism prism{object.number("z0"), object.number("z1"), {}};
  object.each("polygon", [&](const JsonValue& value) {
    const std::vector<double> p = value.numbers(2);
    prism.polygon.emplace_back(p[0], p[1]);
  });
  if (prism.polygon.size() < kCorners) {
    object.at("polygon").fail("three corners or more");
  }
  return prism;
}

geometry::Mesh read_mesh_use(const JsonObject& object, const HeaderMeshes& meshes) {
  const auto number = static_cast<std::size_t>(object.whole("mesh"));
  if (number >= meshes.size()) object.at("mesh").fail("the number of a mesh of the header");
  return {object.text("file"), meshes[number]};
}

geometry::Solid read_solid(const JsonObject& object, const HeaderMeshes& meshes) {
  const std::string type = object.text("type");
  if (type == "box") return geometry::Box{object.point("lower"), object.point("upper")};
  if (type == "cylinder") {
    return geometry::Cylinder{object.number("radius"), object.number("z0"), object.number("z1")};
  }
  if (type == "sphere") return geometry::Sphere{object.point("centre"), object.number("radius")};
  if (type == "capsule") {
    return geometry::Capsule{object.point("a"), object.point("b"), object.number("radius")};
  }
  if (type == "prism") return read_prism(object);
  if (type == "mesh") return read_mesh_use(object, meshes);
  object.at("type").fail("box, cylinder, sphere, capsule, prism or mesh");
}

}  // namespace

HeaderMeshes read_meshes(const JsonObject& header) {
  HeaderMeshes meshes;
  header.each_object("meshes",
                     [&](const JsonObject& object) { meshes.push_back(read_mesh(object)); });
  return meshes;
}

std::vector<geometry::Shape> read_shapes(const JsonObject& object, std::string_view name,
                                         const HeaderMeshes& meshes) {
  std::vector<geometry::Shape> shapes;
  object.each_object(name, [&](const JsonObject& shape) {
    shapes.push_back({read_solid(shape, meshes), shape.pose("pose")});
  });
  return shapes;
}

}  // namespace rubicon::trace
