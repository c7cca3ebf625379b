#include <fmt/format.h>

#include <map>
#include <string>

#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter {

const char* name_of(SupportRules::Mode mode) {
  switch (mode) {
    case SupportRules::Mode::off:
      return "off";
    case SupportRules::Mode::warn:
      return "warn";
    case SupportRules::Mode::on:
      return "on";
  }
  return "";
}

namespace plan_check {

namespace {

using Mode = SupportRules::Mode;

/// m: what is farther below is another storey, not bedding.
constexpr double kMaxGap = 0.5;

constexpr const char* kEquilibrium = "equilibrium";

/// What a clause says, for "is given twice".
std::string clause_of(const syntax::SupportItem& item) {
  if (item.gap) return "support gap";
  if (item.mode && item.mode->text == kEquilibrium) return "support equilibrium";
  return "support";
}

void set_rules(Subject& subject) {
  SupportRules& rules = subject.model.support;
  const bool has_tasks = !subject.model.short_form && !subject.model.tasks.empty();
  rules.mode = has_tasks ? Mode::on : Mode::off;
  std::map<std::string, const syntax::SupportItem*> given;
  for (const syntax::PlanItem& each : subject.plan.items) {
    const auto* item = std::get_if<syntax::SupportItem>(&each);
    if (item == nullptr) continue;
    const std::string clause = clause_of(*item);
    const auto [first, is_new] = given.emplace(clause, item);
    if (!is_new) {
      subject.twice(item->span, clause + " is given twice", first->second->span);
      continue;
    }
    if (item->gap) {
      const auto value = bounded(subject, *item->gap, syntax::UnitKind::length, clause, 0, kMaxGap);
      if (value) rules.gap = *value;
    } else if (clause == "support equilibrium") {
      rules.equilibrium = has_tasks;
    } else if (item->mode) {
      const std::string& text = item->mode->text;
      if (text != "on" && text != "warn" && text != "off") {
        subject.error("P09", item->mode->span,
                      fmt::format("support is on, warn, off or equilibrium, found '{}'", text));
      } else if (has_tasks) {
        rules.mode = text == "on" ? Mode::on : text == "warn" ? Mode::warn : Mode::off;
      }
    }
  }
  const auto equilibrium = given.find("support equilibrium");
  if (rules.mode == Mode::off && rules.equilibrium) {
    subject.error("P09", equilibrium->second->span,
                  "support off and support equilibrium contradict each other",
                  "leave one of them out");
    rules.equilibrium = false;
  }
}

/// A component of the scope, the site or, as a brace, a crew; nothing after reporting that there is
/// none.
std::optional<ThingRef> find_holder(Subject& subject, const Scope& scope,
                                    const syntax::QualifiedName& name, bool is_brace) {
  using Kind = ThingRef::Kind;
  const std::string& text = name.name.text;
  const bool is_component =
      name.body || subject.components.contains(text) ||
      (scope.module != nullptr && scope.module->component_index.contains(text));
  if (is_component) {
    const std::optional<int> component = find_component(subject, scope, name);
    if (!component) return std::nullopt;
    return ThingRef{Kind::component, *component};
  }
  const auto crew = subject.crews.find(text);
  if (crew != subject.crews.end()) {
    if (is_brace) return ThingRef{Kind::crew, crew->second};
    subject.error(
        "P05", name.span,
        fmt::format("a component is fixed to a component or to site; '{}' is a crew", text),
        "write braced by " + text + ";");
    return std::nullopt;
  }
  if (text == "site") return ThingRef{Kind::site, -1};
  if (is_brace) {
    subject.unknown(name.span, "component or crew", text, {&subject.components, &subject.crews});
  } else {
    subject.unknown(name.span, "component", text, {&subject.components});
  }
  return std::nullopt;
}

/// The same; nothing too after reporting that it is the component itself.
std::optional<ThingRef> find_other_holder(Subject& subject, const Scope& scope,
                                          const syntax::ComponentItem& item,
                                          const syntax::QualifiedName& name, bool is_brace) {
  if (name.body || name.name.text != item.name.text) {
    return find_holder(subject, scope, name, is_brace);
  }
  subject.error("P05", name.span,
                fmt::format("component '{}' is {} itself", item.name.text,
                            is_brace ? "braced by" : "fixed to"));
  return std::nullopt;
}

/// `component` is null where a module is not placed: only names are looked up.
void resolve_holders(Subject& subject, const Scope& scope, const syntax::ComponentItem& item,
                     ComponentSpec* component) {
  for (const syntax::Fixing& fixing : item.fixed_to) {
    const auto holder = find_other_holder(subject, scope, item, fixing.to, false);
    const std::optional<int> after =
        fixing.after ? find_task(subject, scope, *fixing.after) : std::optional<int>(-1);
    if (holder && after && component != nullptr) component->fixed_to.push_back({*holder, *after});
  }
  for (const syntax::QualifiedName& name : item.braced_by) {
    const auto holder = find_other_holder(subject, scope, item, name, true);
    if (holder && component != nullptr) component->braced_by.push_back(*holder);
  }
}

}  // namespace

void check_support(Subject& subject) {
  set_rules(subject);
  for (const syntax::PlanItem& each : subject.plan.items) {
    const auto* item = std::get_if<syntax::ComponentItem>(&each);
    if (item == nullptr) continue;
    const bool is_first = subject.component_spans.at(item->name.text) == item->name.span;
    const int index = subject.components.at(item->name.text);
    resolve_holders(
        subject, Scope{}, *item,
        is_first ? &subject.model.components[static_cast<std::size_t>(index)] : nullptr);
  }
  // Once each, so that what is wrong in a module is said where it stands and not for every place.
  const int before = subject.diagnostics.errors();
  for (const ModuleInfo& module : subject.module_infos) {
    for (const syntax::ComponentItem* item : module.components) {
      resolve_holders(subject, scope_of(module), *item, nullptr);
    }
  }
  if (subject.diagnostics.errors() != before) return;
  for (const PlaceInfo& place : subject.place_infos) {
    if (place.module < 0) continue;
    const Scope scope = scope_of(subject, place);
    auto index = static_cast<std::size_t>(place.first_component);
    for (const syntax::ComponentItem* item : scope.module->components) {
      resolve_holders(subject, scope, *item, &subject.model.components[index++]);
    }
  }
}

}  // namespace plan_check

}  // namespace rubicon::interpreter
