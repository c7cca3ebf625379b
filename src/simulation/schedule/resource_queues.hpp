#pragma once

#include <optional>
#include <queue>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "src/simulation/schedule/network.hpp"
#include "src/simulation/schedule/resource_sets.hpp"
#include "src/simulation/schedule/resource_states.hpp"

namespace rubicon::schedule {

/// Who goes next: tasks wait here for what they need, and are taken in the order in which they can
/// start, then by priority, then by file order. Here, unlike where a plan is simulated
/// (taskplan/resource_allocator.hpp), it is known at the start when something is given back: it may
/// be given again for a later moment, and time may go back.
class ResourceQueues {
 public:
  /// The network must be without `network_mistakes` and outlive this. Resources whose calendars
  /// have no common hours are told in `mistakes`; their tasks then wait by a calendar that always
  /// works.
  ResourceQueues(const Network& network, std::vector<std::string>& mistakes);

  /// When all that the task needs works.
  const WorkCalendar& calendar(int task) const;

  /// The task waits from now on; `start` (in shift) is the first moment its links allow.
  void add(int task, Ticks start);

  /// The next task, when it starts and since when all it needs is free.
  struct Next {
    int task = -1;
    Ticks start = 0;
    ResourceStates::Last last;  ///< what of it came free last
  };
  /// Takes the next task out; it holds what it needs until it is released. Nothing if none can
  /// start.
  std::optional<Next> take();

  /// The task gives back what it holds at its finish.
  void release(int task, Ticks finish);

  /// Of each queue that cannot go on: its first task, the resource it waits for, the task that has
  /// it.
  std::vector<std::tuple<int, int, int>> stuck() const;

 private:
  /// (time, -priority, task): the least goes first.
  using Place = std::tuple<Ticks, double, int>;
  using Heap = std::priority_queue<Place, std::vector<Place>, std::greater<>>;
  struct Queue {
    Heap later;  // by the start that links allow
    // These could start as soon as the resources are free: (-priority, task), and by that start.
    std::set<std::pair<double, int>> waiting;
    std::set<std::pair<Ticks, int>> waiting_starts;
    std::optional<Place> first;  // as it stands in order_
  };

  void add_queue(int index);
  double order_of(int task) const {
    return -network_.tasks[static_cast<std::size_t>(task)].priority;
  }
  /// From those that come later to those that wait, and back: what is given back in the meantime
  /// may be free earlier than what was free before.
  void sort_out(Queue& queue, Ticks free);
  void refresh(int index);
  void refresh_all(int task);

  const Network& network_;
  ResourceSets sets_;
  ResourceStates states_;
  std::vector<std::vector<int>> queues_of_;  // to each resource
  std::vector<Queue> queues_;                // to each set
  std::vector<int> queue_of_;                // to each task
  std::vector<Ticks> starts_;                // of each task, that links allow
  std::set<std::pair<Place, int>> order_;    // the first of each queue that can go on, queue
};

}  // namespace rubicon::schedule
