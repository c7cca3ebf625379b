#include "src/results/golden/observation.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <variant>

#include "src/simulation/trace/header.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::golden {

namespace {

using nlohmann::ordered_json;
using trace::RecordKind;

/// Width of the command column in `expected.trace`.
constexpr int kCommandWidth = 34;

/// Changes smaller than this are not shown to people (m or degrees).
constexpr double kShownChange = 1e-9;

/// A number as a trace writes it: a whole one without a point.
ordered_json number_json(double value) {
  std::string text;
  trace::append_number(text, value);
  if (text == "null") return nullptr;
  const bool whole =
      text.find_first_not_of("0123456789", text[0] == '-' ? 1 : 0) == std::string::npos;
  if (!whole) return value;
  if (value < 0) return static_cast<std::int64_t>(value);
  return static_cast<std::uint64_t>(value);
}

/// A time in seconds, in the same way.
ordered_json time_json(trace::Ticks time) { return number_json(trace::seconds(time)); }

ordered_json configuration_json(trace::Configuration q) {
  ordered_json object = ordered_json::object();
  for (const auto& [name, value] : q) object[std::string(name)] = number_json(value);
  return object;
}

/// Only the first word of the reason: names may depend on the order of tests.
std::string first_word(std::string_view reason) {
  return std::string(reason.substr(0, reason.find(' ')));
}

/// The members of a record that goldens keep, with the shorter names that they use.
struct GoldenMembers {
  ordered_json& event;

  void operator()(const trace::TaskStart& start) const { event["time"] = time_json(start.t); }
  void operator()(const trace::GoalStart& goal) const {
    event["k"] = goal.k;
    event["n"] = goal.n;
  }
  void operator()(const trace::Assignment& assignment) const {
    event["var"] = assignment.variable;
    event["value"] = assignment.value ? number_json(*assignment.value) : ordered_json(nullptr);
  }
  void operator()(const trace::LoopStart& loop) const {
    event["kind"] = loop.kind;
    event["line"] = loop.line;
    event["col"] = loop.column;
  }
  void operator()(const trace::LoopEnd& loop) const {
    event["kind"] = loop.kind;
    event["line"] = loop.line;
    event["col"] = loop.column;
    event["reached"] = loop.reached;
    event["successes"] = loop.successes;
  }
  void operator()(const trace::Choice& choice) const {
    event["label"] = choice.label;
    event["line"] = choice.line;
  }
  void operator()(const trace::Attempt& attempt) const {
    event["n"] = attempt.n;
    event["cmd"] = attempt.command;
    if (attempt.command == "together" || attempt.command == "follow" || attempt.command == "line") {
      event["p"] = attempt.parameters;
    } else {
      event["p"] = attempt.parameters.front();
    }
    event["line"] = attempt.line;
    event["col"] = attempt.column;
    event["ok"] = attempt.ok;
    event["why"] = first_word(attempt.reason);
    event["q"] = configuration_json(attempt.q);
  }
  void operator()(const trace::Wait& wait) const { event["n"] = wait.n; }
  void operator()(const trace::Stop& stop) const { event["time"] = time_json(stop.t); }
  void operator()(const trace::Think& think) const { event["time"] = time_json(think.t); }
  void operator()(const trace::GuidePlan& plan) const {
    event["name"] = plan.name;
    event["found"] = plan.found;
  }
  void operator()(const trace::WayPoint& point) const {
    event["k"] = point.k;
    event["n"] = point.n;
  }
  void operator()(const trace::Attach& attach) const { event["component"] = attach.component; }
  void operator()(const trace::Detach& detach) const { event["component"] = detach.component; }
  void operator()(const trace::Turn& turn) const {
    event["component"] = turn.component;
    event["angle"] = number_json(turn.angle_deg);
  }
  void operator()(const trace::MotionEnd& end) const {
    event["status"] = end.status;
    event["reached"] = end.reached;
  }
  void operator()(const trace::TaskEnd& end) const {
    event["time"] = time_json(end.t);
    event["result"] = end.result;
    event["reason"] = without_folders(std::string(end.reason));
  }
  void operator()(const trace::Moving& moving) const {
    event["name"] = moving.name;
    event["by"] = moving.by;
    event["time"] = time_json(moving.t);
  }
  void operator()(const trace::Soil& soil) const {
    event["component"] = soil.component;
    event["volume"] = number_json(soil.volume);
    event["cells"] = soil.cells.size();
  }
  void operator()(const trace::Foreseen& foreseen) const {
    event["machine"] = foreseen.machine;
    event["time"] = time_json(foreseen.t);
  }
  // Crew work, pauses, removals, joints, breakdowns and lost days are in the schedule.
  void operator()(const trace::ColdJoint&) const {}
  void operator()(const trace::Work&) const {}
  void operator()(const trace::Pause&) const {}
  void operator()(const trace::Removal&) const {}
  void operator()(const trace::Breakdown&) const {}
  void operator()(const trace::LostDays&) const {}
  // Of full traces.
  void operator()(const trace::Forbidden&) const {}
};

std::string_view type_of(const trace::Record& record) {
  return trace::kRecordTypes[static_cast<std::size_t>(record.kind())];
}

ObservedEnd observed(const trace::MotionEnd& end) {
  ObservedEnd kept{std::string(end.status),
                   end.period,
                   end.tries,
                   end.accepted,
                   end.rejected,
                   {},
                   configuration_json(end.q),
                   ordered_json::object()};
  for (const auto& [name, off] : end.residual) {
    kept.residual.emplace_back(name, off.value_or(std::numeric_limits<double>::infinity()));
  }
  for (const auto& [name, value] : end.variables) {
    kept.variables[std::string(name)] = value ? number_json(*value) : ordered_json(nullptr);
  }
  return kept;
}

const trace::RecordKinds kWanted = {
    trace::RecordKind::task_start, trace::RecordKind::goal,  trace::RecordKind::set,
    trace::RecordKind::enter,      trace::RecordKind::exit,  trace::RecordKind::which,
    trace::RecordKind::attempt,    trace::RecordKind::wait,  trace::RecordKind::attach,
    trace::RecordKind::detach,     trace::RecordKind::end,   trace::RecordKind::task_end,
    trace::RecordKind::stop,       trace::RecordKind::guide, trace::RecordKind::way_point,
    trace::RecordKind::soil,       trace::RecordKind::turn,  trace::RecordKind::think,
    trace::RecordKind::foreseen};

}  // namespace

