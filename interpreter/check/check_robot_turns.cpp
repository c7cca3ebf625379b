#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "interpreter/check/check_robot_parts.hpp"
#include "src/motion/math/turns.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::interpreter::robot_check {

namespace {

using robot::FormulaOp;

constexpr const char* kNotTheSame = "is not the same after a whole turn of it";

/// What a formula gives more when one parameter grows: by a whole turn (`jump`), and by each unit
/// along a straight line (`slope`). Nothing where that depends on other values.
struct Growth {
  std::optional<double> literal;  ///< the value of a constant
  std::optional<double> jump = 0;
  std::optional<double> slope = 0;
};

std::optional<double> sum(std::optional<double> a, std::optional<double> b, double sign) {
  if (!a || !b) return std::nullopt;
  return *a + sign * *b;
}

std::optional<double> scaled(std::optional<double> a, double factor) {
  if (!a) return std::nullopt;
  return *a * factor;
}

bool is_zero(const std::optional<double>& value) { return value && *value == 0; }

std::optional<double> zero_if(bool holds) {
  return holds ? std::optional<double>(0) : std::nullopt;
}

bool is_whole_turns(const std::optional<double>& jump) {
  return jump && math::is_whole_turns_deg(*jump);
}

Growth added(const Growth& a, const Growth& b, double sign) {
  Growth result;
  result.literal = sum(a.literal, b.literal, sign);
  result.jump = sum(a.jump, b.jump, sign);
  result.slope = sum(a.slope, b.slope, sign);
  return result;
}

Growth multiplied(const Growth& a, const Growth& b) {
  if (!a.literal && b.literal) return multiplied(b, a);
  if (a.literal) {
    return {scaled(b.literal, *a.literal), scaled(b.jump, *a.literal), scaled(b.slope, *a.literal)};
  }
  return {std::nullopt, zero_if(is_zero(a.jump) && is_zero(b.jump)),
          zero_if(is_zero(a.slope) && is_zero(b.slope))};
}

Growth divided(const Growth& a, const Growth& b) {
  if (!b.literal) {
    return {std::nullopt, zero_if(is_zero(a.jump) && is_zero(b.jump)),
            zero_if(is_zero(a.slope) && is_zero(b.slope))};
  }
  if (*b.literal == 0) return {std::nullopt, std::nullopt, std::nullopt};
  const auto by = [&](std::optional<double> value) {
    return value ? std::optional<double>(*value / *b.literal) : value;
  };
  return {by(a.literal), by(a.jump), by(a.slope)};
}

/// Sine or cosine: whole turns of the angle are not seen.
Growth of_angle(const Growth& a) {
  return {std::nullopt, zero_if(is_whole_turns(a.jump)), zero_if(is_zero(a.slope))};
}

Growth growth_of(const robot::Formula& formula, int parameter) {
  using Kind = FormulaOp::Kind;
  std::vector<Growth> stack;
  for (const FormulaOp& op : formula.code) {
    Growth right;
    const bool binary = op.kind == Kind::add || op.kind == Kind::subtract ||
                        op.kind == Kind::multiply || op.kind == Kind::divide;
    if (binary) {
      right = stack.back();
      stack.pop_back();
    }
    switch (op.kind) {
      case Kind::constant:
        stack.push_back({op.value, 0, 0});
        break;
      case Kind::parameter:
        stack.push_back(op.index == parameter ? Growth{std::nullopt, math::kTurn_deg, 1}
                                              : Growth{std::nullopt, 0, 0});
        break;
      case Kind::step:
      case Kind::start:
        stack.push_back({std::nullopt, 0, 0});
        break;
      case Kind::add:
        stack.back() = added(stack.back(), right, 1);
        break;
      case Kind::subtract:
        stack.back() = added(stack.back(), right, -1);
        break;
      case Kind::multiply:
        stack.back() = multiplied(stack.back(), right);
        break;
      case Kind::divide:
        stack.back() = divided(stack.back(), right);
        break;
      case Kind::negate:
        stack.back() = multiplied({-1.0, 0, 0}, stack.back());
        break;
      case Kind::sin:
      case Kind::cos:
        stack.back() = of_angle(stack.back());
        break;
    }
  }
  return stack.empty() ? Growth{0.0, 0, 0} : stack.back();
}

/// Finds which angles may be reduced to (-180, 180] without anything else jumping. Whoever fails
/// is taken out until nothing changes: it counts its turns. So does an angle with a range of which
/// that holds.
class TurnCheck {
 public:
  explicit TurnCheck(Subject& subject) : subject_(subject), model_(subject.model) {}

