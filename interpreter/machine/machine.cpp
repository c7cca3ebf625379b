#include "interpreter/machine/machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "interpreter/machine/run_time_error.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::interpreter {

namespace {

/// Below it (m or degrees) a distance is rounding: a message says 0 instead, and `within` allows
/// it.
constexpr double kRounding = 1e-6;

/// Plans round what is foreseen, on the way to one waypoint: after these only workspaces stop it.
constexpr int kMostLooks = 12;

double readable(double distance) { return distance < kRounding ? 0 : distance; }

/// Where only a turn is missing that no parameter of the robot makes: which.
std::string missing_turn(const robot::RobotModel& model, const robot::Mounting& mounting,
                         const robot::GoalSolution& solution, const math::Pose& X_WG,
                         const robot::PoseTolerance& tolerance) {
  if (solution.position_error > tolerance.position) return {};
  if (solution.q.size() != model.parameters.size()) return {};
  const math::Pose X_WT = robot::tool_pose(model, mounting, solution.q);
  // What the goal is turned against the tool, in the world: it leaves its own axis where it is.
  const math::Mat3 R_W = X_WG.linear() * X_WT.linear().transpose();
  constexpr double kSame = 1e-6;
  for (int i = 0; i < 3; ++i) {
    if ((R_W.col(i) - math::Vec3::Unit(i)).norm() > kSame) continue;
    return i == 2 ? "; no swivel: the turn about z is not free; use within or add one, or let "
                    "people turn "
                    "what hangs: adjust 4 min turning theta;"
                  : fmt::format("; the turn about {} is not free; use within", "xyz"[i]);
  }
  return {};
}

}  // namespace

const char* name_of(MotionStatus status) {
  switch (status) {
    case MotionStatus::done:
      return "done";
    case MotionStatus::livelock:
      return "livelock";
    case MotionStatus::circling:
      return "circling";
    case MotionStatus::budget:
      return "budget";
    case MotionStatus::start_blocked:
      return "start_blocked";
    case MotionStatus::goal_impossible:
      return "goal_impossible";
    case MotionStatus::no_way:
      return "no_way";
    case MotionStatus::error:
      return "error";
  }
  return "";
}

Machine::Machine(const Program& program, MotionTask task)
    : program_(&program), model_(&program.robot->model), task_(std::move(task)) {
  q_ = task_.q;
  time_ = task_.start;
  variables_.resize(program.variables.size());
  steps_.assign(q_.size(), 0.0);
  q_next_ = q_;
  asked_steps_ = steps_;
  asked_q_ = q_;
}

bool Machine::advance(World& world, EventSink* events) {
  if (!end_ && go_on(world, events)) return true;
  if (!stop(events)) return false;
  end_->time = time_;
  return true;
}

bool Machine::stop(EventSink* events) {
  Ticks rest = 0;
  for (const MotionRun& part : run_) rest = std::max(rest, part.rest());
  run_.clear();
  if (rest == 0) return false;
  time_ += rest;
  if (events) events->stop(time_);
  return true;
}

/// To the next attempt or stop (true), or to the end of what the script does (false).
bool Machine::go_on(World& world, EventSink* events) {
  try {
    if (!started_) {
      started_ = true;
      world_version_ = world.version();
      if (auto pair = world.blocked_at(q_)) {
        last_hit_ = pair;
        finish(MotionStatus::start_blocked,
               fmt::format("start in collision: {} meets {}", pair->moved, pair->met));
        return false;
      }
    }
    while (true) {
      if (thought_ && !end_thinking(world, events)) return false;
      if (thought_) return true;
      if (!way_point_begun_ && !begin_way_point(world, events)) return false;
      if (thought_) return true;
      look_ahead(world, events);
      if (thought_) return true;
      if (run_to_attempt(world, events)) return true;
      if (end_) return false;
      if (guide_ && next_way_point(world, events)) {
        if (thought_) return true;
        continue;
      }
      if (end_) return false;
      guide_.reset();
      if (!may_leave_way_point()) return false;
      note_missed();
      way_point_begun_ = false;
      if (++way_point_ == task_.goals.size()) {
        --way_point_;
        finish(MotionStatus::done);
        return false;
      }
    }
  } catch (const RunTimeError& error) {
    finish(MotionStatus::error, error.message, error.span);
    return false;
  }
}

/// Takes note of how far the accepted step leads the tool beside its strip: at its middle and end.
void Machine::note_aside() {
  const GoalSpec& goal = task_.goals[way_point_];
  if (goal.work != GoalSpec::Work::working || !goal.X_WG) return;
  const math::Vec3 along = goal.X_WG->translation() - strip_from_;
  const double length = along.norm();
  std::vector<double> middle(q_.size());
  for (std::size_t i = 0; i < q_.size(); ++i) middle[i] = (q_[i] + q_next_[i]) / 2;
  for (const std::vector<double>* q : {&middle, &q_next_}) {
    const math::Vec3 gone =
        robot::tool_pose(*model_, task_.mounting, *q).translation() - strip_from_;
    const double share = length > 0 ? std::clamp(gone.dot(along) / (length * length), 0.0, 1.0) : 0;
    aside_ = std::max(aside_, (gone - share * along).norm());
  }
}

