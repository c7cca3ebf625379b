#include "src/results/verify/replay/check_goals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/motion/math/turns.hpp"
#include "src/results/verify/geometry/pose_miss.hpp"
#include "src/results/verify/input/mechanism.hpp"
#include "src/results/verify/replay/step_rules.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// m and degrees by which the goal frame may be from where the residual says: how exactly a
/// configuration for it was found.
constexpr double kFoundWithin = 1e-5;
constexpr double kFoundWithin_deg = 1e-3;

/// A motion that the plan asks for: its waypoints, the goal last.
struct PlannedMotion {
  std::vector<SceneGoal> goals;
  bool may_end_short = false;  ///< carrying
};

std::vector<PlannedMotion> planned_motions(const Trace& trace, const TaskRun& run) {
  // A goal without values is a frame that the header does not give.
  const SceneGoal frame{{}, Pose::Identity()};
  if (run.task < 0) {
    return {{{SceneGoal{park_of(trace, run), std::nullopt}}, false}};
  }
  const SceneTask& task = trace.scene.tasks[at(run.task)];
  std::vector<PlannedMotion> motions;
  if (task.move >= 0) {
    motions.push_back({{frame}, false});
    motions.push_back({task.via, true});
    motions.back().goals.push_back(frame);
    motions.push_back({{frame}, false});
  }
  if (task.goes) {
    motions.push_back({task.via, trace.scene.short_form});
    motions.back().goals.push_back({task.go, task.go_pose});
  }
  return motions;
}

/// Follows the motions of one task. Where a carrying motion ended short the trace does not say
/// whether it is tried again or the placing one begins: both are followed.
class GoalCheck {
 public:
  GoalCheck(const Trace& trace, const TaskRun& run, Faults& faults)
      : trace_(trace),
        run_(run),
        faults_(faults),
        robot_(trace.scene.robots[at(run.robot)]),
        mechanism_(robot_),
        motions_(planned_motions(trace, run)) {
    if (!motions_.empty()) states_ = {fresh(0)};
  }

  void check() {
    for (const int index : run_.records) {
      record_ = &trace_.records[at(index)];
      if (const auto* goal = std::get_if<Goal>(&record_->what)) {
        if (!begin(*goal)) return;
      } else if (std::holds_alternative<Try>(record_->what) ||
                 std::holds_alternative<Wait>(record_->what)) {
        if (goals_.empty()) return fault("an attempt before the waypoint of its motion begins");
      } else if (std::holds_alternative<GuidePlan>(record_->what)) {
        guided_ = true;
      } else if (const auto* end = std::get_if<MotionEnd>(&record_->what)) {
        if (!finish(*end)) return;
      } else if (std::holds_alternative<Work>(record_->what) ||
                 std::holds_alternative<LoadChange>(record_->what) ||
                 std::holds_alternative<LoadTurn>(record_->what) ||
                 std::holds_alternative<TaskEnd>(record_->what)) {
        if (!leave()) return;
      }
    }
  }

 private:
  /// A motion that may begin, or go on, with `least` to `most` waypoints left.
  struct State {
    std::size_t motion = 0;
    int least = 0;
    int most = 0;
    bool begins = true;
  };

  State fresh(std::size_t motion) const {
    const int count =
        motion < motions_.size() ? static_cast<int>(motions_[motion].goals.size()) : 0;
    return {motion, count, count, true};
  }

  void fault(std::string text) {
    faults_.push_back({FaultKind::order, ResultFile::trace, record_->line,
                       trace_.runs[at(run_.run)], record_->time, std::move(text)});
  }

  bool begin(const Goal& goal) {
    const int expected = static_cast<int>(goals_.size()) + 1;
    const bool same = goals_.empty() || goals_.front().n == goal.n;
    if (goal.k != expected || !same || goal.k > goal.n) {
      fault(
          fmt::format("waypoint {} of {} begins where {} was expected", goal.k, goal.n, expected));
      return false;
    }
    goals_.push_back(goal);
    return true;
  }

  bool finish(const MotionEnd& end) {
    const std::vector<Goal> goals = std::exchange(goals_, {});
    const std::vector<State> before = std::exchange(states_, {});
    const int k = static_cast<int>(goals.size());
    // Under a guide, and over a floor, no waypoint is left out: the motion ends at one that is not
    // reached.
    const bool covers = run_.task >= 0 && !trace_.scene.tasks[at(run_.task)].working.empty();
    const bool is_guided = std::exchange(guided_, false);
    const bool leaves_none_out = covers || is_guided;
    bool fits = false;
    for (const State& state : before) {
      if (state.motion >= motions_.size()) continue;
      const PlannedMotion& motion = motions_[state.motion];
      const bool held = goals.empty();
      const int n = held ? 0 : goals.front().n;
      if (held) {
        // Its goal held before it began, or it ended before its script did.
        const bool undone = trace_.scene.short_form && end.status != "done";
        const bool at_once = end.status == "done" && end.reached && motion.goals.size() == 1;
        if (end.tries != 0 || !(at_once || undone)) continue;
      } else if (n < state.least || n > state.most ||
                 (end.status == "done" && k != n && !(leaves_none_out && !end.reached))) {
        continue;
      }
      fits = true;
      const bool short_of_it = motion.may_end_short && end.status == "done";
      const bool over = end.reached || short_of_it || trace_.scene.short_form;
      const bool again = !end.reached && (end.status == "done" || end.status == "livelock" ||
                                          end.status == "circling" || end.status == "no_way");
      if (over) states_.push_back(fresh(state.motion + 1));
      if (again) states_.push_back({state.motion, n - k + 1, n, false});
      if (!held && end.status != "goal_impossible")
        check_residual(end, motion.goals[motion.goals.size() - at(n - k) - 1]);
    }
    if (!fits) {
      fault(goals.empty() ? "a motion ends and no waypoint of it has begun"
                          : fmt::format("a motion ends with '{}' at waypoint {} of {}", end.status,
                                        k, goals.front().n));
      return false;
    }
    last_status_ = end.status;
    return true;
  }

