#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "src/results/replay/component_stays.hpp"
#include "src/results/replay/machine.hpp"
#include "src/results/replay/robot_track.hpp"
#include "src/results/replay/task_run.hpp"
#include "src/simulation/trace/header.hpp"
#include "src/simulation/trace/moving_stretches.hpp"
#include "src/simulation/trace/record.hpp"
#include "src/simulation/trace/trace_reader.hpp"

namespace rubicon::replay {

/// Where everything is through a plan, of what happened. What is wrong with a trace is for `verify`
/// to say.
struct Replay {
  trace::TraceHeader header;  ///< of a short plan with one task, its motion
  std::vector<Machine> machines;
  std::vector<TaskRun> runs;       ///< in the order in which the trace names them
  Ticks last = 0;                  ///< when all that happened is over
  Ticks until = 0;                 ///< 1 s later: where tracks and stays end
  std::vector<RobotTrack> tracks;  ///< by machine
  std::vector<Stay> stays;         ///< by component, then by time
  /// Of each `moving` of the header when it stopped and went on.
  std::vector<std::vector<trace::MovingStop>> moving_stops;
};

/// Reads the lines of a trace with every step.
class ReplayReader {
 public:
  ReplayReader();
  /// Throws std::invalid_argument, with a message for the user, for what is no line of such a
  /// trace.
  void line(std::string_view text);
  /// What was read; throws std::invalid_argument if there was no header.
  Replay finish();

 private:
  void begin(trace::TraceHeader&& header);
  void add(const trace::Record& record);
  TaskRun& run_of(const trace::Record& record);
  int component(std::string_view name) const;
  std::vector<double> values(const TaskRun& run, trace::Configuration q) const;

  void add(TaskRun& run, const trace::TaskStart& start);
  void add(TaskRun& run, const trace::Attempt& attempt);
  void add(TaskRun& run, const trace::Attach& attach);
  void add(TaskRun& run, const trace::Detach& detach);
  void add(TaskRun& run, const trace::Turn& turn);
  void add(TaskRun& run, const trace::Removal& removal);
  void add(TaskRun& run, const trace::Pause& pause);
  void add(TaskRun& run, const trace::TaskEnd& end);
  /// Of the others only the time counts.
  template <typename Other>
  void add(TaskRun& run, const Other& other);
  void add_event(TaskRun& run, Ticks time, decltype(Event::what) what);

  trace::TraceReader reader_;
  int lines_ = 0;
  Replay replay_;
  std::map<std::string, int, std::less<>> tasks_, robots_, components_, movings_;
  std::map<std::string, std::size_t, std::less<>> latest_;  ///< by task: the last run of it
};

}  // namespace rubicon::replay
