#include "src/results/verify/input/read_shapes.hpp"

#include <fmt/format.h>

namespace rubicon::verify {

namespace {

void expect_extent(bool there, const char* kind) {
  if (!there) throw UnreadableInput(fmt::format("expected a {} with an extent", kind));
}

void read_box(const JsonFields& fields, ShapeData& shape) {
  shape.kind = ShapeData::Kind::box;
  shape.a = fields.point("lower");
  shape.b = fields.point("upper");
  expect_extent(((shape.b - shape.a).array() > 0).all(), "box");
}

void read_cylinder(const JsonFields& fields, ShapeData& shape) {
  shape.kind = ShapeData::Kind::cylinder;
  shape.radius = fields.number("radius");
  shape.z0 = fields.number("z0");
  shape.z1 = fields.number("z1");
  expect_extent(shape.radius > 0 && shape.z1 > shape.z0, "cylinder");
}

void read_ball(const JsonFields& fields, bool capsule, ShapeData& shape) {
  shape.kind = capsule ? ShapeData::Kind::capsule : ShapeData::Kind::sphere;
  shape.a = fields.point(capsule ? "a" : "centre");
  shape.b = capsule ? fields.point("b") : shape.a;
  shape.radius = fields.number("radius");
  expect_extent(shape.radius > 0, capsule ? "capsule" : "sphere");
}

void read_prism(const JsonFields& fields, ShapeData& shape) {
  shape.kind = ShapeData::Kind::prism;
  shape.z0 = fields.number("z0");
  shape.z1 = fields.number("z1");
  for (const Json& corner : fields.array("polygon")) {
    if (!corner.is_array() || corner.size() != 2) fields.fail("corners of two numbers");
    shape.polygon.emplace_back(number_of(corner[0], "a corner"), number_of(corner[1], "a corner"));
  }
  expect_extent(shape.polygon.size() >= 3 && shape.z1 > shape.z0, "prism");
}

ShapeData read_shape(const Json& object, std::size_t meshes) {
  const JsonFields fields(object, "a shape");
  ShapeData shape;
  const std::string& type = fields.text("type");
  if (type == "box") {
    read_box(fields, shape);
  } else if (type == "cylinder") {
    read_cylinder(fields, shape);
  } else if (type == "sphere" || type == "capsule") {
    read_ball(fields, type == "capsule", shape);
  } else if (type == "prism") {
    read_prism(fields, shape);
  } else if (type == "mesh") {
    shape.kind = ShapeData::Kind::mesh;
    shape.mesh = fields.integer("mesh");
    if (shape.mesh < 0 || static_cast<std::size_t>(shape.mesh) >= meshes) {
      fields.fail("the number of a mesh");
    }
  } else {
    fields.fail("a shape that is known");
  }
  shape.X_BS = fields.pose("pose");
  return shape;
}

MeshData read_mesh(const Json& object) {
  const JsonFields fields(object, "a mesh");
  MeshData mesh;
  mesh.closed = fields.truth("closed");
  const Json& numbers = fields.array("vertices");
  if (numbers.size() % 3 != 0) fields.fail("vertices of three numbers");
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    mesh.vertices.emplace_back(number_of(numbers[i], "a vertex"),
                               number_of(numbers[i + 1], "a vertex"),
                               number_of(numbers[i + 2], "a vertex"));
  }
  const Json& indices = fields.array("triangles");
  if (indices.size() % 3 != 0) fields.fail("triangles of three corners");
  const auto corner = [&](std::size_t i) {
    const double index = number_of(indices[i], "a corner");
    if (!(index >= 0 && index < static_cast<double>(mesh.vertices.size()))) {
      fields.fail("corners among the vertices");
    }
    return static_cast<int>(index);
  };
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    mesh.triangles.push_back({corner(i), corner(i + 1), corner(i + 2)});
  }
  return mesh;
}

}  // namespace

std::vector<MeshData> read_meshes(const Json& list) {
  std::vector<MeshData> meshes;
  for (const Json& object : list) meshes.push_back(read_mesh(object));
  return meshes;
}

std::vector<ShapeData> read_shapes(const Json& list, std::size_t meshes) {
  if (!list.is_array()) throw UnreadableInput("expected a list of shapes");
  std::vector<ShapeData> shapes;
  for (const Json& object : list) shapes.push_back(read_shape(object, meshes));
  return shapes;
}

}  // namespace rubicon::verify
