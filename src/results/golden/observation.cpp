#include "src/results/golden/observation.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <utility>

namespace rubicon::golden {

namespace {

using nlohmann::ordered_json;

/// Width of the command column in `expected.trace`.
constexpr int kCommandWidth = 34;

/// Changes smaller than this are not shown to people (m or degrees).
constexpr double kShownChange = 1e-9;

/// Record fields of a trace and the shorter names that goldens use for them.
ordered_json golden_event(const ordered_json& record) {
  const std::string type = record.at("type");
  ordered_json event = {{"t", type}};
  const auto keep = [&](const char* field, const char* as) {
    if (record.contains(field)) event[as] = record.at(field);
  };
  if (type == "goal") {
    keep("k", "k");
    keep("n", "n");
  } else if (type == "set") {
    keep("var", "var");
    keep("value", "value");
  } else if (type == "enter" || type == "exit") {
    keep("kind", "kind");
    keep("line", "line");
    keep("column", "col");
    keep("reached", "reached");
    keep("successes", "successes");
  } else if (type == "which") {
    keep("label", "label");
    keep("line", "line");
  } else if (type == "try") {
    keep("n", "n");
    keep("command", "cmd");
    keep("parameter", "p");
    keep("line", "line");
    keep("column", "col");
    keep("ok", "ok");
    // Only the first word of the reason: names may depend on the order of tests.
    const std::string reason = record.at("reason");
    event["why"] = reason.substr(0, reason.find(' '));
    keep("q", "q");
  } else if (type == "wait") {
    keep("n", "n");
  } else if (type == "attach" || type == "detach") {
    keep("component", "component");
  } else if (type == "task_start" || type == "task_end") {
    keep("t", "time");
    keep("result", "result");
    if (record.contains("reason")) event["reason"] = without_folders(record.at("reason"));
  } else if (type == "end") {
    keep("status", "status");
    keep("reached", "reached");
  }
  return event;
}

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
                         std::map<std::string, ordered_json> starts, bool with_tasks)
    : command_texts_(std::move(command_texts)),
      with_tasks_(with_tasks),
      starts_(std::move(starts)),
      q_(starts_) {}

void Observation::restart() {
  events_ = ordered_json::array();
  ends_.clear();
  text_.clear();
  depth_ = 0;
  q_ = starts_;
}

void Observation::line(std::string_view record_text) {
  const auto record = ordered_json::parse(record_text);
  const std::string type = record.at("type");
  const bool about_tasks = type == "task_start" || type == "task_end";
  if (type == "work" || type == "pause" || type == "remove") return;
  if (type == "header" || (about_tasks && !with_tasks_)) return;
  if (type == "end") ends_.push_back(record);
  if (type != "end" || with_tasks_) {
    ordered_json event = golden_event(record);
    if (with_tasks_) event["task"] = record.at("task");
    events_.push_back(std::move(event));
  }
  add_text(record);
}

void Observation::add_text(const ordered_json& record) {
  const std::string type = record.at("type");
  const auto write = [&](const std::string& text) {
    text_ += std::string(static_cast<std::size_t>(6 + 2 * depth_), ' ') + text + "\n";
  };
  if (type == "goal") {
    depth_ = 0;
    write(fmt::format("goal {} of {}", record.at("k").get<int>(), record.at("n").get<int>()));
  } else if (type == "set") {
    write(fmt::format("= var({}) = {}", record.at("var").get<std::string>(),
                      brief(record.at("value").get<double>())));
  } else if (type == "enter") {
    write(fmt::format("{}@{} {{", record.at("kind").get<std::string>(),
                      record.at("line").get<int>()));
    ++depth_;
  } else if (type == "exit") {
    depth_ = depth_ > 0 ? depth_ - 1 : 0;
    write(fmt::format("}} {}@{} {}, {} successes", record.at("kind").get<std::string>(),
                      record.at("line").get<int>(),
                      record.at("reached").get<bool>() ? "reached" : "exhausted",
                      record.at("successes").get<int>()));
  } else if (type == "which") {
    write(fmt::format("which@{} -> {}", record.at("line").get<int>(),
                      record.at("label").get<std::string>()));
  } else if (type == "try") {
    write_try(record, record.at("n").get<int>());
  } else if (type == "wait") {
    text_ += fmt::format("{:>5} {}+ wait\n", record.at("n").get<int>(),
                         std::string(static_cast<std::size_t>(2 * depth_), ' '));
  } else if (type == "attach" || type == "detach") {
    depth_ = 0;
    write(fmt::format("{} {}", type, record.at("component").get<std::string>()));
  } else if (type == "task_start") {
    depth_ = 0;
    text_ += fmt::format("task {}\n", record.at("task").get<std::string>());
  } else if (type == "task_end") {
    depth_ = 0;
    const std::string reason = without_folders(record.value("reason", std::string()));
    text_ +=
        fmt::format("task {} {}{}{}\n", record.at("task").get<std::string>(),
                    record.at("result").get<std::string>(), reason.empty() ? "" : ": ", reason);
  } else if (type == "end") {
    depth_ = 0;
    std::string end = "end";
    const char* separator = " ";
    for (const auto& [name, value] : record.at("q").items()) {
      end += fmt::format("{}{} {}", separator, name, brief(value.get<double>()));
      separator = ", ";
    }
    const std::string status = record.at("status");
    write(record.at("period").is_null()
              ? "status " + status
              : fmt::format("status {} period {}", status, record.at("period").get<int>()));
    write(end);
  }
}

void Observation::write_try(const ordered_json& record, int n) {
  const auto found =
      command_texts_.find({record.at("file").get<std::string>(), record.at("line").get<int>(),
                           record.at("column").get<int>()});
  const std::string command =
      found != command_texts_.end() ? found->second : record.at("command").get<std::string>();
  ordered_json& q = q_[record.at("robot").get<std::string>()];
  std::string change;
  if (record.at("ok").get<bool>()) {
    const char* separator = "";
    for (const auto& [name, value] : record.at("q").items()) {
      const double after = value.get<double>();
      if (!q.contains(name)) continue;
      const double before = q.at(name).get<double>();
      if (std::fabs(after - before) <= kShownChange) continue;
      change += fmt::format("{}{}: {} -> {}", separator, name, brief(before), brief(after));
      separator = ", ";
    }
  } else {
    change = record.at("reason").get<std::string>();
    if (record.contains("hit")) change += " " + record.at("hit").at(1).get<std::string>();
  }
  text_ += fmt::format("{:>5} {}{} {:<{}} {}\n", n,
                       std::string(static_cast<std::size_t>(2 * depth_), ' '),
                       record.at("ok").get<bool>() ? '+' : '-', command, kCommandWidth, change);
  q = record.at("q");
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