std::string brief(double value) { return fmt::format("{:g}", value == 0 ? 0.0 : value); }

std::string without_folders(std::string reason) {
  std::size_t open = reason.find('(');
  while (open != std::string::npos) {
    const std::size_t close = reason.find(')', open);
    if (close == std::string::npos) break;
    const std::size_t slash = reason.rfind('/', close);
    if (slash != std::string::npos && slash > open && std::isdigit(reason[close - 1]) != 0) {
      reason.erase(open + 1, slash - open);
    }
    open = reason.find('(', open + 1);
  }
  return reason;
}

Observation::Observation(std::map<Place, std::string> command_texts,
                         std::map<std::string, Values> starts, bool with_tasks)
    : reader_(kWanted),
      command_texts_(std::move(command_texts)),
      with_tasks_(with_tasks),
      starts_(std::move(starts)),
      q_(starts_) {}

void Observation::restart() {
  reader_ = trace::TraceReader(kWanted);
  events_ = ordered_json::array();
  ends_.clear();
  text_.clear();
  depth_ = 0;
  q_ = starts_;
}

void Observation::line(std::string_view text) {
  reader_.read(
      text, [](const trace::TraceHeader&) {}, [&](const trace::Record& record) { add(record); });
}

void Observation::add(const trace::Record& record) {
  const bool about_tasks =
      record.kind() == RecordKind::task_start || record.kind() == RecordKind::task_end;
  if (about_tasks && !with_tasks_) return;
  const auto* end = std::get_if<trace::MotionEnd>(&record.what);
  if (end != nullptr) ends_.push_back(observed(*end));
  if (end == nullptr || with_tasks_) {
    ordered_json event = {{"t", type_of(record)}};
    std::visit(GoldenMembers{event}, record.what);
    if (with_tasks_) event["task"] = record.task;
    events_.push_back(std::move(event));
  }
  std::visit([&](const auto& what) { write_event(record, what); }, record.what);
}

void Observation::write(const std::string& text) {
  text_ += std::string(static_cast<std::size_t>(6 + 2 * depth_), ' ') + text + "\n";
}

void Observation::write_event(const trace::Record&, const trace::GoalStart& goal) {
  depth_ = 0;
  write(fmt::format("goal {} of {}", goal.k, goal.n));
}

void Observation::write_event(const trace::Record&, const trace::Assignment& assignment) {
  write(fmt::format("= var({}) = {}", assignment.variable,
                    assignment.value ? brief(*assignment.value) : "null"));
}

void Observation::write_event(const trace::Record&, const trace::LoopStart& loop) {
  write(fmt::format("{}@{} {{", loop.kind, loop.line));
  ++depth_;
}

