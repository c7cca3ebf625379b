#pragma once

#include <algorithm>
#include <vector>

#include "src/simulation/schedule/ticks.hpp"

namespace rubicon::taskplan {

using schedule::Ticks;

/// A task that has what it needs but for its zone, in which a machine stands.
struct ZoneWait {
  int task = -1;
  Ticks since = 0;
  int robot = -1;
  bool asks = false;  ///< it asks again for robots and crews
};

/// The tasks that wait until a machine has left their zone. A value.
class ZoneWaits {
 public:
  /// The robot stands in the zone of the task, which has given back what it got.
  void add(int task, Ticks now, int robot) {
    if (ZoneWait* const wait = find(task)) {
      wait->robot = robot;
      wait->asks = false;
    } else {
      waits_.push_back({task, now, robot, false});
    }
  }
  void erase(int task) {
    std::erase_if(waits_, [&](const ZoneWait& wait) { return wait.task == task; });
  }
  ZoneWait* find(int task) {
    const auto found = std::find_if(waits_.begin(), waits_.end(),
                                    [&](const ZoneWait& wait) { return wait.task == task; });
    return found == waits_.end() ? nullptr : &*found;
  }
  const ZoneWait* find(int task) const { return const_cast<ZoneWaits*>(this)->find(task); }
  std::vector<ZoneWait>& all() { return waits_; }
  const std::vector<ZoneWait>& all() const { return waits_; }

 private:
  std::vector<ZoneWait> waits_;
};

}  // namespace rubicon::taskplan
