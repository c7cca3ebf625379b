#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "src/simulation/schedule/ticks.hpp"

namespace rubicon::taskplan {

using schedule::Ticks;

/// The time of a run, and which task goes on when: of several at a moment the one whose event was
/// set first. A value: a copy is a moment to go back to.
class EventQueue {
 public:
  Ticks now() const { return now_; }
  void advance_to(Ticks time) { now_ = time; }

  /// The next event of the task is at `time`, whatever it was before.
  void set(int task, Ticks time) {
    cancel(task);
    events_.emplace(time, ++sequence_, task);
    event_of_.emplace(task, std::pair(time, sequence_));
  }
  void cancel(int task) {
    const auto event = event_of_.find(task);
    if (event == event_of_.end()) return;
    events_.erase({event->second.first, event->second.second, task});
    event_of_.erase(event);
  }
  bool is_set(int task) const { return event_of_.contains(task); }
  /// Whether its event is at the present time.
  bool is_due(int task) const {
    const auto event = event_of_.find(task);
    return event != event_of_.end() && event->second.first <= now_;
  }

  /// When the next event is; nothing if none is set.
  std::optional<Ticks> next() const {
    return events_.empty() ? std::nullopt : std::optional(std::get<0>(*events_.begin()));
  }
  /// Takes out the first event that has come; its task.
  std::optional<int> take_due() {
    if (events_.empty() || std::get<0>(*events_.begin()) > now_) return std::nullopt;
    const int task = std::get<2>(*events_.begin());
    cancel(task);
    return task;
  }

 private:
  Ticks now_ = 0;
  std::uint64_t sequence_ = 0;
  std::set<std::tuple<Ticks, std::uint64_t, int>> events_;
  std::map<int, std::pair<Ticks, std::uint64_t>> event_of_;
};

}  // namespace rubicon::taskplan
