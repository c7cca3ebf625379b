#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "src/results/verify/schedule/accounts.hpp"
#include "src/results/verify/schedule/schedule_row.hpp"

namespace rubicon::verify {

/// Whether what tasks waited for came at the moment when they went on, and not sooner.
class WaitCheck {
 public:
  WaitCheck(const Trace& trace, const std::vector<TaskRun>& runs, const WorkingHours& hours);

  /// The waits of a run on its way, as the trace tells them.
  void check_pauses(int index, Faults& faults) const;

  /// The waits of a run before its start, as a row of a schedule tells them.
  void check_start(int index, const TaskAccount& account, const ScheduleRow& row, ResultFile file,
                   Faults& faults) const;

 private:
  bool given_back(int resource, Ticks time, int to_run) const;
  bool any_given_back(int index, Ticks time) const;
  std::vector<int> held_calendars(int index) const;
  bool begins_lift(const TaskRun& run, std::size_t number) const;
  bool finish_is_due(const TaskRun& run, Ticks time) const;

  const Trace& trace_;
  const std::vector<TaskRun>& runs_;
  const WorkingHours& hours_;
  std::vector<const TaskRun*> run_of_;  ///< by task; null: it did not happen
  /// By robot or crew: when which run gave it back; -1: when it was repaired, or kept no more.
  std::vector<std::multimap<Ticks, int>> given_back_;
  std::vector<std::vector<int>> held_;  ///< by run: what it holds from its start to its finish
};

}  // namespace rubicon::verify
