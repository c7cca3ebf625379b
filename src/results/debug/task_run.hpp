#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "src/results/debug/task_state.hpp"
#include "src/simulation/trace/parameter_value.hpp"

namespace rubicon::debug {

/// One run of one task: its events, and states of it here and there, so that the state anywhere is
/// found at once.
class TaskRun {
 public:
  TaskRun(TextId name, TextId robot) : name_(name), robot_(robot) {}

  /// Adds an event; its `row` and the loop that it ends are filled in. `q` is the configuration
  /// after it, empty where the record has none. Throws std::invalid_argument if it ends a loop that
  /// is not the innermost one, if `q` is of another robot than before, or if there are too many of
  /// something (task_state.hpp).
  void add(Event event, trace::Configuration q);
  /// What the robot stood at before this run, by parameter, as far as it is known.
  void set_before(std::map<std::string, double, std::less<>> q) { before_ = std::move(q); }

  TextId name() const { return name_; }
  TextId robot() const { return robot_; }
  std::span<const Event> events() const { return events_; }
  std::size_t size() const { return events_.size(); }
  /// The state after the first `position` events.
  TaskState state_at(std::size_t position) const;
  /// The state after all of them.
  const TaskState& last() const { return last_; }
  int motions() const { return last_.motion; }
  /// Whether it ended rejected: what it tells did not happen.
  bool undone() const { return undone_; }
  void set_undone() { undone_ = true; }

  /// The parameters of the robot; empty if no record tells them.
  const std::vector<std::string>& parameters() const { return parameters_; }
  /// Where it ended, by parameter; empty if no record tells it.
  std::map<std::string, double, std::less<>> ended_at() const;
  /// A configuration by its number; kNone is the one at the beginning. Values by parameter; NaN
  /// what is not known.
  std::vector<double> configuration(std::uint32_t row) const;

  /// Gives back memory that will not be needed: no event is added any more.
  void close();

 private:
  std::uint32_t add_row(trace::Configuration q);

  TextId name_ = kNone;
  TextId robot_ = kNone;
  bool undone_ = false;
  std::vector<Event> events_;
  std::vector<std::string> keys_;        ///< the parameters as the trace has them
  std::vector<std::string> parameters_;  ///< the same, fit to be shown
  std::vector<double> rows_;             ///< one configuration after the other
  std::map<std::string, double, std::less<>> before_;
  TaskState last_;
  std::vector<TaskState> checkpoints_;  ///< after 0, kBetweenCheckpoints, ... events
};

}  // namespace rubicon::debug
