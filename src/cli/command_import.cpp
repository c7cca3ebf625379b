#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "src/cli/check_import.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/import_grid.hpp"
#include "src/cli/import_schedule.hpp"
#include "src/cli/input_file.hpp"
#include "src/exchange/files/atomic_file_io.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/exchange/mesh_io/mesh_format.hpp"
#include "src/exchange/project_io/decode_text.hpp"
#include "src/exchange/project_io/plan_text.hpp"
#include "src/results/report/diagnostic_printer.hpp"

namespace rubicon::cli {

namespace {

bool is_machine(const std::string& path) {
  return path.ends_with(".urdf") || path.ends_with(".xacro");
}

bool is_drawing(const std::string& path) {
  return path.ends_with(".dxf") || path.ends_with(".DXF");
}

int import_schedule(const ImportOptions& options) {
  files::DiskFiles disk;
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const std::string& path = options.files.front();
  if (const auto mistake = overwriting({path}, {options.out})) return fail(*mistake);
  const std::optional<project_io::Project> project =
      read_schedule(path, disk, sources, diagnostics);
  building_io::BuildingPlan plan;
  if (project) {
    const std::string name = std::filesystem::path(path).filename().string();
    plan.plan = project_io::plan_text(
        *project, project_io::clean_text(name), diagnostics, {},
        options.level ? project_io::Levelling::resources : project_io::Levelling::none,
        options.baseline ? project_io::Baselines::written : project_io::Baselines::left_out);
  }
  const std::string messages =
      report::print_text(diagnostics.sorted(), sources, files::wants_colour(stderr));
  std::fwrite(messages.data(), 1, messages.size(), stderr);
  if (!project) return kWrongInput;
  if (refused({options.out.empty() ? "schedule.plan" : options.out, &plan}, disk)) {
    return kWrongInput;
  }
  if (options.level) tell_levelling(*project);
  if (options.out.empty()) {
    std::fwrite(plan.plan.data(), 1, plan.plan.size(), stdout);
  } else if (const auto failure = files::write_file(options.out, plan.plan)) {
    return fail(*failure);
  }
  return kFine;
}

}  // namespace

int run_import(const ImportOptions& options) {
  std::size_t drawings = 0;
  for (const std::string& file : options.files) drawings += is_drawing(file) ? 1U : 0U;
  if (drawings > 0) {
    if (options.files.size() > 1) return fail("one drawing at a time, without other files");
    if (options.level || options.baseline || !options.match.empty() || !options.schedule.empty() ||
        !options.up.empty() || !options.packages.empty() || !options.arguments.empty() ||
        !options.tool.empty()) {
      return fail("a drawing takes --area, --layer, --unit, --tolerance, --height and --out only");
    }
    if (options.area && !options.area->empty())
      return fail("a drawing has no storeys; expected --area alone");
    return import_drawing(options);
  }
  if (!options.layers.empty() || !options.height.empty()) {
    return fail("--layer and --height go with a drawing (.dxf)");
  }
  if (!options.area && !options.tolerance.empty()) return fail("--tolerance goes with --area");
  std::size_t machines = 0;
  for (const std::string& file : options.files) machines += is_machine(file) ? 1U : 0U;
  if (machines > 0) {
    if (options.files.size() > 1) return fail("one machine at a time, without other files");
    if (options.level || options.baseline || !options.match.empty() || !options.schedule.empty() ||
        !options.unit.empty() || !options.up.empty()) {
      return fail("a machine takes --out, --package, --arg and --tool only");
    }
    return import_machine(options);
  }
  if (!options.packages.empty() || !options.arguments.empty() || !options.tool.empty()) {
    return fail("--package, --arg and --tool go with a machine (.urdf, .xacro)");
  }
  if (is_grid_file(options.files.front())) {
    if (options.level || options.baseline || !options.match.empty() || !options.schedule.empty() ||
        !options.unit.empty() || !options.up.empty()) {
      return fail("a map takes --out only");
    }
    return import_grid(options);
  }
  std::size_t models = 0;
  for (const std::string& file : options.files) models += mesh_io::format_of(file) ? 1U : 0U;
  if (options.area && models != options.files.size()) {
    return fail("--area goes with building models (.ifc) or a drawing (.dxf)");
  }
  if (models == options.files.size()) {
    if (options.area && (!options.schedule.empty() || !options.match.empty())) {
      return fail("--area makes a floor; --schedule and --match make tasks: one at a time");
    }
    if (options.area && options.area->empty()) {
      return fail("--area takes the name of a storey: --area \"01*\"");
    }
    if (options.level && options.schedule.empty()) {
      return fail("--level goes with a schedule: it lets tasks wait for their resources");
    }
    if (options.baseline && options.schedule.empty()) {
      return fail("--baseline goes with a schedule: it keeps the dates that its tasks have there");
    }
    return import_building(options);
  }
  if (models > 0)
    return fail("models and schedules cannot be mixed; a schedule goes with models by --schedule");
  if (options.files.size() > 1) return fail("one schedule at a time");
  if (!options.match.empty() || !options.schedule.empty() || !options.unit.empty() ||
      !options.up.empty()) {
    return fail("--schedule, --match, --unit and --up go with a model (.ifc, .gltf, .obj ...)");
  }
  return import_schedule(options);
}

}  // namespace rubicon::cli
