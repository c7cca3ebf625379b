#include "src/cli/run_grid.hpp"

#include <cstdio>
#include <string>
#include <variant>

#include "interpreter/check/check_grid.hpp"
#include "interpreter/check/plan_model.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/set_option.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/exchange/files/plan_files_io.hpp"
#include "src/exchange/files/result_folder_io.hpp"
#include "src/results/report/diagnostic_printer.hpp"
#include "src/results/report/grid_text.hpp"

namespace rubicon::cli {

std::optional<int> run_grid(const RunOptions& options) {
  files::PlanFiles disk(options.plan);
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const auto spec = interpreter::load_grid(disk.plan(), sources, disk, diagnostics);
  if (!spec) return std::nullopt;
  interpreter::SourceMap plan_sources;
  interpreter::Diagnostics found;
  const auto plan =
      interpreter::load_plan(disk.plan(), plan_sources, disk, found, parameter_texts(options.set));
  if (!plan) return std::nullopt;
  const std::string messages =
      report::print_text(found.sorted(), disk.typed(plan_sources), files::wants_colour(stderr));
  std::fwrite(messages.data(), 1, messages.size(), stderr);
  if (!options.trace.empty() || options.compress || !options.sample.empty()) {
    return fail(
        "--trace, --compress and --sample go with tasks; a network with policy grid has ways: "
        "--out FOLDER or --format json");
  }
  std::optional<files::ResultFolder> folder;
  if (!options.out.empty()) {
    auto opened = files::ResultFolder::open(options.out);
    if (auto* message = std::get_if<std::string>(&opened)) return fail(*message);
    folder.emplace(std::get<files::ResultFolder>(std::move(opened)));
  }
  const grid::GridSolution solution = grid::solve(spec->problem, spec->query);
  const std::string json = report::grid_json(*spec, solution);
  if (folder) {
    if (const auto failure = folder->write("ways.json", json)) return fail(*failure);
    if (const auto failure = folder->write("ways.csv", report::grid_csv(*spec, solution))) {
      return fail(*failure);
    }
    if (const auto failure = folder->commit()) return fail(*failure);
  }
  const std::string text = options.format == "json"  ? json
                           : options.format == "csv" ? report::grid_csv(*spec, solution)
                                                     : report::grid_table(*spec, solution);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return solution.end == grid::GridSolution::End::solved ? kFine : kInfeasible;
}

}  // namespace rubicon::cli
