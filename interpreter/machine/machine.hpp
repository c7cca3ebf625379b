#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/functions/way_log.hpp"
#include "interpreter/machine/floor_fence.hpp"
#include "interpreter/machine/goal_memory.hpp"
#include "interpreter/machine/motion_run.hpp"
#include "interpreter/machine/state_table.hpp"
#include "interpreter/program/events.hpp"
#include "interpreter/program/program.hpp"
#include "interpreter/program/world.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/motion/robot/tool_line.hpp"

namespace rubicon::interpreter {

/// One motion: from where the robot is over waypoints to one goal.
struct MotionTask {
  std::vector<GoalSpec> goals;  ///< waypoints, the last is the goal; at least one
  std::vector<std::string>
      situations;  ///< on during the whole motion (besides `via` and what the world switches on)
  std::vector<guides::GuideSpec> guides;  ///< tried in this order; none: unguided
  /// Of a task that covers an area and is led by guides: where they may not lead its tool from
  /// strip to strip. Shared: the machine is copied.
  std::shared_ptr<const FloorFence> fence = {};
  /// Its guides plan again where their way meets what others are foreseen to sweep.
  bool looks_ahead = false;
  /// What motions of the same kind know of goals; null: each finds out by itself. It changes no
  /// answer. Shared: the machine is copied.
  std::shared_ptr<GoalMemory> memory = {};
  Within within;  ///< when the goal counts as reached
  MotionClauses clauses;
  double budget = 20000;   ///< attempts
  double full_budget = 0;  ///< for messages: what the budget was before earlier tries; 0: `budget`
  int first_n = 1;         ///< number of the first attempt
  Ticks start = 0;
  std::vector<double> q;  ///< where the robot stands, per parameter
  robot::Mounting mounting;
};

enum class MotionStatus {
  done,
  livelock,
  circling,
  budget,
  start_blocked,
  goal_impossible,
  no_way,
  error
};
const char* name_of(MotionStatus status);

struct RefusalCounts {
  int at_goal = 0;
  int no_direction = 0;
  int limit = 0;
  int hit = 0;
  int total() const { return at_goal + no_direction + limit + hit; }
};

/// A waypoint that the script left without reaching it.
struct MissedWayPoint {
  int k = 0;       ///< its number among the waypoints of the motion, from 1
  double off = 0;  ///< m, of the tool from where it is at the waypoint
};

/// How a motion ended.
struct MotionEnd {
  MotionStatus status = MotionStatus::done;
  bool reached = false;       ///< only with done
  std::optional<int> period;  ///< of a livelock, in accepted attempts
  int tries = 0;
  int accepted = 0;
  RefusalCounts rejected;
  /// goal - q of every parameter the goal names (or, for a frame, of every free one), cyclic ones
  /// the short way.
  std::vector<std::pair<int, double>> residual;
  std::optional<double> position_error;     ///< m, of a goal frame
  std::optional<double> orientation_error;  ///< degrees
  std::vector<double> q;
  std::vector<std::pair<std::string, double>>
      variables;  ///< those that are set, in order of first mention
  Ticks time = 0;
  std::string message;         ///< in words, for all but done-and-reached
  Span span;                   ///< the script line it speaks of, if any
  std::optional<HitPair> hit;  ///< start_blocked: the pair; livelock and others: the last refusal's
  std::vector<MissedWayPoint> missed;  ///< in order; the goal is none of them
};

/// The abstract machine of LANGUAGE section 8. Deterministic; `advance` goes on to the next
/// proposed motion step and no further. It reads no clock and no file and sees the site only
/// through `World`. Its whole state is a value: copy it to keep a point of a run, and go on from
/// the copy. Program and robot model must outlive it.
/// m: what of a floor a tool may leave beside its strip and still have covered it.
inline constexpr double kMostAside = 0.02;

class Machine {
 public:
  Machine(const Program& program, MotionTask task);

  /// Runs to and including the next attempt, or until the machine stands that has to before it (and
  /// before the end of the motion): true, with so much time gone. False: the motion has ended.
  /// `events` may be null.
  bool advance(World& world, EventSink* events);

  /// Ends the run that goes on: the machine comes to a stop. True if that takes time.
  bool stop(EventSink* events);

  /// The next attempt is not made before `time`: the machine stood still meanwhile.
  void resume_at(Ticks time) { time_ = std::max(time_, time); }

  /// So many attempts more may be made: those that waited for something else to go away.
  void extend_budget(int attempts) { task_.budget += attempts; }

  bool ended() const { return end_.has_value() && run_.empty(); }
  const MotionEnd& end() const { return *end_; }  ///< only once ended
  const std::vector<double>& q() const { return q_; }
  Ticks time() const { return time_; }
  int tries() const { return tries_; }
  /// Time of it that its guides took to think.
  Ticks thinking() const { return thinking_; }
  /// How often its way met what others are foreseen to sweep, and guides found one round that.
  int foreseen() const { return foreseen_; }
  int rounds() const { return rounds_; }
  /// Waypoints behind it.
  std::size_t way_point() const { return way_point_; }

