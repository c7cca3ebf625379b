#include "src/fleets/lanes/grid.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace rubicon::lanes {

NetworkDescription grid(const GridQuery& query) {
  constexpr std::int64_t kMostNodes = 10'000'000;
  const std::int64_t nodes = static_cast<std::int64_t>(query.columns) * query.rows;
  if (query.columns < 1 || query.rows < 1 || nodes > kMostNodes) {
    throw std::invalid_argument(
        fmt::format("grid: expected 1 to {} nodes in columns and rows, found {} by {}", kMostNodes,
                    query.columns, query.rows));
  }
  if (!(query.spacing > 0) || !std::isfinite(query.spacing)) {
    throw std::invalid_argument(
        fmt::format("grid: expected a spacing above 0 m, found {}", query.spacing));
  }
  NetworkDescription result;
  result.classes = {query.lane_class};
  result.nodes.reserve(static_cast<std::size_t>(nodes));
  result.lanes.reserve(static_cast<std::size_t>(4 * nodes));
  const auto join = [&result](NodeIndex a, NodeIndex b) {
    const auto first = static_cast<LaneIndex>(result.lanes.size());
    result.lanes.push_back({a, b, 0, std::nullopt, first + 1});
    result.lanes.push_back({b, a, 0, std::nullopt, first});
  };
  for (int y = 0; y < query.rows; ++y) {
    for (int x = 0; x < query.columns; ++x) {
      const auto here = static_cast<NodeIndex>(result.nodes.size());
      result.nodes.push_back(
          {fmt::format("x{}y{}", x, y), query.spacing * x, query.spacing * y, 0, true});
      if (x > 0) join(here - 1, here);
      if (y > 0) join(here - query.columns, here);
    }
  }
  return result;
}

}  // namespace rubicon::lanes
