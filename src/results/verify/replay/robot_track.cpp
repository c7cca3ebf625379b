#include "src/results/verify/replay/robot_track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/motion/math/turns.hpp"
#include "src/results/verify/geometry/pose_miss.hpp"
#include "src/results/verify/replay/leg_motion.hpp"
#include "src/results/verify/replay/step_rules.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// m or degrees by which a value may miss its goal where the header does not tell.
constexpr double kGoalSlack = 1e-3;
/// Share of its step by which a value may miss its goal (LANGUAGE 4).
constexpr double kGoalShare = 1e-6;
/// m or degrees by which a short plan that is done may miss its goal beyond what the plan allows.
constexpr double kJudgedSlack = 1e-6;
/// What is nearer to its goal than this (share of what is allowed; m or degrees where nothing is)
/// is at it, however it is rounded.
constexpr double kSureShare = 0.01;
constexpr double kSureSlack = 1e-9;
/// kg: a load at the limit of its chart is within it.
constexpr double kMassSlack = 1e-6;
/// m: how far a tool that works over a floor may be beside its strip.
constexpr double kMostAside = 0.02;
/// m: what the radius of a load is known to, and a tenth for what is rounded here.
constexpr double kRadiusSlack = 1.1e-6;
/// m: how exactly the radius is judged in the middle of a step.
constexpr double kRadiusSlackOnWay = 2e-3;
/// m: rounding of how far the tool is from a waypoint.
constexpr double kMissedSlack = 1e-6;

/// A waypoint that the motion under way has left. Neither `reached` nor `missed`: it is at the
/// limit of what is allowed.
struct LeftWayPoint {
  int k = 0;  ///< its number, from 1
  bool reached = false;
  bool missed = false;
  double off = 0;  ///< m, of the tool
};

class TrackBuilder {
 public:
  TrackBuilder(const Trace& trace, const std::vector<TaskRun>& runs, int robot,
               std::vector<LoadEvent>& loads, Faults& faults)
      : trace_(trace),
        runs_(runs),
        index_(robot),
        robot_(trace.scene.robots[at(robot)]),
        mechanism_(robot_),
        loads_(loads),
        faults_(faults),
        q_(start_values(robot_)) {
    if (robot == 0 && !trace.scene.carry.empty()) {
      track_.loads.push_back({-1, Pose::Identity(), 0});
      hanging_ = 0;
    }
  }

  RobotTrack build(Ticks until) {
    for (const int index : in_order()) follow(index);
    stand_until(until);
    return std::move(track_);
  }

