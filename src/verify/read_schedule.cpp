#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "src/verify/check_schedule.hpp"
#include "src/verify/json_fields.hpp"

namespace rubicon::verify {

namespace {

/// The first line from `from` on that names the task; the rows stand in lines of their own.
std::size_t find_row(const std::string& text, std::size_t from, const std::string& task) {
  const std::string wanted =
      "\"task\":" + Json(task).dump(-1, ' ', false, Json::error_handler_t::replace);
  const std::size_t found = text.find(wanted, from);
  return found == std::string::npos ? from : found;
}

/// Splits a CSV text (RFC 4180) into rows of fields, with the line of each row.
class CsvReader {
 public:
  explicit CsvReader(const std::string& text) : text_(text) {}

  bool next(std::vector<std::string>& row, int& line) {
    if (at_ >= text_.size()) return false;
    row.clear();
    line = line_;
    do {
      row.push_back(field());
    } while (take(','));
    take('\r');
    if (!take('\n') && at_ < text_.size()) {
      throw UnreadableInput(fmt::format("{}: expected the end of the line", line_));
    }
    ++line_;
    return true;
  }

 private:
  bool take(char wanted) {
    if (at_ >= text_.size() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }

  std::string field() {
    std::string value;
    if (!take('"')) {
      while (at_ < text_.size() && text_[at_] != ',' && text_[at_] != '\n' && text_[at_] != '\r') {
        value += text_[at_++];
      }
      return value;
    }
    while (at_ < text_.size()) {
      const char c = text_[at_++];
      if (c == '\n') ++line_;
      if (c == '"' && !take('"')) return value;
      value += c;
    }
    throw UnreadableInput(fmt::format("{}: expected a closing quote", line_));
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// Seconds or attempts in a table; more is none.
constexpr double kLargest = 2e9;

double number_in(const std::string& field, int line) {
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() ||
      !(std::fabs(value) < kLargest)) {
    throw UnreadableInput(fmt::format("{}: expected a number, found '{}'", line, field));
  }
  return value;
}

Ticks ticks_of(double seconds) {
  return static_cast<Ticks>(std::floor(seconds * static_cast<double>(kSecond) + 0.5));
}

}  // namespace

ScheduleJson read_schedule_json(const std::string& text) {
  const Json json = parse_json(text);
  const JsonFields schedule(json, "the schedule");
  ScheduleJson read;
  read.process_time = schedule.time("process_time");
  std::size_t place = 0;
  int line = 1;
  for (const Json& object : schedule.array("tasks")) {
    const JsonFields fields(object, "a task of the schedule");
    ScheduleRow row;
    row.task = fields.text("task");
    const std::size_t found = find_row(text, place, row.task);
    line += static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(place),
                                        text.begin() + static_cast<std::ptrdiff_t>(found), '\n'));
    place = found;
    row.line = line;
    row.robot = fields.text("robot");
    row.crew = fields.text("crew");
    row.start = fields.time("start");
    row.duration = fields.time("duration");
    row.tried = fields.integer("tried");
    row.accepted = fields.integer("accepted");
    row.result = fields.text("result");
    row.reason = fields.text("reason");
    read.rows.push_back(std::move(row));
  }
  return read;
}

std::vector<ScheduleRow> read_schedule_csv(const std::string& text) {
  CsvReader reader(text);
  std::vector<std::string> fields;
  int line = 0;
  if (!reader.next(fields, line)) throw UnreadableInput("1: expected a line of column names");
  std::map<std::string, std::size_t> columns;
  for (std::size_t i = 0; i < fields.size(); ++i) columns[fields[i]] = i;
  const auto field = [&](const char* name) {
    const auto column = columns.find(name);
    if (column == columns.end() || column->second >= fields.size()) {
      throw UnreadableInput(fmt::format("{}: expected a column '{}'", line, name));
    }
    return fields[column->second];
  };
  std::vector<ScheduleRow> rows;
  while (reader.next(fields, line)) {
    ScheduleRow row;
    row.line = line;
    row.task = field("task");
    row.robot = field("robot");
    row.crew = field("crew");
    row.start = ticks_of(number_in(field("start"), line));
    row.duration = ticks_of(number_in(field("duration"), line));
    row.tried = static_cast<int>(number_in(field("tried"), line));
    row.accepted = static_cast<int>(number_in(field("accepted"), line));
    row.result = field("result");
    row.reason = field("reason");
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace rubicon::verify
