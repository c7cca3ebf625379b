#pragma once

#include <cstdint>
#include <vector>

#include "src/fleets/traffic/one_shot.hpp"

namespace rubicon::traffic {

/// A roadmap in a square yard: nodes at random, no two nearer than `spacing`, joined both ways by
/// so many straight lines: the shortest that keep it in one piece, then from each node with the
/// fewest to its nearest.
struct RoadmapQuery {
  int nodes = 170;
  int edges = 349;
  double side = 140;   ///< m
  double spacing = 6;  ///< m
  std::uint64_t seed = 1;
};
LaneNetwork roadmap(const RoadmapQuery& query);

/// Trips from and to different nodes, with the speeds of tow motors, loaders and trucks in turn.
std::vector<Trip> random_trips(const LaneNetwork& network, int count, std::uint64_t seed);

/// Where a disc is, in straight pieces: s and m.
struct TimedPlace {
  double t = 0;
  double x = 0;
  double y = 0;
};
std::vector<TimedPlace> track_of(const LaneNetwork& network, const std::vector<TimedNode>& way);

/// The least distance of the middles of two discs at any time; each stays where its track ends.
double least_distance(const std::vector<TimedPlace>& a, const std::vector<TimedPlace>& b);

/// Ways as they are driven if each lane takes up to `most_late` seconds longer and the order is
/// kept; trips that do not arrive have shorter ways.
std::vector<std::vector<TimedNode>> driven_late(const LaneNetwork& network,
                                                const std::vector<Trip>& trips,
                                                const std::vector<Precedence>& order,
                                                const std::vector<std::vector<TimedNode>>& ways,
                                                int most_late, std::uint64_t seed);

}  // namespace rubicon::traffic
