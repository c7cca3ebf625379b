#include <fmt/format.h>

#include <utility>

#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

/// The links of a place hold for those of its tasks that wait for none of their own module.
void add_place_links(Subject& subject, const PlaceInfo& place, const ModuleInfo& module) {
  const std::vector<LinkSpec> links = resolve_links(subject, Scope{}, place.item->after);
  const int first = place.first_task;
  const int last = first + static_cast<int>(module.tasks.size());
  for (int t = first; t < last; ++t) {
    TaskSpec& task = subject.model.tasks[static_cast<std::size_t>(t)];
    bool has_predecessor = false;
    for (const LinkSpec& link : task.after) {
      has_predecessor = has_predecessor || (link.task >= first && link.task < last);
    }
    if (!has_predecessor) task.after.insert(task.after.end(), links.begin(), links.end());
  }
}

void check_tasks_of_plan(Subject& subject) {
  for (const syntax::PlanItem& each : subject.plan.items) {
    const auto* item = std::get_if<syntax::TaskItem>(&each);
    if (item == nullptr) continue;
    TaskSpec task;
    check_task(subject, Scope{}, *item, task);
    if (subject.task_spans.at(item->name.text) != item->name.span) continue;
    const int index = subject.tasks.at(item->name.text);
    subject.model.tasks[static_cast<std::size_t>(index)] = std::move(task);
  }
}

}  // namespace

Scope scope_of(const ModuleInfo& module) {
  Scope scope;
  scope.module = &module;
  return scope;
}

Scope scope_of(const Subject& subject, const PlaceInfo& place) {
  Scope scope = scope_of(subject.module_infos[static_cast<std::size_t>(place.module)]);
  scope.first_component = place.first_component;
  scope.first_task = place.first_task;
  scope.X_WP = place.X_WP;
  return scope;
}

void check_tasks(Subject& subject) {
  check_tasks_of_plan(subject);
  // Once each, so that what is wrong in a module is said where it stands and not for every place.
  for (const ModuleInfo& module : subject.module_infos) {
    Scope scope = scope_of(module);
    scope.records_uses = module.placed;
    for (const syntax::TaskItem* item : module.tasks) {
      TaskSpec task;
      check_task(subject, scope, *item, task);
    }
  }
  if (subject.diagnostics.has_errors()) {
    for (const PlaceInfo& place : subject.place_infos) {
      resolve_links(subject, Scope{}, place.item->after);
    }
    return;
  }
  for (const PlaceInfo& place : subject.place_infos) {
    if (place.module < 0) continue;
    const ModuleInfo& module = subject.module_infos[static_cast<std::size_t>(place.module)];
    Scope scope = scope_of(subject, place);
    scope.records_uses = false;
    for (std::size_t i = 0; i < module.tasks.size(); ++i) {
      TaskSpec& task = subject.model.tasks[static_cast<std::size_t>(place.first_task) + i];
      check_task(subject, scope, *module.tasks[i], task);
      task.name = place.item->as.text + "." + task.name;
      for (TaskSpec& choice : task.choices) choice.name = task.name;
    }
    add_place_links(subject, place, module);
  }
}

}  // namespace rubicon::interpreter::plan_check
