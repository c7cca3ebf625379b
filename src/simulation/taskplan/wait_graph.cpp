#include "src/simulation/taskplan/wait_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace rubicon::taskplan {

namespace {

/// Whether none of those who may bring about what a task waits for ever will.
bool never_comes(const WaitTarget& target, const Deadlocked& deadlocked) {
  if (target.by.empty()) return false;
  if (target.gives.empty()) {
    return std::all_of(target.by.begin(), target.by.end(),
                       [&](int task) { return deadlocked.contains(task); });
  }
  int given = 0;
  for (std::size_t i = 0; i < target.by.size(); ++i) {
    if (!deadlocked.contains(target.by[i])) given += target.gives[i];
  }
  return given < target.missing;
}

/// Whether a task that waits so can never go on.
bool is_deadlocked(const WaitSet& waits, const Deadlocked& deadlocked) {
  const auto never = [&](const WaitTarget& target) { return never_comes(target, deadlocked); };
  const auto& all = waits.targets;
  if (!waits.any) return std::any_of(all.begin(), all.end(), never);
  for (auto first = all.begin(); first != all.end();) {
    const auto last = first->choice < 0
                          ? std::next(first)
                          : std::find_if(first, all.end(), [&](const WaitTarget& target) {
                              return target.choice != first->choice;
                            });
    if (std::none_of(first, last, never)) return false;
    first = last;
  }
  return !all.empty();
}

}  // namespace

Deadlocked deadlocked_from(std::vector<int> roots, const WaitsOf& waits_of) {
  Deadlocked found;
  std::map<int, std::vector<int>> waiters;
  while (!roots.empty()) {
    const int task = roots.back();
    roots.pop_back();
    if (found.contains(task)) continue;
    std::optional<WaitSet> waits = waits_of(task);
    if (!waits) continue;
    if (found.size() >= kMostLookedAt) return {};
    const WaitSet& kept = found.emplace(task, *std::move(waits)).first->second;
    for (const WaitTarget& target : kept.targets) {
      for (const int by : target.by) waiters[by].push_back(task);
      roots.insert(roots.end(), target.by.begin(), target.by.end());
    }
  }
  std::vector<int> open;
  for (const auto& [task, waits] : found) open.push_back(task);
  while (!open.empty()) {
    const int task = open.back();
    open.pop_back();
    const auto place = found.find(task);
    if (place == found.end() || is_deadlocked(place->second, found)) continue;
    found.erase(place);
    // Whoever waits for a task that goes on may go on too.
    const std::vector<int>& waiting = waiters[task];
    open.insert(open.end(), waiting.begin(), waiting.end());
  }
  return found;
}

WaitCycle cycle_in(const Deadlocked& deadlocked) {
  WaitCycle cycle;
  int task = deadlocked.begin()->first;
  while (true) {
    const auto seen = std::find_if(cycle.begin(), cycle.end(),
                                   [&](const WaitLink& link) { return link.task == task; });
    if (seen != cycle.end()) {
      cycle.erase(cycle.begin(), seen);
      break;
    }
    const std::vector<WaitTarget>& all = deadlocked.at(task).targets;
    const auto target = std::find_if(all.begin(), all.end(), [&](const WaitTarget& each) {
      return never_comes(each, deadlocked);
    });
    WaitTarget& link = cycle.emplace_back(WaitLink{task, *target}).target;
    // The next of the cycle goes first: another may yet give back what it has, and too little.
    const auto next = std::find_if(link.by.begin(), link.by.end(),
                                   [&](int each) { return deadlocked.contains(each); });
    std::rotate(link.by.begin(), next, link.by.end());
    task = link.by.front();
  }
  const auto first =
      std::min_element(cycle.begin(), cycle.end(),
                       [](const WaitLink& a, const WaitLink& b) { return a.task < b.task; });
  std::rotate(cycle.begin(), first, cycle.end());
  return cycle;
}

WaitWalk walk_from(int task, const WaitsOf& waits_of) {
  WaitWalk walk;
  while (true) {
    walk.tasks.push_back(task);
    const WaitSet waits = waits_of(task).value_or(WaitSet());
    const auto next = std::find_if(waits.targets.begin(), waits.targets.end(),
                                   [](const WaitTarget& target) { return !target.by.empty(); });
    if (next == waits.targets.end()) {
      walk.cycle.clear();
      return walk;
    }
    walk.cycle.push_back({task, *next});
    task = next->by.front();
    const auto seen = std::find(walk.tasks.begin(), walk.tasks.end(), task);
    if (seen == walk.tasks.end()) continue;
    walk.cycle.erase(walk.cycle.begin(), walk.cycle.begin() + (seen - walk.tasks.begin()));
    return walk;
  }
}

std::string text_of(const WaitCycle& cycle,
                    const std::function<std::string(const WaitLink&)>& text_of_link) {
  const bool machines = std::all_of(cycle.begin(), cycle.end(),
                                    [](const WaitLink& link) { return link.target.machine; });
  std::vector<std::string> texts;
  for (const WaitLink& link : cycle) texts.push_back(text_of_link(link));
  return fmt::format("{} wait for each other: {}", machines ? "machines" : "tasks",
                     fmt::join(texts, machines ? ", " : "; "));
}

std::vector<int> helpful_in(const WaitCycle& cycle) {
  std::vector<int> helpful;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    if (!cycle[i].target.idle) helpful.push_back(cycle[(i + 1) % cycle.size()].task);
  }
  return helpful.empty() ? tasks_of(cycle) : helpful;
}

std::vector<int> tasks_of(const WaitCycle& cycle) {
  std::vector<int> tasks;
  for (const WaitLink& link : cycle) tasks.push_back(link.task);
  return tasks;
}

}  // namespace rubicon::taskplan
