#pragma once

#include <utility>
#include <vector>

#include "src/results/film/column.hpp"
#include "src/results/film/string_table.hpp"
#include "src/simulation/trace/record_kind.hpp"

namespace rubicon::film {

using trace::RecordKind;

/// Lengths and parts of quaternions that stay exact where a double holds them; beyond
/// `kLargestFinePose` (m) there are fewer digits.
inline constexpr double kFinePose = 1e-9;
inline constexpr double kLargestFinePose = 4e6;

/// Poses of loads: seven numbers each. They are few, so their unit is chosen when all are known.
struct PoseColumn {
  std::vector<double> values;
  Column column() const;
};

/// What the records of each kind tell, one column a member.
struct RecordColumns {
  Column kind, run{1, true}, t{kMillionth, true};
  Column goal_k, goal_n;
  Column guide_name, guide_kind, guide_cause, guide_events, guide_nodes, guide_checks;
  Column way_point_k, way_point_n;
  Column set_var, set_value;
  Column enter_kind, enter_place;
  Column exit_kind, exit_place, exit_reached, exit_successes;
  Column which_label, which_place;
  Column try_command, try_parameter, try_place, try_ok, try_reason, try_moved, try_met;
  Column work_what, work_crew, work_from{kMillionth, true}, work_time{kMillionth};
  Column pause_why, pause_for, pause_from{kMillionth, true};
  Column attach_component, detach_component, remove_component;
  Column turn_component, turn_angle{kMillionth}, turn_from{kMillionth, true}, turn_moved, turn_met;
  PoseColumn attach_pose, detach_pose, turn_pose;
  Column cold_joint_ends{kMillionth}, cold_joint_age{kMillionth};
  Column end_status, end_message, end_reached, end_tries, end_accepted;

  /// All of them by the names of docs/film.md.
  std::vector<std::pair<std::string_view, Column>> take();
};

}  // namespace rubicon::film
