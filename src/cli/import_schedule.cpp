#include "src/cli/import_schedule.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <utility>
#include <variant>

#include "src/cli/levelling_delay.hpp"
#include "src/exchange/project_io/decode_text.hpp"
#include "src/exchange/project_io/read_project.hpp"

namespace rubicon::cli {

std::optional<project_io::Project> read_schedule(const std::string& path,
                                                 interpreter::FileProvider& disk,
                                                 interpreter::SourceMap& sources,
                                                 interpreter::Diagnostics& diagnostics) {
  const auto bytes = disk.read_text(path);
  if (const auto* failure = std::get_if<interpreter::FileFailure>(&bytes)) {
    diagnostics.error("F01", {}, fmt::format("'{}': {}", path, failure->message));
    return std::nullopt;
  }
  project_io::DecodedText text = project_io::decode_text(std::get<std::string>(bytes));
  const interpreter::FileId file = sources.add(path, std::move(text.text));
  if (text.guessed) {
    diagnostics.warning("I03", {file, 0, 0}, "this text is not UTF-8: it is read as Windows-1252",
                        "check names with accents");
  }
  return project_io::read_project(sources, file, diagnostics);
}

void tell_levelling(const project_io::Project& project) {
  if (const auto delay = levelling_delay(project)) {
    fmt::print(stderr, "rubicon: note: {}\n", delay_text(*delay));
  }
}

}  // namespace rubicon::cli
