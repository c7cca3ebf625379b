#pragma once

#include <cmath>

/// Whole turns of angles in degrees: the one place where they are added or taken away. An angle and
/// the same angle plus 360 k point the same way.
///
/// Exactness: an angle within half a turn comes back bit for bit; others are reduced by fmod, which
/// is exact, so that the result is the angle whose double was given, whatever its size. Each
/// function says what it does at a tie, half a turn both ways.
namespace rubicon::math {

inline constexpr double kTurn_deg = 360;
inline constexpr double kHalfTurn_deg = 180;

/// `degrees` reduced to (-180, 180] by whole turns; half a turn is +180. NaN for a value that is
/// not finite.
double normalised_deg(double degrees);

/// `degrees` reduced to (-90, 90] by half turns: of an axis that has no sense.
double normalised_axis_deg(double degrees);

/// `degrees` reduced to (least, least + 360] by whole turns; `least` within half a turn.
inline double turn_above_deg(double degrees, double least) {
  const double turned = normalised_deg(degrees);
  return turned <= least ? turned + kTurn_deg : turned;
}

/// The angle that points as `degrees` does and is nearest to `near`; at a tie half a turn above it.
inline double nearest_equivalent_deg(double degrees, double near) {
  return near + normalised_deg(degrees - near);
}

/// The least angle that points as `degrees` does and is not below `lower`, but for rounding.
inline double first_equivalent_deg(double degrees, double lower) {
  return degrees + kTurn_deg * std::ceil((lower - degrees) / kTurn_deg);
}

/// The multiple of 360 nearest to `degrees`; at a tie the greater one.
inline double whole_turns_deg(double degrees) {
  return kTurn_deg * std::floor(degrees / kTurn_deg + 0.5);
}

/// Whether `degrees` is a multiple of 360.
inline bool is_whole_turns_deg(double degrees) { return std::fmod(degrees, kTurn_deg) == 0; }

/// The turn that ends as `turn` does, the other way round; of none: a whole turn.
inline double other_way_round_deg(double turn) {
  return turn > 0 ? turn - kTurn_deg : turn + kTurn_deg;
}

}  // namespace rubicon::math
