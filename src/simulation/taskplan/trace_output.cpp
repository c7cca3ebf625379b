#include "src/simulation/taskplan/trace_output.hpp"

namespace rubicon::taskplan {

TraceOutput::TraceOutput(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                         trace::TraceSink* sink, trace::TraceDetail detail) {
  if (!sink) return;
  buffer_.emplace(*sink);
  writer_.emplace(*buffer_, plan, sources, detail);
  keep([this] { writer_->header(); });
}

trace::TraceWriter* TraceOutput::of(int task, const interpreter::TaskSpec& spec) {
  if (!writer_) return nullptr;
  buffer_->set_owner(task);
  writer_->set_task(spec.name, spec.robot);
  return &*writer_;
}

void TraceOutput::moving(const site::MovingEvent& event, const std::string& name) {
  if (!writer_) return;
  buffer_->set_owner(-1);
  writer_->set_task("", -1);
  writer_->moving(name, event.stop ? std::string_view(event.stop->by) : std::string_view(),
                  event.delay, event.time);
}

void TraceOutput::breakdown(const trace::MachineBreakdown& breakdown) {
  if (!writer_) return;
  buffer_->set_owner(-1);
  writer_->set_task("", -1);
  writer_->breakdown(breakdown);
}

void TraceOutput::lost_days(const LostDaysOutcome& lost, Ticks end) {
  if (!writer_) return;
  buffer_->set_owner(-1);
  writer_->set_task("", -1);
  writer_->lost_days(lost.calendar, lost.working_days, lost.dates, end);
}

void TraceOutput::keep(const std::function<void()>& write) {
  if (!buffer_) return;
  buffer_->set_kept(true);
  write();
  buffer_->set_kept(false);
}

void TraceOutput::repeat(const std::vector<std::string>& lines) {
  keep([&] {
    for (const std::string& line : lines) buffer_->line(line);
  });
}

std::vector<std::string> TraceOutput::kept_of(int task) const {
  return buffer_ ? buffer_->kept_of(task) : std::vector<std::string>();
}

void TraceOutput::forget_since(Mark mark) {
  if (buffer_) buffer_->forget_since(mark);
}

void TraceOutput::keep_only(Mark mark, int task) {
  if (buffer_) buffer_->keep_only(mark, task);
}

void TraceOutput::drop_kept(Mark mark, int task) {
  if (buffer_) buffer_->drop_kept(mark, task);
}

void TraceOutput::release_before(Mark mark) {
  if (buffer_) buffer_->release_before(mark);
}

}  // namespace rubicon::taskplan
