#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "interpreter/parse/parse_state.hpp"

/// Tokens with a value: names, numbers and their units.
namespace rubicon::interpreter {

namespace {

struct Unit {
  std::string_view text;
  syntax::Dimension dimension;
  double factor;   ///< base units per unit
  double divisor;  ///< used instead where the factor is no exact double
};

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

constexpr Unit kUnits[] = {
    {"mm", {1, 0, 0, 0}, 1, 1000},    {"cm", {1, 0, 0, 0}, 1, 100},
    {"m", {1, 0, 0, 0}, 1, 1},        {"m2", {2, 0, 0, 0}, 1, 1},
    {"m3", {3, 0, 0, 0}, 1, 1},       {"l", {3, 0, 0, 0}, 1, 1000},
    {"deg", {0, 1, 0, 0}, 1, 1},      {"rad", {0, 1, 0, 0}, kDegreesPerRadian, 1},
    {"s", {0, 0, 1, 0}, 1, 1},        {"min", {0, 0, 1, 0}, 60, 1},
    {"h", {0, 0, 1, 0}, 3600, 1},     {"t", {0, 0, 0, 1}, 1000, 1},
    {"kg", {0, 0, 0, 1}, 1, 1},       {"kg/m3", {-3, 0, 0, 1}, 1, 1},
    {"t/m3", {-3, 0, 0, 1}, 1000, 1}, {"m/s", {1, 0, -1, 0}, 1, 1},
    {"mm/s", {1, 0, -1, 0}, 1, 1000}, {"km/h", {1, 0, -1, 0}, 1, 3.6},
    {"deg/s", {0, 1, -1, 0}, 1, 1},   {"rad/s", {0, 1, -1, 0}, kDegreesPerRadian, 1},
    {"m/s2", {1, 0, -2, 0}, 1, 1},    {"mm/s2", {1, 0, -2, 0}, 1, 1000},
    {"deg/s2", {0, 1, -2, 0}, 1, 1},  {"rad/s2", {0, 1, -2, 0}, kDegreesPerRadian, 1},
    {"rpm", {0, 1, -1, 0}, 6, 1},  // 360 degrees in 60 seconds
};

/// Units as people write them, and what to write instead.
constexpr std::pair<std::string_view, std::string_view> kUnitWords[] = {
    {"ton", "t"},        {"tons", "t"},      {"tonne", "t"},    {"tonnes", "t"},
    {"to", "t"},         {"kilo", "kg"},     {"kilos", "kg"},   {"kilogram", "kg"},
    {"kilograms", "kg"}, {"meter", "m"},     {"meters", "m"},   {"metre", "m"},
    {"metres", "m"},     {"sec", "s"},       {"secs", "s"},     {"second", "s"},
    {"seconds", "s"},    {"mins", "min"},    {"minute", "min"}, {"minutes", "min"},
    {"hr", "h"},         {"hrs", "h"},       {"hour", "h"},     {"hours", "h"},
    {"degree", "deg"},   {"degrees", "deg"}, {"radian", "rad"}, {"radians", "rad"},
    {"kph", "km/h"},     {"kmh", "km/h"},    {"mps", "m/s"},    {"sqm", "m2"},
    {"cbm", "m3"},       {"L", "l"},         {"liter", "l"},    {"liters", "l"},
    {"litre", "l"},      {"litres", "l"},
};
/// Units that there are not, and what one of them is.
constexpr std::pair<std::string_view, std::string_view> kForeignUnits[] = {
    {"d", "a day of 24 h is 24 h, a working day what its shifts are"},
    {"day", "a day of 24 h is 24 h, a working day what its shifts are"},
    {"days", "a day of 24 h is 24 h, a working day what its shifts are"},
    {"kN", "a mass of 1 t weighs 9.81 kN; write the mass"},
    {"ft", "1 ft is 0.3048 m"},
    {"feet", "1 ft is 0.3048 m"},
    {"inch", "1 inch is 25.4 mm"},
    {"inches", "1 inch is 25.4 mm"},
    {"lb", "1 lb is 0.45359237 kg"},
    {"lbs", "1 lb is 0.45359237 kg"},
};

std::string_view look_up(std::span<const std::pair<std::string_view, std::string_view>> words,
                         std::string_view word) {
  for (const auto& [each, meaning] : words) {
    if (each == word) return meaning;
  }
  return {};
}

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// m3 for m³.
std::string with_plain_digits(std::string_view unit) {
  std::string plain(unit);
  for (const auto& [raised, digit] : {std::pair{"\u00b2", "2"}, std::pair{"\u00b3", "3"}}) {
    const std::size_t at = plain.find(raised);
    if (at != std::string::npos) plain.replace(at, std::string_view(raised).size(), digit);
  }
  return plain;
}

const Unit* find_unit(std::string_view text) {
  for (const Unit& unit : kUnits) {
    if (unit.text == text) return &unit;
  }
  return nullptr;
}

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
    if (name_.body) join_body();
    name_.body = std::move(name_.name);
    name_.span.end = part.span.end;
  } else {
    name_.body.reset();
    name_.span = part.span;
  }
  name_.name = std::move(part);
}

