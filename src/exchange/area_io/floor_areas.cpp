#include "src/exchange/area_io/floor_areas.hpp"

#include <fmt/format.h>

#include "interpreter/parse/parse.hpp"
#include "src/exchange/building_io/component_text.hpp"
#include "src/exchange/building_io/names.hpp"
#include "src/exchange/project_io/identifiers.hpp"

namespace rubicon::area_io {

namespace {

using building_io::number_text;

std::string places_text(const std::vector<Place>& places) {
  std::string text;
  for (const Place& p : places) {
    if (!text.empty()) text += ", ";
    text += fmt::format("({}, {})", number_text(p.x), number_text(p.y));
  }
  return text;
}

std::string remark_of(const std::string& name) {
  return name.empty() ? std::string() : "  // " + building_io::remark_name(name);
}

std::string text_of(const ImportedArea& area, const std::string& name) {
  const coverage::FloorDescription& floor = area.floor;
  std::string text = fmt::format("\n// {:.2f} m2, {}, {}\narea {} {{\n", area.slab,
                                 building_io::counted(floor.shafts.size(), "shaft"),
                                 building_io::counted(floor.columns.size(), "column"), name);
  text += fmt::format("height {} m;\noutline {};\n", number_text(area.height),
                      places_text(floor.outline));
  for (const auto& shaft : floor.shafts) {
    text += fmt::format("shaft {};{}\n", places_text(shaft.corners), remark_of(shaft.name));
  }
  for (const auto& column : floor.columns) {
    text +=
        fmt::format("{} {}, {} m;{}\n", column.round ? "round_column" : "column",
                    places_text({column.centre}), number_text(column.size), remark_of(column.name));
  }
  for (const auto& beam : floor.beams) {
    text += fmt::format("beam {};{}\n", places_text({beam.from, beam.to}), remark_of(beam.name));
  }
  return text + "}\n";
}

}  // namespace

std::string area_text(const std::vector<ImportedArea>& areas, const AreaTerms& terms) {
  project_io::Identifiers plan_names;
  std::string text;
  for (const std::string& note : terms.notes) text += "// " + building_io::clean(note) + "\n";
  text += fmt::format("plan {} {{\n", plan_names.make(terms.name, "floor"));
  project_io::Identifiers names;
  for (const ImportedArea& area : areas) text += text_of(area, names.make(terms.name, "floor"));
  text += "}\n";
  return interpreter::format_text(text, interpreter::TextKind::plan);
}

}  // namespace rubicon::area_io
