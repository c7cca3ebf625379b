#include "src/exchange/project_io/plan_crews.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "src/exchange/project_io/crew_lanes.hpp"
#include "src/exchange/project_io/plan_terms.hpp"

namespace rubicon::project_io {

namespace {

using TaskAndResource = std::pair<std::size_t, std::size_t>;

/// Who works on what, each pair once, in the order of the assignments.
std::vector<TaskAndResource> workers_of(const Project& project) {
  std::unordered_map<std::int64_t, std::size_t> tasks;
  std::unordered_map<std::int64_t, std::size_t> resources;
  for (std::size_t i = 0; i < project.tasks.size(); ++i) tasks.emplace(project.tasks[i].uid, i);
  for (std::size_t i = 0; i < project.resources.size(); ++i) {
    resources.emplace(project.resources[i].uid, i);
  }
  std::vector<TaskAndResource> pairs;
  std::set<TaskAndResource> known;
  for (const Assignment& each : project.assignments) {
    if (each.resource == kNone) continue;
    const TaskAndResource pair(tasks.at(each.task), resources.at(each.resource));
    if (project.resources[pair.second].type != ResourceType::work) continue;
    if (known.insert(pair).second) pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace

PlanCrews plan_crews(const Project& project, const PlanNetwork& network, Levelling levelling,
                     Identifiers& taken) {
  PlanCrews crews;
  const auto new_name = [&](const Resource& resource) {
    return taken.make(resource.name, fmt::format("crew_{}", resource.uid));
  };
  for (const Resource& resource : project.resources) crews.names.push_back({new_name(resource)});
  const std::vector<TaskAndResource> pairs = workers_of(project);
  std::map<TaskAndResource, std::size_t> lane_of;
  if (levelling == Levelling::none) {
    std::vector<std::vector<std::size_t>> lines(project.resources.size());
    // A milestone holds nobody: it needs no lane.
    for (const auto& [task, resource] : pairs) {
      if (network.tasks[task].planned && plan_seconds(project.tasks[task]) > 0) {
        lines[resource].push_back(task);
      }
    }
    const CrewLanes lanes(network);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      std::sort(lines[i].begin(), lines[i].end());
      const std::vector<std::size_t> found = lanes.lanes_of(lines[i]);
      for (std::size_t k = 0; k < found.size(); ++k) {
        lane_of[{lines[i][k], i}] = found[k];
        while (crews.names[i].size() <= found[k]) {
          crews.names[i].push_back(new_name(project.resources[i]));
        }
      }
    }
  }
  crews.of_task.resize(project.tasks.size());
  for (const TaskAndResource& pair : pairs) {
    const auto lane = lane_of.find(pair);
    crews.of_task[pair.first].push_back(
        crews.names[pair.second][lane == lane_of.end() ? 0 : lane->second]);
  }
  return crews;
}

}  // namespace rubicon::project_io
