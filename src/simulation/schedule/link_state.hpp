#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "src/simulation/schedule/journal.hpp"
#include "src/simulation/schedule/network.hpp"

namespace rubicon::schedule {

/// What is known of when tasks start and finish, and what their links make of that. It knows
/// nothing of machines, crews and the queue of events: events go in with `publish`, and `propagate`
/// says whom they let start or finish.
class LinkState {
 public:
  /// Working hours of all that a task holds.
  using CalendarOf = std::function<const WorkCalendar&(int task)>;
  /// `work` of each task: ticks of crew work known before it starts; -1: not known; 0: a milestone.
  /// `precomputed` times of each task, or nothing; the tasks at the end may be left out.
  LinkState(Network network, std::vector<Ticks> work,
            const std::vector<std::optional<TaskTimes>>& precomputed, CalendarOf calendar_of);

  /// A link of a task that comes after another.
  struct Follower {
    int task = -1;
    LinkType type = LinkType::FS;
  };

  int size() const { return static_cast<int>(times_.size()); }
  /// Names, work and links, for texts and the critical path.
  const Network& network() const { return network_; }
  const std::vector<Link>& links_of(int task) const { return network_.tasks[at(task)].after; }
  const std::vector<Follower>& followers_of(int task) const { return followers_[at(task)]; }
  Ticks work(int task) const { return work_[at(task)]; }
  bool known_work(int task) const { return work_[at(task)] >= 0; }
  bool is_milestone(int task) const { return work_[at(task)] == 0; }
  bool is_precomputed(int task) const { return precomputed_[at(task)]; }
  const TaskTimes& times(int task) const { return times_[at(task)]; }
  const std::vector<TaskTimes>& all_times() const { return times_; }

  /// A task that is not done holds nobody who began without it, for good: whatever the run goes
  /// back to.
  void leave_out(int task) { left_out_[at(task)] = true; }
  /// Counts again what each task waits for: once, after the first `leave_out`s.
  void count_links();

  /// Whether a link of that type from `before` keeps the task from starting. Work that is known
  /// starts so late that it does not finish too early, and so waits for what holds its finish too;
  /// so does what holds the machine or people that the task before needs.
  bool waits_to_start(int task, int before, LinkType type) const;
  bool may_start(int task) const { return to_start_[at(task)] == 0; }
  bool may_finish(int task) const { return to_finish_[at(task)] == 0; }
  bool is_known(int task, TaskEnd end) const { return (known_[at(task)] & bit(end)) != 0; }
  /// What the links of a task allow, as far as it is known.
  LinkBounds bounds_of(int task, bool with_finish) const;
  /// The links whose event is not known yet, of those that hold the start or the finish.
  std::vector<int> open_links(int task, TaskEnd end) const;

  /// When a task may start whose links are known since it is known when `before` starts or finishes
  /// (-1: since the plan began).
  TaskTimes ready_times(int task, int before, Ticks now) const;
  /// Whether the link that started the task holds its finish.
  bool started_for_finish(const TaskTimes& times, int task) const;

  void set_times(int task, TaskTimes times);
  void add_mid_wait(int task, MidWait wait);
  /// A task that runs again begins without times known.
  void forget_known(int task);

  /// From now on it is known when the task starts or finishes: a pending event.
  void publish(int task, TaskEnd end, Ticks time);

  /// Who hears what `propagate` finds.
  class Listener {
   public:
    virtual ~Listener() = default;
    /// All is known that the start of `task` waited for, since `before` is.
    virtual void may_start(int task, int before) = 0;
    /// All is known that the finish of `task` waited for.
    virtual void may_finish(int task) = 0;
  };
  /// Counts pending events for those that come after, until there are none.
  void propagate(Listener& listener);
  void drop_pending() { pending_.clear(); }

  /// A link from a task that is left out does not hold the finish of `task` any more; whether that
  /// was the last to hold it.
  bool let_go(int task, int before, LinkType type);

  // to go back
  Journal::Mark mark() const { return journal_.mark(); }
  void undo_to(Journal::Mark mark) { journal_.undo_to(mark); }
  void forget_before(Journal::Mark mark) { journal_.forget_before(mark); }

 private:
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  static std::uint8_t bit(TaskEnd end) { return end == TaskEnd::start ? 1 : 2; }
  void count_down(int& counter);
  bool take_turns(int task, int other) const;

  Network network_;
  std::vector<Ticks> work_;
  CalendarOf calendar_of_;
  std::vector<bool> mutually_constrained_;  ///< LinkOrder::tied_both_ways
  std::vector<bool> precomputed_;
  std::vector<bool> left_out_;
  std::vector<std::vector<Follower>> followers_;
  std::vector<int> to_start_;   ///< events not known yet, without which it cannot start
  std::vector<int> to_finish_;  ///< and without which it cannot finish
  std::vector<TaskTimes> times_;
  std::vector<std::uint8_t> known_;  ///< bits: 1 its start is known, 2 its finish
  std::vector<std::pair<int, TaskEnd>> pending_;
  Journal journal_;
};

}  // namespace rubicon::schedule
