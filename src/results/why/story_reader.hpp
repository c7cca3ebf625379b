#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "src/results/why/task_story.hpp"
#include "src/simulation/trace/trace_reader.hpp"
#include "src/simulation/trace/trace_sink.hpp"

namespace rubicon::why {

/// Reads a trace line by line and keeps what concerns one task, and when all others were done.
class StoryReader : public trace::TraceSink {
 public:
  explicit StoryReader(std::string task);

  /// Throws std::invalid_argument, with a message for the user, for what is no line of a trace.
  void line(std::string_view text) override;
  void restart() override;

  /// The names of the plan's tasks.
  std::vector<std::string> tasks() const;
  bool has_task() const;

  /// Once all lines are read.
  TaskStory story() const;

 private:
  void read_header(const trace::TraceHeader& header);
  void read_record(const trace::Record& record);
  void read_own(const trace::Record& record);
  // What becomes of the task, record by record; all else is of no concern.
  template <typename Other>
  void follow(const Other&) {}
  void follow(const trace::TaskStart& start);
  void follow(const trace::Attempt& attempt);
  void follow(const trace::Wait& wait);
  void follow(const trace::MotionEnd& end);
  void follow(const trace::GuidePlan& plan);
  void follow(const trace::Attach& attach);
  void follow(const trace::Turn& turn);
  void follow(const trace::Detach& detach);
  void follow(const trace::Work& work);
  void follow(const trace::Pause& pause);
  Motion& motion(double from);
  std::string purpose() const;
  void keep(Motion& in, Attempt attempt);

  std::string task_;
  trace::TraceReader reader_;
  int lines_ = 0;
  TaskStory story_;
  RunsByTask runs_;
  std::vector<std::string> order_;
  std::map<std::string, std::size_t> widths_;  ///< of each robot the number of its parameters
  bool carries_ = false;
  int carried_motions_ = 0;
  bool in_motion_ = false;
  double time_ = 0;                   ///< of its last record
  std::vector<std::string> blocked_;  ///< the parameters that something is in the way of
};

}  // namespace rubicon::why
