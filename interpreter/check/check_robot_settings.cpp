#include <fmt/format.h>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_robot_parts.hpp"

namespace rubicon::interpreter::robot_check {

namespace {

using syntax::UnitKind;

void check_time_step(Subject& subject, const syntax::SettingItem& item) {
  if (!check_unit(item.value, UnitKind::time, "time_step", subject.diagnostics)) return;
  if (item.value.value >= kMinStep && item.value.value <= kMaxDuration) {
    subject.model.time_step = item.value.value;
    return;
  }
  subject.diagnostics.error("R07", item.value.span,
                            fmt::format("time_step must be between {} s and {} s, found {}",
                                        kMinStep, kMaxDuration, item.value.value));
}

void check_sensor(Subject& subject, const syntax::SettingItem& item) {
  if (!check_unit(item.value, UnitKind::length, "sensor", subject.diagnostics)) return;
  if (item.value.value >= 0 && item.value.value <= kMaxLength) {
    subject.model.sensor = item.value.value;
    return;
  }
  subject.diagnostics.error(
      "R07", item.value.span,
      fmt::format("the range of the sensor must be between 0 and {} m, found {}", kMaxLength,
                  item.value.value));
}

/// The constants that were defined so far.
class ConstantNames : public FormulaNames {
 public:
  ConstantNames(Subject& subject, const syntax::Name& own) : subject_(subject), own_(own) {}

  std::optional<ResolvedFormula> resolve(const syntax::QualifiedName& name,
                                         Diagnostics& diagnostics) override {
    const std::string text = name.text();
    const auto found = subject_.constants.find(text);
    if (found != subject_.constants.end()) return found->second;
    const auto later = subject_.constant_spans.find(text);
    if (text == own_.text) {
      diagnostics.error("R16", name.span, fmt::format("constant '{}' uses itself", text));
    } else if (later != subject_.constant_spans.end()) {
      // One that stands before and could not be folded was reported there.
      if (later->second.begin < name.span.begin) return std::nullopt;
      Diagnostic diagnostic;
      diagnostic.code = "R16";
      diagnostic.span = name.span;
      diagnostic.message = fmt::format("constant '{}' is used before it is defined", text);
      diagnostic.notes.push_back({later->second, "defined here"});
      diagnostics.add(std::move(diagnostic));
    } else if (subject_.judges_names()) {
      diagnostics.error("R04", name.span,
                        fmt::format("'{}' is not a constant of this robot{}", text,
                                    subject_.suggestions.ending(text, [&] {
                                      std::vector<std::string> names;
                                      for (const auto& [each, span] : subject_.constant_spans) {
                                        names.push_back(each);
                                      }
                                      return names;
                                    })));
    }
    return std::nullopt;
  }

 private:
  Subject& subject_;
  const syntax::Name& own_;
};

bool is_taken_name(const std::string& name) {
  const bool suffixed = name.ends_with("_s") || name.ends_with("_c");
  return script_check::kind_of_parameter(name).has_value() ||
         (suffixed && script_check::kind_of_parameter(name.substr(0, name.size() - 2)).has_value());
}

}  // namespace

void check_settings(Subject& subject) {
  std::map<std::string, Span> given;
  for (const syntax::RobotItem& each : subject.robot.items) {
    const auto* item = std::get_if<syntax::SettingItem>(&each);
    if (item == nullptr) continue;
    const auto [place, is_new] = given.emplace(item->name.text, item->name.span);
    if (item->name.text != "time_step" && item->name.text != "sensor") {
      subject.diagnostics.error(
          "R01", item->name.span,
          fmt::format("unknown setting '{}'{}", item->name.text,
                      subject.suggestions.ending(item->name.text, [] {
                        return std::vector<std::string>{
                            "time_step", "sensor", "body",   "tool",      "const", "touching",
                            "capacity",  "rope",   "buffer", "deviation", "guide", "behaviour"};
                      })));
    } else if (!is_new) {
      subject.twice(item->name.span, fmt::format("{} is given twice", item->name.text),
                    place->second);
    } else if (item->name.text == "time_step") {
      check_time_step(subject, *item);
    } else {
      check_sensor(subject, *item);
    }
  }
}

void check_deviation(Subject& subject) {
  const syntax::MotionClause* given = nullptr;
  for (const syntax::RobotItem& each : subject.robot.items) {
    const auto* item = std::get_if<syntax::MotionClause>(&each);
    if (item == nullptr) continue;
    if (given != nullptr) {
      subject.twice(item->span, "deviation is given twice", given->span);
      continue;
    }
    given = item;
    const auto deviation = resolve_deviation(*item, "R07", subject.diagnostics);
    if (deviation) subject.model.deviation = *deviation;
  }
}

void check_constants(Subject& subject) {
  for (const syntax::RobotItem& each : subject.robot.items) {
    const auto* item = std::get_if<syntax::ConstItem>(&each);
    if (item != nullptr) subject.constant_spans.emplace(item->name.text, item->name.span);
  }
  for (const syntax::RobotItem& each : subject.robot.items) {
    const auto* item = std::get_if<syntax::ConstItem>(&each);
    if (item == nullptr) continue;
    const std::string& name = item->name.text;
    const Span first = subject.constant_spans.at(name);
    if (first.begin != item->name.span.begin) {
      subject.twice(item->name.span, fmt::format("constant '{}' is defined twice", name), first);
      continue;
    }
    if (is_taken_name(name)) {
      subject.diagnostics.error(
          "R02", item->name.span,
          fmt::format("a constant cannot be called '{}': that is the name of a control parameter, "
                      "its step or its start value",
                      name));
      continue;
    }
    if (!item->value) continue;
    ConstantNames names(subject, item->name);
    std::optional<ResolvedFormula> value =
        resolve_formula(*item->value, names, subject.diagnostics);
    if (value) subject.constants.emplace(name, *std::move(value));
  }
}

}  // namespace rubicon::interpreter::robot_check
