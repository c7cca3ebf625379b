#include "src/results/debug/recording_reader.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "src/results/debug/clean_text.hpp"
#include "src/results/report/schedule_text.hpp"

namespace rubicon::debug {

namespace {

using nlohmann::json;

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

}  // namespace

void RecordingReader::restart() { *this = RecordingReader(); }

void RecordingReader::line(std::string_view text) {
  const RecordLine record(text);
  const std::string& type = record.text("type");
  if (type == "header") {
    if (has_header_) throw std::invalid_argument("this is no line of a trace: a second header");
    try {
      read_header(text);
    } catch (const json::exception& error) {
      throw std::invalid_argument(fmt::format("this is no line of a trace: {}", error.what()));
    }
    return;
  }
  if (!has_header_) throw std::invalid_argument("this is no trace: its first line does not say so");
  read_record(type, record);
}

void RecordingReader::read_header(std::string_view text) {
  const json header = json::parse(text);
  if (header.value("format", "") != "rubicon-trace") {
    throw std::invalid_argument("this is no trace: its first line does not say so");
  }
  has_header_ = true;
  recording_.plan = clean_text(header.at("plan").get<std::string>());
  recording_.detail = header.at("detail");
  if (!header.at("start_at").is_null()) {
    recording_.start_at =
        report::start_from_text(clean_text(header.at("start_at").get<std::string>()));
  }
  for (const json& file : header.at("files")) {
    add_file(file.at("path"), file.at("text"));
  }
  for (const json& robot : header.at("robots")) {
    std::vector<std::string>& bodies =
        recording_.robots[clean_text(robot.at("name").get<std::string>())];
    for (const json& body : robot.at("bodies")) {
      bodies.push_back(clean_text(body.at("name").get<std::string>()));
    }
    Configuration& stands = stands_[robot.at("name")];
    for (const auto& [name, value] : robot.at("start").items()) {
      stands[name] = value.get<double>();
    }
  }
  if (header.at("form") == "short") planned(header.at("plan"));
  for (const json& task : header.at("tasks")) {
    PlannedTask& known = planned(task.at("name"));
    known.robot = clean_text(task.value("robot", ""));
    if (task.contains("move")) known.moves = clean_text(task.at("move").get<std::string>());
  }
}

PlannedTask& RecordingReader::planned(const std::string& name) {
  const auto [slot, inserted] = planned_.try_emplace(name, recording_.tasks.size());
  if (inserted) recording_.tasks.emplace_back().name = clean_text(name);
  return recording_.tasks[slot->second];
}

void RecordingReader::read_record(const std::string& type, const RecordLine& record) {
  const std::optional<EventKind> kind = trace::record_kind(type);
  if (!kind) {
    throw std::invalid_argument(
        fmt::format("this is no line of a trace: its type is '{}'", clean_text(type)));
  }
  if (*kind == EventKind::task_end && !open_.contains(record.text("task"))) {
    PlannedTask& task = planned(record.text("task"));
    task.result = clean_text(record.text("result"));
    task.reason = clean_text(record.text("reason"));
    return;
  }
  TaskRun& run = run_of(*kind, record);
  run.add(event_of(*kind, record), record.configuration());
  if (*kind == EventKind::task_end) end_task(run, record);
}

/// The run that a record belongs to. In a short plan it begins with the first record.
TaskRun& RecordingReader::run_of(EventKind kind, const RecordLine& record) {
  const std::string& task = record.text("task");
  const auto open = open_.find(task);
  if (open != open_.end() && kind != EventKind::task_start) return recording_.runs[open->second];
  PlannedTask& known = planned(task);
  const std::string& robot = record.text("robot");
  known.robot = clean_text(robot);
  open_[task] = recording_.runs.size();
  TaskRun& run =
      recording_.runs.emplace_back(recording_.texts.add(task), recording_.texts.add(robot));
  run.set_before(stands_[robot]);
  return run;
}

void RecordingReader::end_task(TaskRun& run, const RecordLine& record) {
  PlannedTask& task = planned(record.text("task"));
  task.result = clean_text(record.text("result"));
  task.reason = clean_text(record.text("reason"));
  open_.erase(record.text("task"));
  if (task.result == "done") {
    Configuration q = run.ended_at();
    if (!q.empty()) stands_[record.text("robot")] = std::move(q);
  } else {
    run.set_undone();
  }
  run.close();
}

Event RecordingReader::event_of(EventKind kind, const RecordLine& record) {
  Event event;
  event.kind = kind;
  const std::size_t known = open_.at(record.text("task"));
  event.t = record.has("t") ? record.number("t") : recording_.runs[known].last().t;
  if (record.has("file")) event.place = place_of(record);
  if (!read_script(record, event)) read_work(record, event);
  return event;
}

/// The members of a record of what a script does; false if it is none.
bool RecordingReader::read_script(const RecordLine& record, Event& event) {
  StringTable& texts = recording_.texts;
  switch (event.kind) {
    case EventKind::goal:
      event.n = record.integer("k");
      event.value = record.integer("n");
      return true;
    case EventKind::set:
      event.text = texts.add(record.text("var"));
      event.value = record.number("value");
      return true;
    case EventKind::exit:
      event.ok = record.truth("reached");
      event.value = record.integer("successes");
      [[fallthrough]];
    case EventKind::enter:
      event.text = texts.add(record.text("kind"));
      return true;
    case EventKind::which:
      event.text = texts.add(record.text("label"));
      return true;
    case EventKind::attempt:
      event.n = record.integer("n");
      event.ok = record.truth("ok");
      event.text = command_of(record);
      if (!event.ok) event.other = refusal_of(record);
      return true;
    case EventKind::wait:
      event.n = record.integer("n");
      return true;
    default:
      return false;
  }
}

/// The members of a record of what becomes of a task.
void RecordingReader::read_work(const RecordLine& record, Event& event) {
  StringTable& texts = recording_.texts;
  switch (event.kind) {
    case EventKind::task_start:
      if (record.has("because")) event.text = texts.add(record.text("because"));
      return;
    case EventKind::work:
      event.text = texts.add(record.text("what"));
      event.other = texts.add(record.text("crew"));
      event.value = record.number("from");
      return;
    case EventKind::pause:
      event.text = texts.add(record.text("why"));
      event.other = texts.add(record.text("for"));
      event.value = record.number("from");
      return;
    case EventKind::end:
      event.text = texts.add(record.text("status"));
      if (record.has("message")) event.other = texts.add(record.text("message"));
      event.ok = record.truth("reached");
      event.n = record.integer("tries");
      event.value = record.integer("accepted");
      return;
    case EventKind::task_end:
      event.text = texts.add(record.text("result"));
      event.other = texts.add(record.text("reason"));
      return;
    default:  // attach, detach, remove
      event.text = texts.add(record.text("component"));
  }
}

/// The number of a file; it is added where it is not known.
std::size_t RecordingReader::add_file(const std::string& path, const std::string& text) {
  const auto [slot, inserted] = files_.try_emplace(path, recording_.files.size());
  if (inserted) {
    const std::string shown = clean_text(path);
    const std::size_t slash = shown.rfind('/');
    const std::string name = slash == std::string::npos ? shown : shown.substr(slash + 1);
    const bool taken = !file_names_.insert(name).second;
    recording_.files.push_back({shown, taken ? shown : name, lines_of(text)});
  }
  return slot->second;
}

std::uint32_t RecordingReader::place_of(const RecordLine& record) {
  const std::string& path = record.text("file");
  const int line = record.integer("line");
  const int column = record.integer("column");
  const auto [slot, inserted] = places_.try_emplace(
      {path, line, column}, static_cast<std::uint32_t>(recording_.places.size()));
  if (inserted) {
    recording_.places.push_back({add_file(path, ""), line, column});
  }
  return slot->second;
}

std::uint32_t RecordingReader::command_of(const RecordLine& record) {
  Command command;
  command.parameters = record.texts("parameter");
  if (command.parameters.size() > kMostParameters) {
    throw std::invalid_argument("this is no line of a trace: too many parameters");
  }
  for (std::string& each : command.parameters) each = clean_text(each);
  command.text =
      fmt::format("{} {}", clean_text(record.text("command")), fmt::join(command.parameters, ", "));
  const auto [slot, inserted] =
      commands_.try_emplace(command.text, static_cast<std::uint32_t>(recording_.commands.size()));
  if (inserted) recording_.commands.push_back(std::move(command));
  return slot->second;
}

std::uint32_t RecordingReader::refusal_of(const RecordLine& record) {
  Refusal refusal;
  refusal.reason = clean_text(record.text("reason"));
  if (record.has("hit")) {
    const std::vector<std::string> pair = record.texts("hit");
    if (pair.size() != 2) {
      throw std::invalid_argument("this is no line of a trace: its 'hit' is no pair");
    }
    refusal.moved = clean_text(pair[0]);
    refusal.met = clean_text(pair[1]);
  }
  const auto [slot, inserted] =
      refusals_.try_emplace({refusal.reason, refusal.moved, refusal.met},
                            static_cast<std::uint32_t>(recording_.refusals.size()));
  if (inserted) recording_.refusals.push_back(std::move(refusal));
  return slot->second;
}

Recording RecordingReader::take() {
  for (TaskRun& run : recording_.runs) run.close();
  return std::move(recording_);
}

}  // namespace rubicon::debug
