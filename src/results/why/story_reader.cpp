#include "src/results/why/story_reader.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "src/results/report/schedule_text.hpp"
#include "src/results/why/wait_chain.hpp"
#include "src/simulation/trace/header.hpp"
#include "src/simulation/trace/record.hpp"

namespace rubicon::why {

namespace {

/// Of the attempts at one place so many are kept, and up to twice as many.
constexpr std::size_t kKeptAttempts = 200;

/// By the names of the parameters.
Configuration configuration(trace::Configuration q) {
  Configuration result;
  for (const trace::ParameterValue& each : q) result.emplace_back(each.name, each.value);
  std::sort(result.begin(), result.end());
  return result;
}

/// The records that tell what becomes of a task. What its script does between its steps does not.
const trace::RecordKinds kWanted = {
    trace::RecordKind::task_start, trace::RecordKind::attempt, trace::RecordKind::wait,
    trace::RecordKind::work,       trace::RecordKind::pause,   trace::RecordKind::attach,
    trace::RecordKind::detach,     trace::RecordKind::remove,  trace::RecordKind::end,
    trace::RecordKind::task_end,   trace::RecordKind::stop,    trace::RecordKind::turn,
    trace::RecordKind::guide};

}  // namespace

StoryReader::StoryReader(std::string task) : task_(std::move(task)), reader_(kWanted) {
  story_.task = task_;
}

void StoryReader::restart() { *this = StoryReader(task_); }

void StoryReader::line(std::string_view text) {
  ++lines_;
  reader_.read(
      text, [&](const trace::TraceHeader& header) { read_header(header); },
      [&](const trace::Record& record) { read_record(record); });
}

void StoryReader::read_header(const trace::TraceHeader& header) {
  story_.detail = header.detail;
  if (header.start_at) story_.start_at = report::start_from_text(*header.start_at);
  if (header.short_form) order_.push_back(header.plan);
  for (const trace::HeaderTask& task : header.tasks) {
    order_.push_back(task.name);
    if (task.name != task_) continue;
    story_.attributes = task.attributes;
    story_.component = task.move.value_or("");
  }
  for (const trace::HeaderRobot& robot : header.robots) {
    widths_[robot.name] = robot.parameters.size();
  }
  for (const trace::HeaderComponent& component : header.components) {
    if (component.name == story_.component) story_.component_attributes = component.attributes;
  }
}

void StoryReader::read_record(const trace::Record& record) {
  if (const auto* start = std::get_if<trace::TaskStart>(&record.what)) {
    TaskRun& run = runs_[std::string(record.task)].emplace_back();
    run.started = true;
    run.start = trace::seconds(start->t);
    run.because = start->because;
    run.after = start->after;
  } else if (const auto* end = std::get_if<trace::TaskEnd>(&record.what)) {
    std::vector<TaskRun>& runs = runs_[std::string(record.task)];
    if (runs.empty()) runs.emplace_back();
    TaskRun& run = runs.back();
    run.end = trace::seconds(end->t);
    run.result = end->result;
    run.reason = end->reason;
    if (!run.started) run.start = run.end;
  }
  if (record.task == task_) read_own(record);
}

/// What the motion that begins now is for.
std::string StoryReader::purpose() const {
  if (story_.component.empty()) return "going";
  if (!carries_) return "on the way to " + story_.component;
  return (carried_motions_ == 0 ? "carrying " : "placing ") + story_.component;
}

Motion& StoryReader::motion(double from) {
  if (!in_motion_) {
    in_motion_ = true;
    Motion& begun = story_.motions.emplace_back();
    begun.what = purpose();
    blocked_.clear();
    begun.from = from;
  }
  return story_.motions.back();
}

void StoryReader::read_own(const trace::Record& record) {
  story_.robot = record.robot;
  std::visit([&](const auto& what) { follow(what); }, record.what);
  if (const auto t = record.time()) time_ = trace::seconds(*t);
}

void StoryReader::follow(const trace::TaskStart&) {
  // A robot may be parked several times: the last is told.
  story_.motions.clear();
  story_.works.clear();
  story_.pauses.clear();
  story_.made.clear();
  story_.turn.reset();
  carries_ = in_motion_ = false;
  carried_motions_ = 0;
}

void StoryReader::follow(const trace::Wait&) { motion(time_); }

void StoryReader::follow(const trace::MotionEnd& end) {
  Motion& ended = motion(time_);
  ended.to = trace::seconds(end.t);
  ended.tries = end.tries;
  ended.accepted = end.accepted;
  ended.reached = end.reached;
  ended.status = end.status;
  ended.message = end.message;
  ended.at_end = configuration(end.q);
  for (const trace::NamedValue& off : end.residual) {
    if (off.value) ended.residual.emplace_back(off.name, *off.value);
  }
  in_motion_ = false;
  if (carries_) ++carried_motions_;
}

void StoryReader::follow(const trace::GuidePlan& plan) {
  GuideStory& guide = motion(time_).guides.emplace_back();
  guide.name = plan.name;
  guide.kind = plan.kind;
  guide.cause = plan.cause;
  guide.checks = plan.checks;
  guide.length = plan.length;
  const std::size_t width = widths_[story_.robot];
  if (plan.found && width > 0) guide.waypoints = static_cast<int>(plan.way.size() / width) - 1;
  guide.events.assign(plan.events.begin(), plan.events.end());
}

void StoryReader::follow(const trace::Attach&) { carries_ = true; }

void StoryReader::follow(const trace::Detach& detach) {
  carries_ = false;
  story_.overtime += trace::seconds(detach.overtime);
}

void StoryReader::follow(const trace::Work& work) {
  story_.works.push_back({std::string(work.what), std::string(work.crew), trace::seconds(work.from),
                          trace::seconds(work.t), trace::seconds(work.time)});
}

/// What its crews waited for before that is no new try of its carrying motion.
void StoryReader::follow(const trace::Turn& turn) {
  story_.turn = LoadTurn{std::string(turn.component),
                         turn.angle_deg,
                         trace::seconds(turn.from),
                         trace::seconds(turn.t),
                         {}};
  if (turn.hit) story_.turn->refused = {std::string(turn.hit->moved), std::string(turn.hit->met)};
  carried_motions_ = std::max(carried_motions_, 1);
}

void StoryReader::follow(const trace::Pause& pause) {
  story_.pauses.push_back({std::string(pause.why), std::string(pause.whom),
                           trace::seconds(pause.from), trace::seconds(pause.t), 0});
  // A motion that is tried again after a pause is still the same one.
  if (pause.why == "machine" && carries_ && carried_motions_ > 0) --carried_motions_;
}

void StoryReader::follow(const trace::Attempt& record) {
  Attempt attempt;
  attempt.n = record.n;
  attempt.command = record.command;
  attempt.parameters.assign(record.parameters.begin(), record.parameters.end());
  attempt.file = record.file;
  attempt.line = record.line;
  attempt.ok = record.ok;
  attempt.reason = record.reason;
  attempt.t = trace::seconds(record.t);
  if (record.hit) {
    attempt.moved = record.hit->moved;
    attempt.met = record.hit->met;
    attempt.trace_line = lines_;
    attempt.q = configuration(record.q);
    attempt.steps.assign(record.step.begin(), record.step.end());
  }
  if (record.ok) story_.made.push_back(record.n);
  Motion& in = motion(time_);
  if (!attempt.met.empty()) {
    ++in.hits;
    if (!in.first_hit) in.first_hit = attempt;
  }
  keep(in, std::move(attempt));
}

/// Whatever is tried where something is blocked belongs together until that moves again.
void StoryReader::keep(Motion& in, Attempt attempt) {
  const bool blocks = !attempt.met.empty();
  if (attempt.ok && attempt.parameters == blocked_) {
    blocked_.clear();
    in.last.clear();
    return;
  }
  if (blocks && blocked_.empty()) in.last.clear();
  if (blocks) blocked_ = attempt.parameters;
  if (blocked_.empty() && attempt.ok) {
    in.last.clear();
    return;
  }
  if (in.last.size() >= 2 * kKeptAttempts) {
    in.last.erase(in.last.begin(), in.last.begin() + static_cast<std::ptrdiff_t>(kKeptAttempts));
  }
  in.last.push_back(std::move(attempt));
}

std::vector<std::string> StoryReader::tasks() const { return order_; }

bool StoryReader::has_task() const {
  return runs_.contains(task_) || std::find(order_.begin(), order_.end(), task_) != order_.end();
}

TaskStory StoryReader::story() const {
  TaskStory story = story_;
  const auto run = runs_.find(task_);
  if (run != runs_.end()) story.run = run->second.back();
  if (story.run.started && trace::has_happened(story.run.result)) {
    story.waits = wait_chain(task_, runs_);
  }
  return story;
}

}  // namespace rubicon::why
