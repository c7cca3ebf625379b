#include "src/cli/load_runnable_plan.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <utility>

#include "src/exchange/files/plan_files_io.hpp"
#include "src/motion/ompl_bridge/ompl_library_io.hpp"
#include "src/results/report/diagnostic_printer.hpp"
#include "src/simulation/site/beginning.hpp"
#include "src/simulation/taskplan/preflight_errors.hpp"

namespace rubicon::cli {

namespace {

/// The warning that a plan has no task and no goal.
constexpr std::string_view kNothingToDo = "P15";

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

void find_ompl(const std::vector<guides::GuideSpec>& guides, interpreter::Span span,
               interpreter::Diagnostics& diagnostics) {
  for (const guides::GuideSpec& guide : guides) {
    if (guide.kind != guides::GuideKind::ompl || ompl_bridge::ompl_library() != nullptr) continue;
    diagnostics.error("G09", span,
                      fmt::format("guide '{}' is a planner of OMPL, and {}", guide.name,
                                  ompl_bridge::ompl_fault()),
                      ompl_bridge::kGetOmpl);
  }
}

/// Planners of OMPL need it to be there.
void find_ompl(const interpreter::PlanModel& plan, interpreter::Diagnostics& diagnostics) {
  find_ompl(plan.guides, {}, diagnostics);
  for (const interpreter::TaskSpec& task : plan.tasks) {
    find_ompl(task.guides, task.span, diagnostics);
  }
}

}  // namespace

ReadPlan read_runnable_plan(const std::string& plan, interpreter::FileProvider& files,
                            interpreter::SourceMap& sources,
                            const interpreter::ParameterTexts& set) {
  ReadPlan result;
  interpreter::Diagnostics diagnostics;
  result.plan = load_plan(plan, sources, files, diagnostics, set);
  if (result.plan) {
    for (auto& mistake : taskplan::preflight_errors(*result.plan)) {
      diagnostics.add(std::move(mistake));
    }
  }
  if (result.plan) find_ompl(*result.plan, diagnostics);
  if (result.plan && !diagnostics.has_errors()) look_at_beginning(*result.plan, diagnostics);
  if (diagnostics.has_errors()) result.plan.reset();
  result.found = diagnostics.sorted();
  return result;
}

std::unique_ptr<interpreter::PlanModel> load_runnable_plan(const std::string& path,
                                                           interpreter::SourceMap& sources,
                                                           const interpreter::ParameterTexts& set,
                                                           bool without_tasks,
                                                           std::set<std::string>* inputs) {
  files::PlanFiles disk(path);
  ReadPlan read;
  const auto text = disk.read_text(disk.plan());
  if (const auto* failure = std::get_if<interpreter::FileFailure>(&text)) {
    interpreter::Diagnostics diagnostics;
    diagnostics.error("F01", {}, fmt::format("'{}': {}", path, failure->message));
    read.found = diagnostics.sorted();
  } else {
    read = read_runnable_plan(disk.plan(), disk, sources, set);
  }
  if (inputs != nullptr) *inputs = disk.read();
  if (without_tasks) {
    std::erase_if(read.found,
                  [](const interpreter::Diagnostic& each) { return each.code == kNothingToDo; });
  }
  if (!read.found.empty()) {
    const std::string messages =
        report::print_text(read.found, disk.typed(sources), files::wants_colour(stderr));
    std::fwrite(messages.data(), 1, messages.size(), stderr);
  }
  return std::move(read.plan);
}

}  // namespace rubicon::cli
