#include "src/motion/math/turns.hpp"

namespace rubicon::math {

double normalised_axis_deg(double degrees) {
  double turned = normalised_deg(degrees);
  if (turned > kHalfTurn_deg / 2) turned -= kHalfTurn_deg;
  if (turned <= -kHalfTurn_deg / 2) turned += kHalfTurn_deg;
  return turned;
}

}  // namespace rubicon::math