 private:
  std::vector<int> in_order() const {
    std::vector<int> order;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      if (runs_[i].robot == index_ && runs_[i].happened) order.push_back(static_cast<int>(i));
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return runs_[at(a)].start < runs_[at(b)].start; });
    return order;
  }

  void follow(int run) {
    stand_until(runs_[at(run)].start);
    run_ = run;
    now_ = runs_[at(run)].start;
    moving_ = stopped_ = {};
    for (const int index : runs_[at(run)].records) {
      record_ = &trace_.records[at(index)];
      std::visit([&](const auto& what) { follow(what); }, record_->what);
      now_ = record_->time;
    }
  }

  void fault(FaultKind kind, std::string text) {
    faults_.push_back({kind, ResultFile::trace, record_->line, trace_.runs[at(runs_[at(run_)].run)],
                       now_, fmt::format("{}: {}", robot_.name, text)});
  }

  void stand_until(Ticks time) {
    if (time <= stands_since_) return;
    track_.legs.push_back(
        {stands_since_, time, q_, {}, hanging_, run_, record_ != nullptr ? record_->line : 0});
    stands_since_ = time;
  }

  template <typename Other>
  void follow(const Other&) {}

  /// What begins now begins when the machine stands.
  void expect_standing(const char* what) {
    const RunTime rest = rest_time(robot_, moving_);
    if (rest.time > rest.slack) {
      fault(FaultKind::motion, fmt::format("{} {:g} s before the machine stands", what,
                                           static_cast<double>(rest.time) / kSecond));
    }
    moving_ = stopped_ = {};
  }

  void follow(const Stop&) {
    const RunTime rest = rest_time(robot_, moving_);
    const Ticks told = record_->time - now_;
    if (moving_.parts.empty()) {
      fault(FaultKind::motion, "a stop of a machine that stands");
    } else if (std::llabs(told - rest.time) > rest.slack) {
      fault(FaultKind::motion, fmt::format("the stop lasts {:g} s instead of {:g} s",
                                           static_cast<double>(told) / kSecond,
                                           static_cast<double>(rest.time) / kSecond));
    }
    stopped_ = std::exchange(moving_, {});
  }

  /// A truck that carries soil drives as loaded.
  void follow(const SoilTaken& taken) {
    const int task = runs_[at(run_)].task;
    if (task >= 0 && trace_.scene.tasks[at(task)].haul) soil_ = taken.volume > 0;
  }

  void follow(const GuidePlan& plan) {
    if (!plan.way.empty()) expect_values(plan.way.front(), "the way of a guide");
  }

  void follow(const Wait&) { expect_standing("a wait begins"); }
  void follow(const Think&) { expect_standing("a guide thinks"); }
  void follow(const Work&) { expect_standing("a work begins"); }
  void follow(const Pause&) { expect_standing("a pause begins"); }

  void follow(const Try& attempt) {
    if (!attempt.ok) {
      expect_values(attempt.q, "a refused attempt");
      stopped_ = {};
      return;
    }
    stand_until(now_);
    StepQuery query{q_,
                    attempt.q,
                    attempt.moved,
                    hanging_ >= 0 || soil_,
                    record_->time - now_,
                    moving_,
                    least_time(attempt.q)};
    StepResult result = check_step(robot_, query);
    if (!result.goes_on) expect_standing("a step of another run begins");
    if (!stopped_.parts.empty() && result.run.is_of_same_parts(stopped_)) {
      fault(FaultKind::motion, "a stop in the middle of a run");
    }
    stopped_ = {};
    moving_ = std::move(result.run);
    for (std::string& text : result.faults) fault(FaultKind::motion, std::move(text));
    check_load_chart(result.reached);
    note_aside(attempt.q);
    expect_off_holes(attempt.q);
    track_.legs.push_back(
        {now_, record_->time, q_, std::move(result.reached), hanging_, run_, record_->line});
    q_ = attempt.q;
    stands_since_ = std::max(stands_since_, record_->time);
  }

  void follow(const Goal& goal) {
    if (goal.k > 1) {
      expect_covered();
      judge_way_point(goal.k - 1);
    } else {
      left_behind_.clear();
    }
    aside_ = 0;
    q_at_way_point_ = q_;
    left_ = goal.n - goal.k;
  }

  /// The task under way if it covers a floor, else null.
  const SceneTask* covering() const {
    const int task = runs_[at(run_)].task;
    if (task < 0) return nullptr;
    const SceneTask& planned = trace_.scene.tasks[at(task)];
    return planned.working.size() > at(left_) ? &planned : nullptr;
  }
  /// The waypoint under way, by its place in `working`.
  std::size_t waypoint(const SceneTask& task) const { return task.working.size() - 1 - at(left_); }

  Vec3 tool_at(const std::vector<double>& q) const {
    return mechanism_.pose(mechanism_.tool(), q).translation();
  }

  /// A tool that covers a floor is at each of its waypoints before it goes on to the next.
  void expect_covered() {
    const SceneTask* const task = covering();
    if (task == nullptr || left_ == 0) return;
    const SceneGoal& goal = task->via[waypoint(*task)];
    if (goal.pose) expect_pose(*goal.pose, *task, "it goes on");
    expect_on_strip();
  }

  void expect_on_strip() {
    if (aside_ <= kMostAside) return;
    fault(FaultKind::motion, fmt::format("the tool is {:.1f} mm beside its strip, of {:g} mm that "
                                         "it may be",
                                         aside_ * 1000, kMostAside * 1000));
  }

  /// How far a step leads a tool that works beside the line to its waypoint.
  void note_aside(const std::vector<double>& after) {
    const SceneTask* const task = covering();
    if (task == nullptr || !task->working[waypoint(*task)] || q_at_way_point_.empty()) return;
    const std::optional<Pose>& goal = left_ == 0 ? task->go_pose : task->via[waypoint(*task)].pose;
    if (!goal) return;
    const Vec3 from = tool_at(q_at_way_point_);
    const Vec3 along = goal->translation() - from;
    const Vec3 gone = tool_at(after) - from;
    const double length = along.norm();
    const double share = length > 0 ? std::clamp(gone.dot(along) / (length * length), 0.0, 1.0) : 0;
    aside_ = std::max(aside_, (gone - share * along).norm());
  }

  /// A tool that guides lead from strip to strip comes over no shaft or column: places along the
  /// step.
  void expect_off_holes(const std::vector<double>& after) {
    const SceneTask* const task = covering();
    if (task == nullptr || task->holes.empty() || waypoint(*task) == 0) return;
    if (task->working[waypoint(*task)]) return;
    constexpr int kPlaces = 8;
    std::vector<double> q = q_;
    for (int k = 1; k <= kPlaces; ++k) {
      for (std::size_t i = 0; i < q.size(); ++i) {
        q[i] = q_[i] + (after[i] - q_[i]) * k / static_cast<double>(kPlaces);
      }
      const Vec3 p_W = tool_at(q);
      const Vec3 p = task->area ? Vec3(task->area->inverse() * p_W) : p_W;
      for (const FloorHole& hole : task->holes) {
        const double deep = depth_inside(hole.corners, p.x(), p.y());
        if (deep <= kMostAside) continue;
        fault(FaultKind::motion, fmt::format("a guide leads the tool {:.1f} mm into {} of its area",
                                             deep * 1000, hole.name));
        return;
      }
    }
  }

  /// m: how far a place lies inside a polygon, negative outside.
  static double depth_inside(const std::vector<std::pair<double, double>>& ring, double x,
                             double y) {
    bool inside = false;
    double nearest = 1e30;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto [ax, ay] = ring[i];
      const auto [bx, by] = ring[i + 1 < ring.size() ? i + 1 : 0];
      if ((ay > y) != (by > y) && x < ax + (bx - ax) * (y - ay) / (by - ay)) inside = !inside;
      const double square = (bx - ax) * (bx - ax) + (by - ay) * (by - ay);
      const double along = (x - ax) * (bx - ax) + (y - ay) * (by - ay);
      const double share = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
      const double off_x = ax + share * (bx - ax) - x;
      const double off_y = ay + share * (by - ay) - y;
      nearest = std::min(nearest, std::sqrt(off_x * off_x + off_y * off_y));
    }
    return inside ? nearest : -nearest;
  }

  /// How long a step takes at least, where its tool works over a floor.
  Ticks least_time(const std::vector<double>& after) const {
    const SceneTask* const task = covering();
    if (task == nullptr || !(task->pace > 0) || !task->working[waypoint(*task)]) return 0;
    return static_cast<Ticks>((tool_at(after) - tool_at(q_)).norm() / task->pace * kSecond + 0.5);
  }

  void follow(const MotionEnd& end) {
    expect_standing("a motion ends");
    expect_values(end.q, "the end of a motion");
    expect_missed(end);
    last_status_ = end.status;
  }

  /// A task that is done left the robot where the plan wanted it.
  void follow(const TaskEnd& end) {
    expect_standing("the task ends");
    if (trace_.scene.short_form) {
      expect_short_result(end.result);
      return;
    }
    if (end.result != TaskResult::done) return;
    const int task = runs_[at(run_)].task;
    if (task < 0) {
      expect_goal(park_of(trace_, runs_[at(run_)]), {});
      return;
    }
    const SceneTask& planned = trace_.scene.tasks[at(task)];
    expect_goal(planned.go, planned.within);
    if (planned.go_pose) expect_pose(*planned.go_pose, planned, "the task is done");
    if (!planned.working.empty()) expect_on_strip();
  }

  void expect_short_result(TaskResult told);
  bool is_at(const SceneGoal& goal, const SceneTask& task, double share, double slack) const;
  std::vector<double> values_at(const SceneGoal& goal, std::vector<double> q) const;
  void judge_way_point(int k);
  void expect_missed(const MotionEnd& end);

  void expect_goal(const std::vector<std::pair<int, double>>& goal,
                   const std::optional<SceneWithin>& within) {
    for (const auto& [index, value] : goal) {
      const SceneParameter& p = robot_.parameters[at(index)];
      double slack = within ? kValueSlack + kGoalShare * std::max(p.step, 1.0) : kGoalSlack;
      for (const auto& [name, allowed] : within.value_or(SceneWithin{}).values) {
        if (name == p.name) slack += allowed;
      }
      const double off = q_[at(index)] - value;
      if (std::fabs(p.rotation ? math::normalised_deg(off) : off) <= slack) continue;
      fault(FaultKind::motion, fmt::format("the task is done with {} at {:g} instead of {:g}",
                                           p.name, q_[at(index)], value));
    }
  }

  void expect_pose(const Pose& X_WG, const SceneTask& task, const char* what,
                   bool any_turn = false);

  void follow(const LoadChange& change) {
    expect_standing("a load changes");
    if (change.kind == LoadChange::Kind::remove) return;
    LoadEvent event{record_->time, record_->line, run_, change, Pose::Identity(), -1, index_};
    event.X_WT = mechanism_.pose(mechanism_.tool(), q_);
    stand_until(record_->time);
    if (change.kind == LoadChange::Kind::attach) {
      if (hanging_ >= 0) fault(FaultKind::load, "it takes something and carries something already");
      hang({change.component, change.X, 0});
      check_weight();
      const int task = runs_[at(run_)].task;
      if (task >= 0 && change.component >= 0) {
        const SceneTask& spec = trace_.scene.tasks[at(task)];
        const Pose X_WG =
            event.X_WT * change.X * trace_.scene.components[at(change.component)].X_OG;
        // What people turn is taken as the hook happens to be turned.
        expect_pose(X_WG, spec, "it takes its load", spec.adjust && spec.adjust->turning);
      }
    } else {
      event.hung = hanging_;
      hanging_ = -1;
    }
    loads_.push_back(event);
  }

  void follow(const LoadTurn& turn) {
    if (hanging_ < 0) {
      fault(FaultKind::load, "people turn what does not hang there");
      return;
    }
    if (!(std::fabs(turn.angle_deg) < math::kTurn_deg) || turn.angle_deg == 0) {
      fault(FaultKind::load, fmt::format("a turn by {:g} degrees", turn.angle_deg));
    }
    stand_until(turn.from);
    const Hanging before = track_.loads[at(hanging_)];
    hang({before.component, before.X_TO, turn.angle_deg});
    const Pose X_WT = mechanism_.pose(mechanism_.tool(), q_);
    const Pose X_WO = turned_about_vertical(X_WT * before.X_TO, X_WT.translation(), turn.angle_deg);
    const PoseMiss off = pose_miss(X_WT * turn.X_TO, X_WO);
    if (!off.within(kSamePose)) {
      fault(FaultKind::load, fmt::format("turned by {:g} degrees it hangs {} from where it is told",
                                         turn.angle_deg, text_of(off)));
    }
    stand_until(record_->time);
    hang({before.component, turn.X_TO, 0});
  }

  void hang(const Hanging& load) {
    hanging_ = static_cast<int>(track_.loads.size());
    track_.loads.push_back(load);
  }

  void expect_values(const std::vector<double>& q, const char* where) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      const double off = q[i] - q_[i];
      const double reduced = robot_.parameters[i].cyclic ? math::normalised_deg(off) : off;
      if (std::fabs(reduced) <= kValueSlack) continue;
      fault(FaultKind::motion, fmt::format("{} has {} at {:g} while it stands at {:g}", where,
                                           robot_.parameters[i].name, q[i], q_[i]));
    }
  }

  double radius(const std::vector<double>& q) const {
    return radius(Vec3(mechanism_.pose(mechanism_.tool(), q).translation()));
  }

  double radius(const Vec3& p_WT) const {
    const Vec3 p_MT = robot_.X_WM.inverse(Eigen::Isometry) * p_WT;
    return std::sqrt(p_MT.x() * p_MT.x() + p_MT.y() * p_MT.y());
  }

  /// Whether the chart allows the load wherever the tool may be on its way.
  bool is_surely_within(const std::vector<double>& after) const {
    const MechanismState way = mechanism_.state(q_, after);
    const int tool = mechanism_.tool();
    const Vec3 p_WT = way.X_WB[at(tool)].translation();
    const double off = mechanism_.reach(way, tool, -1, p_WT, 0).most();
    const double inner = std::max(radius(p_WT) - off, 0.0);
    const double outer = radius(p_WT) + off;
    double least = std::min(allowed(inner), allowed(outer));
    for (const auto& [r, most] : robot_.capacity) {
      if (r > inner && r < outer) least = std::min(least, most);
    }
    return mass() <= least;
  }

  double mass() const {
    const int component = hanging_ < 0 ? -1 : track_.loads[at(hanging_)].component;
    return component < 0 ? 0 : trace_.scene.components[at(component)].mass;
  }

  /// What the load chart allows at a radius: straight between its points, nothing beyond.
  double allowed(double radius) const {
    const auto& chart = robot_.capacity;
    if (radius <= chart.front().first) return chart.front().second;
    for (std::size_t i = 1; i < chart.size(); ++i) {
      if (radius > chart[i].first) continue;
      const double share = (radius - chart[i - 1].first) / (chart[i].first - chart[i - 1].first);
      return chart[i - 1].second + share * (chart[i].second - chart[i - 1].second);
    }
    return 0;
  }

  bool is_within(double r, double slack) const {
    double most = std::max(allowed(std::max(r - slack, 0.0)), allowed(r + slack));
    for (const auto& [radius, mass_there] : robot_.capacity) {
      if (std::fabs(radius - r) <= slack) most = std::max(most, mass_there);
    }
    return mass() <= most + kMassSlack;
  }

  void check_weight() {
    if (robot_.capacity.empty()) return;
    if (!(mass() > 0)) {
      fault(FaultKind::load, "what it lifts has no mass, and the robot has a load chart");
    }
    const double r = radius(q_);
    if (is_within(r, kRadiusSlack)) return;
    fault(FaultKind::load, fmt::format("{:g} kg are too heavy at {:g} m", mass(), r));
  }

  /// At moments of a step, to the resolution with which the run judges it.
  void check_load_chart(const std::vector<double>& after) {
    if (robot_.capacity.empty() || !(mass() > 0) || is_surely_within(after)) return;
    const double before = radius(q_);
    const bool is_too_heavy_before = !is_within(before, kRadiusSlack);
    constexpr int kMoments = 64;
    std::vector<double> q = q_;
    for (int moment = kMoments; moment > 0; --moment) {
      const double s = static_cast<double>(moment) / kMoments;
      for (std::size_t i = 0; i < q.size(); ++i) q[i] = q_[i] + s * (after[i] - q_[i]);
      const double slack = moment == kMoments ? kRadiusSlack : kRadiusSlackOnWay;
      const double r = radius(q);
      if (is_within(r, slack) || std::fabs(r - before) <= slack) continue;
      if (is_too_heavy_before && r < before) continue;
      fault(FaultKind::load,
            fmt::format("{:g} kg are carried {} {:g} m, where the load chart allows {:g} kg",
                        mass(), r > before ? "out to" : "in to", r, allowed(r)));
      return;
    }
  }

  const Trace& trace_;
  const std::vector<TaskRun>& runs_;
  const int index_;
  const SceneRobot& robot_;
  const Mechanism mechanism_;
  std::vector<LoadEvent>& loads_;
  Faults& faults_;
  RobotTrack track_;
  bool soil_ = false;  ///< it carries some
  std::vector<double> q_;
  /// m: how far a tool that works was beside its strip since its waypoint began
  double aside_ = 0;
  int left_ = 0;                           ///< waypoints of the motion after the one under way
  std::vector<double> q_at_way_point_;     ///< when the last waypoint began
  std::vector<LeftWayPoint> left_behind_;  ///< of the motion under way
  std::string last_status_;                ///< of its last motion
  MotionRun moving_;                       ///< the run that goes on
  MotionRun stopped_;  ///< the run of the stop just before, if nothing was tried since
  int hanging_ = -1;
  int run_ = -1;
  Ticks now_ = 0;
  Ticks stands_since_ = 0;
  const Record* record_ = nullptr;
};

