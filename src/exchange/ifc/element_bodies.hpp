#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/exchange/ifc/ifc_model.hpp"
#include "src/exchange/ifc/solid.hpp"
#include "src/exchange/ifc/step_file.hpp"

namespace rubicon::ifc {

/// The body of an element with its openings cut out.
struct ElementBody {
  Solid solid;  ///< metres, in the frame of the element
  /// Where it differs from the model: lower case, for people. It is larger there, never smaller.
  std::vector<std::string> notes;
};

/// By element of the model: its body; nothing where something of it cannot be read. Takes time and
/// memory in proportion to the file, whatever it says: what is left when they are used up is not
/// read.
std::vector<std::optional<ElementBody>> element_bodies(const StepFile& file, const IfcModel& model);

}  // namespace rubicon::ifc