/// Whether the next waypoint may begin. One that a tool works towards, or from, is not left out:
/// the floor would not be covered.
bool Machine::may_leave_way_point() {
  if (task_.goals[way_point_].work == GoalSpec::Work::none) return true;
  if (way_point_ + 1 == task_.goals.size() && aside_ <= kMostAside) return true;
  const bool strays = aside_ > kMostAside;
  if (is_near_goal() && !strays) return true;
  finish(MotionStatus::done);
  if (strays) {
    end_->reached = false;
    end_->message = fmt::format(
        "the tool went {:.0f} mm beside its strip on the way to waypoint "
        "{} of {} over the floor; take line where it is working",
        aside_ * 1000, way_point_ + 1, task_.goals.size());
    return false;
  }
  end_->message = fmt::format("waypoint {} of {} over the floor is not reached: {}", way_point_ + 1,
                              task_.goals.size(), end_->message);
  return false;
}

/// A script may leave a waypoint without reaching it; it is told at the end of the motion.
void Machine::note_missed() {
  if (!goal_.via || is_near_goal()) return;
  std::vector<double> there = goal_.q;
  if (!goal_.X_WG) {
    // What the waypoint does not name is anywhere.
    for (std::size_t i = 0; i < there.size(); ++i) {
      if (!goal_.named[i]) there[i] = q_[i];
    }
    robot::update_derived(*model_, task_.mounting, there);
  }
  const math::Vec3 p_WG = goal_.X_WG ? goal_.p_WG : tool_place(there);
  missed_.push_back({static_cast<int>(way_point_) + 1, tool_distance(p_WG)});
}

bool Machine::begin_way_point(World& world, EventSink* events) {
  if (!resolve_goal(task_.goals[way_point_])) return false;
  if (events) {
    events->goal(static_cast<int>(way_point_) + 1, static_cast<int>(task_.goals.size()));
  }
  seen_.clear();
  visited_.clear();
  world_version_ = world.version();
  way_point_begun_ = true;
  aside_ = 0;
  looks_left_ = kMostLooks;
  no_round_.clear();
  if (task_.goals[way_point_].work == GoalSpec::Work::working) {
    strip_from_ = robot::tool_pose(*model_, task_.mounting, q_).translation();
  }
  target_ = goal_;
  // Where it works over a floor the tool keeps to its strip.
  const bool leads = task_.goals[way_point_].work != GoalSpec::Work::working;
  if (leads && !task_.guides.empty() && !leg().is_there(q_, goal_.q)) {
    return begin_guides(0, world, events);
  }
  begin_script();
  return true;
}

void Machine::begin_script() {
  std::fill(variables_.begin(), variables_.end(), Variable{});
  stack_.clear();
  actives_.clear();
  way_.clear();
  if (program_->uses_way) way_.begin(q_, tool_place(q_), target_.p_WG);
  push_sequence(program_->main);
}

/// Finds the configuration of a goal; false: there is none, and the motion has ended.
bool Machine::resolve_goal(const GoalSpec& spec) {
  goal_ = {};
  goal_.via = way_point_ + 1 < task_.goals.size();
  goal_.q = q_;
  goal_.named.assign(q_.size(), 0);
  if (spec.X_WG) {
    name_values(spec);
    const robot::GoalSolution solution = solved(spec);
    if (!solution.reachable) {
      finish(MotionStatus::goal_impossible,
             fmt::format(
                 "goal out of reach: the nearest pose is {:.3g} m and {:.3g} degrees off{}",
                 readable(solution.position_error),
                 readable(math::degrees(solution.orientation_error)),
                 missing_turn(*model_, task_.mounting, solution, *spec.X_WG, frame_tolerance())),
             spec.span);
      return false;
    }
    goal_.q = solution.q;
    goal_.X_WG = spec.X_WG;
    for (std::size_t i = 0; i < q_.size(); ++i) {
      goal_.named[i] =
          parameter(static_cast<int>(i)).free && !parameter(static_cast<int>(i)).derived;
    }
    for (const auto& [index, value] : spec.values) goal_.named[static_cast<std::size_t>(index)] = 1;
    goal_.p_WG = spec.X_WG->translation();
  } else {
    name_values(spec);
    robot::update_derived(*model_, task_.mounting, goal_.q);
    for (const auto& [index, value] : spec.values) {
      if (parameter(index).derived) goal_.q[static_cast<std::size_t>(index)] = value;
    }
    goal_.p_WG = robot::tool_pose(*model_, task_.mounting, goal_.q).translation();
  }
  return true;
}

