#pragma once

#include "grammar/plan.hpp"
#include "interpreter/parse/parse_script.hpp"

/// The state of a plan's parse. Only for the parse_plan*.cpp files.
namespace rubicon::interpreter {

/// The items of a plan under construction. Tasks and components go to the module they stand in.
class PlanState : public ScriptState {
 public:
  using ScriptState::ScriptState;

  template <typename Item>
  void add(Item item, const char* from) {
    item.span = span_from(from);
    plan.items.emplace_back(std::move(item));
  }
  template <typename Item>
  void add_to_module(Item item, const char* from) {
    item.span = span_from(from);
    if (in_module) {
      module.items.emplace_back(std::move(item));
    } else {
      plan.items.emplace_back(std::move(item));
    }
  }
  /// An item that may stand in a task or in the plan itself.
  template <typename Item>
  void add_to_task(Item item, const char* from) {
    item.span = span_from(from);
    if (in_task) {
      task.parts.emplace_back(std::move(item));
    } else if constexpr (std::is_constructible_v<syntax::PlanItem, Item>) {
      plan.items.emplace_back(std::move(item));
    }
  }
  syntax::Name word(const char* from) const {
    return {std::string(from, last_end), span_from(from)};
  }
  syntax::Values take_values() {
    syntax::Values result = std::exchange(values, {});
    if (!result.values.empty()) {
      result.span = result.values.front().name.span;
      result.span.end = result.values.back().value.span.end;
    }
    return result;
  }
  void set_cost(const char* from);
  /// Of the task or the component that is being read.
  void add_attribute(const char* from);

  syntax::Plan plan;
  syntax::ModuleItem module;
  bool in_module = false;
  syntax::TaskItem task;
  bool in_task = false;

  syntax::Values values;
  syntax::QualifiedName value_name;
  syntax::Goal goal;
  std::vector<syntax::Link> links;
  bool lag_is_negative = false;
  std::vector<syntax::Name> names;
  syntax::Name key;
  syntax::Name name;
  syntax::QualifiedName component_name;
  std::optional<syntax::Name> crew_of_work;
  syntax::Number duration;
  syntax::WithinItem within;
  syntax::Shift shift;
  syntax::String shift_from;
  syntax::CalendarItem calendar;
  syntax::ComponentItem component;
  syntax::RobotUse robot;
  syntax::CrewItem crew;
  bool in_crew = false;
  syntax::PlaceItem place;
  syntax::ImportItem import;
};

}  // namespace rubicon::interpreter
