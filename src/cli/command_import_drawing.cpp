#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "src/cli/check_import.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/input_file.hpp"
#include "src/cli/length_option.hpp"
#include "src/exchange/area_io/floor_drawing.hpp"
#include "src/exchange/building_io/names.hpp"
#include "src/exchange/files/atomic_file_io.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/results/report/diagnostic_printer.hpp"

namespace rubicon::cli {

namespace {

namespace fs = std::filesystem;

constexpr double kMostTolerance = 1;  // m
constexpr double kHighest = 1000;     // m

/// PART=LAYER of --layer; a message if it is none.
std::optional<std::string> take_layers(const std::vector<std::string>& layers,
                                       area_io::DrawingTerms& terms) {
  for (const std::string& part : area_io::parts_of_drawings()) terms.layers[part] = part;
  for (const std::string& each : layers) {
    const std::size_t equals = each.find('=');
    const std::string part = each.substr(0, equals);
    if (equals == std::string::npos || terms.layers.count(part) == 0) {
      return fmt::format(
          "--layer takes outline=NAME, shafts=NAME, columns=NAME or beams=NAME, found '{}'", each);
    }
    terms.layers[part] = each.substr(equals + 1);
  }
  return std::nullopt;
}

}  // namespace

int import_drawing(const ImportOptions& options) {
  area_io::DrawingTerms terms;
  const std::string& path = options.files.front();
  if (const auto mistake = overwriting({path}, {options.out})) return fail(*mistake);
  terms.file = building_io::clean(fs::path(path).filename().string());
  if (const auto wrong = take_layers(options.layers, terms)) return fail(*wrong);
  terms.unit = options.unit == "mm"   ? 1e-3
               : options.unit == "cm" ? 1e-2
               : options.unit == "m"  ? 1
                                      : 0;
  if (const auto wrong =
          take_length("--tolerance", options.tolerance, 1e-4, kMostTolerance, terms.tolerance)) {
    return fail(*wrong);
  }
  if (const auto wrong =
          take_length("--height", options.height, -kHighest, kHighest, terms.height)) {
    return fail(*wrong);
  }
  files::DiskFiles disk;
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  building_io::BuildingPlan plan;
  const auto text = disk.read_text(path);
  if (const auto* failure = std::get_if<interpreter::FileFailure>(&text)) {
    return fail(fmt::format("'{}': {}", path, failure->message));
  }
  const auto read = area_io::read_dxf(std::get<std::string>(text));
  if (const auto* error = std::get_if<area_io::DrawingError>(&read)) {
    diagnostics.error("I19", {},
                      error->line == 0 ? fmt::format("'{}' {}", terms.file, error->message)
                                       : fmt::format("'{}': line {}: {}", terms.file, error->line,
                                                     error->message));
  } else {
    const auto& drawing = std::get<area_io::Drawing>(read);
    area_io::AreaTerms head;
    const fs::path out = options.out.empty() ? fs::path(path) : fs::path(options.out);
    head.name = out.stem().string();
    std::vector<std::string> notes;
    const auto areas = area_io::floors_of_drawing(drawing, terms, notes, diagnostics);
    head.notes = {fmt::format("{}: {} lines read", terms.file, drawing.lines.size())};
    head.notes.insert(head.notes.end(), notes.begin(), notes.end());
    if (!areas.empty()) plan.plan = area_io::area_text(areas, head);
  }
  const std::string messages =
      report::print_text(diagnostics.sorted(), sources, files::wants_colour(stderr));
  std::fwrite(messages.data(), 1, messages.size(), stderr);
  if (diagnostics.has_errors()) return kWrongInput;
  if (refused({options.out.empty() ? "floor.plan" : options.out, &plan}, disk)) return kWrongInput;
  if (options.out.empty()) {
    std::fwrite(plan.plan.data(), 1, plan.plan.size(), stdout);
  } else if (const auto failure = files::write_file(options.out, plan.plan)) {
    return fail(*failure);
  }
  return kFine;
}

}  // namespace rubicon::cli