void Observation::write_event(const trace::Record&, const trace::LoopEnd& loop) {
  depth_ = depth_ > 0 ? depth_ - 1 : 0;
  write(fmt::format("}} {}@{} {}, {} successes", loop.kind, loop.line,
                    loop.reached ? "reached" : "exhausted", loop.successes));
}

void Observation::write_event(const trace::Record&, const trace::Choice& choice) {
  write(fmt::format("which@{} -> {}", choice.line, choice.label));
}

void Observation::write_event(const trace::Record&, const trace::Wait& wait) {
  text_ += fmt::format("{:>5} {}+ wait\n", wait.n,
                       std::string(static_cast<std::size_t>(2 * depth_), ' '));
}

void Observation::write_event(const trace::Record&, const trace::Stop& stop) {
  write(fmt::format("stop, at {} s", brief(trace::seconds(stop.t))));
}

void Observation::write_event(const trace::Record&, const trace::Think& think) {
  write(fmt::format("think, until {} s", brief(trace::seconds(think.t))));
}

void Observation::write_event(const trace::Record&, const trace::GuidePlan& plan) {
  write(plan.found ? fmt::format("guide {} ({}) found a way", plan.name, plan.kind)
                   : fmt::format("guide {} ({}): {}", plan.name, plan.kind, plan.cause));
}

void Observation::write_event(const trace::Record&, const trace::WayPoint& point) {
  depth_ = 0;
  write(fmt::format("waypoint {} of {}", point.k, point.n));
}

void Observation::write_event(const trace::Record&, const trace::Attach& attach) {
  depth_ = 0;
  write(fmt::format("attach {}", attach.component));
}

void Observation::write_event(const trace::Record&, const trace::Detach& detach) {
  depth_ = 0;
  write(fmt::format("detach {}", detach.component));
}

void Observation::write_event(const trace::Record&, const trace::Turn& turn) {
  write(fmt::format("turn {} by {} degrees", turn.component, brief(turn.angle_deg)));
}

void Observation::write_event(const trace::Record& record, const trace::TaskStart&) {
  depth_ = 0;
  text_ += fmt::format("task {}\n", record.task);
}

void Observation::write_event(const trace::Record& record, const trace::TaskEnd& end) {
  depth_ = 0;
  const std::string reason = without_folders(std::string(end.reason));
  text_ +=
      fmt::format("task {} {}{}{}\n", record.task, end.result, reason.empty() ? "" : ": ", reason);
}

void Observation::write_event(const trace::Record&, const trace::MotionEnd& end) {
  depth_ = 0;
  write(end.period ? fmt::format("status {} period {}", end.status, *end.period)
                   : fmt::format("status {}", end.status));
  std::string text = "end";
  const char* separator = " ";
  for (const auto& [name, value] : end.q) {
    text += fmt::format("{}{} {}", separator, name, brief(value));
    separator = ", ";
  }
  write(text);
}

void Observation::write_event(const trace::Record& record, const trace::Attempt& attempt) {
  const auto found = command_texts_.find({std::string(attempt.file), attempt.line, attempt.column});
  const std::string command =
      found != command_texts_.end() ? found->second : std::string(attempt.command);
  Values& q = q_[std::string(record.robot)];
  std::string change;
  if (attempt.ok) {
    const char* separator = "";
    for (const auto& [name, after] : attempt.q) {
      const auto before = q.find(name);
      if (before == q.end() || std::fabs(after - before->second) <= kShownChange) continue;
      change += fmt::format("{}{}: {} -> {}", separator, name, brief(before->second), brief(after));
      separator = ", ";
    }
  } else {
    change = attempt.reason;
    if (attempt.hit) change += fmt::format(" {}", attempt.hit->met);
  }
  text_ += fmt::format("{:>5} {}{} {:<{}} {}\n", attempt.n,
                       std::string(static_cast<std::size_t>(2 * depth_), ' '),
                       attempt.ok ? '+' : '-', command, kCommandWidth, change);
  for (const auto& [name, value] : attempt.q) q.insert_or_assign(std::string(name), value);
}

std::string describe(const ordered_json& event) {
  const std::string type = event.value("t", "?");
  std::string text = type;
  for (const auto& [key, value] : event.items()) {
    if (key == "t") continue;
    if (value.is_number_float()) {
      text += fmt::format("  {} {}", key, value.get<double>());
    } else {
      text +=
          fmt::format("  {} {}", key, value.is_string() ? value.get<std::string>() : value.dump());
    }
  }
  return text;
}

}  // namespace rubicon::golden
