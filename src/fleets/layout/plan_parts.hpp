#pragma once

#include <string>
#include <vector>

#include "src/fleets/layout/judge.hpp"

namespace rubicon::layout {

/// How a layout is called in the plan that it is written into.
struct PlanNames {
  std::string network;
  std::vector<std::string> gates;
  std::string aisle_class;
  std::string cross_class;
  std::vector<std::string> fleets;  ///< on the network
  double floor = 0;                 ///< m, height of the floor
  double height = 2;                ///< m, of modules
  bool with_tasks = true;
};

/// Text that goes into a plan: canonical once `rubicon fmt` has seen it.
struct PlanParts {
  std::string network;  ///< nodes and lanes, into the block of the network
  std::string plan;     ///< modules as shapes of the site, and tasks, into the plan
};

/// Of so many modules a vehicle brings something to, spread over all of them.
inline constexpr std::size_t kMostTrips = 20;

PlanParts plan_parts(const Layout& layout, const PlanNames& names);

}  // namespace rubicon::layout
