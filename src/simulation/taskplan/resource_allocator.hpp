#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "src/simulation/schedule/work_calendar.hpp"
#include "src/simulation/taskplan/journal.hpp"

namespace rubicon::taskplan {

using schedule::Ticks;

/// Who has a robot or a crew.
struct ResourceState {
  int holder = -1;  ///< the task that has it, -1: it is free
  int last = -1;    ///< the task that has or had it, -1: nobody yet
  Ticks free_since = 0;
  bool midway = false;  ///< it was given back before that task's finish
};

/// Gives robots and crews to the tasks that wait for them: all a task asks for at once or nothing;
/// of several tasks that can have what they ask for at a moment the one of the higher priority,
/// then the one that stands first in the file. Resources are numbered robots first, then crews.
class ResourceAllocator {
 public:
  /// `calendar_of` each resource: index into `calendars`, -1: day and night.
  ResourceAllocator(std::vector<std::string> names, std::vector<int> calendar_of,
                    std::vector<schedule::WorkCalendar> calendars);

  /// The queue of those who ask for all of `resources` and need the working hours of all of
  /// `hours_of` (resources too). A message for the user if these have no common hours.
  std::variant<int, std::string> queue_for(std::vector<int> resources, std::vector<int> hours_of);

  /// The working hours of a queue.
  const schedule::WorkCalendar& calendar(int queue) const;
  /// The working hours of a robot or crew.
  const schedule::WorkCalendar& hours(int resource) const;
  const std::vector<int>& resources(int queue) const {
    return queues_[static_cast<std::size_t>(queue)].resources;
  }

  /// The task asks from `from` on.
  void ask(int queue, int task, double priority, Ticks from);
  /// Whatever it asks for, it is never given anything any more, also after the run went back.
  void exclude(int task) { excluded_.insert(task); }

  struct Grant {
    int task = -1;
    int queue = -1;
    int resource = -1;     ///< what was free last of what it asked for; -1: nobody had any of it
    int task_before = -1;  ///< who had it
    Ticks free = 0;        ///< since when all of it is free
    bool midway = false;   ///< it was given back before that task's finish
    std::vector<ResourceState> before;  ///< all states before it was given
  };
  /// Gives the next task what it asks for, in the working hours of its queue only.
  std::optional<Grant> take(Ticks now);

  /// `midway`: the task that gives it back goes on.
  void release(int resource, Ticks now, bool midway);

  /// The next moment after `now` at which somebody could be given something if nothing is given
  /// back before; kEndOfTime if never.
  Ticks next_chance(Ticks now);

  const std::string& name(int resource) const { return names_[static_cast<std::size_t>(resource)]; }
  const ResourceState& state(int resource) const {
    return states_[static_cast<std::size_t>(resource)];
  }
  // to go back: requests are journaled, states copied
  Journal::Mark mark() const { return journal_.mark(); }
  void undo_to(Journal::Mark mark) { journal_.undo_to(mark); }
  void forget_before(Journal::Mark mark) { journal_.forget_before(mark); }
  const std::vector<ResourceState>& states() const { return states_; }
  void set_states(std::vector<ResourceState> states) { states_ = std::move(states); }
  /// Takes a free resource without asking.
  void take_directly(int resource, int task);

 private:
  using Place = std::pair<double, int>;  ///< (-priority, task): the least goes first
  struct Queue {
    std::vector<int> resources;
    int calendar = 0;
    std::set<Place> waiting;
    std::set<std::tuple<Ticks, double, int>> later;  ///< by the moment from which they ask
  };

  std::variant<int, std::string> common_calendar(const std::vector<int>& hours_of);
  bool all_free(const Queue& queue) const;
  void move_up(int index, Ticks now);
  void drop_excluded(Queue& queue);

  std::vector<std::string> names_;
  std::vector<int> calendar_of_;
  std::vector<schedule::WorkCalendar> calendars_;
  std::map<std::vector<int>, int> common_;  ///< sets of calendars
  std::map<std::pair<std::vector<int>, std::vector<int>>, int> queue_of_;
  std::vector<Queue> queues_;
  std::vector<ResourceState> states_;
  std::set<int> excluded_;
  Journal journal_;
};

}  // namespace rubicon::taskplan