  /// 128-bit hash of the state that decides what comes next: stack, configuration (in millionths of
  /// a step), variables, situations, waypoint. Equal states have equal hashes on every machine.
  Hash128 state_hash(const World& world) const;

 private:
  /// A number, or a direction that remembers its parameter so that a stored 0 can become the
  /// preferred one.
  struct Value {
    double number = 0;
    std::int32_t direction_of = -1;
    bool negated = false;
    bool is_place = false;  ///< on the way: `number` steps lie before it
  };
  struct Variable {
    Value value;
    bool set = false;
  };
  struct Frame {
    enum class Kind : std::uint8_t { sequence, loop, each };
    Kind kind = Kind::sequence;
    bool moved = false;  ///< sequence: r of LANGUAGE 8.2; loop: m
    std::int32_t node = -1;
    std::int32_t index = 0;     ///< sequence: the next child; loop and each: the current element
    std::int32_t failures = 0;  ///< cycle: f, failures in a row
    std::int32_t successes = 0;
    std::int32_t actives = 0;  ///< loop: where its A begins in actives_
  };
  /// The goal of the current waypoint, fixed when it begins.
  struct WayPoint {
    std::vector<double> q;
    std::vector<std::uint8_t> named;  ///< per parameter: takes part in reached and residual
    math::Vec3 p_WG = math::Vec3::Zero();
    std::optional<math::Pose> X_WG;
    bool via = false;
  };

  class GuideTests;

  // machine.cpp: waypoints and the end of a motion
  bool go_on(World& world, EventSink* events);
  bool may_leave_way_point();
  void note_missed();
  void note_aside();
  bool begin_way_point(World& world, EventSink* events);
  bool resolve_goal(const GoalSpec& spec);
  robot::GoalSolution solved(const GoalSpec& spec);
  void name_values(const GoalSpec& spec);
  robot::GoalClauses frame_clauses(const GoalSpec& spec) const;
  void begin_script();
  void finish(MotionStatus status, std::string message = {}, Span span = {});
  void judge();
  void measure_residual();
  robot::PoseTolerance frame_tolerance() const;
  double tolerance_of(int parameter) const;
  std::string shortfall() const;

  // machine_guide.cpp: waypoints of guides
  const guides::Leg& leg();
  bool begin_guides(std::size_t first, World& world, EventSink* events);
  bool try_guides(std::size_t first, World& world, EventSink* events);
  void look_ahead(World& world, EventSink* events);
  void add_goals(const guides::GuideSpec& spec, guides::MotionTests& tests,
                 std::vector<std::vector<double>>& goals) const;
  bool take(guides::GuideAnswer answer, const GuideTests& tests, EventSink* events);
  bool think(guides::GuideAnswer& answer, EventSink* events);
  bool end_thinking(World& world, EventSink* events);
  bool use(const guides::GuideAnswer& answer, EventSink* events);
  bool is_still_free(const guides::PlanReport& plan, World& world);
  guides::GuideTask guide_task(const World& world) const;
  void set_target(const guides::GuideAnswer& answer);
  bool next_way_point(World& world, EventSink* events);
  bool is_near_goal();
  void give_up();
  std::string cause_of(const guides::PlanReport& report, const GuideTests& tests) const;

  // machine_control.cpp: the rules of LANGUAGE 8.2
  bool run_to_attempt(World& world, EventSink* events);
  bool run(std::int32_t node, World& world, EventSink* events);
  void give_back(World& world, EventSink* events);
  void enter_loop(std::int32_t node, World& world, EventSink* events);
  void loop_succeeded(World& world, EventSink* events);
  void loop_failed(World& world, EventSink* events);
  void leave_loop(bool reached, bool result, EventSink* events);
  void choose_module(std::int32_t node, const World& world, EventSink* events);
  void push_sequence(std::int32_t node);
  void next_of_sequence();
  void pass(std::int32_t node, const World& world, EventSink* events);
  void assign(std::int32_t node, const World& world, EventSink* events);
  std::int32_t forward(const Node& loop, std::int32_t from, const World& world, EventSink* events);
  std::int32_t backward(const Node& loop, std::int32_t element) const;
  bool goal_or_until_holds(const Node& loop, bool until_too, const World& world);
  bool situation_on(std::int32_t situation, const World& world) const;
  std::int16_t* active_of(std::int32_t each_node);
  const Node& node_at(std::int32_t node) const {
    return program_->nodes[static_cast<std::size_t>(node)];
  }
  std::int32_t child_at(const Node& node, std::int32_t i) const {
    return program_->children[static_cast<std::size_t>(node.first + i)];
  }

