#pragma once

#include <cstdint>
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

/// Columns of the CSV with what the plan says for people.
struct RowTexts {
  std::string name, component, component_name, storey, type, guid, attributes;
};

/// What a task that covers an area came to, in the JSON only.
struct RowCover {
  std::string area;
  std::optional<double> covered, covered_area, volume, length, depth;
  std::optional<int> turns, holes;
};

/// A queue of trucks.
struct RowQueue {
  std::string stage, by;
  int servers = 0;
  std::int64_t served = 0;
  double mean_wait = 0;  ///< s
  Ticks longest_wait = 0;
  double mean_length = 0, utilisation = 0;
};

/// What came of the rounds of trucks, in the JSON only; m3.
struct RowDig {
  double volume = 0, tipped = 0, load = 0;
  std::int64_t loads = 0;
  std::optional<std::int64_t> passes;
  Ticks working = 0;
  double per_hour = 0;
  std::optional<double> cost_per_m3, fuel_per_m3;
  int trucks = 0;
  double mean_loading = 0, mean_round = 0, match_factor = 0;
  std::vector<RowQueue> queues;
};

/// What a robot dug, in the JSON only; m3, s.
struct RowMotionDig {
  double volume = 0, dug = 0, bucket = 0;
  std::int64_t buckets = 0;
  Ticks working = 0;
  double per_hour = 0;
  std::optional<double> cost_per_m3, fuel_per_m3;
  double cycle = 0, to_the_cut = 0, cut = 0, swing = 0, dump = 0;  ///< means over the buckets
  std::optional<std::int64_t> trucks, loads;
  std::optional<double> load;  ///< that a truck takes
  Ticks waited = 0;
};

/// One load of a truck with a body; times that are worked, from the beginning of its task.
struct RowLoad {
  std::string dig;
  double volume = 0;
  Ticks arrived = 0, began = 0, loaded = 0, at_tip = 0, tipped = 0;
};

/// What a truck with a body hauled, in the JSON only.
struct RowHaul {
  double hauled = 0;  ///< m3
  Ticks working = 0;
  double queue = 0, loading = 0, haul = 0, tip = 0, back = 0;  ///< s, means
  std::vector<RowLoad> loads;
};

/// All that trucks with bodies hauled, and what dug it, in the JSON only.
struct HaulingRow {
  double hauled = 0;   ///< m3
  double working = 0;  ///< s
  double per_hour = 0;
  std::optional<double> cost_per_m3, fuel_per_m3, match_factor;
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
  std::string baseline_begins, baseline_ends;       ///< in the JSON only, as `begins`
  std::map<std::string, std::string> attributes;    ///< in the JSON only, as the next three
  std::string component;                            ///< that it moves; "": none
  bool parking = false;                             ///< no task of the plan
  std::string choice;                               ///< why it has these members; "": no pools
  std::optional<RowTexts> texts;
  std::optional<RowFloat> floats;
  std::optional<RowCover> cover;
  std::optional<RowDig> dig;
  std::optional<RowMotionDig> motion_dig;
  std::optional<RowHaul> haul;
  std::optional<RowJoints> joints;
};

/// What schedule.json tells of a robot or a crew.
struct UseRow {
  int line = 0;
  std::string name, kind;
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
  std::optional<HaulingRow> hauling;
  std::vector<BreakdownRow> breakdowns;
  std::vector<LostDaysRecord> lost_days;
  /// What the plan says of components, by their names.
  std::map<std::string, std::map<std::string, std::string>> components;
};

/// One row of loads.csv; times in s, rounded to ms.
struct LoadRow {
  int line = 0;
  std::string task, by;
  std::int64_t number = 0, truck = 0;
  double arrived = 0, began = 0, loaded = 0, tipped = 0;
  double volume = 0;  ///< m3
};

/// Throws UnreadableInput.
ScheduleJson read_schedule_json(const std::string& text);

/// The rows of schedule.csv; throws UnreadableInput. Columns that are not known are left out.
std::vector<ScheduleRow> read_schedule_csv(const std::string& text);

/// The rows of loads.csv; throws UnreadableInput.
std::vector<LoadRow> read_loads_csv(const std::string& text);

}  // namespace rubicon::verify
