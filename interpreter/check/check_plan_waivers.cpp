#include <fmt/format.h>

#include <utility>

#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

/// A component of the scope, a robot, or the site; nothing after reporting that there is none.
std::optional<ThingRef> find_thing(Subject& subject, const Scope& scope,
                                   const syntax::QualifiedName& name) {
  using Kind = ThingRef::Kind;
  const std::string& text = name.name.text;
  const bool is_component =
      name.body || subject.components.contains(text) ||
      (scope.module != nullptr && scope.module->component_index.contains(text));
  if (!is_component) {
    const auto robot = subject.robots.find(text);
    if (robot != subject.robots.end()) return ThingRef{Kind::robot, robot->second};
    if (text == "site") return ThingRef{Kind::site, -1};
    subject.unknown(name.span, "component or robot", text, {&subject.components, &subject.robots});
    return std::nullopt;
  }
  const std::optional<int> component = find_component(subject, scope, name);
  if (!component) return std::nullopt;
  return ThingRef{Kind::component, *component};
}

void check_waiver(Subject& subject, const Scope& scope, const syntax::WaiverItem& item,
                  bool counts) {
  const auto first = find_thing(subject, scope, item.first);
  const auto second = find_thing(subject, scope, item.second);
  if (!first || !second) return;
  // A module that is not placed has no components of its own in the plan yet.
  const bool is_same = counts ? *first == *second : item.first.text() == item.second.text();
  if (is_same) {
    subject.error("P30", item.second.span,
                  fmt::format("{} needs two different things, found '{}' twice", item.kind.text,
                              item.second.text()));
    return;
  }
  if (counts) subject.model.waivers.push_back({*first, *second, item.span});
}

void check_of_module(Subject& subject, const Scope& scope, const syntax::ModuleItem& module,
                     bool counts) {
  for (const auto& inner : module.items) {
    if (const auto* waiver = std::get_if<syntax::WaiverItem>(&inner)) {
      check_waiver(subject, scope, *waiver, counts);
    }
  }
}

}  // namespace

void check_waivers(Subject& subject) {
  for (const syntax::PlanItem& each : subject.plan.items) {
    if (const auto* item = std::get_if<syntax::WaiverItem>(&each)) {
      check_waiver(subject, Scope{}, *item, true);
    }
  }
  // Once each, so that what is wrong in a module is said where it stands and not for every place.
  const int before = subject.diagnostics.errors();
  for (const ModuleInfo& module : subject.module_infos) {
    check_of_module(subject, scope_of(module), *module.item, false);
  }
  if (subject.diagnostics.errors() != before) return;
  for (const PlaceInfo& place : subject.place_infos) {
    if (place.module < 0) continue;
    const Scope scope = scope_of(subject, place);
    check_of_module(subject, scope, *scope.module->item, true);
  }
}

}  // namespace rubicon::interpreter::plan_check
