#pragma once

#include <optional>
#include <queue>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "src/simulation/schedule/network.hpp"

namespace rubicon::schedule {

/// Who goes next: tasks wait here for what they need, and are taken in the order in which they can
/// start, then by priority, then by file order. Tasks that need the same resources wait in one
/// queue, so that only its first needs to be looked at.
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

  /// The next task, and since when all it needs is free.
  struct Next {
    int task = -1;
    Ticks start = 0;
    Ticks free = 0;        ///< 0 if nobody had what it needs
    int resource = -1;     ///< what was free last; -1: nobody had anything it needs
    int task_before = -1;  ///< who had it
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
  struct Resource {
    Ticks free = 0;
    int last = -1;      // the task that has or had it
    bool held = false;  // and when it gives it back is not known
    std::vector<int> queues;
  };
  /// (time, -priority, task): the least goes first.
  using Place = std::tuple<Ticks, double, int>;
  using Heap = std::priority_queue<Place, std::vector<Place>, std::greater<>>;
  struct Queue {
    std::vector<int> resources;
    int calendar = 0;
    Heap later;    // by the start that links allow
    Heap waiting;  // these could start as soon as the resources are free; times are all 0
    std::optional<Place> first;  // as it stands in order_
  };

  int add_queue(const std::vector<int>& resources, std::vector<std::string>& mistakes);
  int common_calendar(const std::vector<int>& resources, std::vector<std::string>& mistakes);
  void refresh(int index);
  void refresh_all(int task);
  /// The resource of the queue that is free last, -1 if all were always free.
  int last_free(const Queue& queue) const;

  const Network& network_;
  std::vector<WorkCalendar> calendars_;
  std::vector<std::pair<std::vector<int>, int>> calendar_sets_;  // sorted; sets of calendars
  std::vector<Resource> resources_;
  std::vector<Queue> queues_;
  std::vector<int> queue_of_;              // to each task
  std::set<std::pair<Place, int>> order_;  // the first of each queue that can go on, queue
};

}  // namespace rubicon::schedule
