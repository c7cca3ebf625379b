#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <utility>

namespace rubicon::schedule {

/// What was done to large tables, so that a run can go back to an earlier moment without a copy of
/// them. What it changes must stay where it is while the change can be undone.
class Journal {
 public:
  using Mark = std::uint64_t;

  /// place = value, to be undone.
  template <typename T>
  void assign(T& place, T value) {
    T before = std::exchange(place, std::move(value));
    undo_.push_back([&place, old = std::move(before)]() mutable { place = std::move(old); });
  }

  /// Remembers how to undo what was just done.
  void on_undo(std::function<void()> undo) { undo_.push_back(std::move(undo)); }

  Mark mark() const { return forgotten_ + undo_.size(); }

  /// Undoes all that was done since `mark`, the last first.
  void undo_to(Mark mark) {
    while (this->mark() > mark) {
      undo_.back()();
      undo_.pop_back();
    }
  }

  /// Nobody will go back to before `mark`.
  void forget_before(Mark mark) {
    while (forgotten_ < mark && !undo_.empty()) {
      undo_.pop_front();
      ++forgotten_;
    }
  }

 private:
  std::deque<std::function<void()>> undo_;
  Mark forgotten_ = 0;
};

}  // namespace rubicon::schedule
