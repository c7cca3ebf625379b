#include "src/exchange/project_io/read_project.hpp"

#include <string_view>

namespace rubicon::project_io {

std::optional<Project> read_project(const interpreter::SourceMap& sources, interpreter::FileId file,
                                    interpreter::Diagnostics& diagnostics) {
  const std::string_view text = sources.file(file).text;
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const std::string_view start = begin == std::string_view::npos ? "" : text.substr(begin);
  if (start.starts_with("ERMHDR")) return read_xer(sources, file, diagnostics);
  if (start.starts_with("<")) return read_mspdi(sources, file, diagnostics);
  diagnostics.error("I02", {file, 0, 1},
                    start.empty() ? "expected a schedule, found nothing"
                                  : "expected Microsoft Project XML or a Primavera XER file",
                    "in Microsoft Project: save as XML; in Primavera P6: export as XER");
  return std::nullopt;
}

}  // namespace rubicon::project_io
