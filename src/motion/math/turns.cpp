#include "src/motion/math/turns.hpp"

namespace rubicon::math {

double normalised_deg(double degrees) {
  if (degrees > -kHalfTurn_deg && degrees <= kHalfTurn_deg) return degrees;
  double turned = std::fmod(degrees, kTurn_deg);
  if (turned > kHalfTurn_deg) turned -= kTurn_deg;
  if (turned <= -kHalfTurn_deg) turned += kTurn_deg;
  return turned + 0.0;
}

double normalised_axis_deg(double degrees) {
  double turned = normalised_deg(degrees);
  if (turned > kHalfTurn_deg / 2) turned -= kHalfTurn_deg;
  if (turned <= -kHalfTurn_deg / 2) turned += kHalfTurn_deg;
  return turned;
}

}  // namespace rubicon::math
