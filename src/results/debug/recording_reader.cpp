#include "src/results/debug/recording_reader.hpp"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>

#include "src/results/debug/clean_text.hpp"
#include "src/results/report/schedule_text.hpp"
#include "src/simulation/trace/header.hpp"
#include "src/simulation/trace/record.hpp"

namespace rubicon::debug {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) end = text.size();
    std::string_view line = std::string_view(text).substr(begin, end - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(clean_text(line, kLongestLine));
    begin = end + 1;
  }
  return lines;
}

/// The configuration after a record; empty where it has none.
trace::Configuration configuration_of(const trace::Record& record) {
  if (const auto* attempt = std::get_if<trace::Attempt>(&record.what)) return attempt->q;
  if (const auto* end = std::get_if<trace::MotionEnd>(&record.what)) return end->q;
  return {};
}

}  // namespace

void RecordingReader::restart() { *this = RecordingReader(); }

void RecordingReader::line(std::string_view text) {
  reader_.read(
      text, [&](const trace::TraceHeader& header) { read_header(header); },
      [&](const trace::Record& record) { read_record(record); });
}

void RecordingReader::read_header(const trace::TraceHeader& header) {
  recording_.plan = clean_text(header.plan);
  recording_.detail = header.detail;
  if (header.start_at) {
    recording_.start_at = report::start_from_text(clean_text(*header.start_at));
  }
  for (const trace::HeaderFile& file : header.files) add_file(file.path, file.text);
  for (const trace::HeaderRobot& robot : header.robots) {
    std::vector<std::string>& bodies = recording_.robots[clean_text(robot.name)];
    for (const trace::HeaderBody& body : robot.bodies) bodies.push_back(clean_text(body.name));
    Stand& stands = stands_[robot.name];
    for (std::size_t i = 0; i < robot.start.size(); ++i) {
      stands[robot.parameters[i].name] = robot.start[i];
    }
  }
  if (header.short_form) planned(header.plan);
  for (const trace::HeaderTask& task : header.tasks) {
    PlannedTask& known = planned(task.name);
    known.robot = clean_text(task.robot);
    if (task.move) known.moves = clean_text(*task.move);
  }
}

PlannedTask& RecordingReader::planned(std::string_view name) {
  const auto known = planned_.find(name);
  if (known != planned_.end()) return recording_.tasks[known->second];
  planned_.emplace(name, recording_.tasks.size());
  PlannedTask& task = recording_.tasks.emplace_back();
  task.name = clean_text(name);
  return task;
}

void RecordingReader::read_record(const trace::Record& record) {
  if (record.kind() == EventKind::moving || record.kind() == EventKind::breakdown ||
      record.kind() == EventKind::lost_days) {
    return;  // of no task
  }
  if (record.kind() == EventKind::forbidden) return;  // a picture, no step
  const auto* end = std::get_if<trace::TaskEnd>(&record.what);
  if (end != nullptr && !open_.contains(record.task)) {
    PlannedTask& task = planned(record.task);
    task.result = clean_text(end->result);
    task.reason = clean_text(end->reason);
    return;
  }
  TaskRun& run = run_of(record);
  run.add(event_of(record), configuration_of(record));
  if (end != nullptr) end_task(run, record, *end);
}

/// The run that a record belongs to. In a short plan it begins with the first record.
TaskRun& RecordingReader::run_of(const trace::Record& record) {
  const auto open = open_.find(record.task);
  if (open != open_.end() && record.kind() != EventKind::task_start) {
    return recording_.runs[open->second];
  }
  planned(record.task).robot = clean_text(record.robot);
  open_[std::string(record.task)] = recording_.runs.size();
  TaskRun& run = recording_.runs.emplace_back(recording_.texts.add(record.task),
                                              recording_.texts.add(record.robot));
  run.set_before(stands_[std::string(record.robot)]);
  return run;
}

