#include <fmt/format.h>

#include <string_view>

#include "interpreter/check/check_plan_charts.hpp"
#include "interpreter/check/check_plan_explore.hpp"
#include "interpreter/check/check_plan_networks.hpp"
#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

/// What an item says about the form of its plan.
struct FormMark {
  enum class Form { either, brief, full };
  Form form = Form::either;
  const char* what = "";
  Span span;
};

FormMark mark_of(const syntax::PlanItem& item) {
  using Form = FormMark::Form;
  if (const auto* robot = std::get_if<syntax::RobotUse>(&item)) {
    return robot->name ? FormMark{Form::full, "a robot with a name", robot->name->span}
                       : FormMark{Form::brief, "a robot without a name", robot->file.span};
  }
  if (const auto* start = std::get_if<syntax::StartItem>(&item)) {
    return {Form::brief, "start", start->span};
  }
  if (const auto* goal = std::get_if<syntax::GoalItem>(&item)) {
    return {Form::brief, "goal", goal->span};
  }
  if (const auto* via = std::get_if<syntax::ViaItem>(&item)) return {Form::brief, "via", via->span};
  if (const auto* guide = std::get_if<syntax::GuideItem>(&item)) {
    return {Form::brief, "the guide of a motion", guide->span};
  }
  if (const auto* clause = std::get_if<syntax::MotionClause>(&item)) {
    return {Form::brief, "a clause of a motion", clause->span};
  }
  if (const auto* carry = std::get_if<syntax::CarryItem>(&item)) {
    return {Form::brief, "carry", carry->span};
  }
  if (const auto* within = std::get_if<syntax::WithinItem>(&item)) {
    return {Form::brief, "within", within->span};
  }
  if (const auto* task = std::get_if<syntax::TaskItem>(&item)) {
    return {Form::full, "a task", task->name.span};
  }
  if (const auto* crew = std::get_if<syntax::CrewItem>(&item)) {
    return {Form::full, "a crew", crew->name.span};
  }
  if (const auto* pool = std::get_if<syntax::PoolItem>(&item)) {
    return {Form::full, "a pool", pool->name.span};
  }
  if (const auto* network = std::get_if<syntax::NetworkItem>(&item)) {
    return {Form::full, "a network", network->name.span};
  }
  if (const auto* area = std::get_if<syntax::AreaItem>(&item)) {
    return {Form::full, "an area", area->name.span};
  }
  if (const auto* earth = std::get_if<syntax::EarthItem>(&item)) {
    return {Form::full, "an earth", earth->name.span};
  }
  if (const auto* fleet = std::get_if<syntax::FleetItem>(&item)) {
    return {Form::full, "a fleet", fleet->name.span};
  }
  if (const auto* overhead = std::get_if<syntax::OverheadItem>(&item)) {
    return {Form::full, "overhead", overhead->span};
  }
  if (const auto* module = std::get_if<syntax::ModuleItem>(&item)) {
    for (const auto& inner : module->items) {
      if (const auto* task = std::get_if<syntax::TaskItem>(&inner)) {
        return {Form::full, "a task", task->name.span};
      }
    }
  }
  return {};
}

void report_mixture(Subject& subject, const FormMark& brief, const FormMark& full) {
  const bool brief_first = brief.span.begin < full.span.begin;
  const FormMark& first = brief_first ? brief : full;
  const FormMark& second = brief_first ? full : brief;
  const auto form_text = [](const FormMark& mark) {
    return mark.form == FormMark::Form::brief ? "short" : "full";
  };
  Diagnostic diagnostic;
  diagnostic.code = "P03";
  diagnostic.span = second.span;
  diagnostic.message =
      fmt::format("{} belongs to the {} form of a plan, but {} to the {} form; a plan has one form",
                  second.what, form_text(second), first.what, form_text(first));
  diagnostic.notes.push_back({first.span, fmt::format("{} stands here", first.what)});
  diagnostic.hint =
      "short form: robot \"FILE\"; start, via, goal, carry, within; full form: robot NAME "
      "\"FILE\", crew, task";
  subject.diagnostics.add(std::move(diagnostic));
}

}  // namespace

void check_form(Subject& subject) {
  std::optional<FormMark> brief, full;
  const syntax::RobotUse* nameless = nullptr;
  const syntax::GoalItem* goal = nullptr;
  for (const syntax::PlanItem& item : subject.plan.items) {
    const FormMark mark = mark_of(item);
    if (mark.form == FormMark::Form::brief && !brief) brief = mark;
    if (mark.form == FormMark::Form::full && !full) full = mark;
    if (const auto* robot = std::get_if<syntax::RobotUse>(&item); robot && !robot->name) {
      if (nameless != nullptr) {
        subject.error("P04", robot->file.span, "the short form of a plan has one robot",
                      "for several give them names: robot NAME \"FILE\"; and write tasks");
      } else {
        nameless = robot;
      }
    }
    if (const auto* given = std::get_if<syntax::GoalItem>(&item)) {
      if (goal != nullptr) {
        subject.error("P04", given->span, "the short form of a plan has one goal",
                      "waypoints before it are written with via");
      } else {
        goal = given;
      }
    }
  }
  if (brief && full) {
    report_mixture(subject, *brief, *full);
    return;
  }
  subject.model.short_form = brief.has_value();
  if (subject.plan.broken) return;
  if (brief && nameless == nullptr) {
    subject.error("P04", brief->span,
                  fmt::format("{} needs a robot: write robot \"FILE\";", brief->what));
  }
  if (brief && goal == nullptr) {
    subject.error("P04", brief->span,
                  "this plan has no goal: write goal PARAMETER VALUE, ...; or goal at FRAME;");
  }
  bool has_work = brief.has_value();
  for (const syntax::PlanItem& item : subject.plan.items) {
    has_work = has_work || std::holds_alternative<syntax::TaskItem>(item) ||
               std::holds_alternative<syntax::PlaceItem>(item) ||
               std::holds_alternative<syntax::ImportItem>(item);
    const auto* network = std::get_if<syntax::NetworkItem>(&item);
    has_work = has_work || (network != nullptr &&
                            (is_of_cells(*network) || charts_policy(*network) != nullptr ||
                             explore_policy(*network) != nullptr));
  }
  if (!has_work) {
    subject.diagnostics.warning(
        "P15", subject.plan.name.span,
        fmt::format("plan '{}' has no task and no goal: nothing will be done",
                    subject.plan.name.text));
  }
}

}  // namespace rubicon::interpreter::plan_check
