#pragma once

#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "src/results/debug/record_line.hpp"
#include "src/results/debug/recording.hpp"
#include "src/simulation/trace/trace_sink.hpp"

namespace rubicon::debug {

/// Makes a recording of a trace, line by line.
class RecordingReader : public trace::TraceSink {
 public:
  /// Throws std::invalid_argument, with a message for the user, for what is no line of a trace.
  void line(std::string_view text) override;
  void restart() override;

  /// Whether a header was read.
  bool has_header() const { return has_header_; }
  /// Once all lines are read.
  Recording take();

 private:
  using Configuration = std::map<std::string, double>;

  void read_header(std::string_view text);
  void read_record(const std::string& type, const RecordLine& record);
  Event event_of(EventKind kind, const RecordLine& record);
  bool read_script(const RecordLine& record, Event& event);
  void read_work(const RecordLine& record, Event& event);
  TaskRun& run_of(EventKind kind, const RecordLine& record);
  void end_task(TaskRun& run, const RecordLine& record);
  std::size_t add_file(const std::string& path, const std::string& text);
  PlannedTask& planned(const std::string& name);
  std::uint32_t place_of(const RecordLine& record);
  std::uint32_t command_of(const RecordLine& record);
  std::uint32_t refusal_of(const RecordLine& record);

  Recording recording_;
  bool has_header_ = false;
  std::map<std::string, std::size_t> open_;     ///< the run of each task that goes on
  std::map<std::string, std::size_t> planned_;  ///< in Recording::tasks
  std::map<std::string, std::size_t> files_;
  std::set<std::string> file_names_;
  std::map<std::tuple<std::string, int, int>, std::uint32_t> places_;
  std::map<std::string, std::uint32_t> commands_;
  std::map<std::tuple<std::string, std::string, std::string>, std::uint32_t> refusals_;
  std::map<std::string, Configuration>
      stands_;  ///< where each robot stands when a task of it begins
};

}  // namespace rubicon::debug
