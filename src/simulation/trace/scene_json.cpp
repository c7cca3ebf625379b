#include "src/simulation/trace/scene_json.hpp"

#include <algorithm>

#include "src/simulation/trace/formula_text.hpp"

namespace rubicon::trace {

namespace {

/// Writes the members of one solid; one overload a kind.
struct SolidWriter {
  JsonBuilder& json;
  MeshTable& meshes;

  void operator()(const geometry::Box& box) const {
    json.field("type", "box").key("lower").point(box.lower).key("upper").point(box.upper);
  }
  void operator()(const geometry::Cylinder& cylinder) const {
    json.field("type", "cylinder").field("radius", cylinder.radius);
    json.field("z0", cylinder.z0).field("z1", cylinder.z1);
  }
  void operator()(const geometry::Sphere& sphere) const {
    json.field("type", "sphere").key("centre").point(sphere.centre);
    json.field("radius", sphere.radius);
  }
  void operator()(const geometry::Capsule& capsule) const {
    json.field("type", "capsule").key("a").point(capsule.a).key("b").point(capsule.b);
    json.field("radius", capsule.radius);
  }
  void operator()(const geometry::Prism& prism) const {
    json.field("type", "prism").field("z0", prism.z0).field("z1", prism.z1);
    json.key("polygon").begin_array();
    for (const Eigen::Vector2d& p : prism.polygon) {
      json.begin_array().value(p.x()).value(p.y()).end_array();
    }
    json.end_array();
  }
  void operator()(const geometry::Mesh& mesh) const {
    json.field("type", "mesh").field("file", mesh.file);
    json.field("mesh", meshes.number_of(mesh.mesh));
  }
};

void write_parameter(JsonBuilder& json, const robot::RobotModel& model,
                     const robot::Parameter& parameter) {
  json.begin_object().field("name", parameter.display_name);
  json.field("body", model.bodies[static_cast<std::size_t>(parameter.body)].name);
  json.field("kind", parameter.rotation ? "rotation" : "translation");
  json.field("cyclic", parameter.cyclic);
  json.field("lower", parameter.lower).field("upper", parameter.upper);
  json.field("step", parameter.step).field("speed", parameter.speed);
  json.field("loaded_speed", parameter.loaded_speed);
  if (parameter.acceleration > 0) json.field("acceleration", parameter.acceleration);
  json.field("start", parameter.start);
  json.field("prefer", parameter.prefer);
  if (parameter.derived) {
    json.field("derived", formula_text(model, parameter.derived_value));
  } else {
    json.field("rule", formula_text(model, parameter.rule));
  }
  json.end_object();
}

}  // namespace

int MeshTable::number_of(const std::shared_ptr<const geometry::TriangleMesh>& mesh) {
  const auto found = std::find(meshes_.begin(), meshes_.end(), mesh);
  if (found != meshes_.end()) return static_cast<int>(found - meshes_.begin());
  meshes_.push_back(mesh);
  return static_cast<int>(meshes_.size()) - 1;
}

void MeshTable::write(JsonBuilder& json) const {
  json.begin_array();
  for (const auto& mesh : meshes_) {
    json.begin_object().key("vertices").begin_array();
    if (mesh) {
      for (const math::Vec3& p : mesh->vertices) json.value(p.x()).value(p.y()).value(p.z());
    }
    json.end_array().key("triangles").begin_array();
    if (mesh) {
      for (const auto& [a, b, c] : mesh->triangles) json.value(a).value(b).value(c);
    }
    json.end_array().field("closed", mesh && mesh->closed).end_object();
  }
  json.end_array();
}

void write_shapes(JsonBuilder& json, const std::vector<geometry::Shape>& shapes,
                  MeshTable& meshes) {
  json.begin_array();
  for (const geometry::Shape& shape : shapes) {
    json.begin_object();
    std::visit(SolidWriter{json, meshes}, shape.solid);
    json.key("pose").pose(shape.X_BS).end_object();
  }
  json.end_array();
}

void write_deviation(JsonBuilder& json, const robot::LineDeviation& deviation) {
  json.key("deviation").begin_object().field("position", deviation.position);
  json.field("orientation", deviation.orientation_deg).end_object();
}

void write_robot_model(JsonBuilder& json, const robot::RobotModel& model, MeshTable& meshes) {
  const auto body_name = [&](int index) {
    return model.bodies[static_cast<std::size_t>(index)].name;
  };
  json.field("time_step", model.time_step).field("sensor", model.sensor);
  json.key("bodies").begin_array();
  for (const robot::Body& body : model.bodies) {
    json.begin_object().field("name", body.name).key("parent");
    if (body.parent < 0) {
      json.null();
    } else {
      json.value(body_name(body.parent));
    }
    json.field("frame", frame_text(model, body.frame)).key("shapes");
    write_shapes(json, body.shapes, meshes);
    if (body.buffer > 0) json.field("buffer", body.buffer);
    if (body.rope) {
      json.key("rope").begin_object().field("radius", body.rope->radius);
      json.field("from", body_name(body.rope->from));
      json.key("p_from").point(body.rope->p_from).key("p_to").point(body.rope->p_to).end_object();
    }
    json.end_object();
  }
  json.end_array().key("parameters").begin_array();
  for (const robot::Parameter& parameter : model.parameters) {
    write_parameter(json, model, parameter);
  }
  json.end_array().key("tool").begin_object();
  json.field("body", body_name(model.tool_body));
  json.field("frame", frame_text(model, model.tool_frame)).end_object();
  json.key("touching").begin_array();
  for (const auto& [a, b] : model.touching) {
    json.begin_array().value(body_name(a)).value(body_name(b)).end_array();
  }
  json.end_array();
  if (!(model.deviation == robot::LineDeviation{})) write_deviation(json, model.deviation);
  json.key("capacity").begin_array();
  for (const robot::CapacityPoint& point : model.capacity) {
    json.begin_array().value(point.radius).value(point.mass).end_array();
  }
  json.end_array();
}

}  // namespace rubicon::trace
