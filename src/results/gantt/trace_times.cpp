#include "src/results/gantt/trace_times.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "src/results/report/exact_json.hpp"

namespace rubicon::gantt {

namespace {

using nlohmann::json;
using report::ExactJson;

schedule::CalendarRules read_calendar(const json& object) {
  schedule::CalendarRules rules;
  rules.name = object.at("name");
  rules.carry_over = object.value("carry_over", false);
  for (const json& entry : object.at("shifts")) {
    schedule::CalendarRules::Shift shift;
    shift.first_day = entry.at("days").at(0);
    shift.last_day = entry.at("days").at(1);
    for (const json& pair : entry.at("minutes")) {
      shift.minutes.emplace_back(pair.at(0).get<int>(), pair.at(1).get<int>());
    }
    rules.shifts.push_back(std::move(shift));
  }
  for (const json& day : object.at("off")) {
    const auto date = schedule::parse_date(day.get<std::string>());
    if (!date) throw std::invalid_argument("expected YYYY-MM-DD in 'off'");
    rules.off.push_back(*date);
  }
  return rules;
}

/// The type of a record; lines that rubicon wrote begin with it, so that what is not wanted need
/// not be read.
std::string type_of(const std::string& line) {
  constexpr std::string_view kBegin = R"({"type":")";
  if (!line.starts_with(kBegin)) return ExactJson::parse(line).at("type").text();
  const std::size_t end = line.find('"', kBegin.size());
  if (end == std::string::npos) throw std::invalid_argument("this is no line of a trace");
  return line.substr(kBegin.size(), end - kBegin.size());
}

Stretch stretch_of(const std::string& type, const ExactJson& record) {
  Stretch stretch;
  stretch.from = record.at("from").ticks();
  stretch.to = record.at("t").ticks();
  if (type == "work") {
    stretch.crew = record.at("crew").text();
    stretch.what = record.at("what").text();
  } else {
    stretch.kind = Stretch::Kind::wait;
    stretch.what = record.at("why").text();
  }
  if (stretch.to < stretch.from) {
    throw std::invalid_argument("this is no line of a trace: it ends before it begins");
  }
  return stretch;
}

}  // namespace

void TraceTimesReader::line(const std::string& text) {
  const std::string type = type_of(text);
  if (has_header_) {
    read_record(type, text);
  } else if (type == "header") {
    read_header(text);
  } else {
    throw std::invalid_argument("this is no trace: its first line does not say so");
  }
}

void TraceTimesReader::read_header(const std::string& text) {
  has_header_ = true;
  try {
    const json header = json::parse(text);
    times_.plan = header.at("plan");
    short_form_ = header.at("form") == "short";
    for (const json& calendar : header.at("calendars")) {
      times_.calendars.push_back(read_calendar(calendar));
    }
    for (const char* list : {"robots", "crews"}) {
      for (const json& resource : header.at(list)) {
        const std::string calendar = resource.at("calendar");
        if (!calendar.empty()) times_.calendar_of[resource.at("name")] = calendar;
      }
    }
    for (const json& task : header.at("tasks")) {
      times_.held[task.at("name")] = task.at("crews").get<std::vector<std::string>>();
    }
  } catch (const json::exception& error) {
    throw std::invalid_argument(fmt::format("this is no header of a trace: {}", error.what()));
  }
}

void TraceTimesReader::read_record(const std::string& type, const std::string& text) {
  if (type != "task_start" && type != "task_end" && type != "work" && type != "pause") return;
  const ExactJson record = ExactJson::parse(text);
  const std::string& task = record.at("task").text();
  if (type == "task_start") {
    open_[task] = {record.at("t").ticks(), 0, !record.at("robot").text().empty(), {}};
  } else if (type == "task_end") {
    const auto run = open_.extract(task);
    const bool happened = record.at("result").text() == "done" || short_form_;
    if (run.empty() || !happened) return;
    run.mapped().end = record.at("t").ticks();
    times_.runs[{task, run.mapped().start}] = run.mapped();
  } else {
    open_[task].stretches.push_back(stretch_of(type, record));
  }
}

}  // namespace rubicon::gantt
