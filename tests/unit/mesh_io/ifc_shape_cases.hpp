#pragma once

#include <string>
#include <vector>

#include "src/motion/geometry/shape.hpp"

namespace rubicon::mesh_io::testing {

/// A shape of an IFC file, and what it must be by hand.
struct ShapeCase {
  std::string name;
  std::string records;   ///< #100 is the item; below #100 see ifc_of()
  std::string openings;  ///< items of openings in the element, such as "#200,#300"
  double volume = 0;     ///< m3
  geometry::Vec3 size = geometry::Vec3::Zero();   ///< m
  geometry::Vec3 lower = geometry::Vec3::Zero();  ///< m
};

std::vector<ShapeCase> shape_cases();

/// A file with one wall of that shape at the origin, in millimetres and radians. What it offers:
/// #3 the origin, #4 a placement there, #6 #7 #8 the directions z, x, y, #10 the origin of the
/// plane, #12 a placement there.
std::string ifc_of(const std::string& records, const std::string& openings = {});

}  // namespace rubicon::mesh_io::testing
