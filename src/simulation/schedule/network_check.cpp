#include "src/simulation/schedule/network_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rubicon::schedule {

namespace {

bool is_index(int index, std::size_t count) {
  return index >= 0 && static_cast<std::size_t>(index) < count;
}

bool repeats(std::vector<int> indices) {
  std::sort(indices.begin(), indices.end());
  return std::adjacent_find(indices.begin(), indices.end()) != indices.end();
}

}  // namespace

std::vector<std::string> network_mistakes(const Network& network) {
  std::vector<std::string> messages;
  for (const NetworkResource& resource : network.resources) {
    if (resource.calendar != -1 && !is_index(resource.calendar, network.calendars.size())) {
      messages.push_back(fmt::format("'{}' works by calendar number {}, which is not there",
                                     resource.name, resource.calendar));
    }
  }
  for (const NetworkTask& task : network.tasks) {
    if (task.work < 0) {
      messages.push_back(fmt::format("task '{}' has a negative amount of work", task.name));
    }
    if (!std::isfinite(task.priority)) {
      messages.push_back(fmt::format("the priority of task '{}' is no number", task.name));
    }
    if (repeats(task.resources)) {
      messages.push_back(fmt::format("task '{}' needs the same resource twice", task.name));
    }
    for (const int resource : task.resources) {
      if (is_index(resource, network.resources.size())) continue;
      messages.push_back(fmt::format("task '{}' needs resource number {}, which is not there",
                                     task.name, resource));
    }
    if (!task.units.empty() && task.units.size() != task.resources.size()) {
      messages.push_back(
          fmt::format("task '{}' does not say of all its resources how much it needs", task.name));
    }
    for (std::size_t i = 0; i < std::min(task.units.size(), task.resources.size()); ++i) {
      if (!is_index(task.resources[i], network.resources.size())) continue;
      const NetworkResource& resource =
          network.resources[static_cast<std::size_t>(task.resources[i])];
      if (task.units[i] >= 1 && task.units[i] <= resource.size) continue;
      messages.push_back(fmt::format("task '{}' needs {} of '{}', which has {}", task.name,
                                     task.units[i], resource.name, resource.size));
    }
    for (const Link& link : task.after) {
      if (is_index(link.task, network.tasks.size())) continue;
      messages.push_back(fmt::format("task '{}' comes after task number {}, which is not there",
                                     task.name, link.task));
    }
  }
  return messages;
}

}  // namespace rubicon::schedule
