#pragma once

#include <vector>

#include "src/simulation/taskplan/stage.hpp"
#include "src/simulation/taskplan/task_records.hpp"
#include "src/simulation/taskplan/zone_waits.hpp"

namespace rubicon::taskplan {

/// The moments before the active tasks started, oldest first. Each part of a run gives its own
/// state, or a mark in the journal of its own changes, and takes it back.
class Checkpoints {
 public:
  Checkpoints(Stage& stage, TaskRecords& records, ZoneWaits& zone_waits)
      : stage_(stage), records_(records), zone_waits_(zone_waits) {}

  /// `resources`: the moment before the task was given what it asked for.
  void add(int task, Journal::Mark resources);
  /// Nobody goes back to before the task started any more.
  void drop(int task);
  /// To the moment before the task started, which with all later ones is dropped; whether its trace
  /// lines are kept. False if there is none.
  bool go_back(int task, bool keeps_lines = true);

 private:
  struct Checkpoint {
    int task = -1;
    Journal::Mark records = 0;
    Journal::Mark links = 0;
    Journal::Mark resources = 0;
    Journal::Mark choices = 0;
    TraceOutput::Mark trace = 0;
    SiteChanges::Moment site;
    EventQueue events;
    ActiveTasks active;
    std::vector<WholeLift> lifts;
    SiteProgress progress;
    Breakdowns breakdowns;
    std::size_t breakdown_outcomes = 0;
    std::size_t failed_parkings = 0;
    ZoneWaits zone_waits;
    Haulage haulage;
  };

  Stage& stage_;
  TaskRecords& records_;
  ZoneWaits& zone_waits_;
  std::vector<Checkpoint> checkpoints_;
};

}  // namespace rubicon::taskplan
