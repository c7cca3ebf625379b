#include "src/exchange/building_io/elements_table.hpp"

#include <fmt/format.h>

#include "src/exchange/building_io/component_text.hpp"

namespace rubicon::building_io {

namespace {

/// A field of CSV: in quotation marks where it must be.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace

std::string elements_table(const std::vector<ElementRow>& rows, const Vec3& origin) {
  std::string text =
      "component,storey,type,name,guid,model,fate,activity,activity_hours,task,x,y,z,turn_deg,"
      "length,width,height,"
      "volume,mass\n";
  for (const ElementRow& row : rows) {
    const Element& e = *row.element;
    const Vec3 p = e.frame.origin - origin;
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}", e.component, field(e.storey),
                        field(e.type), field(e.name), field(e.guid), field(e.model), row.fate,
                        row.activity, row.hours, row.task);
    for (const double value : {p.x(), p.y(), p.z(), e.frame.turn_deg, e.frame.size.x(),
                               e.frame.size.y(), e.frame.size.z(), e.frame.volume}) {
      text += "," + number_text(value);
    }
    text += "," + field(row.mass) + "\n";
  }
  return text;
}

}  // namespace rubicon::building_io
