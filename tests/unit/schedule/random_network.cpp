#include "tests/unit/schedule/random_network.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "src/simulation/schedule/index.hpp"
#include "tests/unit/schedule/calendar_cases.hpp"

namespace rubicon::test {

using schedule::kMinute;
using schedule::LagClock;
using schedule::Link;
using schedule::LinkType;
using schedule::Network;
using schedule::NetworkTask;

namespace {

using schedule::at;

}  // namespace

Network Dice::network(const RandomNetworkWanted& wanted) {
  Network network;
  network.calendars = {calendar(daily_shift(), kRandomStart),
                       calendar(weekday_shift(), kRandomStart)};
  for (int i = 0; i < 5; ++i) {
    network.resources.push_back(
        {std::string(1, static_cast<char>('A' + i)), wanted.calendars ? below(3) - 1 : -1});
  }
  if (wanted.shares) {
    for (schedule::NetworkResource& each : network.resources) each.size = 1 + below(4);
  }
  const int count = 1 + below(40);
  std::vector<int> order;
  for (int i = 0; i < count; ++i) order.push_back(i);
  std::shuffle(order.begin(), order.end(), engine_);
  network.tasks.resize(at(count));
  std::vector<int> priorities = order;
  std::shuffle(priorities.begin(), priorities.end(), engine_);
  for (int place = 0; place < count; ++place) {
    NetworkTask& task = network.tasks[at(order[at(place)])];
    task.name = "t" + std::to_string(order[at(place)]);
    task.work = below(8) == 0 ? 0 : (1 + below(600)) * kMinute;
    task.priority = priorities[at(place)];
    for (int i = 0; i < 5; ++i) {
      if (below(3) == 0) task.resources.push_back(i);
    }
    if (!wanted.resources) task.resources.clear();
    if (wanted.shares) {
      for (const int resource : task.resources) {
        task.units.push_back(1 + below(network.resources[at(resource)].size));
      }
    }
    for (int links = place == 0 ? 0 : below(4); links > 0; --links) {
      Link link;
      link.task = order[at(below(place))];
      link.type = static_cast<LinkType>(below(wanted.forward ? 2 : 4));
      if (wanted.lags && below(2) == 0) {
        link.lag = (below(2400) - (wanted.forward ? 0 : 1000)) * kMinute;
      }
      link.clock = below(3) == 0 ? LagClock::working : LagClock::elapsed;
      task.after.push_back(link);
    }
  }
  return network;
}

}  // namespace rubicon::test
