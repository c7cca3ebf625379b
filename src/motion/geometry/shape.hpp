#pragma once

#include <array>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "src/motion/math/pose.hpp"

namespace rubicon::geometry {

using math::Pose;
using math::Vec3;

/// A triangle mesh in metres. Vertices are finite, indices in range, at least one triangle (the
/// loader guarantees it).
struct TriangleMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;
  /// It encloses a volume: every edge is used equally often in both directions (in a simple surface
  /// by two triangles, oppositely oriented), so winding numbers are defined; triangles face
  /// outwards.
  bool closed = false;
};

/// Axis-parallel box between two corners, in the frame of the shape.
struct Box {
  Vec3 lower = Vec3::Zero();
  Vec3 upper = Vec3::Zero();
};

/// Cylinder about the z axis from z0 to z1.
struct Cylinder {
  double radius = 0;
  double z0 = 0;
  double z1 = 0;
};

struct Sphere {
  Vec3 centre = Vec3::Zero();
  double radius = 0;
};

/// All points nearer than `radius` to the segment a-b.
struct Capsule {
  Vec3 a = Vec3::Zero();
  Vec3 b = Vec3::Zero();
  double radius = 0;
};

/// A simple polygon (either orientation, not necessarily convex), extruded from z0 to z1.
struct Prism {
  double z0 = 0;
  double z1 = 0;
  std::vector<Eigen::Vector2d> polygon;
};

/// A mesh read from a file; `mesh` is already in metres, z up, with unit, scale and hull applied.
struct Mesh {
  std::string file;  ///< as written in the source
  std::shared_ptr<const TriangleMesh>
      mesh;  // shared: meshes are large and immutable, instances are many
};

using Solid = std::variant<Box, Cylinder, Sphere, Capsule, Prism, Mesh>;

/// A solid, placed in the frame of its body or component (X_BS).
struct Shape {
  Solid solid;
  Pose X_BS = Pose::Identity();
};

}  // namespace rubicon::geometry
