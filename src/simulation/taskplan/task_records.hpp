#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "src/simulation/schedule/journal.hpp"
#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::taskplan {

using schedule::Journal;

/// How far each task is, and what the finished ones came to.
class TaskRecords {
 public:
  enum class Status : std::uint8_t { pending, asking, active, done };

  explicit TaskRecords(int tasks)
      : status_(static_cast<std::size_t>(tasks), Status::pending),
        outcomes_(static_cast<std::size_t>(tasks)) {}

  Status status(int task) const { return status_[at(task)]; }
  bool has_begun(int task) const {
    return status(task) == Status::active || status(task) == Status::done;
  }
  void set_status(int task, Status status) { journal_.assign(status_[at(task)], status); }

  /// The task is done.
  void finish(int task, TaskOutcome outcome) {
    set_status(task, Status::done);
    interpreter::Rare<TaskOutcome>& place = outcomes_[at(task)];
    place = std::move(outcome);
    journal_.on_undo([&place] { place.reset(); });
  }
  /// A robot is parked; it may be parked again.
  void finish_parking(int task, TaskOutcome outcome) {
    set_status(task, Status::pending);
    parkings_.push_back(std::move(outcome));
    journal_.on_undo([this] { parkings_.pop_back(); });
  }
  /// The outcome of a task; nothing if it is not done.
  interpreter::Rare<TaskOutcome>& outcome(int task) { return outcomes_[at(task)]; }
  std::vector<TaskOutcome>& parkings() { return parkings_; }

  /// A robot was asked out of the way for the sake of the task.
  void made_room_for(int task) {
    asked_for_.push_back(task);
    journal_.on_undo([this] { asked_for_.pop_back(); });
  }
  const std::vector<int>& made_room_for() const { return asked_for_; }

  /// One more task is behind us; how many are.
  int count_one() {
    ++behind_;
    journal_.on_undo([this] { --behind_; });
    return behind_;
  }
  /// The same, whatever the run goes back to.
  int count_one_for_good() { return ++behind_; }

  Journal::Mark mark() const { return journal_.mark(); }
  void undo_to(Journal::Mark mark) { journal_.undo_to(mark); }
  void forget_before(Journal::Mark mark) { journal_.forget_before(mark); }

 private:
  static std::size_t at(int task) { return static_cast<std::size_t>(task); }

  std::vector<Status> status_;
  std::vector<interpreter::Rare<TaskOutcome>> outcomes_;
  std::vector<TaskOutcome> parkings_;
  std::vector<int> asked_for_;
  int behind_ = 0;
  Journal journal_;
};

}  // namespace rubicon::taskplan
