#pragma once

#include <memory>
#include <optional>
#include <string>

#include "src/motion/geometry/shape.hpp"

namespace rubicon::building_io {

using geometry::Vec3;

/// Where an element stands and how large it is. Its own frame {O}: origin in the middle of the
/// lower side of its box, z up, x along its longer side.
struct ElementFrame {
  Vec3 origin = Vec3::Zero();  ///< m, in the coordinates of the model
  double turn_deg = 0;         ///< of {O} about z, (-90, 90]
  Vec3 size = Vec3::Zero();    ///< m, along the axes of {O}: x and y about its origin, z upwards
  double volume = 0;           ///< m3; 0: its surface is not closed
};

/// A thing of a building model.
struct Element {
  std::string component;  ///< its name in the plan, unique
  std::string model;      ///< the file, as the plan names it
  std::string unit;       ///< of a file that declares none, as the plan says it: mm, cm, m
  char up = 0;            ///< 'y', 'z'; 0: as the file declares
  std::string part;       ///< of the file, as the plan names it; empty: the whole file
  /// The mesh in its own frame, where the plan cannot name it in the file.
  std::optional<geometry::TriangleMesh> mesh;
  std::string mesh_file;  ///< where the plan has that mesh, empty: it names the model
  std::string storey;     ///< name of the storey (of the node above it in glTF and Collada)
  std::string type;       ///< IfcWall; empty where the format knows no types
  std::string name;       ///< as the model has it
  std::string guid;       ///< GlobalId, of IFC
  ElementFrame frame;
  /// The mesh in the coordinates of the model, where the terms asked to keep it.
  std::shared_ptr<const geometry::TriangleMesh> world;
};

}  // namespace rubicon::building_io
