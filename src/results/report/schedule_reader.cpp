#include "src/results/report/schedule_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "src/results/report/exact_json.hpp"
#include "src/results/report/schedule_text.hpp"

namespace rubicon::report {

namespace {

using taskplan::CriticalTask;
using taskplan::ResourceUse;
using taskplan::Schedule;
using taskplan::TaskOutcome;
using taskplan::TaskResult;

/// More people or money than this no run writes (rates are at most 1e12 per hour).
constexpr double kLargestAmount = 1e24;

double amount(const ExactJson& value) {
  const double number = value.number();
  if (!(std::fabs(number) <= kLargestAmount)) {
    throw std::invalid_argument(fmt::format("expected a smaller number than {}", number));
  }
  return number;
}

/// Names of crews hold no commas.
std::vector<std::string> split_names(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t comma = std::min(text.find(", ", from), text.size());
    names.push_back(text.substr(from, comma - from));
    from = comma + 2;
  }
  return names;
}

TaskResult read_result(const std::string& text) {
  for (const TaskResult result :
       {TaskResult::done, TaskResult::ended_short, TaskResult::rejected, TaskResult::not_reached}) {
    if (text == name_of(result)) return result;
  }
  throw std::invalid_argument(
      fmt::format("expected done, short, rejected or not reached as 'result', found '{}'", text));
}

interpreter::Attributes read_attributes(const ExactJson& json) {
  interpreter::Attributes attributes;
  if (!json.has("attributes")) return attributes;
  const ExactJson& texts = json.at("attributes");
  for (std::size_t i = 0; i < texts.names().size(); ++i) {
    attributes.push_back({texts.names()[i], texts.member(i).text()});
  }
  return attributes;
}

TaskOutcome read_task(const ExactJson& json) {
  TaskOutcome task;
  task.task = json.at("task").text();
  task.robot = json.at("robot").text();
  task.crews = split_names(json.at("crew").text());
  task.parking = json.has("parking") && json.at("parking").truth();
  task.start = json.at("start").ticks();
  task.duration = json.at("duration").ticks();
  task.motion_time = json.at("motion").ticks();
  task.work_time = json.at("work").ticks();
  const ExactJson& waits = json.at("waited");
  task.waits = {waits.at("predecessor").ticks(), waits.at("resource").ticks(),
                waits.at("machine").ticks(), waits.at("shift").ticks()};
  if (waits.has("repair")) task.waits.repair = waits.at("repair").ticks();
  if (json.has("thinking")) task.thinking = json.at("thinking").ticks();
  if (json.has("cost")) task.cost = amount(json.at("cost"));
  if (json.has("fuel")) task.fuel = amount(json.at("fuel"));
  task.tried = json.at("tried").integer();
  task.accepted = json.at("accepted").integer();
  task.result = read_result(json.at("result").text());
  task.reason = json.at("reason").text();
  if (json.has("component")) task.component = json.at("component").text();
  task.attributes = read_attributes(json);
  if (json.has("lift")) {
    const ExactJson& lift = json.at("lift");
    task.lift = taskplan::LiftOutcome{lift.at("from").ticks(), lift.at("to").ticks(),
                                      lift.at("own").ticks(), lift.at("overtime").ticks(),
                                      lift.at("why").text()};
  }
  if (json.has("due")) task.due = json.at("due").ticks();
  if (json.has("baseline")) {
    const ExactJson& baseline = json.at("baseline");
    task.baseline =
        interpreter::Baseline{baseline.at("start").ticks(), baseline.at("finish").ticks()};
  }
  if (json.has("float")) {
    const ExactJson& floats = json.at("float");
    task.floats =
        schedule::TaskFloat{floats.at("latest_start").ticks(), floats.at("latest_finish").ticks(),
                            floats.at("total").ticks(), floats.at("free").ticks()};
  }
  if (json.has("support")) {
    for (const ExactJson& each : json.at("support").elements()) task.support.push_back(each.text());
  }
  if (json.has("missed")) {
    for (const ExactJson& each : json.at("missed").elements()) task.missed.push_back(each.text());
  }
  if (json.has("choice")) task.choice = json.at("choice").text();
  if (task.start < 0 || task.duration < 0) {
    throw std::invalid_argument(fmt::format("expected times from 0 on of task '{}'", task.task));
  }
  return task;
}

ResourceUse read_use(const ExactJson& json) {
  ResourceUse use;
  use.name = json.at("name").text();
  const std::string& kind = json.at("kind").text();
  if (kind != "robot" && kind != "crew") {
    throw std::invalid_argument(fmt::format("expected robot or crew as 'kind', found '{}'", kind));
  }
  use.robot = kind == "robot";
  if (!use.robot) use.size = amount(json.at("size"));
  use.tasks = json.at("tasks").integer();
  use.held = json.at("held").ticks();
  use.busy = json.at("busy").ticks();
  use.shift_time = json.at("shifts").ticks();
  if (json.has("cost_per_hour")) use.rate = amount(json.at("cost_per_hour"));
  if (json.has("cost")) use.cost = amount(json.at("cost"));
  if (json.has("fuel")) use.fuel = amount(json.at("fuel"));
  return use;
}

CriticalTask read_critical(const ExactJson& json) {
  return {json.at("task").text(), json.at("work_counts").truth(), json.at("text").text()};
}

}  // namespace

