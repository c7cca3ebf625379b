#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "src/motion/math/pose.hpp"
#include "src/results/verify/input/scene.hpp"

namespace rubicon::verify {

struct TaskStart {
  std::string chosen;           ///< of pools
  std::vector<double> to = {};  ///< of who parks elsewhere: values in the order of its park
};

/// The script begins for waypoint k of the n that are left of a motion.
struct Goal {
  int k = 0;
  int n = 0;
};

/// One attempt.
struct Try {
  bool ok = false;
  bool follows = false;  ///< it is a step of the leg to the waypoint
  bool lines = false;    ///< it is a step of the tool's straight way
  int n = 0;
  std::vector<int> moved;                                  ///< parameters of the command
  std::vector<double> q;                                   ///< every parameter after it
  std::string reason;                                      ///< why it was refused
  std::optional<std::pair<std::string, std::string>> hit;  ///< what moved, what it met
};

struct Wait {
  int n = 0;
};

/// The machine came to a stop, from the record before it to this one's time.
struct Stop {};

/// A guide planned a way; none: it found no way.
struct GuidePlan {
  std::string name;
  std::vector<std::vector<double>> way;  ///< where it begins, its waypoints; all parameters
  double roughness = 0;
  double length = 0;                       ///< m
  double motion_time = 0;                  ///< s
  std::vector<std::vector<double>> graph;  ///< both ends of each leg, only in full traces
  int checks = 0;
};

/// The guide thought about a plan of so many checks, from the record before it.
struct Think {
  int checks = 0;
};

/// The script begins for waypoint k of the n of its guide.
struct WayPoint {
  int k = 0;
  int n = 0;
};

/// Crew work from `from` to the record's time.
struct Work {
  std::string what;
  int crew = -1;  ///< -1: whoever holds the task
  Ticks from = 0;
  Ticks time = 0;  ///< of this, in shifts
};

/// The task stands still from `from` to the record's time.
struct Pause {
  std::string why;  ///< machine, crew, shift, held, lift
  std::string whom;
  Ticks from = 0;
};

struct LoadChange {
  enum class Kind { attach, detach, remove };
  Kind kind = Kind::attach;
  int component = -1;
  math::Pose X = math::Pose::Identity();  ///< attach: X_TO; detach: X_WO
  Ticks overtime = 0;                     ///< detach: of the lift, as the trace tells it
};

/// People turned what hangs on the tool about the vertical through its origin, from `from` to the
/// record's time.
struct LoadTurn {
  int component = -1;
  double angle_deg = 0;
  math::Pose X_TO = math::Pose::Identity();  ///< how it hangs after it
  Ticks from = 0;
  std::optional<std::pair<std::string, std::string>> hit;  ///< of the shorter way
};

/// A bucket has taken soil, since `from`, and is clear of it.
struct SoilTaken {
  int component = -1;
  std::int64_t volume = 0;  ///< mm3
  std::vector<int> cells;
  std::vector<std::int64_t> heights;  ///< to each: its new one, mm
  Ticks from = 0;
};

/// What another machine is foreseen to sweep so many seconds ahead, which the way of the task's
/// would meet; outlines with x and y in turn, m.
struct Foreseen {
  int robot = -1;
  double seconds = 0;
  std::vector<std::vector<double>> outlines;
};

/// Where the robot may not stand about what its guide searched through: in cells that two
/// parameters span, in layers for values of a third.
struct Forbidden {
  std::vector<int> parameters;     ///< two, or three with layers
  std::array<double, 2> low = {};  ///< of the first two
  std::array<double, 2> high = {};
  std::array<int, 2> cells = {};
  std::vector<double> layers;
  std::vector<double> at;  ///< all parameters, where the search began
  std::vector<long> runs;  ///< so many free cells, so many that are not, and so on
};

/// A motion ended.
struct MotionEnd {
  std::string status;
  bool reached = false;
  int tries = 0;
  int accepted = 0;
  int refused = 0;  ///< for all reasons together
  std::map<std::string, int> refused_for;
  std::vector<double> q;
  std::vector<std::pair<int, double>> residual;  ///< parameter, goal - q
  std::optional<double> position_error;          ///< m
  std::optional<double> orientation_error;       ///< degrees
  std::vector<std::pair<int, double>> missed;    ///< waypoint, from 1, and m of the tool from it
};

enum class TaskResult { done, ended_short, rejected, not_reached };
struct TaskEnd {
  TaskResult result = TaskResult::done;
  std::string reason;
  /// Of rounds of trucks, s, where fuel counts: in which the trucks together drive, and those who
  /// serve them (diggers but robots, then of stages) together have one.
  std::optional<double> driving = {};
  std::vector<double> serving = {};
};

/// A joint between strips of a floor that is over its limit, m.
struct ColdJoint {
  double from_x = 0, from_y = 0, to_x = 0, to_y = 0;
  Ticks age = 0;
  Ticks laid = 0;
  Ticks joined = 0;
  bool operator==(const ColdJoint&) const = default;
};

/// One line of a trace that has a place on the clock.
struct Record {
  int line = 0;
  int run = -1;    ///< index into Trace::runs
  int robot = -1;  ///< -1: crew work
  Ticks time = 0;  ///< when it is over
  std::variant<TaskStart, Goal, Try, Wait, Stop, Work, Pause, LoadChange, LoadTurn, MotionEnd,
               TaskEnd, GuidePlan, WayPoint, ColdJoint, SoilTaken, Think, Foreseen, Forbidden>
      what;
};

/// Something with a timetable stops before `by`, or goes on ("").
struct MovingRecord {
  int line = 0;
  int moving = -1;
  Ticks time = 0;
  std::string by;
  Ticks delay = 0;  ///< by how much its timetable has shifted up to then
};

/// A machine broke down; `until` it was repaired.
struct BreakdownRecord {
  int line = 0;
  int robot = -1;
  std::string during;  ///< the task that it had
  Ticks every = 0, worked = 0, repair = 0;
  Ticks from = 0, until = 0;
};

/// Days of a calendar that the weather took.
struct LostDaysRecord {
  int line = 0;
  std::string calendar;
  std::int64_t of = 0;            ///< days with working time
  std::vector<std::string> days;  ///< YYYY-MM-DD
};

/// A trace as it was read.
struct Trace {
  Scene scene;
  std::vector<std::string>
      runs;  ///< names of tasks, also of those that no plan has, such as `park`
  std::vector<Record> records;
  std::vector<MovingRecord> movings;  ///< in the order of the lines, as the next two
  std::vector<BreakdownRecord> breakdowns;
  std::vector<LostDaysRecord> lost_days;
  int lines = 0;
};

}  // namespace rubicon::verify
