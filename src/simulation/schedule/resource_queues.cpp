#include "src/simulation/schedule/resource_queues.hpp"

#include <algorithm>
#include <iterator>

#include "src/simulation/schedule/index.hpp"

namespace rubicon::schedule {

namespace {

std::vector<int> calendars_of(const Network& network) {
  std::vector<int> calendars;
  for (const NetworkResource& each : network.resources) calendars.push_back(each.calendar);
  return calendars;
}

std::vector<int> sizes_of(const Network& network) {
  std::vector<int> sizes;
  for (const NetworkResource& each : network.resources) sizes.push_back(each.size);
  return sizes;
}

}  // namespace

ResourceQueues::ResourceQueues(const Network& network, std::vector<std::string>& mistakes)
    : network_(network),
      sets_(calendars_of(network), network.calendars),
      states_(sizes_of(network)),
      queues_of_(network.resources.size()),
      starts_(network.tasks.size(), 0) {
  queue_of_.reserve(network.tasks.size());
  for (const NetworkTask& task : network.tasks) {
    std::vector<Share> shares;
    for (std::size_t i = 0; i < task.resources.size(); ++i) {
      const int resource = task.resources[i];
      shares.push_back({resource, task.units.empty() ? states_.size_of(resource) : task.units[i]});
    }
    auto set = sets_.set_of(shares, task.resources);
    if (const auto* message = std::get_if<std::string>(&set)) {
      mistakes.push_back(*message);
      set = sets_.set_of(shares, {});
    }
    queue_of_.push_back(std::get<int>(set));
    while (queues_.size() < static_cast<std::size_t>(sets_.size())) {
      add_queue(static_cast<int>(queues_.size()));
    }
  }
}

void ResourceQueues::add_queue(int index) {
  queues_.emplace_back();
  for (const int resource : sets_.resources(index)) queues_of_[at(resource)].push_back(index);
}

const WorkCalendar& ResourceQueues::calendar(int task) const {
  return sets_.calendar(queue_of_[at(task)]);
}

void ResourceQueues::add(int task, Ticks start) {
  const int index = queue_of_[at(task)];
  starts_[at(task)] = start;
  queues_[at(index)].later.push({start, order_of(task), task});
  refresh(index);
}

std::optional<ResourceQueues::Next> ResourceQueues::take() {
  if (order_.empty()) return std::nullopt;
  const auto [place, index] = *order_.begin();
  Queue& queue = queues_[at(index)];
  Next next;
  next.start = std::get<Ticks>(place);
  next.task = std::get<int>(place);
  next.last = states_.last_free(sets_.shares(index));
  if (queue.waiting.empty()) {
    queue.later.pop();
  } else {
    queue.waiting.erase(queue.waiting.begin());
    queue.waiting_starts.erase({starts_[at(next.task)], next.task});
  }
  for (const Share& share : sets_.shares(index)) states_.take(share, next.task);
  refresh(index);  // one without resources is in none of their lists
  refresh_all(next.task);
  return next;
}

void ResourceQueues::release(int task, Ticks finish) {
  for (const int resource : sets_.resources(queue_of_[at(task)])) {
    states_.release(resource, task, finish, false);
  }
  refresh_all(task);
}

std::vector<std::tuple<int, int, int>> ResourceQueues::stuck() const {
  std::vector<std::tuple<int, int, int>> result;
  for (std::size_t i = 0; i < queues_.size(); ++i) {
    const Queue& queue = queues_[i];
    if (queue.waiting.empty() && queue.later.empty()) continue;
    const int first =
        queue.waiting.empty() ? std::get<int>(queue.later.top()) : queue.waiting.begin()->second;
    for (const Share& share : sets_.shares(static_cast<int>(i))) {
      if (states_.are_free({share})) continue;
      result.emplace_back(first, share.resource, states_.of(share.resource).holder());
      break;
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

void ResourceQueues::sort_out(Queue& queue, Ticks free) {
  while (!queue.waiting_starts.empty() && queue.waiting_starts.rbegin()->first > free) {
    const auto [start, task] = *queue.waiting_starts.rbegin();
    queue.waiting_starts.erase(std::prev(queue.waiting_starts.end()));
    queue.waiting.erase({order_of(task), task});
    queue.later.push({start, order_of(task), task});
  }
  while (!queue.later.empty() && std::get<Ticks>(queue.later.top()) <= free) {
    const auto [start, order, task] = queue.later.top();
    queue.later.pop();
    queue.waiting.emplace(order, task);
    queue.waiting_starts.emplace(start, task);
  }
}

void ResourceQueues::refresh(int index) {
  Queue& queue = queues_[at(index)];
  if (queue.first) order_.erase({*queue.first, index});
  queue.first.reset();
  const std::vector<Share>& shares = sets_.shares(index);
  if (!states_.are_free(shares)) return;
  const ResourceStates::Last last = states_.last_free(shares);
  Ticks free = -kEndOfTime;
  if (last.resource >= 0) free = sets_.calendar(index).next_working(last.since);
  sort_out(queue, free);
  if (!queue.waiting.empty()) {
    const auto [order, task] = *queue.waiting.begin();
    queue.first = {free, order, task};
  } else if (!queue.later.empty()) {
    queue.first = queue.later.top();
  }
  if (queue.first) order_.emplace(*queue.first, index);
}

void ResourceQueues::refresh_all(int task) {
  for (const int resource : sets_.resources(queue_of_[at(task)])) {
    for (const int queue : queues_of_[at(resource)]) refresh(queue);
  }
}

}  // namespace rubicon::schedule
