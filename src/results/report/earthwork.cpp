#include "src/results/report/earthwork.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "src/results/report/columns.hpp"

namespace rubicon::report {

namespace {

using hauling::kPerCubicMetre;
using hauling::kPerSecond;
using hauling::Queue;
using hauling::Result;
using taskplan::TaskOutcome;
using Row = TableRow;

bool dug(const TaskOutcome& task) { return task.dig && task.result == taskplan::TaskResult::done; }

double cubic_metres(hauling::CubicMillimetres volume) {
  return static_cast<double>(volume) / kPerCubicMetre;
}

/// As 1:15:30 from an hour on, else as 12:30.5, minutes and seconds.
std::string time_text(double seconds) {
  const auto tenths = static_cast<std::int64_t>(std::llround(seconds * 10));
  std::int64_t whole = tenths / 10;
  const auto tenth = tenths % 10;
  if (whole >= 3600) {
    whole = std::llround(seconds);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  }
  return fmt::format("{}:{:02}.{}", whole / 60, whole % 60, tenth);
}

std::optional<double> cost_per_cubic_metre(const TaskOutcome& task) {
  const double volume = cubic_metres(task.dig->result.tipped);
  return volume > 0 ? std::optional(task.cost / volume) : std::nullopt;
}

std::string production_table(const taskplan::Schedule& schedule) {
  const std::string cost =
      schedule.currency.empty() ? "cost per m3" : schedule.currency + " per m3";
  std::vector<Row> rows = {
      {"digs", "m3", "loads", "m3 a load", "working", "m3 per h", "match factor"}};
  if (schedule.costed) rows.front().push_back(cost);
  for (const TaskOutcome& task : schedule.tasks) {
    if (!dug(task)) continue;
    const hauling::Operation& operation = task.dig->operation;
    const Result& result = task.dig->result;
    const double tipped = cubic_metres(result.tipped);
    rows.push_back({task.task,
                    result.is_complete
                        ? fmt::format("{:.1f}", tipped)
                        : fmt::format("{:.1f} of {:.1f}", tipped, cubic_metres(operation.volume)),
                    fmt::format("{}", result.loads),
                    fmt::format("{:.2f}", cubic_metres(operation.load)),
                    time_text(static_cast<double>(result.time) / kPerSecond),
                    fmt::format("{:.1f}", result.per_hour()),
                    fmt::format("{:.2f}", operation.match_factor())});
    const auto per_volume = cost_per_cubic_metre(task);
    if (schedule.costed) {
      rows.back().push_back(per_volume ? fmt::format("{:.3f}", *per_volume) : "-");
    }
  }
  return columns(rows, {1, 2, 3, 4, 5, 6, 7});
}

std::string queue_table(const taskplan::Schedule& schedule) {
  std::vector<Row> rows = {
      {"queues", "before", "trucks", "mean wait", "longest", "that wait", "busy"}};
  for (const TaskOutcome& task : schedule.tasks) {
    if (!dug(task)) continue;
    const Result& result = task.dig->result;
    for (const Queue& queue : result.queues) {
      rows.push_back(
          {fmt::format("{}.{}", task.task, queue.name),
           queue.servers == 1 ? queue.by : fmt::format("{} ({})", queue.by, queue.servers),
           fmt::format("{}", queue.served), time_text(queue.mean_wait()),
           time_text(static_cast<double>(queue.longest) / kPerSecond),
           fmt::format("{:.2f}", queue.mean_length(result.time)),
           fmt::format("{:.1f} %", 100 * queue.utilisation(result.time))});
    }
  }
  return columns(rows, {2, 3, 4, 5, 6});
}

}  // namespace

std::string earthwork_table(const taskplan::Schedule& schedule) {
  if (std::none_of(schedule.tasks.begin(), schedule.tasks.end(), dug)) return {};
  std::string text = production_table(schedule) + "\n" + queue_table(schedule);
  const auto by_means = [](const TaskOutcome& task) {
    return dug(task) && task.dig->operation.uncertain_stages() > 0;
  };
  if (!schedule.sample && std::any_of(schedule.tasks.begin(), schedule.tasks.end(), by_means)) {
    text +=
        "by the means of durations that are not certain: with chance queues are longer and "
        "production is less, --sample SEED and studies show it\n";
  }
  return text;
}

void write_dig(trace::JsonBuilder& json, const TaskOutcome& task, bool is_costed) {
  const hauling::Operation& operation = task.dig->operation;
  const Result& result = task.dig->result;
  json.key("dig").begin_object().field("volume", cubic_metres(operation.volume));
  json.field("tipped", cubic_metres(result.tipped)).field("loads", result.loads);
  json.field("load", cubic_metres(operation.load));
  if (operation.bucket > 0) json.field("passes", result.passes);
  json.key("working").seconds(result.time).field("per_hour", result.per_hour());
  const auto per_volume = cost_per_cubic_metre(task);
  if (is_costed && per_volume) json.field("cost_per_m3", *per_volume);
  json.field("trucks", operation.trucks).field("mean_loading", operation.mean_loading());
  json.field("mean_round", operation.mean_round());
  json.field("match_factor", operation.match_factor()).key("queues").begin_array();
  for (const Queue& queue : result.queues) {
    json.begin_object().field("stage", queue.name).field("by", queue.by);
    json.field("servers", queue.servers).field("served", queue.served);
    json.field("mean_wait", queue.mean_wait()).key("longest_wait").seconds(queue.longest);
    json.field("mean_length", queue.mean_length(result.time));
    json.field("utilisation", queue.utilisation(result.time)).end_object();
  }
  json.end_array().end_object();
}

std::string loads_csv(const interpreter::PlanModel& plan, const taskplan::Schedule& schedule) {
  std::string text;
  const auto seconds = [](hauling::Nanoseconds time) {
    return static_cast<double>(time) / kPerSecond;
  };
  for (const TaskOutcome& task : schedule.tasks) {
    if (!dug(task)) continue;
    if (text.empty()) text = "task,load,truck,by,arrived,began,loaded,tipped,volume\r\n";
    const hauling::Operation& operation = task.dig->operation;
    std::optional<hauling::Draws> draws;
    if (plan.sample) draws = {plan.sample->seed, plan.sample->run, task.task};
    simulate(operation, draws, [&](const hauling::Load& load) {
      const std::string by =
          load.diggers < 0 ? "" : operation.diggers[static_cast<std::size_t>(load.diggers)].name;
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{:.3f},{:.3f},{:.3f},{:.3f},{:.6f}\r\n",
                     csv_field(task.task), load.number, load.truck + 1, csv_field(by),
                     seconds(load.arrived), seconds(load.began), seconds(load.loaded),
                     seconds(load.tipped), cubic_metres(load.volume));
    });
  }
  return text;
}

}  // namespace rubicon::report
