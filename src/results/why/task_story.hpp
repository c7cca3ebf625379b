#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/results/why/engine_answer.hpp"
#include "src/simulation/schedule/civil_time.hpp"

namespace rubicon::why {

/// Values by the names of parameters, m or degrees.
using Configuration = std::vector<std::pair<std::string, double>>;

/// One attempt of a command. Times in seconds from the beginning of the plan.
struct Attempt {
  int n = 0;
  std::string command;                  ///< move_to, move_dir, together
  std::vector<std::string> parameters;  ///< display names
  std::string file;
  int line = 0;
  bool ok = false;
  std::string reason;  ///< "", at goal, no direction, limit P, hit
  std::string moved;   ///< of a hit: what moved
  std::string met;     ///< and what it met
  double t = 0;
  // Of a hit:
  int trace_line = 0;
  Configuration q;
  std::vector<double> steps;             ///< how far each of the parameters was to go
  std::optional<ContactAnswer> contact;  ///< of the collision engine
  std::optional<Origin> origin;          ///< of what it met
};

/// A way that a guide planned for a motion, or found none.
struct GuideStory {
  std::string name;
  std::string kind;
  std::string cause;  ///< of no way
  int waypoints = 0;
  int checks = 0;
  double length = 0;  ///< m
  std::vector<std::string> events;
};

/// One motion of the task. Of the attempts those are kept that tell why it ended: all since what
/// was blocked last has not moved any more, steps of other parameters among them.
struct Motion {
  std::string what;  ///< "to PANEL", "carrying PANEL", "placing PANEL", "going"
  double from = 0;
  double to = 0;
  int tries = 0;
  int accepted = 0;
  bool reached = false;
  std::string status;
  std::string message;
  std::vector<GuideStory> guides;  ///< in the order in which they planned
  std::optional<Attempt> first_hit;
  std::vector<InTheWay> way;  ///< all that the command of the first hit meets up to the goal
  int hits = 0;
  std::vector<Attempt> last;  ///< in order; of very many the latest
  Configuration at_end;
  Configuration residual;  ///< goal - q of the parameters of the goal
};

/// A time in which the task stood still, or its crews worked.
struct Span {
  std::string what;  ///< hook, adjust, release, takes; machine, crew, shift, held, lift
  std::string whom;
  double from = 0;
  double to = 0;
  double time = 0;  ///< of it in shifts, of work
};

/// People turned the load about the vertical. Seconds from the beginning of the plan.
struct LoadTurn {
  std::string component;
  double angle_deg = 0;  ///< counter-clockwise as seen from above
  double from = 0;
  double to = 0;
  std::pair<std::string, std::string> refused;  ///< what the shorter way would have met: what
                                                ///< moved, and what it met; else empty
};

/// When a task of the plan was done.
struct TaskRun {
  bool started = false;
  double start = 0;
  double end = 0;
  std::string result;  ///< "" as long as it is not known
  std::string reason;
  std::string because;  ///< why it began when it did
  std::string after;    ///< the task it waited for, "" for none
};

/// Of each task its runs, in order: a machine may be asked to its park position several times.
using RunsByTask = std::map<std::string, std::vector<TaskRun>>;

/// Why a task began when it did.
struct WaitStep {
  std::string task;
  double start = 0;
  std::string text;  ///< a sentence
};

/// What the plan says of the task or of the component it moves only to hand it on: texts by name.
using Attributes = std::vector<std::pair<std::string, std::string>>;

/// All that a trace tells of a task.
struct TaskStory {
  std::string task;
  std::string robot;
  TaskRun run;
  std::vector<Motion> motions;
  std::vector<Span> works;
  std::vector<Span> pauses;
  std::optional<LoadTurn> turn;
  double overtime = 0;          ///< its load hung so long out of the shifts of its lift
  std::vector<WaitStep> waits;  ///< first to last; the last is the task itself
  std::optional<schedule::CivilTime> start_at;
  std::string detail;  ///< of the trace
  Attributes attributes;
  std::string component;  ///< that it moves; "": none
  Attributes component_attributes;
  std::vector<int> made;         ///< the numbers of the attempts that were accepted
  double contact_tolerance = 0;  ///< m, of the engine's answers
  std::optional<NearestMiss> nearest;
  std::string no_scene;  ///< why the engine could not be asked; "": it was, or need not be
};

}  // namespace rubicon::why
