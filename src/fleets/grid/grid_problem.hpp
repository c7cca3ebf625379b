#pragma once

#include <string>
#include <vector>

#include "src/fleets/grid/grid_map.hpp"

namespace rubicon::grid {

/// Most agents, and most pairs of an agent and an open cell: to each belongs a distance of 2 bytes.
inline constexpr std::size_t kMostAgents = 100'000;
inline constexpr std::size_t kMostPairs = 500'000'000;
/// Longest way that a distance can say, in steps.
inline constexpr int kLongestWay = 65'000;

/// Who wants from where to where.
struct GridAgent {
  std::string name;
  Cell from;
  Cell to;
};

/// Agents on a map. They move at the same time: in one tick each stays or goes to one of the four
/// cells beside it.
struct GridProblem {
  GridMap map;
  std::vector<GridAgent> agents;
};

/// What is wrong with an agent, alone or with an earlier one; agent -1: with all of it.
struct GridFault {
  int agent = -1;
  int other = -1;
  bool at_goal = false;  ///< of its goal, else of its start
  std::string message;
};

/// Starts and goals outside or on walls, two agents at one place, goals that cannot be reached,
/// and problems that are too large. Empty: it can be solved, unless the others are in the way.
std::vector<GridFault> faults_of(const GridProblem& problem);

}  // namespace rubicon::grid
