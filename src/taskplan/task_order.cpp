#include "src/taskplan/task_order.hpp"

#include <functional>
#include <queue>

namespace rubicon::taskplan {

std::vector<int> task_order(const std::vector<interpreter::TaskSpec>& tasks) {
  std::vector<std::vector<std::size_t>> followers(tasks.size());
  std::vector<int> open(tasks.size(), 0);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    for (const interpreter::LinkSpec& link : tasks[i].after) {
      followers[static_cast<std::size_t>(link.task)].push_back(i);
      ++open[i];
    }
  }
  std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> ready;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (open[i] == 0) ready.push(i);
  }
  std::vector<int> order;
  while (!ready.empty()) {
    const std::size_t next = ready.top();
    ready.pop();
    order.push_back(static_cast<int>(next));
    for (const std::size_t follower : followers[next]) {
      if (--open[follower] == 0) ready.push(follower);
    }
  }
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (open[i] > 0) order.push_back(static_cast<int>(i));
  }
  return order;
}

}  // namespace rubicon::taskplan
