#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/events.hpp"
#include "interpreter/plan_model.hpp"
#include "interpreter/program.hpp"
#include "interpreter/state_table.hpp"
#include "interpreter/world.hpp"
#include "src/robot/kinematics.hpp"

namespace rubicon::interpreter {

/// One motion: from where the robot is over way points to one goal.
struct MotionTask {
  std::vector<GoalSpec> goals;            ///< way points, the last is the goal; at least one
  std::vector<std::string> situations;    ///< on during the whole motion (besides `via` and what the world switches on)
  Within within;                          ///< when the goal counts as reached
  double budget = 20000;                  ///< attempts
  int first_n = 1;                        ///< number of the first attempt
  Ticks start = 0;
  std::vector<double> q;                  ///< where the robot stands, per parameter
  robot::Mounting mounting;
};

enum class MotionStatus { done, livelock, circling, budget, start_blocked, goal_impossible, error };
const char* name_of(MotionStatus status);

struct RefusalCounts {
  int at_goal = 0;
  int no_direction = 0;
  int limit = 0;
  int hit = 0;
  int total() const { return at_goal + no_direction + limit + hit; }
};

/// How a motion ended.
struct MotionEnd {
  MotionStatus status = MotionStatus::done;
  bool reached = false;                 ///< only with done
  std::optional<int> period;            ///< of a livelock, in accepted attempts
  int tries = 0;
  int accepted = 0;
  RefusalCounts rejected;
  /// goal - q of every parameter the goal names (or, for a frame, of every free one), cyclic ones the short way.
  std::vector<std::pair<int, double>> residual;
  std::optional<double> position_error;     ///< m, of a goal frame
  std::optional<double> orientation_error;  ///< degrees
  std::vector<double> q;
  std::vector<std::pair<std::string, double>> variables;  ///< those that are set, in order of first mention
  Ticks time = 0;
  std::string message;                  ///< in words, for all but done-and-reached
  Span span;                            ///< the script line it speaks of, if any
  std::optional<HitPair> hit;           ///< start_blocked: the pair; livelock and others: the last refusal's
};

/// The abstract machine of LANGUAGE section 8. Deterministic; `advance` goes on to the next proposed motion step and no
/// further. It reads no clock and no file and sees the site only through `World`. Its whole state is a value: copy it
/// to keep a point of a run, and go on from the copy. Program and robot model must outlive it.
class Machine {
 public:
  Machine(const Program& program, MotionTask task);

  /// Runs to and including the next attempt (true), or to the end of the motion (false). `events` may be null.
  bool advance(World& world, EventSink* events);

  bool ended() const { return end_.has_value(); }
  const MotionEnd& end() const { return *end_; }  ///< only once ended
  const std::vector<double>& q() const { return q_; }
  Ticks time() const { return time_; }
  int tries() const { return tries_; }

  /// 128-bit hash of the state that decides what comes next: stack, configuration (in millionths of a step), variables,
  /// situations, way point. Equal states have equal hashes on every machine.
  Hash128 state_hash(const World& world) const;

 private:
  /// A number, or a direction that remembers its parameter so that a stored 0 can become the preferred one.
  struct Value {
    double number = 0;
    std::int32_t direction_of = -1;
    bool negated = false;
  };
  struct Variable {
    Value value;
    bool set = false;
  };
  struct Frame {
    enum class Kind : std::uint8_t { sequence, loop, each };
    Kind kind = Kind::sequence;
    bool moved = false;       ///< sequence: r; loop: m
    std::int32_t node = -1;
    std::int32_t index = 0;   ///< next child of a sequence; element of a loop or each
    std::int32_t failures = 0;
    std::int32_t successes = 0;
    std::int32_t actives = 0; ///< loop: where its A begins in actives_
  };
  struct Resolved {           ///< the goal of the current way point
    std::vector<double> q;
    std::vector<bool> named;
    math::Vec3 p_WG = math::Vec3::Zero();
    std::optional<math::Pose> X_WG;
  };
  /// What a command would do now.
  struct Proposal {
    Refusal refusal = Refusal::none;
    int limit_parameter = -1;
    Ticks duration = 0;
  };
  struct RunTimeError {
    std::string message;
    Span span;
  };

  bool begin_way_point(World& world, EventSink* events);
  void finish(MotionStatus status, std::string message = {}, Span span = {});
  bool step_to_attempt(World& world, EventSink* events);
  void run(std::int32_t node, World& world, EventSink* events);
  void give_back(bool success, World& world, EventSink* events);
  bool attempt(std::int32_t node, World& world, EventSink* events);
  bool may_attempt(std::int32_t node, const World& world);
  void assign(const Node& node, World& world, EventSink* events);

  std::int32_t forward(const Node& loop, std::int32_t from, World& world, EventSink* events);
  std::int32_t backward(const Node& loop, std::int32_t element) const;
  bool goal_holds(const Node& loop, World& world);
  bool until_holds(const Node& loop, World& world);
  bool has_goal(const Node& loop) const;
  void leave_loop(bool reached, bool success, EventSink* events);

  Value evaluate(const Code& code, const World& world);
  double evaluate_number(const Code& code, const World& world);
  double delta(int parameter, double value) const;
  bool at(int parameter, double value) const;
  Refusal plan_part(const Node& part, const World& world, Ticks& duration);
  Refusal plan_move_to(int parameter, double value);
  Refusal plan_direction(int parameter, double direction);
  double room(int parameter, int sign) const;
  Proposal complete_proposal(Ticks duration);
  Ticks duration_of(int parameter, double ds) const;
  bool situation_on(std::int32_t situation, const World& world) const;
  void judge();
  double tool_distance() const;

  const Program* program_;
  const robot::RobotModel* model_;
  MotionTask task_;

  // the state proper
  std::vector<Frame> stack_;
  std::vector<std::int16_t> actives_;
  std::int32_t pending_ = -1;        ///< node to run next; -1: give back `result_`
  bool result_ = false;
  std::vector<double> q_;
  std::vector<Variable> variables_;
  Ticks time_ = 0;
  std::size_t way_point_ = 0;
  bool way_point_begun_ = false;
  Resolved goal_;

  // counts and what was seen
  int tries_ = 0;
  int accepted_ = 0;
  RefusalCounts rejected_;
  std::optional<HitPair> last_hit_;
  StateTable seen_;
  StateTable visited_;
  std::uint64_t world_version_ = 0;
  std::optional<MotionEnd> end_;

  // scratch, no part of the state
  std::vector<double> steps_;
  std::vector<double> q_next_;
  std::vector<Value> operands_;
  bool loaded_ = false;
};

}  // namespace rubicon::interpreter