/// The configuration of a goal frame, for `goal_.q`.
robot::GoalSolution Machine::solved(const GoalSpec& spec) {
  GoalMemory* const memory = task_.memory.get();
  if (memory != nullptr && memory->knows(goal_.q, spec.values, *spec.X_WG)) return memory->solution;
  robot::GoalSolution solution = robot::solve_goal(*model_, task_.mounting, goal_.q, *spec.X_WG,
                                                   frame_tolerance(), frame_clauses(spec));
  if (memory != nullptr) *memory = {goal_.q, spec.values, *spec.X_WG, solution};
  return solution;
}

void Machine::name_values(const GoalSpec& spec) {
  for (const auto& [index, value] : spec.values) {
    const auto i = static_cast<std::size_t>(index);
    goal_.q[i] = robot::nearest_turn_equivalent(parameter(index), value, q_[i]);
    goal_.named[i] = 1;
  }
}

/// What a goal frame asks: the values beside it are as good as locked while it is solved.
robot::GoalClauses Machine::frame_clauses(const GoalSpec& spec) const {
  robot::GoalClauses clauses = task_.clauses;
  for (const auto& [index, value] : spec.values) clauses.locked.push_back(index);
  std::sort(clauses.locked.begin(), clauses.locked.end());
  return clauses;
}

robot::PoseTolerance Machine::frame_tolerance() const {
  robot::PoseTolerance tolerance;
  if (task_.within.length >= 0) tolerance.position = task_.within.length;
  for (const auto& [index, value] : task_.within.values) {
    if (parameter(index).rotation) {
      tolerance.orientation = std::max(tolerance.orientation, math::radians(value));
    }
  }
  return tolerance;
}

double Machine::tolerance_of(int index) const {
  double tolerance = kEpsilon * parameter(index).quantum;
  for (const auto& [within, value] : task_.within.values) {
    if (within == index) tolerance += value;
  }
  return tolerance;
}

void Machine::finish(MotionStatus status, std::string message, Span span) {
  end_.emplace();
  end_->status = status;
  end_->tries = tries_;
  end_->accepted = accepted_;
  end_->rejected = rejected_;
  end_->q = q_;
  end_->time = time_;
  end_->message = std::move(message);
  end_->span = span;
  end_->hit = last_hit_;
  end_->missed = missed_;
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    if (variables_[i].set) {
      end_->variables.emplace_back(program_->variables[i], variables_[i].value.number);
    }
  }
  measure_residual();
  if (status == MotionStatus::done) judge();
}

void Machine::measure_residual() {
  for (std::size_t i = 0; i < goal_.named.size(); ++i) {
    if (!goal_.named[i]) continue;
    end_->residual.emplace_back(static_cast<int>(i), delta(static_cast<int>(i), goal_.q[i]));
  }
  if (goal_.X_WG) {
    const math::Pose X_WT = robot::tool_pose(*model_, task_.mounting, q_);
    end_->position_error = (goal_.X_WG->translation() - X_WT.translation()).norm();
    end_->orientation_error =
        robot::turn_off_deg(X_WT.linear(), goal_.X_WG->linear(), task_.clauses.free);
  }
}

void Machine::judge() {
  if (goal_.X_WG) {
    const robot::PoseTolerance tolerance = frame_tolerance();
    const std::vector<std::pair<int, double>>& values = task_.goals[way_point_].values;
    end_->reached =
        readable(*end_->position_error - tolerance.position) <= 0 &&
        readable(*end_->orientation_error - math::degrees(tolerance.orientation)) <= 0 &&
        std::all_of(values.begin(), values.end(), [&](const auto& named) {
          return std::fabs(delta(named.first, named.second)) <= tolerance_of(named.first);
        });
  } else {
    const bool near =
        task_.within.length >= 0 && readable(tool_distance(goal_.p_WG) - task_.within.length) <= 0;
    end_->reached = std::all_of(end_->residual.begin(), end_->residual.end(),
                                [&](const std::pair<int, double>& off) {
                                  return std::fabs(off.second) <= tolerance_of(off.first) ||
                                         (near && !parameter(off.first).rotation);
                                });
  }
  if (!end_->reached) end_->message = shortfall();
}

std::string Machine::shortfall() const {
  std::string text = "short of the goal:";
  const char* separator = " ";
  for (const auto& [index, off] : end_->residual) {
    if (std::fabs(off) <= tolerance_of(index)) continue;
    text += fmt::format("{}{} is {:g} {} {} the goal", separator, parameter(index).display_name,
                        std::fabs(off), parameter(index).rotation ? "degrees" : "m",
                        off < 0 ? "above" : "below");
    separator = ", ";
  }
  if (separator[0] == ' ' && end_->position_error) {
    text += fmt::format(" the tool is {:g} m and {:g} degrees off", readable(*end_->position_error),
                        readable(*end_->orientation_error));
  }
  return text;
}

math::Vec3 Machine::tool_place(std::span<const double> q) const {
  return robot::tool_pose(*model_, task_.mounting, q).translation();
}

double Machine::tool_distance(const math::Vec3& p_WG) const {
  return (p_WG - tool_place(q_)).norm();
}

}  // namespace rubicon::interpreter
