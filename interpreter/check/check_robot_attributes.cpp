#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_robot_parts.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::interpreter::robot_check {

namespace {

using syntax::Attribute;
using syntax::UnitKind;

struct AttributeForm {
  const char* name;
  std::size_t numbers;
};
constexpr AttributeForm kForms[] = {{"range", 2},  {"cyclic", 0}, {"step", 1},  {"speed", 1},
                                    {"loaded", 1}, {"accel", 1},  {"start", 1}, {"prefer", 1}};

/// The attributes of one parameter, each at most once.
class ParameterAttributes {
 public:
  ParameterAttributes(Subject& subject, std::size_t index)
      : subject_(subject),
        item_(*subject.parameters[index]),
        parameter_(subject.model.parameters[index]),
        unit_(parameter_.rotation ? UnitKind::angle : UnitKind::length),
        rate_(parameter_.rotation ? UnitKind::turn_rate : UnitKind::speed),
        acceleration_(parameter_.rotation ? UnitKind::turn_acceleration : UnitKind::acceleration) {}

  void check() {
    if (parameter_.derived) {
      refuse_attributes_of_derived();
      return;
    }
    collect();
    check_range();
    check_cyclic();
    check_motion();
    check_start();
    check_prefer();
  }

 private:
  void refuse_attributes_of_derived() {
    if (item_.attributes.empty()) return;
    const Attribute& first = item_.attributes.front();
    subject_.diagnostics.error(
        "R15", first.name.span,
        fmt::format("'{}' is computed from other parameters and cannot have {}", parameter_.name,
                    first.name.text));
  }

  void collect() {
    for (const Attribute& attribute : item_.attributes) {
      const std::string& name = attribute.name.text;
      const auto* form = std::find_if(std::begin(kForms), std::end(kForms),
                                      [&](const auto& each) { return each.name == name; });
      if (form == std::end(kForms)) {
        report_unknown(attribute);
        continue;
      }
      const auto [place, is_new] = given_.emplace(name, &attribute);
      if (!is_new) {
        subject_.twice(attribute.name.span,
                       fmt::format("{} of '{}' is given twice", name, parameter_.name),
                       place->second->name.span);
      } else if (attribute.numbers.size() != form->numbers) {
        subject_.diagnostics.error(
            "R06", attribute.span,
            fmt::format("{} takes {}, found {}", name,
                        form->numbers == 0   ? "no number"
                        : form->numbers == 1 ? "1 number"
                                             : "2 numbers (lower and upper limit)",
                        attribute.numbers.size()));
        malformed_.insert(name);
      }
    }
  }

  void report_unknown(const Attribute& attribute) {
    std::string ending = subject_.suggestions.ending(attribute.name.text, [] {
      std::vector<std::string> names;
      for (const AttributeForm& each : kForms) names.emplace_back(each.name);
      return names;
    });
    if (ending.empty())
      ending = "; expected range, cyclic, step, speed, loaded, accel, start or prefer";
    subject_.diagnostics.error("R01", attribute.name.span,
                               fmt::format("unknown attribute '{}' of parameter '{}'{}",
                                           attribute.name.text, parameter_.name, ending));
  }

  /// The attribute if it is there with the right number of numbers, else null.
  const Attribute* given(const char* name) const {
    const auto found = given_.find(name);
    return found == given_.end() || malformed_.count(name) != 0 ? nullptr : found->second;
  }
  bool mentioned(const char* name) const { return given_.count(name) != 0; }

  bool check_value(const syntax::Number& number, const char* attribute, UnitKind unit) {
    return check_unit(number, unit, fmt::format("{} of '{}'", attribute, parameter_.name),
                      subject_.diagnostics);
  }

  void check_range() {
    const Attribute* range = given("range");
    if (range == nullptr) return;
    const bool fine = check_value(range->numbers[0], "range", unit_);
    if (!check_value(range->numbers[1], "range", unit_) || !fine) return;
    const double lower = range->numbers[0].value, upper = range->numbers[1].value;
    if (lower > upper) {
      subject_.diagnostics.error(
          "R08", range->span,
          fmt::format("range of '{}' goes from {} to {}; expected the smaller limit first",
                      parameter_.name, lower, upper));
      return;
    }
    parameter_.lower = lower;
    parameter_.upper = upper;
  }

  void check_cyclic() {
    const Attribute* cyclic = given("cyclic");
    if (cyclic == nullptr) return;
    if (!parameter_.rotation) {
      subject_.diagnostics.error("R10", cyclic->name.span,
                                 fmt::format("only rotations (psi, phi, theta) can be cyclic, not "
                                             "'{}'",
                                             parameter_.name));
      return;
    }
    if (mentioned("range")) {
      subject_.diagnostics.error(
          "R10", cyclic->name.span,
          fmt::format("'{}' cannot be cyclic and have a range: it turns freely or it has limits",
                      parameter_.name));
      return;
    }
    parameter_.cyclic = true;
  }

