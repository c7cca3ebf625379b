#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/results/verify/input/fault.hpp"
#include "src/results/verify/input/record.hpp"

namespace rubicon::verify {

/// Where the time of a task went, from the beginning of the plan to its finish.
struct TimeSplit {
  Ticks motion = 0;
  Ticks work = 0;
  Ticks predecessor = 0;  ///< waiting, as the next four
  Ticks resource = 0;
  Ticks machine = 0;
  Ticks shift = 0;
  Ticks repair = 0;
  Ticks thinking = 0;  ///< part of the motion
};

/// How much later a task could have been.
struct RowFloat {
  Ticks total = 0;
  Ticks free = 0;
  Ticks latest_start = 0;  ///< in the JSON only, as the next
  Ticks latest_finish = 0;
};

/// The cold joints of a task, in the JSON only.
struct RowJoints {
  Ticks after = 0;
  int count = 0;
  double length = 0;  ///< m
  Ticks oldest = 0;
  std::vector<ColdJoint> places;
};

/// One row of a schedule, as a file tells it.
struct ScheduleRow {
  int line = 0;
  std::string task, robot, crew, result, reason;
  Ticks start = 0;
  Ticks duration = 0;
  TimeSplit split;
  /// How often its way met what others are foreseen to sweep, and went round.
  std::optional<std::pair<int, int>> foreseen;
  std::optional<double> cost;
  std::optional<double> fuel;  ///< l
  std::string begins, ends;    ///< YYYY-MM-DD HH:MM; "": not given
  int tried = 0;
  int accepted = 0;
  std::optional<Ticks> due, late;
  std::optional<std::pair<Ticks, Ticks>> baseline;  ///< start, finish
  std::optional<RowFloat> floats;
  std::optional<RowJoints> joints;
};

/// What schedule.json tells of a robot or a crew.
struct UseRow {
  int line = 0;
  std::string name;
  std::optional<int> size;  ///< of a crew: people
  int tasks = 0;
  Ticks held = 0;
  Ticks busy = 0;
  Ticks shifts = 0;
  double utilisation = 0;
  std::optional<double> rate;
  std::optional<double> cost;
  std::optional<double> fuel;  ///< l
};

/// One task of the critical path, and the sentence why it came so late.
struct CriticalRow {
  int line = 0;
  std::string task;
  bool work_counts = false;
  std::string text;
};

/// A machine broke down.
struct BreakdownRow {
  std::string robot, during;
  Ticks worked = 0, repair = 0, from = 0, to = 0;
};

/// The rows of schedule.json, when the last task ends and what all costs.
struct ScheduleJson {
  std::vector<ScheduleRow> rows;
  std::vector<UseRow> uses;
  std::vector<CriticalRow> critical;  ///< from the first to the last
  Ticks process_time = 0;
  std::string start_at, ends;  ///< YYYY-MM-DD HH:MM; "": not given
  std::string currency;
  std::optional<double> cost;
  std::map<std::string, double> cost_by_kind;  ///< empty: not given
  std::optional<double> fuel;                  ///< l
  std::vector<BreakdownRow> breakdowns;
  std::vector<LostDaysRecord> lost_days;
};

/// Throws UnreadableInput.
ScheduleJson read_schedule_json(const std::string& text);

/// The rows of schedule.csv; throws UnreadableInput. Columns that are not known are left out.
std::vector<ScheduleRow> read_schedule_csv(const std::string& text);

}  // namespace rubicon::verify
