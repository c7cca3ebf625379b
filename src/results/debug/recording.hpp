#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/results/debug/task_run.hpp"
#include "src/simulation/schedule/civil_time.hpp"

namespace rubicon::debug {

/// What an attempt asked for.
struct Command {
  std::string text;                     ///< "move_to jib.theta", "together boom.phi, stick.phi"
  std::vector<std::string> parameters;  ///< display names
};

/// Why an attempt made no step.
struct Refusal {
  std::string reason;  ///< at goal, no direction, limit P, hit
  std::string moved;   ///< of a hit: what moved
  std::string met;     ///< and what it met
};

/// A place in a text.
struct Place {
  std::size_t file = 0;  ///< in Recording::files
  int line = 0;          ///< from 1
  int column = 0;
};

/// A text that was read for the run.
struct ScriptFile {
  std::string path;
  std::string name;  ///< its last part, where no file before has it too
  std::vector<std::string> lines;
};

/// A task of the plan, or one that came up in the run (a robot parked).
struct PlannedTask {
  std::string name;
  std::string robot;
  std::string moves;   ///< the component that it moves, "" if it moves none
  std::string result;  ///< "" as long as it is not known
  std::string reason;
};

/// What a trace tells, in short form. All texts are fit to be shown.
struct Recording {
  std::string plan;
  std::string detail;  ///< steps, tasks, none
  std::optional<schedule::CivilTime> start_at;
  std::vector<ScriptFile> files;
  std::vector<PlannedTask> tasks;  ///< those of the plan first, in its order
  std::map<std::string, std::vector<std::string>> robots;  ///< the bodies of each robot

  StringTable texts;
  std::vector<Place> places;
  std::vector<Command> commands;
  std::vector<Refusal> refusals;
  std::vector<TaskRun> runs;  ///< in the order in which they begin

  const PlannedTask* task_of(const TaskRun& run) const;
  /// The place that an event speaks of; null where it speaks of none.
  const Place* place_of(const Event& event) const;
  /// A line of a script; null where there is none.
  const std::string* line(const Place& place) const;
  /// "crane.motion:14"
  std::string place_text(const Place& place) const;
  /// "hook of low meets wall_2", "limit of x".
  std::string refusal_text(const Refusal& refusal) const;
};

}  // namespace rubicon::debug
