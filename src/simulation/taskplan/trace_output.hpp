#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/program/events.hpp"
#include "interpreter/syntax/source.hpp"
#include "src/simulation/site/site_world.hpp"
#include "src/simulation/taskplan/schedule.hpp"
#include "src/simulation/taskplan/trace_buffer.hpp"
#include "src/simulation/trace/trace_writer.hpp"

namespace rubicon::taskplan {

/// The trace of a run, if there is one: who writes says for which task, and what was written can be
/// taken back.
class TraceOutput {
 public:
  using Mark = TraceBuffer::Mark;

  /// `sink` may be null: nothing is written. All must outlive it.
  TraceOutput(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
              trace::TraceSink* sink, trace::TraceDetail detail);

  /// For lines of the task; null if there is no trace.
  trace::TraceWriter* of(int task, const interpreter::TaskSpec& spec);
  /// For the events of motions; null if there is no trace.
  interpreter::EventSink* events() { return writer_ ? &*writer_ : nullptr; }

  /// Something with a timetable stops or goes on.
  void moving(const site::MovingEvent& event, const std::string& name);

  /// A machine broke down. Of no task: what is undone with one is not told.
  void breakdown(const trace::MachineBreakdown& breakdown);
  /// What the weather took up to the end of the plan.
  void lost_days(const LostDaysOutcome& lost, Ticks end);

  /// What `write` writes stays, whatever the run goes back to.
  void keep(const std::function<void()>& write);
  /// Lines of an earlier run, for good.
  void repeat(const std::vector<std::string>& lines);
  /// The lines of a task that are kept for good and not written yet.
  std::vector<std::string> kept_of(int task) const;

  Mark mark() const { return buffer_ ? buffer_->mark() : 0; }
  /// Takes out the lines since `mark` but those that are kept.
  void forget_since(Mark mark);
  /// The same, but the lines of `task` are put back at the end, for good.
  void keep_only(Mark mark, int task);
  void drop_kept(Mark mark, int task);
  /// Nobody will go back to before `mark`.
  void release_before(Mark mark);

 private:
  std::optional<TraceBuffer> buffer_;
  std::optional<trace::TraceWriter> writer_;
};

}  // namespace rubicon::taskplan
