#include "interpreter/syntax/dimension.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace rubicon::syntax {

namespace {

/// Powers beyond this are of no unit that anybody means.
constexpr int kMaxPower = 100;

constexpr std::array<std::pair<Dimension, UnitKind>, 11> kKinds = {{
    {{0, 0, 0, 0}, UnitKind::none},
    {{1, 0, 0, 0}, UnitKind::length},
    {{0, 1, 0, 0}, UnitKind::angle},
    {{0, 0, 1, 0}, UnitKind::time},
    {{0, 0, 0, 1}, UnitKind::mass},
    {{-3, 0, 0, 1}, UnitKind::density},
    {{1, 0, -1, 0}, UnitKind::speed},
    {{0, 1, -1, 0}, UnitKind::turn_rate},
    {{1, 0, -2, 0}, UnitKind::acceleration},
    {{0, 1, -2, 0}, UnitKind::turn_acceleration},
    {{0, 0, -1, 0}, UnitKind::per_hour},
}};

constexpr std::array<std::pair<Dimension, const char*>, 14> kTexts = {{
    {{0, 0, 0, 0}, "a plain number"},
    {{1, 0, 0, 0}, "a length"},
    {{0, 1, 0, 0}, "an angle"},
    {{0, 0, 1, 0}, "a time"},
    {{0, 0, 0, 1}, "a mass"},
    {{1, 0, -1, 0}, "a speed"},
    {{0, 1, -1, 0}, "a turning speed"},
    {{1, 0, -2, 0}, "an acceleration"},
    {{0, 1, -2, 0}, "a turning acceleration"},
    {{0, 0, -1, 0}, "an hourly rate"},
    {{2, 0, 0, 0}, "an area"},
    {{3, 0, 0, 0}, "a volume"},
    {{-3, 0, 0, 1}, "a density"},
    {{3, 0, -1, 0}, "a volume per time"},
}};

std::int8_t cut(int power) {
  return static_cast<std::int8_t>(std::clamp(power, -kMaxPower, kMaxPower));
}

void append(std::string& text, const char* unit, int power) {
  if (power <= 0) return;
  if (!text.empty()) text += ' ';
  text += unit;
  if (power > 1) text += std::to_string(power);
}

}  // namespace

Dimension combined(Dimension a, Dimension b, int sign) {
  return {cut(a.length + sign * b.length), cut(a.angle + sign * b.angle),
          cut(a.time + sign * b.time), cut(a.mass + sign * b.mass)};
}

UnitKind unit_kind(Dimension dimension) {
  for (const auto& [known, kind] : kKinds) {
    if (known == dimension) return kind;
  }
  return UnitKind::compound;
}

Dimension dimension_of(UnitKind kind) {
  for (const auto& [dimension, known] : kKinds) {
    if (known == kind) return dimension;
  }
  return {};
}

std::string dimension_text(Dimension dimension) {
  for (const auto& [known, text] : kTexts) {
    if (known == dimension) return text;
  }
  std::string above, below;
  append(above, "kg", dimension.mass);
  append(above, "m", dimension.length);
  append(above, "deg", dimension.angle);
  append(above, "s", dimension.time);
  append(below, "kg", -dimension.mass);
  append(below, "m", -dimension.length);
  append(below, "deg", -dimension.angle);
  append(below, "s", -dimension.time);
  std::string text = "a value" + (above.empty() ? std::string() : " in " + above);
  return below.empty() ? text : text + " per " + below;
}

}  // namespace rubicon::syntax
