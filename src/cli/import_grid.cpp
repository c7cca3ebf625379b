#include "src/cli/import_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "interpreter/syntax/token.hpp"
#include "src/cli/check_import.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/input_file.hpp"
#include "src/exchange/files/atomic_file_io.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/fleets/grid/solve_grid.hpp"

namespace rubicon::cli {

namespace {

/// A name that a plan may have, of the name of a file.
std::string plan_name(const std::string& path) {
  std::string name = std::filesystem::path(path).stem().string();
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 || static_cast<unsigned char>(c) > 127) {
      c = '_';
    }
  }
  if (name.empty() || std::isalpha(static_cast<unsigned char>(name.front())) == 0) {
    name = "map_" + name;
  }
  if (interpreter::is_reserved(name)) name += "_";
  return name;
}

/// A file as the plan names it: from the folder of the plan.
std::string named_from(const std::string& file, const std::string& plan) {
  std::error_code error;
  // The plan is not there yet: of a name alone weakly_canonical would make no absolute path.
  const auto place = [&](const std::string& name) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(name, error), error);
  };
  const auto folder = place(plan).parent_path();
  const auto path = place(file);
  if (error) return file;
  return path.lexically_relative(folder).generic_string();
}

bool can_be_quoted(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) >= ' ' && c != '"' && c != '\\';
  });
}

}  // namespace

bool is_grid_file(const std::string& path) {
  return path.ends_with(".map") || path.ends_with(".scen");
}

int import_grid(const ImportOptions& options) {
  std::string map, scenario;
  for (const std::string& file : options.files) {
    std::string& place = file.ends_with(".map") ? map : scenario;
    if (!is_grid_file(file) || !place.empty()) {
      return fail("expected one map (.map) and one scenario (.scen) at most");
    }
    place = file;
  }
  if (map.empty()) return fail("a scenario (.scen) goes with its map: FILE.map FILE.scen");
  if (const auto mistake = overwriting({map, scenario}, {options.out})) return fail(*mistake);
  const std::string out = options.out.empty() ? "grid.plan" : options.out;
  building_io::BuildingPlan plan;
  plan.plan = fmt::format("plan {} {{\n  network floor {{\n    policy grid {{ expansions {}; }}\n",
                          plan_name(scenario.empty() ? map : scenario), grid::kUsualExpansions);
  for (const auto& [key, file] : {std::pair("map", map), std::pair("scenario", scenario)}) {
    if (file.empty()) continue;
    const std::string name = named_from(file, out);
    if (!can_be_quoted(name)) {
      return fail(fmt::format("a plan cannot name the file '{}'; rename it", file));
    }
    plan.plan += fmt::format("    {} \"{}\";\n", key, name);
  }
  plan.plan += "  }\n}\n";
  files::DiskFiles disk;
  if (refused({out, &plan}, disk)) return kWrongInput;
  if (options.out.empty()) {
    std::fwrite(plan.plan.data(), 1, plan.plan.size(), stdout);
  } else if (const auto failure = files::write_file(options.out, plan.plan)) {
    return fail(*failure);
  }
  return kFine;
}

}  // namespace rubicon::cli
