#include "src/results/film/film_builder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

#include "src/motion/math/pose.hpp"
#include "src/simulation/trace/header.hpp"
#include "src/simulation/trace/json_builder.hpp"
#include "src/simulation/trace/record.hpp"

namespace rubicon::film {

namespace {

/// Adds the seven numbers of a pose: position (m) and quaternion x, y, z, w.
void add_pose(PoseColumn& column, const math::Pose& X) {
  const Eigen::Quaterniond turn(Eigen::Matrix3d(X.linear()));
  const auto p = X.translation();
  for (const double value : {p.x(), p.y(), p.z(), turn.x(), turn.y(), turn.z(), turn.w()}) {
    millionths(value, "a pose");
    column.values.push_back(value);
  }
}

/// The kinds of guides whose ways are seen from above (docs/guides.md).
bool is_plan_view(std::string_view kind) {
  constexpr std::array<std::string_view, 8> kKinds = {
      "bug1", "bug2", "visbug21", "pledge", "simple", "tangent", "ace", "visibility"};
  return std::find(kKinds.begin(), kKinds.end(), kind) != kKinds.end();
}

}  // namespace

void FilmBuilder::line(std::string_view text) {
  reader_.read(
      text,
      [&](const trace::TraceHeader& header) {
        scene_ = read_scene(header, text);
        tracks_.emplace(scene_.robots);
      },
      [&](const trace::Record& each) { record(each); });
}

/// When a record is over.
double FilmBuilder::time_of(const trace::Record& record, const FilmRun& run) const {
  const auto time = record.time();
  const double t = time ? trace::seconds(*time) : run.last;
  // The end of a rejected task tells its start again.
  const auto* end = std::get_if<trace::TaskEnd>(&record.what);
  const bool undone = end != nullptr && !trace::has_happened(end->result);
  if (t < run.last && !undone) {
    throw std::invalid_argument("the task's time runs backwards here");
  }
  return t;
}

void FilmBuilder::record(const trace::Record& record) {
  if (const auto* moving = std::get_if<trace::Moving>(&record.what)) {
    movings_.push_back({std::string(moving->name), std::string(moving->by),
                        trace::seconds(moving->delay), trace::seconds(moving->t)});
    return;
  }
  // The page has these from the schedule.
  if (record.kind() == RecordKind::breakdown || record.kind() == RecordKind::lost_days) return;
  const int run = run_of(record);
  const double t = time_of(record, runs_[run]);
  if (const auto* soil = std::get_if<trace::Soil>(&record.what)) {
    soils_.push_back({run,
                      component(soil->component),
                      t,
                      {soil->cells.begin(), soil->cells.end()},
                      {soil->heights.begin(), soil->heights.end()}});
    runs_[run].last = t;
    return;
  }
  if (const auto* way = std::get_if<trace::Foreseen>(&record.what)) {
    foreseen_.push_back({run,
                         std::string(way->machine),
                         way->seconds,
                         t,
                         {way->corners.begin(), way->corners.end()},
                         {way->points.begin(), way->points.end()}});
    runs_[run].last = t;
    return;
  }
  if (const auto* grid = std::get_if<trace::Forbidden>(&record.what)) {
    add_forbidden(*grid, run);
    return;
  }
  columns_.kind.add(static_cast<int>(record.kind()));
  columns_.run.add(run);
  columns_.t.add(time_millionths(t));
  runs_[run].last = t;
  std::visit([&](const auto& what) { write(what, run); }, record.what);
}

/// The run that a record belongs to; begins it where this is its first.
int FilmBuilder::run_of(const trace::Record& record) {
  const int open = runs_.open_run(record.task);
  const bool starts = record.kind() == RecordKind::task_start;
  if (open >= 0) {
    if (starts) throw std::invalid_argument(fmt::format("task '{}' begins twice", record.task));
    return open;
  }
  if (!starts && record.kind() != RecordKind::task_end && !scene_.short_form) {
    throw std::invalid_argument(fmt::format("task '{}' has not begun", record.task));
  }
  return begin(record);
}

int FilmBuilder::begin(const trace::Record& record) {
  FilmRun run;
  run.task = record.task;
  if (!record.robot.empty()) {
    const auto found = scene_.robot_numbers.find(record.robot);
    if (found == scene_.robot_numbers.end()) {
      throw std::invalid_argument(
          fmt::format("the trace's header has no robot '{}'", record.robot));
    }
    run.robot = found->second;
  }
  // The one task of a short plan begins with it.
  const auto time = record.time();
  run.start = scene_.short_form || !time ? 0 : trace::seconds(*time);
  run.last = run.start;
  if (const auto* start = std::get_if<trace::TaskStart>(&record.what)) {
    run.because = start->because;
    run.after = start->after;
  }
  const int number = runs_.begin(std::move(run));
  if (record.kind() != RecordKind::task_end) {
    tracks_->begin(number, runs_[number].robot, runs_[number].start);
  }
  return number;
}

std::int64_t FilmBuilder::place(const trace::InText& place) {
  return places_.number({string(place.file), place.line, place.column});
}

std::int64_t FilmBuilder::component(std::string_view name) const {
  const auto found = scene_.component_numbers.find(name);
  if (found == scene_.component_numbers.end()) {
    throw std::invalid_argument(fmt::format("the trace's header has no component '{}'", name));
  }
  return found->second;
}

/// To where a record says that the robot is.
void FilmBuilder::move(trace::Configuration q, int run) {
  const int robot = runs_[run].robot;
  if (robot < 0) return;
  const auto& parameters = scene_.robots[static_cast<std::size_t>(robot)].parameters;
  q_.clear();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    // As they are written; any other order is as good.
    std::size_t at = i;
    if (at >= q.size() || q[at].name != parameters[i].name) {
      for (at = 0; at < q.size() && q[at].name != parameters[i].name;) ++at;
    }
    if (at == q.size()) {
      throw std::invalid_argument(
          fmt::format("this is no line of a trace: it has no '{}' in 'q'", parameters[i].name));
    }
    q_.push_back(q[at].value);
  }
  tracks_->move(run, runs_[run].last, q_);
}

