#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/exchange/ifc/ifc_model.hpp"
#include "src/exchange/ifc/step_file.hpp"

namespace rubicon::ifc {

/// A file in terms of IFC 2x3 that has the shapes of the model's elements, with their openings, and
/// nothing else. Each element stands at the origin in its own frame, so that nothing is lost of
/// coordinates far out; its number in the model is its GlobalId (see element_of). Lengths are said
/// to be metres, whatever they are: the caller scales. What IFC 4 says in other words is put into
/// those of 2x3: triangle and polygon lists, indexed curves, positions that may be left out. A
/// shape that has anything else in it is left out: its element comes without one.
struct PlainIfc {
  std::string text;
  std::size_t elements = 0;  ///< written in the text
  /// By element: what was taken off its points because they lie far out, in the units of the file.
  std::vector<math::Vec3> offsets;
};
/// `left_out`, by element: what is not wanted; empty: all are.
PlainIfc plain_ifc(const StepFile& file, const IfcModel& model,
                   const std::vector<char>& left_out = {});

/// Index in IfcModel::elements by the name that the library gives the node of an element; nothing
/// for the names of other nodes.
std::optional<std::size_t> element_of(std::string_view node_name);

}  // namespace rubicon::ifc