/// Before a second dot: yard.unit of yard.unit[2].slab.
void ParseState::join_body() {
  const syntax::Name& import = *name_.body;
  if (!import.indices.empty()) {
    report_token(code_, begin_ + import.span.begin,
                 "brackets stand behind the last two parts of a name only: NAME.x[i].y[j]");
  }
  name_.name.text = import.text + "." + name_.name.text;
  name_.name.span.begin = import.span.begin;
}

void ParseState::open_indices() { indexed_.push_back({std::move(name_), {}}); }

void ParseState::close_indices() {
  name_ = std::move(indexed_.back().name);
  name_.name.indices = std::move(indexed_.back().indices);
  name_.name.span.end = name_.span.end = span_from(last_end).begin;
  indexed_.pop_back();
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
  number.span.end = static_cast<std::uint32_t>(to - begin_);
  std::vector<std::string> words;
  for (const char* at = from; at != to;) {
    const char* end = at;
    while (end != to && !is_blank(*end)) ++end;
    words.push_back(with_plain_digits({at, static_cast<std::size_t>(end - at)}));
    for (at = end; at != to && is_blank(*at);) ++at;
  }
  number.unit_text = fmt::format("{}", fmt::join(words, " "));
  const Unit* const above = words.front() == "per" ? nullptr : find_unit(words.front());
  const Unit* const below = words.size() > 1 ? find_unit(words.back()) : nullptr;
  if (above != nullptr) {
    number.value =
        above->divisor > 1 ? number.value / above->divisor : number.value * above->factor;
    number.dimension = above->dimension;
  }
  if (below != nullptr) {
    number.value =
        below->divisor > 1 ? number.value * below->divisor : number.value / below->factor;
    number.dimension = combined(number.dimension, below->dimension, -1);
  }
  number.unit = unit_kind(number.dimension);
  if (computes_numbers_ || number.unit != syntax::UnitKind::compound) return;
  report(code_, from, to, fmt::format("the unit '{}' belongs into plans", number.unit_text));
}

void ParseState::unknown_unit(const char* from, const char* to) {
  std::vector<std::string> names;
  for (const Unit& unit : kUnits) {
    if (computes_numbers_ || unit_kind(unit.dimension) != syntax::UnitKind::compound) {
      names.emplace_back(unit.text);
    }
  }
  const std::string word(from, to);
  const std::string_view foreign = look_up(kForeignUnits, word);
  if (!foreign.empty()) {
    report(code_, from, to, fmt::format("unknown unit {}", found(from)), std::string(foreign));
    return;
  }
  if (const std::size_t blank = word.find_last_of(" \t"); blank != std::string::npos) {  // per day
    const std::string_view of = std::string_view(word).substr(blank + 1);
    const std::string_view meant = look_up(kUnitWords, of);
    report(code_, from, to, fmt::format("'per {}' is no unit", of),
           meant.empty() ? std::string("write for example 140 per h")
                         : fmt::format("write {}: 140 per {}", meant, meant));
    if (const Unit* const unit = find_unit(meant)) {  // no second error of a wrong kind
      number.dimension = combined({}, unit->dimension, -1);
      number.unit = unit_kind(number.dimension);
    }
    return;
  }
  const std::string_view meant = look_up(kUnitWords, word);
  const std::string near = meant.empty() ? did_you_mean(word, names) : std::string(meant);
  report(code_, from, to,
         near.empty() ? fmt::format("unknown unit {}", found(from))
                      : fmt::format("unknown unit {}; did you mean {}?", found(from), near),
         computes_numbers_
             ? "units are mm, cm, m, m2, m3, l, deg, rad, s, min, h, t, kg, kg/m3, t/m3, "
               "m/s, mm/s, km/h, deg/s, rad/s, rpm, m/s2, mm/s2, deg/s2, rad/s2, and such as per h "
               "or t per m3"
             : "units are mm, cm, m, deg, rad, s, min, h, t, kg, kg/m3, t/m3, "
               "m/s, mm/s, km/h, deg/s, rad/s, rpm, m/s2, mm/s2, deg/s2, rad/s2 and per h");
}

}  // namespace rubicon::interpreter
