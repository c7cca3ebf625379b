#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "interpreter/program/world.hpp"
#include "src/motion/math/pose.hpp"
#include "src/simulation/trace/parameter_value.hpp"
#include "src/simulation/trace/record_kind.hpp"

namespace rubicon::trace {

using interpreter::Ticks;

/// A value by the name of its parameter or variable; nothing where it is not finite.
struct NamedValue {
  std::string_view name;
  std::optional<double> value;
};
using NamedValues = std::span<const NamedValue>;

/// One name, or a list of them.
using Names = std::span<const std::string_view>;

/// Where a record's loop, choice or command stands in a text; line and column count from 1.
/// Without a file it has no place.
struct InText {
  std::string_view file;
  int line = 0;
  int column = 0;
};

/// A list of numbers.
using Numbers = std::span<const double>;

/// What moved and what it met.
struct Hit {
  std::string_view moved;
  std::string_view met;
};

/// Refused attempts by reason.
struct RefusalCounts {
  int at_goal = 0;
  int no_direction = 0;
  int limit = 0;
  int hit = 0;
};

// One struct for each kind of record (docs/trace.md says what its members mean); record_fields.hpp
// says how the members are called in the text. All times are ticks of 1 ns since the plan began.

struct TaskStart {
  Ticks t = 0;
  std::string_view because;
  std::string_view after;
  std::string_view chosen;
  /// Of a vehicle of a fleet that gives way: values of the parameters of its `park`, in their
  /// order.
  Numbers to;
};

struct GoalStart {
  int k = 0;
  int n = 0;
};

struct Assignment {
  std::string_view variable;
  std::optional<double> value;  ///< nothing: it is not finite
};

struct LoopStart : InText {
  std::string_view kind;
};

struct LoopEnd : InText {
  std::string_view kind;
  bool reached = false;
  int successes = 0;
};

struct Choice : InText {
  std::string_view label;
};

struct Attempt : InText {
  int n = 0;
  std::string_view command;
  Names parameters;
  bool ok = false;
  std::string_view reason;
  std::optional<Hit> hit;
  Numbers step;  ///< of a hit: how far each of the parameters was to go, m or degrees
  Ticks t = 0;
  Configuration q;
};

struct Wait {
  int n = 0;
  Ticks t = 0;
};

struct Work {
  std::string_view what;
  std::string_view crew;
  Ticks from = 0;
  Ticks t = 0;
  Ticks time = 0;
};

struct Pause {
  std::string_view why;
  std::string_view whom;
  Ticks from = 0;
  Ticks t = 0;
};

struct Attach {
  std::string_view component;
  math::Pose X_TO = math::Pose::Identity();
  Ticks t = 0;
};

struct Detach {
  std::string_view component;
  math::Pose X_WO = math::Pose::Identity();
  Ticks t = 0;
  Ticks overtime = 0;  ///< of its lift, out of the shifts of all that it needs
};

struct Removal {
  std::string_view component;
  Ticks t = 0;
};

struct MotionEnd : InText {
  std::string_view status;
  bool reached = false;
  std::optional<int> period;
  int tries = 0;
  int accepted = 0;
  RefusalCounts rejected;
  NamedValues residual;
  std::optional<double> position_error;
  std::optional<double> orientation_error;
  Configuration q;
  NamedValues variables;
  Ticks t = 0;
  Numbers missed;     ///< waypoints left without reaching them, by number from 1
  Numbers missed_by;  ///< m, of the tool, for each of them
  std::string_view message;
};

/// Whether a task with this result did what it did: one that is rejected or not reached is undone.
inline bool has_happened(std::string_view result) { return result == "done" || result == "short"; }

struct TaskEnd {
  Ticks t = 0;
  std::string_view result;
  std::string_view reason;
  std::optional<double> driving;  ///< s, of trucks that haul by durations
  Numbers serving;                ///< s, of who serves them
};

/// A machine came to a stop: what was left of its run, from the record before it.
struct Stop {
  Ticks t = 0;
};

/// A guide planned a way, or found none.
struct GuidePlan {
  std::string_view name;
  std::string_view kind;
  double seed = 0;
  bool found = false;
  std::string_view cause;  ///< of no way
  int nodes = 0;
  int checks = 0;
  int refused = 0;
  /// Where it begins and its waypoints, the goal last: of each all parameters of the robot, in
  /// their order (m, degrees).
  Numbers way;
  Numbers graph;  ///< of each leg both configurations; only in full traces
  int legs = 0;   ///< of all that it searched through
  Names events;   ///< of guides that travel without a map: "hit at (4.28, 22.00) by ring"
  double roughness = 0;
  double length = 0;       ///< m
  double motion_time = 0;  ///< s
  Ticks t = 0;
};

/// A guide thought about what it has planned; its robot stood meanwhile.
struct Think {
  int checks = 0;  ///< of the plan
  Ticks t = 0;     ///< when it is over
};

/// The script begins at waypoint k of the n of its guide's way.
struct WayPoint {
  int k = 0;
  int n = 0;
};

/// People turned a hanging load about the vertical through the tool's origin.
struct Turn {
  std::string_view component;
  double angle_deg = 0;                      ///< counter-clockwise as seen from above
  math::Pose X_TO = math::Pose::Identity();  ///< how it hangs after it
  Ticks from = 0;
  Ticks t = 0;
  std::optional<Hit> hit;  ///< what the shorter way would have met
};

/// Something with a timetable stops where it is, or goes on; of no task.
struct Moving {
  std::string_view name;
  std::string_view by;  ///< what it would have entered; "": it goes on
  Ticks delay = 0;      ///< by how much its timetable has shifted up to then
  Ticks t = 0;
};

/// A joint between two strips of a floor, over the limit of its task, in the plan view; told when
/// the task ends.
struct ColdJoint {
  Numbers ends;      ///< x and y of one, then of the other, m
  Ticks age = 0;     ///< of what was laid first, where it was oldest
  Ticks laid = 0;    ///< when that was laid
  Ticks joined = 0;  ///< when the rest came
  Ticks t = 0;
};

/// A machine broke down and was repaired; of no task, since it may outlast the one that it had.
struct Breakdown {
  std::string_view machine;
  std::string_view during;  ///< the task that it had
  Ticks every = 0;          ///< so much work it was good for
  Ticks worked = 0;         ///< so much it had done since it was repaired last: up to a safe place
  Ticks repair = 0;         ///< in its working hours
  Ticks t = 0;
  Ticks until = 0;
};

/// What the weather took of the days of a calendar, up to the end of the plan; of no task.
struct LostDays {
  std::string_view calendar;
  int of = 0;  ///< days with working time, lost or not
  Names days;  ///< YYYY-MM-DD
  Ticks t = 0;
};

/// A bucket has taken soil, and is clear of it.
struct Soil {
  std::string_view component;
  double volume = 0;  ///< mm3, whole
  Numbers cells;      ///< of the earth, counted along its rows from 0
  Numbers heights;    ///< to each: its height now, mm
  Ticks from = 0;     ///< since then the bucket may have been in the soil
  Ticks t = 0;
};

/// What another machine is foreseen to sweep, in the plan view, which the way of the task's would
/// meet.
struct Foreseen {
  std::string_view machine;
  double seconds = 0;  ///< so far ahead
  Numbers corners;     ///< of each outline
  Numbers points;      ///< x and y in turn, outline by outline
  Ticks t = 0;
};

/// Where the robot may not stand about what its guide searched through: configurations that two
/// parameters span, in layers for values of a third. Only in full traces, behind its `guide`.
struct Forbidden {
  Names parameters;  ///< two, or three with layers
  Numbers low;       ///< of the first two
  Numbers high;
  Numbers cells;   ///< along each of the first two
  Numbers layers;  ///< values of the third, ascending
  Numbers at;      ///< where the search began: all parameters, in their order (m, degrees)
  /// So many cells in a row that are free, then so many that are not, and so on: along the first
  /// parameter, row by row, layer by layer. Each is judged at its middle.
  Numbers runs;
  Ticks t = 0;
};

/// One record of a trace. Its texts and lists belong to the reader that gave it.
struct Record {
  /// In the order of RecordKind.
  using What = std::variant<TaskStart, GoalStart, Assignment, LoopStart, LoopEnd, Choice, Attempt,
                            Wait, Work, Pause, Attach, Detach, Removal, MotionEnd, TaskEnd, Stop,
                            GuidePlan, WayPoint, Turn, Moving, ColdJoint, Breakdown, LostDays, Soil,
                            Think, Foreseen, Forbidden>;

  std::string_view task;
  std::string_view robot;  ///< "": crew work
  What what;

  RecordKind kind() const { return static_cast<RecordKind>(what.index()); }
  /// When it is over; nothing for what a script does between its steps.
  std::optional<Ticks> time() const {
    return std::visit(
        [](const auto& record) -> std::optional<Ticks> {
          if constexpr (requires { record.t; }) return record.t;
          return std::nullopt;
        },
        what);
  }
  /// Where it stands in a text; null if it has no place.
  const InText* place() const {
    return std::visit(
        [](const auto& record) -> const InText* {
          if constexpr (requires { record.column; }) {
            return record.file.empty() ? nullptr : &record;
          }
          return nullptr;
        },
        what);
  }
};

/// The double nearest to a time in seconds.
double seconds(Ticks time);

}  // namespace rubicon::trace
