#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "src/results/debug/recording.hpp"
#include "src/simulation/trace/trace_reader.hpp"
#include "src/simulation/trace/trace_sink.hpp"

namespace rubicon::debug {

/// Makes a recording of a trace, line by line.
class RecordingReader : public trace::TraceSink {
 public:
  /// Throws std::invalid_argument, with a message for the user, for what is no line of a trace.
  void line(std::string_view text) override;
  void restart() override;

  /// Once all lines are read.
  Recording take();

 private:
  using Stand = std::map<std::string, double, std::less<>>;

  void read_header(const trace::TraceHeader& header);
  void read_record(const trace::Record& record);
  Event event_of(const trace::Record& record);
  // The members of an event by the kind of its record.
  void fill(Event& event, const trace::TaskStart& start);
  void fill(Event& event, const trace::GoalStart& goal);
  void fill(Event& event, const trace::Assignment& assignment);
  void fill(Event& event, const trace::LoopStart& loop);
  void fill(Event& event, const trace::LoopEnd& loop);
  void fill(Event& event, const trace::Choice& choice);
  void fill(Event& event, const trace::Attempt& attempt);
  void fill(Event& event, const trace::Wait& wait);
  void fill(Event& event, const trace::Work& work);
  void fill(Event& event, const trace::Pause& pause);
  void fill(Event& event, const trace::Attach& attach);
  void fill(Event& event, const trace::Detach& detach);
  void fill(Event& event, const trace::Turn& turn);
  void fill(Event& event, const trace::Removal& removal);
  void fill(Event& event, const trace::MotionEnd& end);
  void fill(Event& event, const trace::TaskEnd& end);
  void fill(Event&, const trace::Stop&) {}
  void fill(Event& event, const trace::Think& think);
  void fill(Event&, const trace::Moving&) {}  // of no task, as the next two
  void fill(Event&, const trace::Breakdown&) {}
  void fill(Event&, const trace::LostDays&) {}
  void fill(Event& event, const trace::ColdJoint& joint);
  void fill(Event& event, const trace::Soil& soil);
  void fill(Event& event, const trace::Foreseen& foreseen);
  void fill(Event&, const trace::Forbidden&) {}  // not read
  void fill(Event& event, const trace::GuidePlan& plan);
  void fill(Event& event, const trace::WayPoint& point);
  TaskRun& run_of(const trace::Record& record);
  void end_task(TaskRun& run, const trace::Record& record, const trace::TaskEnd& end);
  std::size_t add_file(std::string_view path, const std::string& text);
  PlannedTask& planned(std::string_view name);
  std::uint32_t place_of(const trace::InText& place);
  std::uint32_t command_of(const trace::Attempt& attempt);
  std::uint32_t refusal_of(const trace::Attempt& attempt);

  trace::TraceReader reader_;
  Recording recording_;
  std::map<std::string, std::size_t, std::less<>> open_;     ///< the run of each task that goes on
  std::map<std::string, std::size_t, std::less<>> planned_;  ///< in Recording::tasks
  std::map<std::string, std::size_t, std::less<>> files_;
  std::set<std::string> file_names_;
  std::map<std::tuple<std::string, int, int>, std::uint32_t, std::less<>> places_;
  std::map<std::string, std::uint32_t, std::less<>> commands_;  ///< by command and parameters
  std::string command_key_;
  std::map<std::tuple<std::string, std::string, std::string>, std::uint32_t, std::less<>> refusals_;
  /// Where each robot stands when a task of it begins.
  std::map<std::string, Stand, std::less<>> stands_;
};

}  // namespace rubicon::debug
