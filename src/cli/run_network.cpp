#include "src/cli/run_network.hpp"

#include <cstdio>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/set_option.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/exchange/files/plan_files_io.hpp"
#include "src/exchange/files/result_folder_io.hpp"
#include "src/results/gantt/charts_picture.hpp"
#include "src/results/report/charts_text.hpp"
#include "src/results/report/diagnostic_printer.hpp"
#include "src/results/report/walk_text.hpp"

namespace rubicon::cli {

namespace {

/// The words are not in most plans: these are not loaded for them.
bool may_have_network(files::PlanFiles& disk) {
  const auto read = disk.read_text(disk.plan());
  const auto* text = std::get_if<std::string>(&read);
  if (text == nullptr || text->find("policy") == std::string::npos) return false;
  return text->find("charts") != std::string::npos || text->find("tarry") != std::string::npos ||
         text->find("fraenkel") != std::string::npos;
}

/// What a run says, and its files.
struct Written {
  std::string table, csv, json;
  std::vector<std::pair<const char*, std::string>> files;
  int code = kFine;
};

Written run_charts(const interpreter::PlanModel& plan) {
  const interpreter::ChartsSpec& spec = *plan.charts;
  const interpreter::NetworkSpec& description =
      plan.networks[static_cast<std::size_t>(spec.network)];
  const lanes::LaneNetwork network(description.description);
  const auto course =
      charts::carry_out(network, spec.robots, spec.settings, spec.reports, spec.barriers);
  const report::ChartsResult result{spec, description, network, std::get<charts::Course>(course)};
  Written written{report::charts_table(result),
                  report::charts_csv(result),
                  report::charts_json(result),
                  {},
                  kFine};
  written.files = {{"charts.json", written.json},
                   {"charts.csv", written.csv},
                   {"charts.svg", gantt::charts_picture(result)}};
  if (report::outcome_of(result.course) != report::ChartsOutcome::all_at_goals) {
    written.code = kInfeasible;
  }
  return written;
}

Written run_walks(const interpreter::PlanModel& plan) {
  const interpreter::ExploreSpec& spec = *plan.explore;
  const interpreter::NetworkSpec& description =
      plan.networks[static_cast<std::size_t>(spec.network)];
  const lanes::LaneNetwork network(description.description);
  const report::WalkResult result = report::explore(spec, description, network);
  Written written{
      report::walk_table(result), report::walk_csv(result), report::walk_json(result), {}, kFine};
  written.files = {{"walk.json", written.json}, {"walk.csv", written.csv}};
  return written;
}

}  // namespace

std::optional<int> run_network(const RunOptions& options) {
  files::PlanFiles disk(options.plan);
  if (!may_have_network(disk)) return std::nullopt;
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const auto plan =
      interpreter::load_plan(disk.plan(), sources, disk, diagnostics, parameter_texts(options.set));
  if (!plan || (!plan->charts && !plan->explore)) return std::nullopt;
  const std::string messages =
      report::print_text(diagnostics.sorted(), disk.typed(sources), files::wants_colour(stderr));
  std::fwrite(messages.data(), 1, messages.size(), stderr);
  if (!options.trace.empty() || options.compress || !options.sample.empty()) {
    return fail(
        "--trace, --compress and --sample go with tasks; a network with this policy has none: "
        "--out FOLDER or --format json");
  }
  std::optional<files::ResultFolder> folder;
  if (!options.out.empty()) {
    auto opened = files::ResultFolder::open(options.out);
    if (auto* message = std::get_if<std::string>(&opened)) return fail(*message);
    folder.emplace(std::get<files::ResultFolder>(std::move(opened)));
  }
  const Written written = plan->charts ? run_charts(*plan) : run_walks(*plan);
  if (folder) {
    for (const auto& [name, text] : written.files) {
      if (const auto failure = folder->write(name, text)) return fail(*failure);
    }
    if (const auto failure = folder->commit()) return fail(*failure);
  }
  const std::string& text = options.format == "json"  ? written.json
                            : options.format == "csv" ? written.csv
                                                      : written.table;
  std::fwrite(text.data(), 1, text.size(), stdout);
  return written.code;
}

}  // namespace rubicon::cli
