#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/simulation/schedule/calendar_rules.hpp"
#include "src/simulation/trace/moving_stretches.hpp"
#include "src/simulation/trace/record.hpp"
#include "src/simulation/trace/trace_reader.hpp"

namespace rubicon::gantt {

using schedule::Ticks;

/// A time in which a task did something else than move its robot.
struct Stretch {
  enum class Kind { work, wait };
  Kind kind = Kind::work;
  Ticks from = 0;
  Ticks to = 0;
  std::string crew;  ///< of work: who did it; "": those who hold the task
  std::string what;  ///< of work: hook, adjust, release, takes; of waiting: what for
};

/// One task from its start to its end.
struct TaskTimes {
  Ticks start = 0;
  Ticks end = 0;
  bool has_robot = false;
  std::vector<Stretch> stretches;
};

/// What keeps a timetable by itself.
struct MovingTimes {
  std::string name;
  geometry::Timetable timetable;
  std::vector<trace::MovingStop> stops;
};

/// What a trace tells of when things were done. Tasks that were undone are not in it.
struct TraceTimes {
  std::string plan;
  std::vector<schedule::CalendarRules> calendars;
  std::map<std::string, std::string> calendar_of;        ///< by robot or crew; not if it has none
  std::map<std::string, std::vector<std::string>> held;  ///< by task: the crews of `by`
  std::map<std::pair<std::string, Ticks>, TaskTimes> runs;  ///< by task and start
  std::vector<MovingTimes> movings;
};

/// Reads a trace line by line, of any detail.
class TraceTimesReader {
 public:
  /// Throws std::invalid_argument, with a message for the user, for what is no line of a trace.
  void line(std::string_view text);

  /// Once all lines are read.
  TraceTimes take() { return std::move(times_); }

 private:
  void read_header(const trace::TraceHeader& header);
  void lose_days(const trace::LostDays& lost);
  void begin(const trace::Record& record, Ticks start);
  void end(const trace::Record& record, const trace::TaskEnd& end);
  void add(const trace::Record& record, Stretch stretch);

  trace::TraceReader reader_{{trace::RecordKind::task_start, trace::RecordKind::task_end,
                              trace::RecordKind::work, trace::RecordKind::pause,
                              trace::RecordKind::lost_days, trace::RecordKind::moving}};
  TraceTimes times_;
  std::map<std::string, TaskTimes, std::less<>> open_;  ///< by task
  bool short_form_ = false;
};

}  // namespace rubicon::gantt