void FilmBuilder::write(const trace::TaskStart&, int) {}

void FilmBuilder::write(const trace::GoalStart& goal, int) {
  columns_.goal_k.add(goal.k);
  columns_.goal_n.add(goal.n);
}

void FilmBuilder::write(const trace::Assignment& assignment, int) {
  columns_.set_var.add(string(assignment.variable));
  std::string text;
  if (assignment.value) {
    trace::append_number(text, *assignment.value);
  } else {
    text = "null";
  }
  columns_.set_value.add(string(text));
}

void FilmBuilder::write(const trace::LoopStart& loop, int) {
  columns_.enter_kind.add(string(loop.kind));
  columns_.enter_place.add(place(loop));
}

void FilmBuilder::write(const trace::LoopEnd& loop, int) {
  columns_.exit_kind.add(string(loop.kind));
  columns_.exit_place.add(place(loop));
  columns_.exit_reached.add(loop.reached ? 1 : 0);
  columns_.exit_successes.add(loop.successes);
}

void FilmBuilder::write(const trace::Choice& choice, int) {
  columns_.which_label.add(string(choice.label));
  columns_.which_place.add(place(choice));
}

void FilmBuilder::write(const trace::Attempt& attempt, int run) {
  columns_.try_command.add(string(attempt.command));
  if (attempt.parameters.size() == 1) {
    columns_.try_parameter.add(string(attempt.parameters.front()));
  } else {
    columns_.try_parameter.add(string(fmt::format("{}", fmt::join(attempt.parameters, ", "))));
  }
  columns_.try_place.add(place(attempt));
  columns_.try_ok.add(attempt.ok ? 1 : 0);
  columns_.try_reason.add(string(attempt.reason));
  const trace::Hit hit = attempt.hit.value_or(trace::Hit{});
  columns_.try_moved.add(string(hit.moved));
  columns_.try_met.add(string(hit.met));
  if (attempt.ok) move(attempt.q, run);
}

void FilmBuilder::write(const trace::Wait&, int run) { tracks_->stand(run, runs_[run].last); }

void FilmBuilder::write(const trace::Stop&, int run) { tracks_->stand(run, runs_[run].last); }

void FilmBuilder::write(const trace::Think&, int run) { tracks_->stand(run, runs_[run].last); }

void FilmBuilder::write(const trace::GuidePlan& plan, int run) {
  if (is_plan_view(plan.kind) && !plan.way.empty()) {
    for (const double value : plan.way) millionths(value, "a way");
    Walk& walk = walks_.emplace_back();
    walk.run = run;
    walk.t = trace::seconds(plan.t);
    walk.way.assign(plan.way.begin(), plan.way.end());
    walk.events.assign(plan.events.begin(), plan.events.end());
  }
  if (!plan.graph.empty()) {
    for (const double value : plan.graph) millionths(value, "a graph");
    graphs_.push_back(
        {run, trace::seconds(plan.t), plan.legs, {plan.graph.begin(), plan.graph.end()}});
  }
  columns_.guide_name.add(string(plan.name));
  columns_.guide_kind.add(string(plan.kind));
  columns_.guide_cause.add(string(plan.cause));
  columns_.guide_events.add(
      string(fmt::format("{}", fmt::join(plan.events.begin(), plan.events.end(), "; "))));
  columns_.guide_nodes.add(plan.nodes);
  columns_.guide_checks.add(plan.checks);
}

