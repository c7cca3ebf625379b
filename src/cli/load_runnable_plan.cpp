#include "src/cli/load_runnable_plan.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "src/exchange/files/plan_files_io.hpp"
#include "src/results/report/diagnostic_printer.hpp"
#include "src/simulation/site/beginning.hpp"
#include "src/simulation/taskplan/preflight_errors.hpp"

namespace rubicon::cli {

namespace {

/// What is in each other at the beginning, into the plan, and what is to be said of it.
void look_at_beginning(interpreter::PlanModel& plan, interpreter::Diagnostics& diagnostics) {
  const site::Beginning beginning = site::look_at_beginning(plan);
  plan.overlaps.emplace();
  for (const site::BeginningOverlap& each : beginning.overlaps) {
    plan.overlaps->push_back(each.pair);
  }
  plan.floating.emplace();
  for (const auto& [component, why] : beginning.floating) plan.floating->push_back(component);
  for (auto& each : site::warnings_of(plan, beginning)) diagnostics.add(std::move(each));
}

}  // namespace

std::unique_ptr<interpreter::PlanModel> load_runnable_plan(const std::string& path,
                                                           interpreter::SourceMap& sources,
                                                           const interpreter::ParameterTexts& set) {
  files::PlanFiles disk(path);
  interpreter::Diagnostics diagnostics;
  std::unique_ptr<interpreter::PlanModel> plan;
  const auto text = disk.read_text(disk.plan());
  if (const auto* failure = std::get_if<interpreter::FileFailure>(&text)) {
    diagnostics.error("F01", {}, fmt::format("'{}': {}", path, failure->message));
  } else {
    plan = load_plan(disk.plan(), sources, disk, diagnostics, set);
  }
  if (plan) {
    for (auto& mistake : taskplan::preflight_errors(*plan)) diagnostics.add(std::move(mistake));
  }
  if (plan && !diagnostics.has_errors()) look_at_beginning(*plan, diagnostics);
  const auto found = diagnostics.sorted();
  if (!found.empty()) {
    const std::string messages =
        report::print_text(found, disk.typed(sources), files::wants_colour(stderr));
    std::fwrite(messages.data(), 1, messages.size(), stderr);
  }
  if (diagnostics.has_errors()) plan.reset();
  return plan;
}

}  // namespace rubicon::cli
