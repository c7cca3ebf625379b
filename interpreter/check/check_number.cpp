#include "interpreter/check/check_number.hpp"

#include <fmt/format.h>

#include <iterator>

namespace rubicon::interpreter {

using syntax::UnitKind;

std::string_view unit_kind_text(UnitKind kind) {
  switch (kind) {
    case UnitKind::none:
      return "a plain number";
    case UnitKind::length:
      return "a length";
    case UnitKind::angle:
      return "an angle";
    case UnitKind::time:
      return "a time";
    case UnitKind::mass:
      return "a mass";
    case UnitKind::density:
      return "a density";
    case UnitKind::speed:
      return "a speed";
    case UnitKind::turn_rate:
      return "a turning speed";
    case UnitKind::acceleration:
      return "an acceleration";
    case UnitKind::turn_acceleration:
      return "a turning acceleration";
    case UnitKind::per_hour:
      return "an hourly rate";
    case UnitKind::compound:
      return "a value of another kind";
  }
  return "";
}

bool check_unit(const syntax::Number& number, UnitKind wanted, std::string_view what,
                Diagnostics& diagnostics) {
  if (number.unit == UnitKind::none || number.unit == wanted) return true;
  diagnostics.error(
      "F09", number.span,
      number.unit_text.empty()  // computed
          ? fmt::format("{} needs {}, but the value is {}", what, unit_kind_text(wanted),
                        syntax::dimension_text(number.dimension))
          : fmt::format("{} needs {}, but '{}' is {}", what, unit_kind_text(wanted),
                        number.unit_text, syntax::dimension_text(number.dimension)));
  return false;
}

std::optional<robot::LineDeviation> resolve_deviation(const syntax::MotionClause& clause,
                                                      const char* code, Diagnostics& diagnostics) {
  struct Bounds {
    UnitKind unit;
    double least, most;
    const char* text;
  };
  static constexpr Bounds kBounds[] = {{UnitKind::length, 1e-5, 1, "0.01 mm and 1 m"},
                                       {UnitKind::angle, 1e-3, 10, "0.001 and 10 degrees"}};
  robot::LineDeviation deviation;
  double* const values[] = {&deviation.position, &deviation.orientation_deg};
  if (clause.numbers.empty() || clause.numbers.size() > std::size(kBounds)) return std::nullopt;
  for (std::size_t i = 0; i < clause.numbers.size(); ++i) {
    const syntax::Number& number = clause.numbers[i];
    const Bounds& bounds = kBounds[i];
    if (!check_unit(number, bounds.unit, "deviation", diagnostics)) return std::nullopt;
    if (!(number.value >= bounds.least && number.value <= bounds.most)) {
      diagnostics.error(
          code, number.span,
          fmt::format("deviation must be between {}, found {}", bounds.text, number.value));
      return std::nullopt;
    }
    *values[i] = number.value;
  }
  return deviation;
}

}  // namespace rubicon::interpreter