void TrackBuilder::expect_pose(const Pose& X_WG, const SceneTask& task, const char* what,
                               bool any_turn) {
  GoalTolerance allowed = goal_tolerance(robot_, task.within);
  if (any_turn) allowed.turned_deg = math::kTurn_deg;
  const PoseMiss off = pose_miss(mechanism_.pose(mechanism_.tool(), q_), X_WG, task.free_axis);
  if (off.within(allowed)) return;
  fault(FaultKind::motion, fmt::format("{} with the tool {} from its goal", what, text_of(off)));
}

/// The configuration `q` with the values that a goal names.
std::vector<double> TrackBuilder::values_at(const SceneGoal& goal, std::vector<double> q) const {
  for (const auto& [index, value] : goal.values) q[at(index)] = value;
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (!robot_.parameters[i].derived) continue;
    q[i] = robot_.parameters[i].rule.value(FormulaValues{q, {}, robot_.starts});
  }
  return q;
}

/// Whether the robot stands at a goal or waypoint of a task: by `share` of what `within` allows,
/// and `slack` (m, degrees) beyond.
bool TrackBuilder::is_at(const SceneGoal& goal, const SceneTask& task, double share,
                         double slack) const {
  const SceneWithin within = task.within.value_or(SceneWithin{});
  if (goal.pose) {
    GoalTolerance allowed = goal_tolerance(robot_, within);
    allowed.off = share * allowed.off + slack;
    allowed.turned_deg = share * allowed.turned_deg + slack;
    const PoseMiss off =
        pose_miss(mechanism_.pose(mechanism_.tool(), q_), *goal.pose, task.free_axis);
    if (!off.within(allowed)) return false;
    if (goal.values.empty()) return true;
  }
  const std::vector<double> there = values_at(goal, q_at_way_point_.empty() ? q_ : q_at_way_point_);
  // Within a length of it the tool may be anywhere; turned as the goal says.
  const bool near = within.length >= 0 && pose_miss(mechanism_.pose(mechanism_.tool(), q_),
                                                    mechanism_.pose(mechanism_.tool(), there))
                                                  .off <= share * within.length + slack;
  return std::all_of(goal.values.begin(), goal.values.end(), [&](const auto& named) {
    const SceneParameter& p = robot_.parameters[at(named.first)];
    double allowed = kGoalShare * p.step;
    for (const auto& [name, value] : within.values) {
      if (name == p.name) allowed += value;
    }
    const double off = q_[at(named.first)] - named.second;
    return std::fabs(p.rotation ? math::normalised_deg(off) : off) <= share * allowed + slack ||
           (near && !p.rotation);
  });
}

