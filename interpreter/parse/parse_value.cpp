#include <fmt/format.h>

#include <charconv>
#include <numbers>

#include "interpreter/parse/parse_state.hpp"

/// Tokens with a value: names, numbers and their units.
namespace rubicon::interpreter {

namespace {

struct Unit {
  std::string_view text;
  syntax::UnitKind kind;
  double factor;   ///< base units per unit
  double divisor;  ///< used instead where the factor is no exact double
};

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

constexpr Unit kUnits[] = {
    {"mm", syntax::UnitKind::length, 1, 1000},
    {"cm", syntax::UnitKind::length, 1, 100},
    {"m", syntax::UnitKind::length, 1, 1},
    {"deg", syntax::UnitKind::angle, 1, 1},
    {"rad", syntax::UnitKind::angle, kDegreesPerRadian, 1},
    {"s", syntax::UnitKind::time, 1, 1},
    {"min", syntax::UnitKind::time, 60, 1},
    {"h", syntax::UnitKind::time, 3600, 1},
    {"t", syntax::UnitKind::mass, 1000, 1},
    {"kg", syntax::UnitKind::mass, 1, 1},
    {"m/s", syntax::UnitKind::speed, 1, 1},
    {"mm/s", syntax::UnitKind::speed, 1, 1000},
    {"km/h", syntax::UnitKind::speed, 1, 3.6},
    {"deg/s", syntax::UnitKind::turn_rate, 1, 1},
    {"rad/s", syntax::UnitKind::turn_rate, kDegreesPerRadian, 1},
    {"rpm", syntax::UnitKind::turn_rate, 6, 1},  // 360 degrees in 60 seconds
};

/// ψ φ ϕ θ ϑ, either case, spelt as in code.
void append_spelt(std::string& text, const char* from, const char* to) {
  while (from != to) {
    const auto byte = static_cast<unsigned char>(*from);
    if (byte < 0x80) {
      text += *from++;
      continue;
    }
    const std::string_view letter(from, 2);
    if (letter == "ψ" || letter == "Ψ") {
      text += "psi";
    } else if (letter == "φ" || letter == "Φ" || letter == "ϕ") {
      text += "phi";
    } else {
      text += "theta";
    }
    from += 2;
  }
}

}  // namespace

void ParseState::set_name(const char* from, const char* to) {
  syntax::Name part;
  append_spelt(part.text, from, to);
  part.span = span(from, to);
  if (dot_) {
    dot_ = false;
    name_.body = std::move(name_.name);
    name_.span.end = part.span.end;
  } else {
    name_.body.reset();
    name_.span = part.span;
  }
  name_.name = std::move(part);
}

syntax::Name ParseState::take_name() { return std::move(name_.name); }
syntax::QualifiedName ParseState::take_qualified_name() { return std::move(name_); }

void ParseState::set_number(const char* from, const char* to) {
  number = {};
  number.span = span(from, to);
  const auto result = std::from_chars(from, to, number.value);
  if (result.ec == std::errc::result_out_of_range) {
    number.value = 0;
    report(code_, from, to, fmt::format("number {} is out of range", found(from)));
  }
}

void ParseState::set_unit(const char* from, const char* to) {
  number.unit_text.assign(from, to);
  number.span.end = static_cast<std::uint32_t>(to - begin_);
  if (*from == 'p') {  // per h
    number.unit = syntax::UnitKind::per_hour;
    number.unit_text = "per h";
    number.value /= 3600;
    return;
  }
  for (const Unit& unit : kUnits) {
    if (unit.text != number.unit_text) continue;
    number.unit = unit.kind;
    number.value = unit.divisor > 1 ? number.value / unit.divisor : number.value * unit.factor;
    return;
  }
}

void ParseState::unknown_unit(const char* from, const char* to) {
  std::vector<std::string> names;
  for (const Unit& unit : kUnits) names.emplace_back(unit.text);
  const std::string near = did_you_mean(std::string(from, to), names);
  report(code_, from, to,
         near.empty() ? fmt::format("unknown unit {}", found(from))
                      : fmt::format("unknown unit {}; did you mean {}?", found(from), near),
         "units are mm, cm, m, deg, rad, s, min, h, t, kg, m/s, mm/s, km/h, deg/s, rad/s, rpm and "
         "per h");
}

}  // namespace rubicon::interpreter
