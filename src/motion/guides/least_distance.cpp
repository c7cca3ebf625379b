#include "src/motion/guides/least_distance.hpp"

#include <cmath>

namespace rubicon::guides {

double least_distance(const Space& space, std::span<const double> a, std::span<const double> b) {
  if (!space.leg().steers()) return space.distance(a, b);
  constexpr double kWeightOfWay = 10;  // of a metre that a vehicle steers
  const auto place = space.leg().place();
  double sum = 0;
  for (std::size_t i = 0; i < space.size(); ++i) {
    const int index = space.leg().parameters()[i];
    if (index == space.leg().heading()) continue;
    const bool driven = index == place[0] || index == place[1];
    const double off = driven ? (b[i] - a[i]) * kWeightOfWay : space.offset(a, b, i);
    sum += off * off;
  }
  constexpr double kNoMore = 1 - 1e-12;  // than the way, by rounding
  return std::sqrt(sum) * kNoMore;
}

}  // namespace rubicon::guides
