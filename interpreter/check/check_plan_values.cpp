#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_plan_parts.hpp"
#include "interpreter/check/meant_parameters.hpp"
#include "src/motion/guides/vehicle.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

using syntax::UnitKind;

/// How far a goal may be from the start of a parameter that no command can change, m or degrees.
constexpr double kUnmovedTolerance = 1e-9;

const char* use_text(ValueUse use) {
  switch (use) {
    case ValueUse::start:
      return "start";
    case ValueUse::via:
      return "via";
    case ValueUse::goal:
      return "goal";
    case ValueUse::park:
      return "park";
    case ValueUse::within:
      return "within";
    case ValueUse::near:
      return "near";
  }
  return "";
}

std::vector<std::string> display_names(const robot::RobotModel& model) {
  std::vector<std::string> names;
  for (const robot::Parameter& each : model.parameters) names.push_back(each.display_name);
  return names;
}

class ValueChecker {
 public:
  ValueChecker(Subject& subject, const RobotSpec& robot, ValueUse use)
      : subject_(subject), robot_(robot), model_(robot.robot->model), use_(use) {}

  std::optional<std::pair<int, double>> check(const syntax::NamedValue& value) {
    const std::optional<int> index = find(value.name);
    if (!index) return std::nullopt;
    const robot::Parameter& parameter = model_.parameters[static_cast<std::size_t>(*index)];
    const std::string what = fmt::format("{} of '{}'", use_text(use_), value.name.text());
    if (!check_unit(value.value, parameter.rotation ? UnitKind::angle : UnitKind::length, what,
                    subject_.diagnostics)) {
      return std::nullopt;
    }
    if (use_ == ValueUse::within) {
      const auto tolerance = bounded(subject_, value.value, value.value.unit, what, 0, kMaxLength);
      if (!tolerance) return std::nullopt;
      return std::pair{*index, *tolerance};
    }
    if (!check_range(parameter, value) || !check_movable(parameter, *index, value)) {
      return std::nullopt;
    }
    return std::pair{*index, value.value.value};
  }

  std::optional<int> find(const syntax::QualifiedName& name) {
    const int index = resolve_parameter(model_, -1, name);
    if (index >= 0) return index;
    if (index == -2) {
      subject_.error("P12", name.span,
                     fmt::format("'{}' is ambiguous: {}", name.text(),
                                 fmt::join(meant_parameters(model_, name.name.text), ", ")));
      return std::nullopt;
    }
    std::vector<std::string> names = display_names(model_);
    std::string ending = subject_.suggestions.ending(name.text(), [&] { return names; });
    if (ending.empty() && !names.empty()) {
      ending = fmt::format(" (it has {})", fmt::join(names, ", "));
    }
    subject_.error("P12", name.span,
                   fmt::format("robot '{}' has no control parameter '{}'{}", robot_.name,
                               name.text(), ending));
    return std::nullopt;
  }

 private:
  bool check_range(const robot::Parameter& parameter, const syntax::NamedValue& value) {
    const double v = value.value.value;
    if (!(std::fabs(v) <= kMaxLength)) {
      subject_.error("P13", value.value.span,
                     fmt::format("{} of '{}' is too large: {}; expected at most {}", use_text(use_),
                                 value.name.text(), v, kMaxLength));
      return false;
    }
    if (parameter.cyclic || parameter.derived) return true;
    if (v >= parameter.lower && v <= parameter.upper) return true;
    // Of a limited rotation a goal may be any turn-equivalent inside the range.
    if (use_ != ValueUse::start && parameter.rotation && robot::has_turn_equivalent(parameter, v)) {
      return true;
    }
    subject_.error(
        "P13", value.value.span,
        fmt::format("{} of '{}' is {}, outside its range ({}, {}) of robot '{}'", use_text(use_),
                    value.name.text(), v, parameter.lower, parameter.upper, robot_.name));
    return false;
  }

  bool check_movable(const robot::Parameter& parameter, int index,
                     const syntax::NamedValue& value) {
    if (use_ == ValueUse::start || parameter.free || parameter.derived) return true;
    if (robot_.start.size() <= static_cast<std::size_t>(index)) return true;
    const double start = robot_.start[static_cast<std::size_t>(index)];
    const double off = robot::reduced(parameter, value.value.value - start);
    if (std::fabs(off) <= kUnmovedTolerance) return true;
    subject_.error(
        "P14", value.name.span,
        fmt::format("no command can change '{}' of robot '{}': it stays at {} and cannot "
                    "reach {}",
                    value.name.text(), robot_.name, start, value.value.value));
    return false;
  }

  Subject& subject_;
  const RobotSpec& robot_;
  const robot::RobotModel& model_;
  ValueUse use_;
};

}  // namespace

std::vector<std::pair<int, double>> resolve_values(Subject& subject, const RobotSpec* robot,
                                                   const syntax::Values& values, ValueUse use) {
  std::vector<std::pair<int, double>> result;
  if (robot == nullptr || !robot->robot || !robot->robot->usable) return result;
  ValueChecker checker(subject, *robot, use);
  std::map<int, Span> given;
  for (const syntax::NamedValue& each : values.values) {
    const auto value = checker.check(each);
    if (!value) continue;
    const auto [place, is_new] = given.emplace(value->first, each.name.span);
    if (is_new) {
      result.push_back(*value);
    } else {
      subject.twice(each.name.span,
                    fmt::format("{} of '{}' is given twice", use_text(use), each.name.text()),
                    place->second);
    }
  }
  return result;
}

std::optional<int> find_parameter(Subject& subject, const RobotSpec& robot,
                                  const syntax::QualifiedName& name) {
  return ValueChecker(subject, robot, ValueUse::goal).find(name);
}

GoalSpec resolve_goal(Subject& subject, const RobotSpec* robot, const syntax::Goal& goal,
                      ValueUse use, const math::Pose& X_WP) {
  GoalSpec result;
  result.span = goal.span;
  const bool is_node = goal.at && goal.at->elements.size() == 1 &&
                       goal.at->elements.front().kind == syntax::FrameElement::Kind::node;
  if (is_node && robot != nullptr && robot->fleet >= 0) {
    // A vehicle drives to a node; its tool may be anywhere on it.
    result.values = guides::values_at(robot->robot->model, {robot->X_WM, robot->start},
                                      robot->start, resolve_placed_frame(subject, *goal.at, X_WP));
    for (auto& value : resolve_values(subject, robot, goal.values, use)) {
      result.values.push_back(std::move(value));
    }
    return result;
  }
  if (goal.at) result.X_WG = resolve_placed_frame(subject, *goal.at, X_WP);
  result.values = resolve_values(subject, robot, goal.values, use);
  return result;
}

void resolve_within(Subject& subject, const RobotSpec* robot, const syntax::WithinItem& item,
                    Within& within) {
  if (item.length) {
    const auto length = bounded(subject, *item.length, UnitKind::length, "within", 0, kMaxLength);
    if (!length) return;
    if (within.length >= 0) {
      subject.error("P02", item.length->span, "the length of within is given twice");
    }
    within.length = *length;
    return;
  }
  for (const auto& value : resolve_values(subject, robot, item.values, ValueUse::within)) {
    for (const auto& [index, tolerance] : within.values) {
      if (index != value.first) continue;
      subject.error(
          "P02", item.values.span,
          fmt::format(
              "within of '{}' is given twice",
              robot->robot->model.parameters[static_cast<std::size_t>(index)].display_name));
    }
    within.values.push_back(value);
  }
}

}  // namespace rubicon::interpreter::plan_check
