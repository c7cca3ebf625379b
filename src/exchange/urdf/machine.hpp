#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "src/exchange/urdf/element.hpp"
#include "src/exchange/urdf/findings.hpp"

namespace rubicon::urdf {

using Triple = std::array<double, 3>;

/// Where a frame stands in another: first turned about x, y, z of the other (rad), then moved (m).
struct Origin {
  Triple xyz{};
  Triple rpy{};
};

struct Geometry {
  enum class Kind { box, cylinder, sphere, capsule, mesh };
  Kind kind = Kind::box;
  Triple size{};     ///< m: the sides of a box; radius and length of the others
  std::string mesh;  ///< its reference
  Triple scale{1, 1, 1};
  interpreter::Span span;
};

/// A piece of geometry, placed in the frame of its link.
struct Piece {
  Origin origin;
  Geometry geometry;
};

struct Link {
  std::string name;
  std::vector<Piece> pieces;  ///< of collision, else of visual
  interpreter::Span span;
};

struct Mimic {
  std::string joint;
  double multiplier = 1;
  double offset = 0;  ///< m or rad
  interpreter::Span span;
};

/// A joint in SI units and radians.
struct Joint {
  enum class Type { fixed, revolute, continuous, prismatic };
  std::string name;
  Type type = Type::fixed;
  std::size_t parent = 0;  ///< index of a link
  std::size_t child = 0;
  Origin origin;         ///< of the child's frame in the parent's, at 0
  Triple axis{1, 0, 0};  ///< in the child's frame, of length 1
  double lower = 0;
  double upper = 0;
  double speed = 0;  ///< 0: none was given
  std::optional<Mimic> mimic;
  interpreter::Span span;
};

/// A checked machine: its links are one tree.
struct Machine {
  std::string name;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::size_t root = 0;
  interpreter::Span span;
};

/// Reads what URDF says of a machine; what is not taken over is listed. Throws a Fault.
Machine read_machine(const Element& root, Findings& findings);

}  // namespace rubicon::urdf
