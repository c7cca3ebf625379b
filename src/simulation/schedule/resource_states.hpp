#pragma once

#include <vector>

#include "src/simulation/schedule/resource_sets.hpp"
#include "src/simulation/schedule/ticks.hpp"

namespace rubicon::schedule {

/// A robot or a crew: who has it, and since when the rest is free.
struct ResourceState {
  struct Held {
    int task = -1;
    int units = 0;
  };
  struct Free {
    int units = 0;
    Ticks since = 0;
    int task_before = -1;  ///< who had them, -1: nobody yet
    bool midway = false;   ///< they were given back before that task's finish
  };

  std::vector<Held> held;  ///< in the order in which they got it
  std::vector<Free> free;  ///< the longest free first
  int free_units = 0;
  int last = -1;         ///< the task that has or had any of it last, -1: nobody yet
  int reserved = -1;     ///< the group for which it is kept while it is free, -1: for nobody
  Ticks kept_until = 0;  ///< when it was kept last
  Ticks given_back = 0;  ///< for how long those had it who gave it back

  /// The first who has any of it, -1: it is free.
  int holder() const { return held.empty() ? -1 : held.front().task; }
};

/// Who has what, and what was free last of what a task asks for: the rule by which resources are
/// given, whoever keeps the queues. A task has all its shares or none; of a resource it is given
/// what has been free longest. A value.
class ResourceStates {
 public:
  /// `sizes` of the resources: units.
  explicit ResourceStates(const std::vector<int>& sizes);

  int size_of(int resource) const { return sizes_[at(resource)]; }
  const ResourceState& of(int resource) const { return states_[at(resource)]; }
  bool are_free(const std::vector<Share>& shares) const;

  /// What comes free last of some shares.
  struct Last {
    int resource = -1;     ///< -1: nobody has had any of them
    int task_before = -1;  ///< who had it
    Ticks since = 0;       ///< since when all are free and kept for nobody
    bool midway = false;
    bool kept = false;  ///< it was free before, and kept for others
  };
  /// Of shares that are free.
  Last last_free(const std::vector<Share>& shares) const;

  void take(const Share& share, int task);
  /// What the task has of it is free from `since` on; `held_for`: how long it had it.
  void release(int resource, int task, Ticks since, bool midway, Ticks held_for = 0);
  void reserve(int resource, int group) { states_[at(resource)].reserved = group; }
  void keep_no_more(int resource, Ticks now) {
    states_[at(resource)].reserved = -1;
    states_[at(resource)].kept_until = now;
  }
  void set(int resource, ResourceState state) { states_[at(resource)] = std::move(state); }

 private:
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  std::vector<int> sizes_;
  std::vector<ResourceState> states_;
};

}  // namespace rubicon::schedule
