#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "src/simulation/schedule/journal.hpp"
#include "src/simulation/schedule/resource_sets.hpp"
#include "src/simulation/schedule/resource_states.hpp"

namespace rubicon::taskplan {

using schedule::Journal;
using schedule::Share;
using schedule::Ticks;

/// Gives robots and crews to the tasks that wait for them: all a task asks for at once or nothing;
/// of several tasks that can have what they ask for at a moment the one of the higher priority,
/// then the one that stands first in the file. Resources are numbered robots first, then crews.
class ResourceAllocator {
 public:
  /// `calendar_of` each resource: index into `calendars`, -1: day and night; `sizes` in units.
  ResourceAllocator(std::vector<std::string> names, const std::vector<int>& sizes,
                    std::vector<int> calendar_of, std::vector<schedule::WorkCalendar> calendars);

  /// The queue of those who ask for all of `shares` and need the working hours of all of
  /// `hours_of` (resources too). A message for the user if these have no common hours.
  std::variant<int, std::string> queue_for(std::vector<Share> shares, std::vector<int> hours_of);

  /// The working hours of a queue.
  const schedule::WorkCalendar& calendar(int queue) const { return sets_.calendar(queue); }
  /// The working hours of a robot or crew.
  const schedule::WorkCalendar& hours(int resource) const { return sets_.hours(resource); }
  const std::vector<int>& resources(int queue) const { return sets_.resources(queue); }
  const std::vector<Share>& shares(int queue) const { return sets_.shares(queue); }

  /// The task asks from `from` on.
  void ask(int queue, int task, double priority, Ticks from);
  /// A task that asks in several queues is given what it asks for in one of them. `in_one_of` says
  /// in which of those where it could have it now; `asks_no_more` whether it does not ask there
  /// any more.
  struct Choices {
    std::function<int(int task, const std::vector<int>& queues)> in_one_of;
    std::function<bool(int task, int queue)> asks_no_more;
  };
  void set_choices(Choices choices) { choices_ = std::move(choices); }

  /// Whatever it asks for, it is never given anything any more, also after the run went back.
  void exclude(int task) { excluded_.insert(task); }
  bool is_excluded(int task) const { return excluded_.contains(task); }

  struct Grant {
    int task = -1;
    int queue = -1;
    schedule::ResourceStates::Last last;  ///< what was free last of what it asked for
    Journal::Mark before = 0;             ///< the moment before it was given
  };
  /// Gives the next task what it asks for, in the working hours of its queue only.
  std::optional<Grant> take(Ticks now);

  /// What the task has of it; `midway`: the task goes on; `held`: for how long it had it.
  void release(int resource, int task, Ticks now, bool midway, Ticks held);
  /// It is under repair until then: nobody is given it before.
  void set_out(int resource, Ticks until);
  /// Free, only the group is given it.
  void reserve(int resource, int group);
  /// Free, all are given it from now on.
  void keep_no_more(int resource, Ticks now);

  /// The next moment after `now` at which somebody could be given something if nothing is given
  /// back before; kEndOfTime if never.
  Ticks next_chance(Ticks now);

  bool is_free(const Share& share) const { return states_.are_free({share}); }
  /// Whether the task is not given anything there any more.
  bool asks_no_more(int task, int queue) const {
    return excluded_.contains(task) ||
           (choices_.asks_no_more && choices_.asks_no_more(task, queue));
  }
  const std::string& name(int resource) const { return names_[static_cast<std::size_t>(resource)]; }
  const schedule::ResourceState& state(int resource) const { return states_.of(resource); }
  int size_of(int resource) const { return states_.size_of(resource); }
  /// Takes what is free without asking.
  void take_directly(const Share& share, int task);

  // to go back
  Journal::Mark mark() const { return journal_.mark(); }
  void undo_to(Journal::Mark mark) { journal_.undo_to(mark); }
  void forget_before(Journal::Mark mark) { journal_.forget_before(mark); }

 private:
  using Place = std::pair<double, int>;  ///< (-priority, task): the least goes first
  /// Who waits for the set of the same number.
  struct Queue {
    std::set<Place> waiting;
    std::set<std::tuple<Ticks, double, int>> later;  ///< by the moment from which they ask

    bool is_empty() const { return waiting.empty() && later.empty(); }
  };

  bool all_free(int queue) const { return states_.are_free(sets_.shares(queue)); }
  /// Until when any of what the queue asks for is under repair.
  Ticks out_until(int queue) const;
  void keep_state(int resource);
  void move_up(int index, Ticks now);
  void drop_those_who_ask_no_more(int index);

  std::vector<std::string> names_;
  schedule::ResourceSets sets_;
  schedule::ResourceStates states_;
  std::vector<Queue> queues_;
  std::vector<Ticks> out_;  ///< to each resource; empty where none was ever under repair
  std::set<int> excluded_;
  Choices choices_;
  Journal journal_;
};

}  // namespace rubicon::taskplan
