#pragma once

#include <string>

#include "src/verify/task_run.hpp"

namespace rubicon::verify {

/// One row of a schedule, as a file tells it.
struct ScheduleRow {
  int line = 0;
  std::string task, robot, crew, result, reason;
  Ticks start = 0;
  Ticks duration = 0;
  int tried = 0;
  int accepted = 0;
};

/// The rows of schedule.json and when the last task ends; throws UnreadableInput.
struct ScheduleJson {
  std::vector<ScheduleRow> rows;
  Ticks process_time = 0;
};
ScheduleJson read_schedule_json(const std::string& text);

/// The rows of schedule.csv; throws UnreadableInput. Columns that are not known are left out.
std::vector<ScheduleRow> read_schedule_csv(const std::string& text);

/// Compares a schedule with what the trace tells of the same tasks.
void check_rows(const Trace& trace, const std::vector<TaskRun>& runs,
                const std::vector<ScheduleRow>& rows, ResultFile file, Faults& faults);

/// Compares the process time: the end of the last task of the plan that was done.
void check_process_time(const std::vector<TaskRun>& runs, Ticks process_time, Faults& faults);

}  // namespace rubicon::verify