  /// The value of a step, speed or acceleration; nothing if it is not given or wrong.
  std::optional<double> positive(const char* name, UnitKind unit) {
    const Attribute* attribute = given(name);
    if (attribute == nullptr) return std::nullopt;
    const syntax::Number& number = attribute->numbers[0];
    if (!check_value(number, name, unit)) return std::nullopt;
    if (number.value >= kMinStep && number.value <= kMaxLength) return number.value;
    subject_.diagnostics.error(
        "R07", number.span,
        number.value > 0 ? fmt::format("{} of '{}' must be between {} and {}, found {}", name,
                                       parameter_.name, kMinStep, kMaxLength, number.value)
                         : fmt::format("{} of '{}' must be greater than 0, found {}", name,
                                       parameter_.name, number.value));
    return std::nullopt;
  }

  void check_needs_speed(const char* name, const char* reason, const char* example) {
    const Attribute* attribute = given(name);
    if (attribute == nullptr || mentioned("speed")) return;
    subject_.diagnostics.error(
        "R12", attribute->name.span,
        fmt::format("{} of '{}' needs a speed: {}", name, parameter_.name, reason),
        fmt::format("write speed(v) {}", example));
  }

  void check_motion() {
    const std::optional<double> step = positive("step", unit_);
    const std::optional<double> speed = positive("speed", rate_);
    const std::optional<double> loaded = positive("loaded", rate_);
    const std::optional<double> acceleration = positive("accel", acceleration_);
    check_needs_speed("loaded", "it is the speed while an object is attached", "loaded(v2)");
    check_needs_speed("accel", "it is how fast this speed is gained and lost", "accel(a)");
    if (!mentioned("step") && !mentioned("speed")) return;
    const double time_step = subject_.model.time_step;
    if (step) {
      parameter_.step = *step;
      parameter_.speed = speed.value_or(*step / time_step);
    } else {
      // Where the value is wrong another takes its place, so that nothing is said of a parameter
      // without step.
      parameter_.speed = speed.value_or(1);
      parameter_.step = std::clamp(parameter_.speed * time_step, kMinStep, kMaxLength);
    }
    parameter_.loaded_speed = loaded.value_or(parameter_.speed);
    parameter_.acceleration = acceleration.value_or(0);
  }

  void check_start() {
    parameter_.start = std::clamp(0.0, parameter_.lower, parameter_.upper);
    const Attribute* start = given("start");
    if (start == nullptr || !check_value(start->numbers[0], "start", unit_)) return;
    const double value = start->numbers[0].value;
    if (!(std::fabs(value) <= kMaxLength)) {
      subject_.diagnostics.error("R09", start->numbers[0].span,
                                 fmt::format("start of '{}' is too large: {}; expected at most {}",
                                             parameter_.name, value, kMaxLength));
    } else if (value < parameter_.lower || value > parameter_.upper) {
      subject_.diagnostics.error(
          "R09", start->numbers[0].span,
          fmt::format("start of '{}' is {}, outside its range ({}, {})", parameter_.name, value,
                      parameter_.lower, parameter_.upper));
    } else {
      parameter_.start = value;
    }
  }

  void check_prefer() {
    const Attribute* prefer = given("prefer");
    if (prefer == nullptr) return;
    const syntax::Number& number = prefer->numbers[0];
    if (number.unit != UnitKind::none || (number.value != 1 && number.value != -1)) {
      subject_.diagnostics.error(
          "R11", number.span,
          fmt::format("prefer of '{}' is 1 or -1: the direction that is taken when both are as "
                      "good; found {}{}",
                      parameter_.name, number.value,
                      number.unit_text.empty() ? "" : " " + number.unit_text));
      return;
    }
    parameter_.prefer = number.value > 0 ? 1 : -1;
  }

  Subject& subject_;
  const syntax::ParameterItem& item_;
  robot::Parameter& parameter_;
  UnitKind unit_;
  UnitKind rate_;
  UnitKind acceleration_;
  std::map<std::string, const Attribute*> given_;  ///< the first of each name
  std::set<std::string> malformed_;                ///< of these, with a wrong number of numbers
};

}  // namespace

void check_attributes(Subject& subject) {
  for (std::size_t i = 0; i < subject.parameters.size(); ++i) {
    ParameterAttributes(subject, i).check();
  }
}

void complete_parameters(Subject& subject) {
  auto& parameters = subject.model.parameters;
  std::map<std::string, int> uses;
  double smallest[2] = {std::numeric_limits<double>::infinity(),
                        std::numeric_limits<double>::infinity()};
  for (const robot::Parameter& each : parameters) {
    ++uses[each.name];
    if (each.step > 0) smallest[each.rotation] = std::min(smallest[each.rotation], each.step);
  }
  for (robot::Parameter& each : parameters) {
    const std::string& body = subject.model.bodies[static_cast<std::size_t>(each.body)].name;
    each.display_name = uses[each.name] == 1 ? each.name : body + "." + each.name;
    each.quantum = each.step;
    if (each.quantum <= 0) {
      each.quantum = std::isfinite(smallest[each.rotation]) ? smallest[each.rotation] : 1;
    }
  }
  const std::vector<double> starts = subject.model.start_values();
  for (robot::Parameter& each : parameters) {
    if (!each.derived) continue;
    each.start = robot::reduced(each, each.derived_value.evaluate({starts, {}, starts}));
  }
}

}  // namespace rubicon::interpreter::robot_check
