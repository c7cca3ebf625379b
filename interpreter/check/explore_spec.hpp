#pragma once

#include <limits>
#include <string>
#include <vector>

#include "src/fleets/lanes/covering_walk.hpp"

namespace rubicon::interpreter {

/// A checked network that robots explore without a map, each by itself.
struct ExploreSpec {
  struct Explorer {
    std::string name;
    lanes::NodeIndex from = lanes::kNone;
    double speed = std::numeric_limits<double>::infinity();  ///< m/s, at most
  };
  int network = 0;  ///< index into networks
  lanes::Exploration rule = lanes::Exploration::kTarry;
  std::vector<Explorer> explorers;
};

}  // namespace rubicon::interpreter