void RecordingReader::end_task(TaskRun& run, const trace::Record& record,
                               const trace::TaskEnd& end) {
  PlannedTask& task = planned(record.task);
  task.result = clean_text(end.result);
  task.reason = clean_text(end.reason);
  open_.erase(open_.find(record.task));
  if (trace::has_happened(task.result)) {
    Stand q = run.ended_at();
    if (!q.empty()) stands_[std::string(record.robot)] = std::move(q);
  } else {
    run.set_undone();
  }
  run.close();
}

Event RecordingReader::event_of(const trace::Record& record) {
  Event event;
  event.kind = record.kind();
  const auto t = record.time();
  event.t = t ? trace::seconds(*t) : recording_.runs[open_.find(record.task)->second].last().t;
  if (const trace::InText* place = record.place()) event.place = place_of(*place);
  std::visit([&](const auto& what) { fill(event, what); }, record.what);
  return event;
}

void RecordingReader::fill(Event& event, const trace::TaskStart& start) {
  if (!start.because.empty()) event.text = recording_.texts.add(start.because);
}

void RecordingReader::fill(Event& event, const trace::GoalStart& goal) {
  event.n = goal.k;
  event.value = goal.n;
}

void RecordingReader::fill(Event& event, const trace::GuidePlan& plan) {
  event.text = recording_.texts.add(fmt::format("{} ({})", plan.name, plan.kind));
  event.other = recording_.texts.add(plan.cause);
  event.ok = plan.found;
  event.n = plan.nodes;
  event.value = plan.checks;
}

void RecordingReader::fill(Event& event, const trace::Think& think) { event.n = think.checks; }

void RecordingReader::fill(Event& event, const trace::WayPoint& point) {
  event.n = point.k;
  event.value = point.n;
}

void RecordingReader::fill(Event& event, const trace::Assignment& assignment) {
  event.text = recording_.texts.add(assignment.variable);
  event.value = assignment.value.value_or(std::numeric_limits<double>::quiet_NaN());
}

void RecordingReader::fill(Event& event, const trace::LoopStart& loop) {
  event.text = recording_.texts.add(loop.kind);
}

void RecordingReader::fill(Event& event, const trace::LoopEnd& loop) {
  event.ok = loop.reached;
  event.value = loop.successes;
  event.text = recording_.texts.add(loop.kind);
}

void RecordingReader::fill(Event& event, const trace::Choice& choice) {
  event.text = recording_.texts.add(choice.label);
}

void RecordingReader::fill(Event& event, const trace::Attempt& attempt) {
  event.n = attempt.n;
  event.ok = attempt.ok;
  event.text = command_of(attempt);
  if (!event.ok) event.other = refusal_of(attempt);
}

void RecordingReader::fill(Event& event, const trace::Wait& wait) { event.n = wait.n; }

void RecordingReader::fill(Event& event, const trace::Work& work) {
  event.text = recording_.texts.add(work.what);
  event.other = recording_.texts.add(work.crew);
  event.value = trace::seconds(work.time);
}

void RecordingReader::fill(Event& event, const trace::Pause& pause) {
  event.text = recording_.texts.add(pause.why);
  event.other = recording_.texts.add(pause.whom);
  event.value = trace::seconds(pause.from);
}

void RecordingReader::fill(Event& event, const trace::Attach& attach) {
  event.text = recording_.texts.add(attach.component);
}

void RecordingReader::fill(Event& event, const trace::Detach& detach) {
  event.text = recording_.texts.add(detach.component);
}

void RecordingReader::fill(Event& event, const trace::Turn& turn) {
  event.text = recording_.texts.add(turn.component);
  event.value = turn.angle_deg;
}

void RecordingReader::fill(Event& event, const trace::ColdJoint& joint) {
  const trace::Numbers ends = joint.ends;
  if (ends.size() != 4) throw std::invalid_argument("expected x and y of two ends as 'ends'");
  event.text = recording_.texts.add(
      fmt::format("({:.2f}, {:.2f}) to ({:.2f}, {:.2f})", ends[0], ends[1], ends[2], ends[3]));
  event.value = trace::seconds(joint.age);
}

