#pragma once

#include <string>
#include <string_view>

#include "src/simulation/schedule/civil_time.hpp"
#include "src/simulation/schedule/time_text.hpp"
#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::report {

/// For people: a table of the tasks (robot, crew, start, duration, of it motion and crew work, time
/// waited, steps tried and accepted, result with the reason), the process time, the use and cost
/// of robots and crews, and the critical path.
std::string schedule_table(const taskplan::Schedule& schedule);

/// Everything of a schedule as JSON (docs/commands/run.md); times in seconds.
std::string schedule_json(const taskplan::Schedule& schedule);

/// The tasks as CSV (RFC 4180, line ends "\n"), a header line first; times in seconds.
std::string schedule_csv(const taskplan::Schedule& schedule);

/// The tasks of the plan, by what became of them. A machine that goes out of the way of another is
/// none.
struct TaskCounts {
  int tasks = 0;
  int done = 0;
  int ended_short = 0;
  int rejected = 0;
  int not_reached = 0;
};
TaskCounts count_tasks(const taskplan::Schedule& schedule);

/// "845 of 851 tasks done, 4 rejected, 2 not reached".
std::string count_text(const TaskCounts& counts);

using schedule::clock_text;

/// The names of a task's crews, with commas between.
std::string crew_text(const taskplan::TaskOutcome& task);

/// A moment of a plan that begins at `start_at`, as "YYYY-MM-DD HH:MM", rounded down to its minute.
std::string date_text(const schedule::CivilTime& start_at, interpreter::Ticks time);

/// The same to the second, as "YYYY-MM-DD HH:MM:SS".
std::string moment_text(const schedule::CivilTime& start_at, interpreter::Ticks time);

/// The `start_at` of a trace or of a schedule in JSON; throws std::invalid_argument if it is no
/// date with a time.
schedule::CivilTime start_from_text(std::string_view text);

/// A time in seconds, exactly.
std::string seconds_text(interpreter::Ticks ticks);

}  // namespace rubicon::report
