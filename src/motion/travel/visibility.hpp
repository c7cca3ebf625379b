#pragma once

#include <utility>
#include <vector>

#include "src/motion/travel/travel.hpp"

namespace rubicon::travel {

/// The shortest way round standing obstacles, for whoever knows them all, with the graph that it
/// was found in.
struct VisibilityResult {
  bool reached = false;
  double length = 0;                       ///< m
  std::vector<Vec2> way;                   ///< from start to destination; empty where there is none
  std::vector<Vec2> nodes;                 ///< start, destination, then the corners of the outlines
  std::vector<std::pair<int, int>> edges;  ///< nodes that see each other, by their numbers
};

/// The shortest way, by the visibility graph (Lozano-Perez and Wesley, CACM 22, 1979): start,
/// destination and all corners of the outlines at which the obstacle is convex, joined where the
/// straight way between them enters no obstacle; then Dijkstra. Ways along edges and past corners
/// are free, points where obstacles meet are closed, as for all travel. What sees what is decided
/// exactly. Obstacles stand where they are at time 0; with timetables of more than one placement
/// std::invalid_argument.
VisibilityResult shortest_way(const TravelQuery& query);

}  // namespace rubicon::travel
