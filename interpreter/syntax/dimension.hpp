#pragma once

#include <cstdint>
#include <string>

/// What a number measures: of units, and of what is computed with them.
namespace rubicon::syntax {

enum class UnitKind {
  none,
  length,
  angle,
  time,
  mass,
  density,
  speed,
  turn_rate,
  acceleration,
  turn_acceleration,
  per_hour,
  compound  ///< any other, such as an area: its Dimension says which
};

/// Powers of the base units m, degree, s and kg. All 0: a bare number.
struct Dimension {
  std::int8_t length = 0;
  std::int8_t angle = 0;
  std::int8_t time = 0;
  std::int8_t mass = 0;
  bool operator==(const Dimension&) const = default;
  bool is_bare() const { return *this == Dimension{}; }
};

/// Of a product (`sign` 1) or a quotient (-1). Powers stay within 8 bits: beyond 100 they are cut.
Dimension combined(Dimension a, Dimension b, int sign);

UnitKind unit_kind(Dimension dimension);

/// Of a kind other than compound.
Dimension dimension_of(UnitKind kind);

/// "a length", "an area", "a plain number"; what has no word is "a value in kg per m".
std::string dimension_text(Dimension dimension);

}  // namespace rubicon::syntax
