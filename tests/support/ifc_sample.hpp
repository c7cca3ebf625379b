#pragma once

#include <array>
#include <string>
#include <vector>

namespace rubicon::testing {

/// One wall-like block of a sample: size along x, y, z and place of its lowest corner, metres.
struct SampleBlock {
  std::string keyword = "IFCWALL";
  std::string name = "wall";  ///< as it stands in the file: escapes are the caller's
  std::array<double, 3> at{0, 0, 0};
  std::array<double, 3> size{2, 0.2, 2.5};
  int storey = 0;
};

/// An IFC file written by hand.
struct IfcSample {
  std::string schema = "IFC2X3";
  /// How blocks are shaped: "extrusion", "extrusion without positions" (IFC 4), "brep",
  /// "triangles", "polygons", "indexed curve", "mapped", "advanced" (not read), or the text of a
  /// profile such as "IFCLSHAPEPROFILEDEF(.AREA.,$,$,100.,100.,10.,$,$,$)", extruded.
  std::string shape = "extrusion";
  std::string unit = "mm";  ///< mm, m, ft
  std::vector<std::string> storeys{"Ground floor"};
  std::vector<SampleBlock> blocks{SampleBlock{}};
  std::array<double, 3> site{0, 0, 0};         ///< where the site is placed, m
  std::array<double, 3> coordinates{0, 0, 0};  ///< added to all points of brep and lists, m
  std::string more;                            ///< records behind the others
  bool owner_history = true;
};

/// The text of the file. Blocks have the GlobalIds block_id(0), block_id(1) ...
std::string ifc_text(const IfcSample& sample);

/// 22 characters, as a GlobalId has.
std::string block_id(std::size_t index);

}  // namespace rubicon::testing
