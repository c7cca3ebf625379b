#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/results/gantt/off_times.hpp"
#include "src/results/gantt/trace_times.hpp"
#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::gantt {

/// Part of a bar: what went on.
struct Part {
  enum class Kind { motion, work, wait, off };  ///< off: out of shift, or as its path says
  Kind kind = Kind::motion;
  Span span;
};

/// A task in a lane or a row. One without length is a milestone.
struct Bar {
  std::string name;
  Span span;
  std::vector<Part> parts;  ///< cover it
  bool critical = false;
  std::string text;              ///< all about it, in lines
  std::optional<Span> baseline;  ///< of a row: when others planned it
};

/// A machine, a crew, a task or a group of tasks through time.
struct Lane {
  std::string name;
  std::string note;   ///< how it was used, or how long it took
  std::string brief;  ///< the same where there is little room
  std::vector<Bar> bars;
  std::vector<Span> off;  ///< out of its shifts
};

/// Why a task was not done.
struct NotDone {
  std::string task;
  std::string why;
};

/// All that a Gantt chart shows, without its looks.
struct Chart {
  std::string title;
  std::vector<std::string> facts;  ///< process time, cost, how many tasks
  std::optional<schedule::CivilTime> start;
  Ticks end = 0;
  bool has_shifts = false;
  bool has_baselines = false;
  bool has_milestones = false;
  std::vector<Lane> resources;
  std::string rows_title;  ///< what the rows are: tasks, or groups of them
  std::vector<Lane> rows;
  std::vector<Lane> movings;  ///< what keeps a timetable by itself
  std::vector<Span> nobody;   ///< times in which no machine and no crew has a shift
  std::vector<NotDone> not_done;
};

/// The chart of a schedule. Without `times` (null) bars are not split into motion, work and
/// waiting, and shifts are not there. `title` names the plan where `times` does not. Throws
/// std::invalid_argument if the calendars of the trace are none.
Chart make_chart(const taskplan::Schedule& schedule, const TraceTimes* times,
                 const std::string& title);

}  // namespace rubicon::gantt
