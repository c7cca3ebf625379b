#include "src/studies/statistics/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace rubicon::statistics {

std::vector<std::size_t> pareto_front(std::span<const Costs> points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isfinite(points[i].first) && std::isfinite(points[i].second)) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(points[a].first, points[a].second, a) <
           std::tie(points[b].first, points[b].second, b);
  });
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  const Costs* last = nullptr;
  for (const std::size_t i : order) {
    const bool same =
        last != nullptr && last->first == points[i].first && last->second == points[i].second;
    if (points[i].second < least || same) {
      front.push_back(i);
      last = &points[i];
    }
    least = std::min(least, points[i].second);
  }
  return front;
}

}  // namespace rubicon::statistics
