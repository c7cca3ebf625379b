#include "src/simulation/schedule/network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "src/simulation/schedule/link_order.hpp"
#include "src/simulation/schedule/network_check.hpp"
#include "src/simulation/schedule/resource_queues.hpp"

namespace rubicon::schedule {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// The forward pass: events become known one by one, and with them those that waited for them.
class ForwardPass {
 public:
  ForwardPass(const Network& network, ResourceQueues& queues, std::vector<bool> tied_both_ways)
      : tasks_(network.tasks),
        queues_(queues),
        tied_(std::move(tied_both_ways)),
        times_(tasks_.size()),
        to_start_(tasks_.size(), 0),
        to_finish_(tasks_.size(), 0),
        started_(tasks_.size(), false),
        followers_(tasks_.size()) {
    for (int task = 0; task < static_cast<int>(tasks_.size()); ++task) {
      for (const Link& link : tasks_[at(task)].after) {
        followers_[at(link.task)].emplace_back(task, link.type);
        if (waits_to_start(task, link.type)) ++to_start_[at(task)];
        if (end_after(link.type) == TaskEnd::finish) ++to_finish_[at(task)];
      }
    }
  }

  void run() {
    for (int task = 0; task < static_cast<int>(tasks_.size()); ++task) {
      if (to_start_[at(task)] == 0) make_ready(task);
    }
    spread();
    while (const auto next = queues_.take()) {
      TaskTimes& times = times_[at(next->task)];
      if (next->resource >= 0 && next->free > times.ready) {
        times.wanted = next->free;
        times.held = Held::resource;
        times.link = -1;
        times.resource = next->resource;
        times.task_before = next->task_before;
      }
      start(next->task, next->start);
      spread();
    }
  }

  const std::vector<TaskTimes>& times() const { return times_; }
  bool all_finished() const { return finished_ == tasks_.size(); }

 private:
  bool waits_to_start(int task, LinkType type) const {
    return end_after(type) == TaskEnd::start || !tied_[at(task)];
  }

  LinkBounds bounds(int task, bool with_finish) const {
    LinkBounds result;
    const std::vector<Link>& links = tasks_[at(task)].after;
    for (std::size_t i = 0; i < links.size(); ++i) {
      const TaskEnd end = end_after(links[i].type);
      if (end == TaskEnd::finish && !with_finish) continue;
      const TaskTimes& before = times_[at(links[i].task)];
      const Ticks event =
          end_before(links[i].type) == TaskEnd::start ? before.start : before.finish;
      result.hold(end, bound_of(links[i], event, queues_.calendar(task)), static_cast<int>(i));
    }
    return result;
  }

  void make_ready(int task) {
    const LinkBounds held_by = bounds(task, !tied_[at(task)]);
    const Ticks work = tasks_[at(task)].work;
    const EarliestStart earliest = earliest_start(held_by, 0, work, queues_.calendar(task));
    TaskTimes& times = times_[at(task)];
    times.ready = times.wanted = earliest.wanted;
    if (earliest.hold != StartHold::not_before) {
      times.held = Held::link;
      times.link =
          earliest.hold == StartHold::start_link ? held_by.start_link : held_by.finish_link;
    }
    if (work == 0) {
      start(task, earliest.start);
    } else {
      queues_.add(task, earliest.start);
    }
  }

  void start(int task, Ticks when) {
    TaskTimes& times = times_[at(task)];
    times.start = when;
    if (tasks_[at(task)].work > 0) {
      times.first_gain = times.wanted - queues_.calendar(task).last_working(times.wanted);
    }
    started_[at(task)] = true;
    known_.emplace_back(task, TaskEnd::start);
    if (to_finish_[at(task)] == 0) finish(task);
  }

  void finish(int task) {
    TaskTimes& times = times_[at(task)];
    const Ticks done = queues_.calendar(task).finish(times.start, tasks_[at(task)].work);
    const LinkBounds held_by = bounds(task, true);
    times.finish = held_finish(held_by, done);
    const bool started_for_finish =
        times.held == Held::link &&
        end_after(tasks_[at(task)].after[at(times.link)].type) == TaskEnd::finish;
    if (times.finish > done || started_for_finish) times.finish_link = held_by.finish_link;
    ++finished_;
    known_.emplace_back(task, TaskEnd::finish);
    if (tasks_[at(task)].work > 0) queues_.release(task, times.finish);
  }

  /// Tells those that wait for what became known, until nothing new does.
  void spread() {
    while (!known_.empty()) {
      const auto [task, end] = known_.back();
      known_.pop_back();
      for (const auto& [follower, type] : followers_[at(task)]) {
        if (end_before(type) != end) continue;
        if (end_after(type) == TaskEnd::finish && --to_finish_[at(follower)] == 0 &&
            started_[at(follower)]) {
          finish(follower);
        }
        if (waits_to_start(follower, type) && --to_start_[at(follower)] == 0) make_ready(follower);
      }
    }
  }

  const std::vector<NetworkTask>& tasks_;
  ResourceQueues& queues_;
  std::vector<bool> tied_;
  std::vector<TaskTimes> times_;
  std::vector<int> to_start_;   // events that are not known yet, without which it cannot start
  std::vector<int> to_finish_;  // and without which it cannot finish
  std::vector<bool> started_;
  std::vector<std::vector<std::pair<int, LinkType>>> followers_;
  std::vector<std::pair<int, TaskEnd>> known_;  // and not told yet
  std::size_t finished_ = 0;
};

}  // namespace

std::variant<NetworkTimes, NetworkMistakes> times_of(const Network& network) {
  NetworkMistakes mistakes{network_mistakes(network)};
  if (!mistakes.messages.empty()) return mistakes;
  LinkOrder order = link_order(network.tasks);
  for (const std::vector<int>& ring : order.rings) {
    mistakes.messages.push_back(ring_text(network.tasks, ring));
  }
  ResourceQueues queues(network, mistakes.messages);
  if (!mistakes.messages.empty()) return mistakes;

  ForwardPass pass(network, queues, std::move(order.tied_both_ways));
  pass.run();
  if (!pass.all_finished()) {
    for (const auto& [task, resource, holder] : queues.stuck()) {
      mistakes.messages.push_back(
          fmt::format("task '{}' never gets '{}': '{}' holds it until its links let it finish, "
                      "and they wait for tasks that cannot go on",
                      network.tasks[at(task)].name, network.resources[at(resource)].name,
                      network.tasks[at(holder)].name));
    }
    assert(!mistakes.messages.empty());
    return mistakes;
  }
  NetworkTimes result{pass.times(), 0};
  for (std::size_t task = 0; task < result.tasks.size(); ++task) {
    result.finish = std::max(result.finish, result.tasks[task].finish);
    if (result.tasks[task].finish < kEndOfTime) continue;
    mistakes.messages.push_back(fmt::format("task '{}' is not done within 126 years of the start",
                                            network.tasks[task].name));
    return mistakes;
  }
  return result;
}

}  // namespace rubicon::schedule