  /// What follows is no motion: the one before is over.
  bool leave() {
    if (!goals_.empty()) {
      fault("a waypoint begins and its motion does not end");
      return false;
    }
    std::erase_if(states_, [](const State& state) { return !state.begins; });
    if (!states_.empty() || motions_.empty()) return true;
    fault(
        fmt::format("the task goes on after a motion that ended with '{}' and was not tried again",
                    last_status_));
    return false;
  }

  void check_residual(const MotionEnd& end, const SceneGoal& goal) {
    if (goal.pose) {
      check_frame(end);
      return;
    }
    if (end.residual.size() != goal.values.size()) {
      wrong(fmt::format("the residual has {} values, the goal {}", end.residual.size(),
                        goal.values.size()));
    }
    for (const auto& [index, value] : goal.values) {
      const auto told = std::find_if(end.residual.begin(), end.residual.end(),
                                     [&](const auto& each) { return each.first == index; });
      const SceneParameter& p = robot_.parameters[at(index)];
      if (told == end.residual.end()) {
        wrong(fmt::format("the residual lacks {}", p.name));
        continue;
      }
      double off = told->second - (value - end.q[at(index)]);
      // Of an angle that turns freely, or has a range, any turn of the goal may be meant.
      if (p.rotation && (p.cyclic || p.lower || p.upper)) off = math::normalised_deg(off);
      if (std::fabs(off) <= kValueSlack) continue;
      wrong(fmt::format("the residual of {} is {:g}, from {:g} to the goal {:g}", p.name,
                        told->second, end.q[at(index)], value));
    }
  }

  /// The goal frame stands where the residual leads, as far away as it is said to be.
  void check_frame(const MotionEnd& end) {
    if (!end.position_error || !end.orientation_error) {
      wrong("it does not say how far the tool is from its goal");
      return;
    }
    std::vector<double> there = end.q;
    for (const auto& [index, off] : end.residual) there[at(index)] += off;
    for (std::size_t i = 0; i < there.size(); ++i) {
      if (!robot_.parameters[i].derived) continue;
      const FormulaValues values{there, {}, robot_.starts};
      there[i] = robot_.parameters[i].rule.value(values);
    }
    double off = kFoundWithin;
    double turned_deg = kFoundWithin_deg;
    if (run_.task >= 0 && trace_.scene.tasks[at(run_.task)].within) {
      const SceneWithin& within = *trace_.scene.tasks[at(run_.task)].within;
      off += std::max(within.length, 0.0);
      for (const auto& [name, value] : within.values) turned_deg += value;
    }
    const PoseMiss miss = pose_miss(
        mechanism_.pose(mechanism_.tool(), end.q), mechanism_.pose(mechanism_.tool(), there),
        run_.task < 0 ? kNothingFree : trace_.scene.tasks[at(run_.task)].free_axis);
    if (std::fabs(miss.off - *end.position_error) > off) {
      wrong(fmt::format("the tool is {:g} m from its goal, by the residual {:g} m",
                        *end.position_error, miss.off));
    } else if (std::fabs(miss.turned_deg - *end.orientation_error) > turned_deg) {
      wrong(fmt::format("the tool is turned by {:g} degrees from its goal, by the residual {:g}",
                        *end.orientation_error, miss.turned_deg));
    }
  }

  /// Each end is judged once, however many motions it may belong to.
  void wrong(std::string text) {
    if (judged_ == record_) return;
    judged_ = record_;
    faults_.push_back({FaultKind::motion, ResultFile::trace, record_->line,
                       trace_.runs[at(run_.run)], record_->time, std::move(text)});
  }

  const Trace& trace_;
  const TaskRun& run_;
  Faults& faults_;
  const SceneRobot& robot_;
  const Mechanism mechanism_;
  const std::vector<PlannedMotion> motions_;
  std::vector<State> states_;
  std::vector<Goal> goals_;  ///< of the motion under way
  bool guided_ = false;      ///< the motion under way
  std::string last_status_;
  const Record* record_ = nullptr;
  const Record* judged_ = nullptr;
};

}  // namespace

void check_goals(const Trace& trace, const TaskRun& run, Faults& faults) {
  if (run.happened && run.robot >= 0) GoalCheck(trace, run, faults).check();
}

}  // namespace rubicon::verify
