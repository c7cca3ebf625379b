#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "interpreter/parse/parse.hpp"
#include "src/exchange/area_io/floor_drawing.hpp"

/// Any bytes as a drawing: no crash, no hang, and what is made of it is a plan that parses.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rubicon;
  const auto read = area_io::read_dxf(std::string_view(reinterpret_cast<const char*>(data), size));
  const auto* drawing = std::get_if<area_io::Drawing>(&read);
  if (drawing == nullptr) return 0;
  area_io::DrawingTerms terms;
  terms.file = "deck.dxf";
  terms.unit = 1e-3;
  for (const std::string& part : area_io::parts_of_drawings()) terms.layers[part] = part;
  interpreter::Diagnostics diagnostics;
  std::vector<std::string> notes;
  const auto areas = area_io::floors_of_drawing(*drawing, terms, notes, diagnostics);
  if (areas.empty()) return 0;
  interpreter::SourceMap sources;
  interpreter::Diagnostics found;
  const auto file = sources.add("deck.plan", area_io::area_text(areas, {"deck", notes}));
  interpreter::parse_plan(sources, file, found);
  if (found.has_errors()) std::abort();
  return 0;
}
