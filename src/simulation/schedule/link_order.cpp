#include "src/simulation/schedule/link_order.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/simulation/schedule/components.hpp"
#include "src/simulation/schedule/index.hpp"

namespace rubicon::schedule {

namespace {

int event(int task, TaskEnd end) { return 2 * task + (end == TaskEnd::finish ? 1 : 0); }

/// From each event to those it waits for: a finish for its own start, and what links say.
Graph events(const std::vector<NetworkTask>& tasks) {
  Graph graph(2 * tasks.size());
  for (int task = 0; task < static_cast<int>(tasks.size()); ++task) {
    graph[at(event(task, TaskEnd::finish))].push_back(event(task, TaskEnd::start));
    for (const Link& link : tasks[at(task)].after) {
      graph[at(event(task, end_after(link.type)))].push_back(
          event(link.task, end_before(link.type)));
    }
  }
  return graph;
}

/// From each task to those that its links name.
Graph predecessors(const std::vector<NetworkTask>& tasks) {
  Graph graph(tasks.size());
  for (std::size_t task = 0; task < tasks.size(); ++task) {
    for (const Link& link : tasks[task].after) graph[task].push_back(link.task);
  }
  return graph;
}

/// Whether each node can be reached from itself.
std::vector<bool> on_rings(const Graph& graph, const std::vector<int>& components) {
  std::vector<int> sizes(graph.size(), 0);
  for (const int component : components) ++sizes[at(component)];
  std::vector<bool> result(graph.size());
  for (std::size_t node = 0; node < graph.size(); ++node) {
    const bool to_itself = std::find(graph[node].begin(), graph[node].end(),
                                     static_cast<int>(node)) != graph[node].end();
    result[node] = sizes[at(components[node])] > 1 || to_itself;
  }
  return result;
}

/// The tasks of a ring of events, each once where its start and finish follow each other.
std::vector<int> tasks_of(const std::vector<int>& ring) {
  std::vector<int> tasks;
  for (const int each : ring) {
    if (tasks.empty() || tasks.back() != each / 2) tasks.push_back(each / 2);
  }
  if (tasks.size() > 1 && tasks.back() == tasks.front()) tasks.pop_back();
  return tasks;
}

}  // namespace

LinkOrder link_order(const std::vector<NetworkTask>& tasks) {
  LinkOrder order;
  const Graph graph = events(tasks);
  const std::vector<int> components = strong_components(graph);
  const std::vector<bool> ringed = on_rings(graph, components);
  std::vector<bool> named(graph.size(), false);
  for (int node = 0; node < static_cast<int>(graph.size()); ++node) {
    if (!ringed[at(node)] || named[at(components[at(node)])]) continue;
    named[at(components[at(node)])] = true;
    order.rings.push_back(tasks_of(ring_through(graph, components, node)));
  }
  const Graph before = predecessors(tasks);
  order.tied_both_ways = on_rings(before, strong_components(before));
  return order;
}

std::string ring_text(const std::vector<NetworkTask>& tasks, const std::vector<int>& ring) {
  constexpr std::size_t kMostNamed = 12;
  if (ring.size() == 1) return fmt::format("task '{}' waits for itself", tasks[at(ring[0])].name);
  std::string text = "these tasks wait for each other: ";
  for (std::size_t i = 0; i < ring.size() && i < kMostNamed; ++i) {
    text += tasks[at(ring[i])].name + " after ";
  }
  if (ring.size() > kMostNamed)
    text += fmt::format("... ({} more) after ", ring.size() - kMostNamed);
  return text + tasks[at(ring[0])].name;
}

}  // namespace rubicon::schedule
