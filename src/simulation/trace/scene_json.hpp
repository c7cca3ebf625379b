#pragma once

#include <memory>
#include <vector>

#include "src/motion/geometry/shape.hpp"
#include "src/motion/robot/robot_model.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::trace {

/// The meshes of a scene, each written once, numbered in order of first mention.
class MeshTable {
 public:
  int number_of(const std::shared_ptr<const geometry::TriangleMesh>& mesh);
  /// An array of {"vertices": flat metres, "triangles": flat indices, "closed"}.
  void write(JsonBuilder& json) const;

 private:
  std::vector<std::shared_ptr<const geometry::TriangleMesh>> meshes_;
};

/// An array of shapes (metres, in the frame of their body): {"type", its numbers, "pose"}; a mesh
/// names its file and its number in `meshes`.
void write_shapes(JsonBuilder& json, const std::vector<geometry::Shape>& shapes, MeshTable& meshes);

/// The member "deviation": m and degrees.
void write_deviation(JsonBuilder& json, const robot::LineDeviation& deviation);

/// What a robot file says of its machine: "bodies" with frames and shapes, "parameters", "rules"
/// and the rest, as members of the open object.
void write_robot_model(JsonBuilder& json, const robot::RobotModel& model, MeshTable& meshes);

}  // namespace rubicon::trace
