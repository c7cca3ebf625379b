#pragma once

#include "src/fleets/lanes/lane_network.hpp"

namespace rubicon::lanes {

/// Nodes in columns and rows, each joined to its neighbours by a lane in both directions.
struct GridQuery {
  int columns = 10;
  int rows = 10;
  double spacing = 5;  ///< m
  LaneClass lane_class{"lane", 1, 4, 1};
};

/// The description: nodes x0y0, x1y0, ... row by row from the origin, with x east and y north.
/// Throws std::invalid_argument for less than one column or row, more than 10 million nodes, and a
/// spacing that is not above 0.
NetworkDescription grid(const GridQuery& query = {});

}  // namespace rubicon::lanes
