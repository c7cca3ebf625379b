#include "src/results/film/record_columns.hpp"

#include <algorithm>
#include <cmath>

namespace rubicon::film {

Column PoseColumn::column() const {
  const bool fine = std::all_of(values.begin(), values.end(),
                                [](double value) { return std::abs(value) <= kLargestFinePose; });
  Column column(fine ? kFinePose : kMillionth);
  for (const double value : values) column.add(std::llround(value * (fine ? 1e9 : 1e6)));
  return column;
}

std::vector<std::pair<std::string_view, Column>> RecordColumns::take() {
  std::vector<std::pair<std::string_view, Column>> columns;
  const auto give = [&](std::string_view name, Column& column) {
    columns.emplace_back(name, std::move(column));
  };
  give("record.kind", kind);
  give("record.run", run);
  give("record.t", t);
  give("goal.k", goal_k);
  give("goal.n", goal_n);
  give("guide.name", guide_name);
  give("guide.kind", guide_kind);
  give("guide.cause", guide_cause);
  give("guide.events", guide_events);
  give("guide.nodes", guide_nodes);
  give("guide.checks", guide_checks);
  give("way_point.k", way_point_k);
  give("way_point.n", way_point_n);
  give("set.var", set_var);
  give("set.value", set_value);
  give("enter.kind", enter_kind);
  give("enter.place", enter_place);
  give("exit.kind", exit_kind);
  give("exit.place", exit_place);
  give("exit.reached", exit_reached);
  give("exit.successes", exit_successes);
  give("which.label", which_label);
  give("which.place", which_place);
  give("try.command", try_command);
  give("try.parameter", try_parameter);
  give("try.place", try_place);
  give("try.ok", try_ok);
  give("try.reason", try_reason);
  give("try.moved", try_moved);
  give("try.met", try_met);
  give("work.what", work_what);
  give("work.crew", work_crew);
  give("work.from", work_from);
  give("work.time", work_time);
  give("pause.why", pause_why);
  give("pause.for", pause_for);
  give("pause.from", pause_from);
  give("attach.component", attach_component);
  columns.emplace_back("attach.pose", attach_pose.column());
  give("detach.component", detach_component);
  columns.emplace_back("detach.pose", detach_pose.column());
  give("remove.component", remove_component);
  give("end.status", end_status);
  give("end.message", end_message);
  give("end.reached", end_reached);
  give("end.tries", end_tries);
  give("end.accepted", end_accepted);
  give("turn.component", turn_component);
  give("turn.angle", turn_angle);
  give("turn.from", turn_from);
  columns.emplace_back("turn.pose", turn_pose.column());
  give("turn.moved", turn_moved);
  give("turn.met", turn_met);
  if (cold_joint_age.count() > 0) {
    give("cold_joint.ends", cold_joint_ends);
    give("cold_joint.age", cold_joint_age);
  }
  return columns;
}

}  // namespace rubicon::film
