#include "src/cli/run_network.hpp"

#include <cstdio>
#include <string>
#include <utility>
#include <variant>

#include "interpreter/check/plan_model.hpp"
#include "src/cli/set_option.hpp"
#include "src/cli/taskless_result.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/exchange/files/plan_files_io.hpp"
#include "src/results/gantt/charts_page.hpp"
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

int run_charts(const RunOptions& options, const interpreter::PlanModel& plan,
               std::optional<files::ResultFolder>& folder) {
  const interpreter::ChartsSpec& spec = *plan.charts;
  const interpreter::NetworkSpec& description =
      plan.networks[static_cast<std::size_t>(spec.network)];
  const lanes::LaneNetwork network(description.description);
  const auto course =
      charts::carry_out(network, spec.robots, spec.settings, spec.reports, spec.barriers);
  const report::ChartsResult charts{spec, description, network, std::get<charts::Course>(course)};
  TasklessResult result;
  result.table = [&] { return report::charts_table(charts); };
  result.csv = [&] { return report::charts_csv(charts); };
  result.json = [&] { return report::charts_json(charts); };
  result.files = {{"charts.json", result.json},
                  {"charts.csv", result.csv},
                  {"charts.svg", [&] { return gantt::charts_picture(charts); }},
                  {"report.html", [&] { return gantt::charts_page(charts); }}};
  if (report::outcome_of(charts.course) != report::ChartsOutcome::all_at_goals) {
    result.code = kInfeasible;
  }
  return write_taskless(options, folder, result);
}

int run_walks(const RunOptions& options, const interpreter::PlanModel& plan,
              std::optional<files::ResultFolder>& folder) {
  const interpreter::ExploreSpec& spec = *plan.explore;
  const interpreter::NetworkSpec& description =
      plan.networks[static_cast<std::size_t>(spec.network)];
  const lanes::LaneNetwork network(description.description);
  const report::WalkResult walks = report::explore(spec, description, network);
  TasklessResult result;
  result.table = [&] { return report::walk_table(walks); };
  result.csv = [&] { return report::walk_csv(walks); };
  result.json = [&] { return report::walk_json(walks); };
  result.files = {{"walk.json", result.json}, {"walk.csv", result.csv}};
  return write_taskless(options, folder, result);
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
  std::optional<files::ResultFolder> folder;
  files::ResultTerms terms{{"walk.json", "walk.csv"}, disk.read()};
  if (plan->charts) terms.names = {"charts.json", "charts.csv", "charts.svg", "report.html"};
  if (const auto code =
          open_taskless(options, "a network with this policy has none", std::move(terms), folder)) {
    return code;
  }
  return plan->charts ? run_charts(options, *plan, folder) : run_walks(options, *plan, folder);
}

}  // namespace rubicon::cli
