#include "src/report/schedule_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "src/trace/json_builder.hpp"

namespace rubicon::report {

namespace {

using interpreter::Ticks;
using taskplan::Schedule;
using taskplan::TaskOutcome;

std::string crew_text(const TaskOutcome& task) {
  return fmt::format("{}", fmt::join(task.crews, ", "));
}

std::string seconds_text(Ticks ticks) {
  std::string text;
  trace::append_seconds(text, ticks);
  return text;
}

/// How many characters a terminal shows: code points.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
  }));
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char byte : text) {
    quoted += byte;
    if (byte == '"') quoted += '"';
  }
  return quoted + "\"";
}

constexpr std::size_t kColumns = 8;
using Row = std::array<std::string, kColumns>;

/// Columns that hold numbers and times, aligned to the right.
constexpr bool right_aligned(std::size_t column) { return column >= 3 && column <= 6; }

}  // namespace

std::string clock_text(Ticks ticks) {
  const Ticks seconds = (ticks + Ticks{500'000'000}) / Ticks{1'000'000'000};
  return fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

std::string schedule_table(const Schedule& schedule) {
  std::vector<Row> rows = {
      {"task", "robot", "crew", "start", "duration", "tried", "accepted", "result"}};
  for (const TaskOutcome& task : schedule.tasks) {
    std::string result = name_of(task.result);
    if (!task.reason.empty()) result += ": " + task.reason;
    rows.push_back({task.task, task.robot, crew_text(task), clock_text(task.start),
                    clock_text(task.duration), fmt::format("{}", task.tried),
                    fmt::format("{}", task.accepted), result});
  }
  std::array<std::size_t, kColumns> widths{};
  for (const Row& row : rows) {
    for (std::size_t c = 0; c + 1 < kColumns; ++c) widths[c] = std::max(widths[c], width(row[c]));
  }
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t c = 0; c + 1 < kColumns; ++c) {
      const std::string padding(widths[c] - width(row[c]), ' ');
      text += right_aligned(c) ? padding + row[c] : row[c] + padding;
      text += "  ";
    }
    text += row.back() + "\n";
  }
  const auto count = [&](taskplan::TaskResult result) {
    return std::count_if(schedule.tasks.begin(), schedule.tasks.end(),
                         [&](const TaskOutcome& task) { return task.result == result; });
  };
  text += fmt::format("\n{} of {} tasks done", count(taskplan::TaskResult::done),
                      schedule.tasks.size());
  for (const auto result : {taskplan::TaskResult::rejected, taskplan::TaskResult::not_reached}) {
    if (count(result) > 0) text += fmt::format(", {} {}", count(result), name_of(result));
  }
  text += fmt::format(", process time {} ({} s)\n", clock_text(schedule.process_time),
                      seconds_text(schedule.process_time));
  return text;
}

std::string schedule_json(const Schedule& schedule) {
  std::string text = "{\"tasks\":[";
  const char* separator = "\n";
  for (const TaskOutcome& task : schedule.tasks) {
    trace::JsonBuilder json;
    json.begin_object();
    json.field("task", std::string_view(task.task)).field("robot", std::string_view(task.robot));
    json.field("crew", std::string_view(crew_text(task)));
    json.key("start").seconds(task.start).key("duration").seconds(task.duration);
    json.field("tried", task.tried).field("accepted", task.accepted);
    json.field("result", name_of(task.result)).field("reason", std::string_view(task.reason));
    json.end_object();
    text += separator + json.take();
    separator = ",\n";
  }
  return text + fmt::format("\n],\"process_time\":{}}}\n", seconds_text(schedule.process_time));
}

std::string schedule_csv(const Schedule& schedule) {
  std::string text = "task,robot,crew,start,duration,tried,accepted,result,reason\n";
  for (const TaskOutcome& task : schedule.tasks) {
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", csv_field(task.task), csv_field(task.robot),
                        csv_field(crew_text(task)), seconds_text(task.start),
                        seconds_text(task.duration), task.tried, task.accepted,
                        name_of(task.result), csv_field(task.reason));
  }
  return text;
}

}  // namespace rubicon::report