/// What is sure, beyond rounding, of a waypoint that the script has left.
void TrackBuilder::judge_way_point(int k) {
  const int index = runs_[at(run_)].task;
  if (index < 0) return;
  const SceneTask& task = trace_.scene.tasks[at(index)];
  if (left_ < 1 || at(left_) > task.via.size()) return;
  const SceneGoal& goal = task.via[task.via.size() - at(left_)];
  const Vec3 place = goal.pose ? goal.pose->translation() : tool_at(values_at(goal, q_));
  LeftWayPoint left;
  left.k = k;
  left.reached = is_at(goal, task, 1 - kSureShare, kSureSlack);
  left.missed = !is_at(goal, task, 1, kJudgedSlack);
  left.off = (place - tool_at(q_)).norm();
  left_behind_.push_back(left);
}

/// The end of a motion tells the waypoints that it left without reaching them, and no others.
void TrackBuilder::expect_missed(const MotionEnd& end) {
  for (const LeftWayPoint& left : left_behind_) {
    const auto told = std::find_if(end.missed.begin(), end.missed.end(),
                                   [&](const auto& each) { return each.first == left.k; });
    if (told == end.missed.end()) {
      if (!left.missed) continue;
      fault(
          FaultKind::motion,
          fmt::format("waypoint {} was left with the tool {:g} m from it and is not told as missed",
                      left.k, left.off));
    } else if (left.reached) {
      fault(FaultKind::motion,
            fmt::format("waypoint {} was reached and is told as missed", left.k));
    } else if (std::fabs(told->second - left.off) > kMissedSlack) {
      fault(FaultKind::motion, fmt::format("waypoint {} is told as missed by {:g} m, not by {:g} m",
                                           left.k, told->second, left.off));
    }
  }
  for (const auto& [k, off] : end.missed) {
    const bool left = std::any_of(left_behind_.begin(), left_behind_.end(),
                                  [k = k](const auto& each) { return each.k == k; });
    if (!left) {
      fault(FaultKind::motion,
            fmt::format("waypoint {} is told as missed, and the motion never left it", k));
    }
  }
  left_behind_.clear();
}

