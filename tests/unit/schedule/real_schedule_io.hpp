#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/simulation/schedule/civil_time.hpp"
#include "src/simulation/schedule/network.hpp"

namespace rubicon::test {

/// The schedule of a real building as its planner's program wrote it, with the dates which that
/// program calculated. Only what this one file holds is understood.
struct RealSchedule {
  struct Task {
    std::string name;
    schedule::CivilTime start, finish;
  };
  schedule::CivilTime start;
  schedule::Network
      network;               ///< its tasks first; then one milestone for each date a task waits for
  std::map<int, int> tasks;  ///< the file's number of a task -> index into the network
  std::map<int, Task> dates;  ///< of tasks with work, by the file's number
};

/// Reads the file; nothing if it is not there.
std::optional<RealSchedule> read_real_schedule(const std::string& path);

}  // namespace rubicon::test