Schedule schedule_from_json(std::string_view text) {
  const ExactJson json = ExactJson::parse(text);
  Schedule schedule;
  for (const ExactJson& task : json.at("tasks").elements()) {
    schedule.tasks.push_back(read_task(task));
    // A robot asked out of the way that could not go is no task of the plan that failed.
    schedule.feasible &=
        schedule.tasks.back().parking || schedule.tasks.back().result == TaskResult::done;
  }
  schedule.process_time = json.at("process_time").ticks();
  if (json.has("start_at")) {
    schedule.start_at = start_from_text(json.at("start_at").text());
  }
  schedule.costed = json.has("currency");
  if (schedule.costed) {
    schedule.currency = json.at("currency").text();
    schedule.cost = amount(json.at("cost"));
    schedule.has_kinds = json.has("cost_by_kind");
  }
  if (schedule.has_kinds) {
    schedule.pays_fuel = json.at("cost_by_kind").has(name_of(taskplan::CostKind::fuel));
    for (const taskplan::CostKind kind : told_kinds(schedule)) {
      schedule.cost_by_kind[static_cast<std::size_t>(kind)] =
          amount(json.at("cost_by_kind").at(name_of(kind)));
    }
  }
  schedule.burns_fuel = json.has("fuel");
  if (schedule.burns_fuel) schedule.fuel = amount(json.at("fuel"));
  for (const ExactJson& use : json.at("resources").elements()) {
    schedule.resources.push_back(read_use(use));
  }
  for (const ExactJson& task : json.at("critical").elements()) {
    schedule.critical.push_back(read_critical(task));
  }
  if (json.has("uncertain")) schedule.uncertain = json.at("uncertain").integer();
  if (json.has("sample")) {
    const ExactJson& sample = json.at("sample");
    schedule.sample = {static_cast<std::uint64_t>(sample.at("seed").integer()),
                       static_cast<std::uint64_t>(sample.at("run").integer())};
  }
  if (json.has("timetables")) {
    for (const ExactJson& each : json.at("timetables").elements()) {
      schedule.timetables.push_back({each.at("name").text(), each.at("stops").integer(),
                                     each.at("late").ticks(), each.at("stands_before").text()});
    }
  }
  schedule.loses_days = json.has("lost_days");
  if (schedule.loses_days) {
    for (const ExactJson& each : json.at("lost_days").elements()) {
      taskplan::LostDaysOutcome& lost = schedule.lost_days.emplace_back();
      lost.calendar = each.at("calendar").text();
      lost.working_days = each.at("working_days").integer();
      for (const ExactJson& date : each.at("dates").elements()) lost.dates.push_back(date.text());
    }
  }
  schedule.breaks_down = json.has("breakdowns");
  if (schedule.breaks_down) {
    for (const ExactJson& each : json.at("breakdowns").elements()) {
      schedule.breakdowns.push_back({each.at("robot").text(), each.at("during").text(),
                                     each.at("worked").ticks(), each.at("repair").ticks(),
                                     each.at("from").ticks(), each.at("to").ticks()});
    }
  }
  if (json.has("components")) {
    for (const ExactJson& component : json.at("components").elements()) {
      schedule.components.push_back({component.at("component").text(), read_attributes(component)});
    }
  }
  return schedule;
}

}  // namespace rubicon::report
