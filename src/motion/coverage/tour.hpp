#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "src/motion/coverage/grid.hpp"
#include "src/motion/coverage/order.hpp"

namespace rubicon::coverage {

/// What is visited: a thing with two ends, end 2 i and end 2 i + 1 of thing i.
struct TourQuery {
  std::vector<Point> ends;
  std::vector<int> groups;  ///< of each thing; moves stay inside a group's block; empty: all one
  std::function<double(int, int)> between;  ///< cost from end to end
  /// The same where it is the last argument or less, else anything more; empty: `between`.
  std::function<double(int, int, double)> between_within;
  std::function<double(int)> from_start;  ///< cost to a first end; empty: none
  int kicks = 0;                          ///< how many random changes are tried
};

/// Improves an order by 2-opt and or-opt of up to three things, each way round, among the ten
/// nearest ends, until none helps; then by kicks. Ties and kicks by fixed rules: the same input
/// gives the same order.
void improve_tour(const TourQuery& query, std::vector<DirectedLine>& order);

}  // namespace rubicon::coverage
