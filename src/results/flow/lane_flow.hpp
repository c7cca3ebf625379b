#pragma once

#include <string>
#include <vector>

#include "src/results/replay/replay.hpp"

namespace rubicon::flow {

using interpreter::Ticks;

/// What a vehicle of a fleet did with its time.
struct VehicleFlow {
  std::string fleet;
  std::string name;
  int tasks = 0;        ///< those that happened, and parking
  Ticks held = 0;       ///< it had a task
  Ticks moving = 0;     ///< of that
  int waits = 0;        ///< times it stood for another machine
  Ticks waited = 0;     ///< in all
  double distance = 0;  ///< m, in the plan view
};

/// Where vehicles stood for other machines: at the node that is nearest, of equal ones the first.
struct NodeWaits {
  std::string network;
  std::string node;
  int waits = 0;
  Ticks waited = 0;
  Ticks longest = 0;
  int most = 0;  ///< vehicles at the same time
};

/// So many vehicles of a network wait from a moment on.
struct QueueLength {
  Ticks time = 0;
  int count = 0;
};

struct NetworkQueue {
  std::string network;
  std::vector<QueueLength> lengths;  ///< from time 0 on, an entry for each change
};

/// Of a plan with fleets; else empty.
struct LaneFlow {
  std::vector<VehicleFlow> vehicles;  ///< as in the plan
  std::vector<NodeWaits> nodes;       ///< those where any waited, the longest in all first
  std::vector<NetworkQueue> queues;   ///< of each network with fleets
};

/// What happened counts: the waits of a rejected task do not.
LaneFlow lane_flow(const replay::Replay& replay);

}  // namespace rubicon::flow
