#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/exchange/ifc/step_file.hpp"

namespace rubicon::ifc {

/// The IfcShapeRepresentation records of an IfcProductDefinitionShape that may be the body of a
/// thing, the best first: the one called Body, then those that do not say they are something else.
std::vector<std::uint64_t> body_representations(const StepFile& file, std::uint64_t shape);

/// The items of an IfcShapeRepresentation.
std::vector<std::uint64_t> representation_items(const StepFile& file, std::uint64_t id);

/// Whether an item may be a piece of a body: all but drawings beside it.
bool may_be_body(const StepFile& file, std::uint64_t item);

/// The classes of what a product's shape consists of that is not read, with their usual spelling,
/// each once: IfcSectionedSolid. To tell why an element has no triangles.
std::vector<std::string> unread_classes(const StepFile& file, std::uint64_t shape);

}  // namespace rubicon::ifc