/// The motion of a short plan is done at its goal and short anywhere else; one that did not end by
/// its script is rejected. Where neither is sure by rounding both pass.
void TrackBuilder::expect_short_result(TaskResult told) {
  const SceneTask& task = trace_.scene.tasks.front();
  if (!task.within || (!task.go_pose && task.go.empty())) return;
  const SceneGoal goal{task.go, task.go_pose};
  if (last_status_ != "done") {
    if (told != TaskResult::rejected) {
      fault(FaultKind::motion,
            fmt::format("its motion ended with '{}' and it is not rejected", last_status_));
    }
  } else if (told == TaskResult::rejected) {
    fault(FaultKind::motion, "its script ended, and it is told as rejected");
  } else if (told == TaskResult::done && !is_at(goal, task, 1, kJudgedSlack)) {
    fault(FaultKind::motion, "it is told as done and ended short of its goal");
  } else if (told == TaskResult::ended_short && is_at(goal, task, 1 - kSureShare, kSureSlack)) {
    fault(FaultKind::motion, "it is told as short and stands at its goal");
  }
}

}  // namespace

RobotTrack follow_robot(const Trace& trace, const std::vector<TaskRun>& runs, int robot,
                        Ticks until, std::vector<LoadEvent>& loads, Faults& faults) {
  return TrackBuilder(trace, runs, robot, loads, faults).build(until);
}

}  // namespace rubicon::verify
