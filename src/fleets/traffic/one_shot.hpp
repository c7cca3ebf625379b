#pragma once

#include <cstdint>
#include <vector>

#include "src/fleets/traffic/nearness.hpp"
#include "src/fleets/traffic/timed_way.hpp"

namespace rubicon::traffic {

/// One vehicle that begins at a node at time 0, goes to another and stays there.
struct Trip {
  NodeIndex from = lanes::kNone;
  NodeIndex to = lanes::kNone;
  double speed = 1;  ///< m/s at most
};

struct OneShotOptions {
  std::int64_t expansions = 1'000'000;  ///< pairs of node and interval that searches may go on from
  std::uint64_t seed = 1;
};

/// Ways of all at once. Nobody meets anybody, whatever is late, as long as each waits for those
/// whose turn was before (order_of).
struct OneShot {
  bool solved = false;
  std::vector<std::vector<TimedNode>> ways;  ///< by trip
  Nanoseconds cost = 0;                      ///< arrivals at the goals, summed
  Nanoseconds first_cost = 0;                ///< of the first solution
  Nanoseconds least = 0;                     ///< each as if alone: no cost is below that
  std::int64_t expansions = 0;
};

/// Ways by priorities, the longest trip first; who finds none gets the highest priority, and all
/// begin again. Then small neighbourhoods plan again, those that are late with those in their way,
/// and what is not worse is kept (J. Li and others, "Anytime Multi-Agent Path Finding via Large
/// Neighborhood Search", IJCAI 2021), until the expansions are used up or nobody is late. Throws
/// std::invalid_argument for unknown nodes, two trips that begin or end at one node, and speeds
/// that are not above 0.
OneShot plan_all(const LaneNetwork& network, const Nearness& near, const std::vector<Trip>& trips,
                 const OneShotOptions& options = {});

/// Trip `later` may leave its node `departs` - 1 for node `departs` only when trip `first` has
/// arrived at its node `arrives`; nodes of a way count from 0.
struct Precedence {
  int first = 0;
  int arrives = 0;
  int later = 0;
  int departs = 0;
};

/// All of the order that the ways have: who is before whom where both cannot be.
std::vector<Precedence> order_of(const Nearness& near,
                                 const std::vector<std::vector<TimedNode>>& ways);

}  // namespace rubicon::traffic
