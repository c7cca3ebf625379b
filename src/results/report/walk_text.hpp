#pragma once

#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"

namespace rubicon::report {

/// How one robot explored its network.
struct ExplorerWalk {
  std::vector<lanes::WalkStep> steps;        ///< along travelways
  std::vector<lanes::Nanoseconds> arrivals;  ///< to each: when it ends
  double length = 0;                         ///< m
  int ways = 0;                              ///< travelways that can be reached
  std::vector<lanes::NodeIndex> unseen;      ///< nodes that cannot be reached
};

/// A network that was explored.
struct WalkResult {
  const interpreter::ExploreSpec& spec;
  const interpreter::NetworkSpec& description;
  const lanes::LaneNetwork& network;
  lanes::Travelways travelways;
  std::vector<ExplorerWalk> walks;  ///< by explorer
};

/// Sends all explorers, each from its node at 0 s, by the rule of the network.
WalkResult explore(const interpreter::ExploreSpec& spec,
                   const interpreter::NetworkSpec& description, const lanes::LaneNetwork& network);

/// For people; the nodes of short walks in their order.
std::string walk_table(const WalkResult& result);
/// Each step of each robot; times in seconds.
std::string walk_csv(const WalkResult& result);
/// All of it; times in whole nanoseconds. What rubicon verify reads.
std::string walk_json(const WalkResult& result);

}  // namespace rubicon::report