  void check() {
    const bool any = std::any_of(model_.parameters.begin(), model_.parameters.end(),
                                 [](const robot::Parameter& each) { return each.cyclic; });
    if (any) {
      for (robot::Parameter& each : model_.parameters) {
        if (each.derived && each.rotation) each.cyclic = follows_turns(each);
      }
      while (take_out()) {
      }
      for (robot::Parameter& each : model_.parameters) {
        if (!each.derived) each.start = robot::reduced(each, each.start);
      }
    }
    for (int p = 0; p < count(); ++p) {
      robot::Parameter& each = at(p);
      each.counts_turns = each.rotation && each.limited() && who_jumps(p).has_value();
    }
  }

 private:
  robot::Parameter& at(int index) { return model_.parameters[static_cast<std::size_t>(index)]; }
  int count() const { return static_cast<int>(model_.parameters.size()); }

  std::string name(const robot::Parameter& parameter) const {
    return model_.bodies[static_cast<std::size_t>(parameter.body)].name + "." + parameter.name;
  }

  /// Whether a derived angle makes whole turns with a cyclic one, and at most half a turn in any
  /// step: who reads its values one after the other can tell which way it went.
  bool follows_turns(const robot::Parameter& derived) {
    bool follows = false;
    double largest = 0;
    for (int p = 0; p < count(); ++p) {
      if (!derived.derived_value.depends_on_parameter(p)) continue;
      const robot::Parameter& other = at(p);
      const Growth growth = growth_of(derived.derived_value, p);
      if (other.cyclic && !other.derived) {
        if (!is_whole_turns(growth.jump)) return false;
        follows = follows || *growth.jump != 0;
      }
      if (!growth.slope || (*growth.slope != 0 && other.free && !other.direct)) return false;
      largest += std::fabs(*growth.slope) * other.step;
    }
    return follows && largest <= math::kHalfTurn_deg;
  }

  /// Takes one angle out that cannot stay; false if all can.
  bool take_out() {
    for (int p = 0; p < count(); ++p) {
      if (!at(p).cyclic) continue;
      const std::optional<std::string> reader = who_jumps(p);
      if (!reader && (!at(p).derived || follows_turns(at(p)))) continue;
      at(p).cyclic = false;
      if (!at(p).derived && reader) report(p, *reader);
      return true;
    }
    return false;
  }

  /// What would jump if parameter p jumped by a whole turn; nothing if it may.
  std::optional<std::string> who_jumps(int p) {
    for (int i = 0; i < count(); ++i) {
      const robot::Parameter& other = at(i);
      const robot::Formula& formula = other.derived ? other.derived_value : other.rule;
      if (!formula.depends_on_parameter(p)) continue;
      const std::optional<double> jump = growth_of(formula, p).jump;
      const bool stays = other.derived && other.cyclic ? is_whole_turns(jump)
                         : i == p                      ? jump == math::kTurn_deg
                                                       : is_zero(jump);
      if (stays) continue;
      if (other.derived && other.rotation && is_whole_turns(jump)) {
        return fmt::format("parameter {} may make more than half a turn in a step", name(other));
      }
      return fmt::format("{} {} {}", other.derived ? "parameter" : "the rule of", name(other),
                         kNotTheSame);
    }
    for (const robot::Body& body : model_.bodies) {
      if (frame_jumps(body.frame, p))
        return fmt::format("the frame of body {} {}", body.name, kNotTheSame);
    }
    if (frame_jumps(model_.tool_frame, p))
      return fmt::format("the frame of the tool {}", kNotTheSame);
    return std::nullopt;
  }

  static bool frame_jumps(const robot::FrameFormula& frame, int p) {
    return std::any_of(frame.begin(), frame.end(), [&](const robot::FrameElement& element) {
      if (element.kind != robot::FrameElement::Kind::trans)
        return !is_whole_turns(growth_of(element.a, p).jump);
      return !is_zero(growth_of(element.a, p).jump) || !is_zero(growth_of(element.b, p).jump) ||
             !is_zero(growth_of(element.c, p).jump);
    });
  }

  void report(int p, const std::string& reader) {
    subject_.diagnostics.note(
        "R22", subject_.parameters[static_cast<std::size_t>(p)]->name.span,
        fmt::format("'{}' counts its turns, since {}: its values run on beyond 180, and goals are "
                    "reached with their turns",
                    name(at(p)), reader));
  }

  Subject& subject_;
  robot::RobotModel& model_;
};

}  // namespace

void check_turns(Subject& subject) { TurnCheck(subject).check(); }

}  // namespace rubicon::interpreter::robot_check