void RecordingReader::fill(Event& event, const trace::Removal& removal) {
  event.text = recording_.texts.add(removal.component);
}

void RecordingReader::fill(Event& event, const trace::Foreseen& foreseen) {
  event.text = recording_.texts.add(foreseen.machine);
  event.value = foreseen.seconds;
}

void RecordingReader::fill(Event& event, const trace::Soil& soil) {
  event.text = recording_.texts.add(soil.component);
  event.value = soil.volume;
}

void RecordingReader::fill(Event& event, const trace::MotionEnd& end) {
  event.text = recording_.texts.add(end.status);
  if (!end.message.empty()) event.other = recording_.texts.add(end.message);
  event.ok = end.reached;
  event.n = end.tries;
  event.value = end.accepted;
}

void RecordingReader::fill(Event& event, const trace::TaskEnd& end) {
  event.text = recording_.texts.add(end.result);
  event.other = recording_.texts.add(end.reason);
}

/// The number of a file; it is added where it is not known.
std::size_t RecordingReader::add_file(std::string_view path, const std::string& text) {
  const auto known = files_.find(path);
  if (known != files_.end()) return known->second;
  const std::size_t number = recording_.files.size();
  files_.emplace(path, number);
  const std::string shown = clean_text(path);
  const std::size_t slash = shown.rfind('/');
  const std::string name = slash == std::string::npos ? shown : shown.substr(slash + 1);
  const bool taken = !file_names_.insert(name).second;
  recording_.files.push_back({shown, taken ? shown : name, lines_of(text)});
  return number;
}

std::uint32_t RecordingReader::place_of(const trace::InText& place) {
  const auto known = places_.find(std::tuple(place.file, place.line, place.column));
  if (known != places_.end()) return known->second;
  const auto number = static_cast<std::uint32_t>(recording_.places.size());
  places_.emplace(std::tuple(std::string(place.file), place.line, place.column), number);
  recording_.places.push_back({add_file(place.file, ""), place.line, place.column});
  return number;
}

std::uint32_t RecordingReader::command_of(const trace::Attempt& attempt) {
  if (attempt.parameters.size() > kMostParameters) {
    throw std::invalid_argument("this is no line of a trace: too many parameters");
  }
  command_key_ = attempt.command;
  const char* separator = " ";
  for (const std::string_view parameter : attempt.parameters) {
    command_key_ += separator;
    command_key_ += parameter;
    separator = ", ";
  }
  const auto [slot, inserted] =
      commands_.try_emplace(command_key_, static_cast<std::uint32_t>(recording_.commands.size()));
  if (inserted) {
    Command command;
    for (const std::string_view each : attempt.parameters) {
      command.parameters.push_back(clean_text(each));
    }
    command.text =
        fmt::format("{} {}", clean_text(attempt.command), fmt::join(command.parameters, ", "));
    recording_.commands.push_back(std::move(command));
  }
  return slot->second;
}

std::uint32_t RecordingReader::refusal_of(const trace::Attempt& attempt) {
  const trace::Hit hit = attempt.hit.value_or(trace::Hit{});
  const auto known = refusals_.find(std::tuple(attempt.reason, hit.moved, hit.met));
  if (known != refusals_.end()) return known->second;
  const auto number = static_cast<std::uint32_t>(recording_.refusals.size());
  refusals_.emplace(
      std::tuple(std::string(attempt.reason), std::string(hit.moved), std::string(hit.met)),
      number);
  recording_.refusals.push_back(
      {clean_text(attempt.reason), clean_text(hit.moved), clean_text(hit.met)});
  return number;
}

Recording RecordingReader::take() {
  for (TaskRun& run : recording_.runs) run.close();
  return std::move(recording_);
}

}  // namespace rubicon::debug
