#include "src/simulation/schedule/network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "src/simulation/schedule/index.hpp"
#include "src/simulation/schedule/link_order.hpp"
#include "src/simulation/schedule/link_state.hpp"
#include "src/simulation/schedule/network_check.hpp"
#include "src/simulation/schedule/resource_queues.hpp"

namespace rubicon::schedule {

namespace {

std::vector<Ticks> work_of(const Network& network) {
  std::vector<Ticks> work;
  for (const NetworkTask& task : network.tasks) work.push_back(task.work);
  return work;
}

/// The forward pass: events become known one by one, and with them those that waited for them.
class ForwardPass : private LinkState::Listener {
 public:
  ForwardPass(const Network& network, ResourceQueues& queues)
      : queues_(queues),
        links_(network, work_of(network), {},
               [&queues](int task) -> const WorkCalendar& { return queues.calendar(task); }) {}

  void run() {
    for (int task = 0; task < links_.size(); ++task) {
      if (links_.may_start(task)) may_start(task, -1);
    }
    propagate();
    while (const auto next = queues_.take()) {
      TaskTimes times = links_.times(next->task);
      if (next->last.resource >= 0 && next->last.since > times.ready) {
        times.wanted = next->last.since;
        times.held = Held::resource;
        times.link = -1;
        times.resource = next->last.resource;
        times.task_before = next->last.task_before;
      }
      start(next->task, std::move(times), next->start);
      propagate();
    }
  }

  const std::vector<TaskTimes>& times() const { return links_.all_times(); }
  bool all_finished() const { return finished_ == times().size(); }

 private:
  /// All that holds its start is known: it waits for what it needs.
  void may_start(int task, int /*before*/) override {
    TaskTimes times = links_.ready_times(task, -1, 0);
    const Ticks earliest = times.start;
    if (links_.is_milestone(task)) {
      start(task, std::move(times), earliest);
    } else {
      links_.set_times(task, std::move(times));
      queues_.add(task, earliest);
    }
  }

  void start(int task, TaskTimes times, Ticks when) {
    if (!links_.is_milestone(task)) {
      times.first_gain = times.wanted - queues_.calendar(task).last_working(times.wanted);
    }
    links_.set_times(task, std::move(times));
    links_.publish(task, TaskEnd::start, when);
    if (links_.may_finish(task)) may_finish(task);
  }

  void may_finish(int task) override {
    if (!links_.is_known(task, TaskEnd::start)) return;
    TaskTimes times = links_.times(task);
    const Ticks done = queues_.calendar(task).finish(times.start, links_.work(task));
    const LinkBounds held_by = links_.bounds_of(task, true);
    const Ticks finish = held_finish(held_by, done);
    if (finish > done || links_.started_for_finish(times, task)) {
      times.finish_link = held_by.finish_link;
    }
    ++finished_;
    links_.set_times(task, std::move(times));
    links_.publish(task, TaskEnd::finish, finish);
    if (!links_.is_milestone(task)) queues_.release(task, finish);
  }

  void propagate() {
    links_.propagate(*this);
    links_.forget_before(links_.mark());
  }

  ResourceQueues& queues_;
  LinkState links_;
  std::size_t finished_ = 0;
};

}  // namespace

std::variant<NetworkTimes, NetworkMistakes> times_of(const Network& network) {
  NetworkMistakes mistakes{network_mistakes(network)};
  if (!mistakes.messages.empty()) return mistakes;
  for (const std::vector<int>& ring : link_order(network.tasks).rings) {
    mistakes.messages.push_back(ring_text(network.tasks, ring));
  }
  ResourceQueues queues(network, mistakes.messages);
  if (!mistakes.messages.empty()) return mistakes;

  ForwardPass pass(network, queues);
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
