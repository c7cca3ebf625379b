#pragma once

#include <string>
#include <vector>

#include "src/simulation/schedule/network.hpp"

namespace rubicon::schedule {

/// What is wrong with the numbers of a network: indices of what is not there, a resource named
/// twice, negative work, a priority that is no number. Empty if nothing is.
std::vector<std::string> network_mistakes(const Network& network);

}  // namespace rubicon::schedule