/// It belongs to the search that was told just before.
void FilmBuilder::add_forbidden(const trace::Forbidden& grid, int run) {
  const double t = trace::seconds(grid.t);
  if (graphs_.empty() || graphs_.back().run != run || graphs_.back().t != t) {
    throw std::invalid_argument("'forbidden' follows a 'guide' with what it searched through");
  }
  constexpr double kMostCells = 1e7;
  double cells = grid.layers.empty() ? 1 : static_cast<double>(grid.layers.size());
  bool counts = true;
  for (const double count : grid.cells) {
    counts = counts && count >= 1 && count == std::floor(count);
    cells *= count;
  }
  counts = counts && cells <= kMostCells;
  for (const double length : grid.runs) {
    counts = counts && length >= 0 && length == std::floor(length);
    cells -= length;
  }
  if (grid.low.size() != 2 || grid.high.size() != 2 || grid.cells.size() != 2 ||
      grid.parameters.size() != (grid.layers.empty() ? 2u : 3u) || !counts || cells != 0) {
    throw std::invalid_argument("'runs' of 'forbidden' has each of its cells once");
  }
  const auto list = [](trace::Numbers values) {
    for (const double value : values) millionths(value, "forbidden cells");
    return std::vector<double>(values.begin(), values.end());
  };
  graphs_.back().forbidden = ForbiddenCells{{grid.parameters.begin(), grid.parameters.end()},
                                            list(grid.low),
                                            list(grid.high),
                                            list(grid.cells),
                                            list(grid.layers),
                                            list(grid.at),
                                            list(grid.runs)};
}

void FilmBuilder::write(const trace::WayPoint& point, int) {
  columns_.way_point_k.add(point.k);
  columns_.way_point_n.add(point.n);
}

void FilmBuilder::write(const trace::Work& work, int run) {
  columns_.work_what.add(string(work.what));
  columns_.work_crew.add(string(work.crew));
  columns_.work_from.add(time_millionths(trace::seconds(work.from)));
  columns_.work_time.add(time_millionths(trace::seconds(work.time)));
  tracks_->stand(run, runs_[run].last);
}

void FilmBuilder::write(const trace::Pause& pause, int run) {
  columns_.pause_why.add(string(pause.why));
  columns_.pause_for.add(string(pause.whom));
  columns_.pause_from.add(time_millionths(trace::seconds(pause.from)));
  tracks_->stand(run, runs_[run].last);
}

void FilmBuilder::write(const trace::Attach& attach, int) {
  columns_.attach_component.add(component(attach.component));
  add_pose(columns_.attach_pose, attach.X_TO);
}

void FilmBuilder::write(const trace::Detach& detach, int) {
  columns_.detach_component.add(component(detach.component));
  add_pose(columns_.detach_pose, detach.X_WO);
}

void FilmBuilder::write(const trace::Turn& turn, int) {
  columns_.turn_component.add(component(turn.component));
  columns_.turn_angle.add(millionths(turn.angle_deg, "an angle"));
  columns_.turn_from.add(time_millionths(trace::seconds(turn.from)));
  add_pose(columns_.turn_pose, turn.X_TO);
  const trace::Hit hit = turn.hit.value_or(trace::Hit{});
  columns_.turn_moved.add(string(hit.moved));
  columns_.turn_met.add(string(hit.met));
}

void FilmBuilder::write(const trace::Removal& removal, int) {
  columns_.remove_component.add(component(removal.component));
}

void FilmBuilder::write(const trace::ColdJoint& joint, int) {
  if (joint.ends.size() != 4) throw std::invalid_argument("expected x and y of two ends as 'ends'");
  for (const double each : joint.ends) {
    columns_.cold_joint_ends.add(millionths(each, "a place"));
  }
  columns_.cold_joint_age.add(time_millionths(trace::seconds(joint.age)));
}

void FilmBuilder::write(const trace::MotionEnd& end, int run) {
  columns_.end_status.add(string(end.status));
  columns_.end_message.add(string(end.message));
  columns_.end_reached.add(end.reached ? 1 : 0);
  columns_.end_tries.add(end.tries);
  columns_.end_accepted.add(end.accepted);
  // Where single steps are not written, this is where they led.
  move(end.q, run);
}

void FilmBuilder::write(const trace::TaskEnd& end, int run) {
  FilmRun& ended = runs_[run];
  ended.result = end.result;
  ended.reason = end.reason;
  ended.happened = trace::has_happened(ended.result);
  ended.end = ended.happened ? ended.last : tracks_->reached(run).value_or(ended.start);
  if (ended.happened) {
    tracks_->accept(run);
  } else {
    tracks_->reject(run);
  }
  runs_.close(run);
}

}  // namespace rubicon::film
