#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "interpreter/check/check_plan_obstacles.hpp"
#include "interpreter/check/check_plan_parts.hpp"
#include "interpreter/expand/imports.hpp"
#include "interpreter/parse/parse.hpp"

namespace rubicon::interpreter {

namespace {

/// Every situation that the plan or one of its tasks switches on, each once.
std::vector<std::string> all_situations(const syntax::Plan& plan) {
  std::vector<std::string> names;
  const auto add = [&](const syntax::SituationItem& item) {
    for (const syntax::Name& name : item.names) names.push_back(name.text);
  };
  const auto add_task = [&](const syntax::TaskItem& task) {
    for (const syntax::TaskPart& part : task.parts) {
      if (const auto* item = std::get_if<syntax::SituationItem>(&part)) add(*item);
    }
  };
  for (const syntax::PlanItem& each : plan.items) {
    if (const auto* item = std::get_if<syntax::SituationItem>(&each)) {
      add(*item);
    } else if (const auto* task = std::get_if<syntax::TaskItem>(&each)) {
      add_task(*task);
    } else if (const auto* module = std::get_if<syntax::ModuleItem>(&each)) {
      for (const auto& inner : module->items) {
        if (const auto* inner_task = std::get_if<syntax::TaskItem>(&inner)) add_task(*inner_task);
      }
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace

std::unique_ptr<PlanModel> load_plan(const std::string& path, SourceMap& sources,
                                     FileProvider& files, Diagnostics& diagnostics,
                                     const ParameterTexts& set) {
  const std::size_t said_before = diagnostics.all().size();
  const int errors_before = diagnostics.errors();
  std::variant<std::string, FileFailure> text = files.read_text(path);
  if (const auto* failure = std::get_if<FileFailure>(&text)) {
    diagnostics.error("F01", {}, fmt::format("'{}': {}", path, failure->message));
    return nullptr;
  }
  const FileId file = sources.add(path, std::get<std::string>(std::move(text)));
  syntax::Plan plan = parse_plan(sources, file, diagnostics);
  ImportFiles imports{files, {path}};
  expand_plan(plan, set, sources, diagnostics, imports);

  auto model = std::make_unique<PlanModel>();
  model->name = plan.name.text;
  model->path = path;
  model->set = set;
  plan_check::NodePlaces names(model->networks);
  ShapeResolver shapes(path, files, names, diagnostics);
  plan_check::Subject subject{plan, *model, sources, files, diagnostics, shapes, names};
  plan_check::check_form(subject);
  plan_check::check_networks(subject);
  plan_check::declare_names(subject);
  plan_check::check_settings(subject);
  plan_check::check_calendars(subject);
  plan_check::check_robots(subject, all_situations(plan));
  plan_check::check_crews(subject);
  plan_check::check_pools(subject);
  plan_check::check_fleets(subject);
  plan_check::check_guides(subject);
  plan_check::check_components(subject);
  plan_check::check_movings(subject);
  plan_check::check_areas(subject);
  plan_check::check_earths(subject);
  plan_check::check_tasks(subject);
  plan_check::finish_hauls(subject);
  plan_check::finish_earths(subject);
  plan_check::check_workspaces(subject);
  plan_check::finish_covers(subject);
  plan_check::check_scale(subject);
  plan_check::check_short_form(subject);
  plan_check::check_waivers(subject);
  plan_check::check_support(subject);
  plan_check::check_whole(subject);
  if (diagnostics.errors() == errors_before) plan_check::check_cycles(subject);
  if (diagnostics.errors() == errors_before) plan_check::check_same_as(subject);
  if (diagnostics.errors() == errors_before) plan_check::check_masses(subject);
  diagnostics.name_copies(said_before, sources);
  if (diagnostics.errors() != errors_before || plan.broken) return nullptr;
  number_draws(*model);
  return model;
}

}  // namespace rubicon::interpreter
