#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "src/exchange/ifc/step_file.hpp"
#include "src/motion/math/pose.hpp"

namespace rubicon::ifc {

/// A thing that is built: a product of the file that has a shape.
struct IfcElement {
  std::uint64_t id = 0;            ///< of its record
  std::string type;                ///< IfcWall
  std::string guid;                ///< its GlobalId
  std::string name;                ///< as the model has it, may be empty
  std::string object_type;         ///< what kind of its class, as the model has it
  std::string tag;                 ///< its number in the program that wrote the file
  std::string storey;              ///< name of the storey it is in, empty: in none
  double storey_height = 0;        ///< m, as the file says of the storey
  std::optional<math::Pose> X_WE;  ///< its placement in the world of the file, z up, translation in
                                   ///< metres; nothing if the file's cannot be followed
  std::string no_place;            ///< why there is none
  std::uint64_t shape = 0;         ///< its IfcProductDefinitionShape
  int node = -1;                   ///< in IfcModel::tree
};

/// A step of the way down from the project to an element.
struct IfcNode {
  std::string name;  ///< CLASS_NAME_GLOBALID
  int parent = -1;   ///< an earlier one, -1: none
};

/// A hole in an element, or what projects from it.
struct IfcOpening {
  std::uint64_t id = 0;
  std::uint64_t element = 0;  ///< record of what it is in
};

/// What a file says of a building, besides its geometry.
struct IfcModel {
  std::string schema;                ///< IFC2X3, IFC4 ...
  double metres_per_unit = 1;        ///< of its lengths
  std::vector<IfcElement> elements;  ///< in the order of the file
  std::vector<IfcNode> tree;         ///< parents first
  std::vector<IfcOpening> openings;
  std::vector<IfcOpening> projections;  ///< from elements with a shape: corbels, pilasters
  /// Products with a shape that are nothing built, by class: spaces, openings ...
  std::map<std::string, int> no_elements;
  /// Where its origin lies on the map (east, north, height), if it says so; it is not applied.
  std::optional<math::Vec3> map_origin;
};

/// Why there is no model: lower case, for people.
struct IfcFailure {
  std::string message;
};

/// `file` must be read from a text that the caller keeps; the model does not need it.
std::variant<IfcModel, IfcFailure> read_model(const StepFile& file);

}  // namespace rubicon::ifc
