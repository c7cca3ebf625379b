#include "src/cli/run_charts.hpp"

#include <cstdio>
#include <string>
#include <variant>

#include "interpreter/check/plan_model.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/set_option.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/exchange/files/plan_files_io.hpp"
#include "src/exchange/files/result_folder_io.hpp"
#include "src/results/gantt/charts_picture.hpp"
#include "src/results/report/charts_text.hpp"
#include "src/results/report/diagnostic_printer.hpp"

namespace rubicon::cli {

namespace {

/// The word is not in most plans: they are not loaded for it.
bool may_have_charts(files::PlanFiles& disk) {
  const auto text = disk.read_text(disk.plan());
  return std::holds_alternative<std::string>(text) &&
         std::get<std::string>(text).find("charts") != std::string::npos;
}

std::optional<std::string> write_folder(files::ResultFolder& folder,
                                        const report::ChartsResult& result,
                                        const std::string& json) {
  if (auto failure = folder.write("charts.json", json)) return failure;
  if (auto failure = folder.write("charts.csv", report::charts_csv(result))) return failure;
  if (auto failure = folder.write("charts.svg", gantt::charts_picture(result))) return failure;
  return folder.commit();
}

}  // namespace

std::optional<int> run_charts(const RunOptions& options) {
  files::PlanFiles disk(options.plan);
  if (!may_have_charts(disk)) return std::nullopt;
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const auto plan = interpreter::load_plan(disk.plan(), sources, disk, diagnostics,
                                           parameter_texts(options.set));
  if (!plan || !plan->charts) return std::nullopt;
  const std::string messages =
      report::print_text(diagnostics.sorted(), disk.typed(sources), files::wants_colour(stderr));
  std::fwrite(messages.data(), 1, messages.size(), stderr);
  if (!options.trace.empty() || options.compress || !options.sample.empty()) {
    return fail(
        "--trace, --compress and --sample go with tasks; a network with policy charts has charts: "
        "--out FOLDER or --format json");
  }
  std::optional<files::ResultFolder> folder;
  if (!options.out.empty()) {
    auto opened = files::ResultFolder::open(options.out);
    if (auto* message = std::get_if<std::string>(&opened)) return fail(*message);
    folder.emplace(std::get<files::ResultFolder>(std::move(opened)));
  }
  const interpreter::ChartsSpec& spec = *plan->charts;
  const interpreter::NetworkSpec& description =
      plan->networks[static_cast<std::size_t>(spec.network)];
  const lanes::LaneNetwork network(description.description);
  const auto course = charts::carry_out(network, spec.robots, spec.settings, spec.reports);
  const report::ChartsResult result{spec, description, network, std::get<charts::Course>(course)};
  const std::string json = report::charts_json(result);
  if (folder) {
    if (const auto failure = write_folder(*folder, result, json)) return fail(*failure);
  }
  const std::string text = options.format == "json"  ? json
                           : options.format == "csv" ? report::charts_csv(result)
                                                     : report::charts_table(result);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return report::outcome_of(result.course) == report::ChartsOutcome::all_at_goals ? kFine
                                                                                  : kInfeasible;
}

}  // namespace rubicon::cli
