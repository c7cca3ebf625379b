#include "src/cli/run_grid.hpp"

#include <cstdio>
#include <string>
#include <utility>

#include "interpreter/check/check_grid.hpp"
#include "interpreter/check/plan_model.hpp"
#include "src/cli/set_option.hpp"
#include "src/cli/taskless_result.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/exchange/files/plan_files_io.hpp"
#include "src/results/report/diagnostic_printer.hpp"
#include "src/results/report/grid_text.hpp"
#include "src/results/report/jobs_text.hpp"

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
  std::optional<files::ResultFolder> folder;
  files::ResultTerms terms{{"ways.json", "ways.csv"}, disk.read()};
  if (!spec->jobs.empty()) terms.names = {"jobs.json", "jobs.csv", "agents.csv"};
  if (const auto code =
          open_taskless(options, "a network with policy grid has ways", std::move(terms), folder)) {
    return code;
  }
  if (!spec->jobs.empty()) {
    const grid::JobsResult jobs = grid::do_jobs(spec->problem, spec->jobs, spec->job_query);
    TasklessResult result;
    result.table = [&] { return report::jobs_table(*spec, jobs); };
    result.csv = [&] { return report::jobs_csv(*spec, jobs); };
    result.json = [&] { return report::jobs_json(*spec, jobs); };
    result.files = {{"jobs.json", result.json},
                    {"jobs.csv", result.csv},
                    {"agents.csv", [&] { return report::job_agents_csv(*spec, jobs); }}};
    result.code = jobs.end == grid::JobsResult::End::done ? kFine : kInfeasible;
    return write_taskless(options, folder, result);
  }
  const grid::GridSolution solution = grid::solve(spec->problem, spec->query);
  TasklessResult result;
  result.table = [&] { return report::grid_table(*spec, solution); };
  result.csv = [&] { return report::grid_csv(*spec, solution); };
  result.json = [&] { return report::grid_json(*spec, solution); };
  result.files = {{"ways.json", result.json}, {"ways.csv", result.csv}};
  result.code = solution.end == grid::GridSolution::End::solved ? kFine : kInfeasible;
  return write_taskless(options, folder, result);
}

}  // namespace rubicon::cli