  // machine_motion.cpp: commands, limits, what was seen before
  const robot::ToolLine& line();
  std::vector<int> named_beside_frame() const;
  bool attempt(std::int32_t node, World& world, EventSink* events);
  bool may_attempt(std::int32_t node, const World& world);
  Refusal plan_part(const Node& part, const World& world, std::vector<double>& steps,
                    std::int32_t& limit);
  Refusal plan_move_to(int parameter, double value, std::vector<double>& steps,
                       std::int32_t& limit) const;
  Refusal plan_direction(int parameter, double direction, std::vector<double>& steps,
                         std::int32_t& limit) const;
  double room(int parameter, bool upwards) const;
  int first_out_of_range(std::span<const double> q) const;
  int first_locked(std::span<const double> q) const;
  Refusal plan(const Node& node, const World& world, std::int32_t& limit);
  Refusal plan_line(std::int32_t& limit);
  void find_steps_of_run();
  Ticks plan_run(bool loaded);
  bool must_stop(const World& world, Ticks duration) const;
  std::string describe_next(std::int32_t command) const;
  bool would_accept(int parameter, double direction, const World& world);
  void hash_stack(StateHasher& hasher, std::int32_t command) const;
  void hash_variables(StateHasher& exact, StateHasher& coarse) const;

  // machine_evaluate.cpp: values
  Value evaluate(const Code& code, const World& world);
  double number(const Code& code, const World& world) { return evaluate(code, world).number; }
  class Scope;
  void call(const ExpressionOp& op, const World& world);
  /// value - q(parameter), the short way round for a cyclic one.
  double delta(int parameter, double value) const;
  bool at(int parameter, double value) const;
  Value stored(const Value& value) const;
  double tool_distance(const math::Vec3& p_WG) const;
  math::Vec3 tool_place(std::span<const double> q) const;
  const robot::Parameter& parameter(int index) const {
    return model_->parameters[static_cast<std::size_t>(index)];
  }

  const Program* program_;
  const robot::RobotModel* model_;
  MotionTask task_;

  // the state proper
  std::vector<Frame> stack_;
  std::vector<std::int16_t>
      actives_;                ///< per loop frame the active element of every `each` of the program
  std::int32_t pending_ = -1;  ///< node to run next; -1: give back result_
  bool result_ = false;
  std::vector<double> q_;
  std::vector<Variable> variables_;
  Ticks time_ = 0;
  std::size_t way_point_ = 0;
  math::Vec3 strip_from_ = math::Vec3::Zero();  ///< where the tool was when the waypoint began
  double aside_ = 0;  ///< m: how far a tool that works has been beside its strip since then
  std::vector<MissedWayPoint> missed_;
  WayLog way_;  ///< only of scripts that ask for it
  bool way_point_begun_ = false;
  bool started_ = false;
  /// What moves, by parameter, where any of it has an acceleration; empty: the machine stands, or
  /// stops at once. It changes when things are done and never what: no part of what a livelock is
  /// told by.
  std::vector<MotionRun> run_;
  bool stopped_ = false;  ///< for the pending command, which has been planned: its `steps_`
  WayPoint goal_;
  /// What scripts are told: the goal, or the waypoint that a guide gave for it.
  WayPoint target_;
  guides::GuideValue guide_;    ///< of the goal under way; none: it is not guided
  bool leads_to_goal_ = false;  ///< its waypoint is the last
  int guide_point_ = 0;         ///< its number, from 1, on the way planned last
  std::size_t guide_index_ = 0;
  int idle_way_points_ = 0;  ///< in a row, at which no step was made
  int accepted_at_way_point_ = 0;
  std::pair<Ticks, std::uint64_t> way_point_given_{-1, 0};  ///< when, and the world's version then
  /// What its guide has said when it has done thinking; it stands meanwhile.
  std::optional<guides::GuideAnswer> thought_;
  Ticks looked_ahead_ = -1;                    ///< when it looked last
  int looks_left_ = 0;                         ///< that lead to a plan, for this waypoint
  std::vector<std::vector<double>> no_round_;  ///< where others went when no way round was found
  std::string guide_cause_;                    ///< why the first guide gave up
  bool guide_found_no_way_ = false;
  std::shared_ptr<const guides::Leg> leg_;       // shared: it does not change
  std::shared_ptr<const guides::Leg> arc_leg_;   // of a vehicle that steers
  double arc_radius_ = 0;                        ///< m: that of `arc_leg_`
  std::shared_ptr<const guides::Leg> lane_leg_;  // from node to node: forks and booms stay
  std::shared_ptr<const robot::ToolLine> line_;  // so does this

  // counts, and what was seen
  int tries_ = 0;
  int accepted_ = 0;
  Ticks thinking_ = 0;
  int foreseen_ = 0;
  int rounds_ = 0;
  RefusalCounts rejected_;
  std::optional<HitPair> last_hit_;
  StateTable seen_;
  StateTable visited_;
  std::uint64_t world_version_ = 0;
  std::optional<MotionEnd> end_;

  // scratch, no part of the state but where `stopped_` says so
  std::vector<double> steps_;
  std::vector<double>
      run_steps_;  ///< of these, those that decide how long they take; 0: the others
  std::vector<double> refused_steps_;  ///< those of the command's own parameters
  std::vector<double> q_next_;
  std::vector<MotionRun> run_next_;
  bool goes_on_ = false;  ///< `run_next_` with `run_`
  std::vector<double> asked_steps_;
  std::vector<double> asked_q_;
  std::vector<Value> operands_;
};

}  // namespace rubicon::interpreter
