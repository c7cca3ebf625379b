#include <cstdint>
#include <variant>

#include "src/exchange/ifc/element_bodies.hpp"
#include "src/exchange/ifc/plain_ifc.hpp"

/// Any bytes as an IFC file: bodies or none, no crash, no hang.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rubicon::ifc;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto file = StepFile::read(text);
  if (!std::holds_alternative<StepFile>(file)) return 0;
  const auto model = read_model(std::get<StepFile>(file));
  if (!std::holds_alternative<IfcModel>(model)) return 0;
  WorkBudget budget = shape_budget(std::get<StepFile>(file));
  element_bodies(std::get<StepFile>(file), std::get<IfcModel>(model), budget);
  plain_ifc(std::get<StepFile>(file), std::get<IfcModel>(model), {});
  return 0;
}
