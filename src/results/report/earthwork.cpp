#include "src/results/report/earthwork.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

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

/// Litres for each m3 that a task dug; nothing where no volume was.
std::optional<double> litres_per_cubic_metre(const TaskOutcome& task, double volume) {
  return volume > 0 ? std::optional(task.fuel / volume) : std::nullopt;
}

/// "0.342" or "-".
std::string rate_text(const std::optional<double>& rate) {
  return rate ? fmt::format("{:.3f}", *rate) : "-";
}

std::string production_table(const taskplan::Schedule& schedule) {
  const std::string cost =
      schedule.currency.empty() ? "cost per m3" : schedule.currency + " per m3";
  std::vector<Row> rows = {
      {"digs", "m3", "loads", "m3 a load", "working", "m3 per h", "match factor"}};
  if (schedule.burns_fuel) rows.front().emplace_back("l per m3");
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
    if (schedule.burns_fuel) {
      rows.back().push_back(rate_text(litres_per_cubic_metre(task, tipped)));
    }
    if (schedule.costed) rows.back().push_back(rate_text(cost_per_cubic_metre(task)));
  }
  return columns(rows, {1, 2, 3, 4, 5, 6, 7, 8});
}

bool dug_by_robot(const TaskOutcome& task) {
  return task.motion_dig && task.result == taskplan::TaskResult::done;
}

std::optional<double> cost_per_dug_metre(const TaskOutcome& task) {
  const double volume = cubic_metres(task.motion_dig->dug());
  return volume > 0 ? std::optional(task.cost / volume) : std::nullopt;
}

/// What robots dug, and the parts of their cycles: seconds, on average.
std::string bucket_table(const taskplan::Schedule& schedule) {
  std::vector<Row> rows = {
      {"digs", "m3", "buckets", "m3 a bucket", "loads", "working", "for trucks", "m3 per h"}};
  std::vector<Row> parts = {{"cycles", "mean", "to the cut", "cut", "swing", "dump"}};
  if (schedule.burns_fuel) rows.front().emplace_back("l per m3");
  if (schedule.costed) {
    rows.front().push_back(schedule.currency.empty() ? "cost per m3"
                                                     : schedule.currency + " per m3");
  }
  const auto seconds = [](double value) { return fmt::format("{:.1f} s", value); };
  for (const TaskOutcome& task : schedule.tasks) {
    if (!dug_by_robot(task)) continue;
    const taskplan::MotionDigOutcome& dig = *task.motion_dig;
    const double volume = cubic_metres(dig.dug());
    const bool has_trucks = !dig.trucks.empty() || dig.bodies > 0;
    const std::size_t loads =
        dig.bodies > 0 ? static_cast<std::size_t>(dig.body_loads) : dig.loads.size();
    rows.push_back({task.task, fmt::format("{:.1f}", volume), fmt::format("{}", dig.buckets.size()),
                    fmt::format("{:.2f}", volume / static_cast<double>(dig.buckets.size())),
                    has_trucks ? fmt::format("{}", loads) : "-",
                    time_text(interpreter::seconds_from_ticks(dig.time)),
                    has_trucks ? time_text(interpreter::seconds_from_ticks(dig.waited)) : "-",
                    fmt::format("{:.1f}", dig.per_hour())});
    if (schedule.burns_fuel) {
      rows.back().push_back(rate_text(litres_per_cubic_metre(task, volume)));
    }
    if (schedule.costed) rows.back().push_back(rate_text(cost_per_dug_metre(task)));
    parts.push_back({task.task, seconds(dig.mean_cycle()), seconds(dig.mean_return()),
                     seconds(dig.mean_dig()), seconds(dig.mean_swing()), seconds(dig.mean_dump())});
  }
  return columns(rows, {1, 2, 3, 4, 5, 6, 7, 8, 9}) + "\n" + columns(parts, {1, 2, 3, 4, 5});
}

bool hauled(const TaskOutcome& task) {
  return task.haul && task.result == taskplan::TaskResult::done;
}

/// Means over the loads of a truck with a body, s.
struct RoundTimes {
  double queue = 0, loading = 0, haul = 0, tip = 0;
  double back = 0;  ///< to the queue again, over all loads but the first
};
RoundTimes round_of(const taskplan::HaulOutcome& haul) {
  RoundTimes sum;
  const taskplan::HauledLoad* before = nullptr;
  const auto seconds = [](auto from, auto to) {
    return interpreter::seconds_from_ticks(to - from);
  };
  for (const taskplan::HauledLoad& load : haul.loads) {
    sum.queue += seconds(load.arrived, load.began);
    sum.loading += seconds(load.began, load.loaded);
    sum.haul += seconds(load.loaded, load.at_tip);
    sum.tip += seconds(load.at_tip, load.tipped);
    if (before != nullptr) sum.back += seconds(before->tipped, load.arrived);
    before = &load;
  }
  const auto count = static_cast<double>(haul.loads.size());
  if (count == 0) return sum;
  for (double* each : {&sum.queue, &sum.loading, &sum.haul, &sum.tip}) *each /= count;
  if (count > 1) sum.back /= count - 1;
  return sum;
}

/// All that trucks with bodies hauled, and what dug it.
struct HauledTogether {
  double volume = 0;   ///< m3
  double working = 0;  ///< s, of the truck that took longest
  double cost = 0;
  double fuel = 0;  ///< l
  /// Trucks x loading / (diggers x round without waiting); nothing where no truck made two rounds.
  std::optional<double> match_factor;

  double per_hour() const { return working > 0 ? volume / working * 3600 : 0; }
};
HauledTogether hauled_together(const taskplan::Schedule& schedule) {
  HauledTogether all;
  double loading = 0, round = 0, trucks = 0;
  std::set<std::string> diggers;
  for (const TaskOutcome& task : schedule.tasks) {
    if (dug_by_robot(task) && task.motion_dig->bodies > 0) {
      diggers.insert(task.robot);
      all.cost += task.cost;
      all.fuel += task.fuel;
    }
    if (!hauled(task)) continue;
    all.volume += cubic_metres(task.haul->hauled());
    all.working = std::max(all.working, interpreter::seconds_from_ticks(task.haul->time));
    all.cost += task.cost;
    all.fuel += task.fuel;
    if (task.haul->loads.size() < 2) continue;
    const RoundTimes times = round_of(*task.haul);
    ++trucks;
    loading += times.loading;
    round += times.loading + times.haul + times.tip + times.back;
  }
  if (trucks > 0 && !diggers.empty() && round > 0) {
    all.match_factor = trucks * loading / (static_cast<double>(diggers.size()) * round);
  }
  return all;
}

/// What trucks with bodies hauled, and the parts of their rounds: seconds, on average.
std::string haul_table(const taskplan::Schedule& schedule) {
  std::vector<Row> rows = {{"hauls", "truck", "loads", "m3", "m3 a load", "queue", "loading",
                            "haul", "tip", "back", "m3 per h"}};
  const auto seconds = [](double value) { return fmt::format("{:.1f} s", value); };
  for (const TaskOutcome& task : schedule.tasks) {
    if (!hauled(task)) continue;
    const taskplan::HaulOutcome& haul = *task.haul;
    const double volume = cubic_metres(haul.hauled());
    const auto count = static_cast<double>(haul.loads.size());
    const RoundTimes times = round_of(haul);
    const double hours = interpreter::seconds_from_ticks(haul.time) / 3600;
    rows.push_back({task.task, task.robot, fmt::format("{}", haul.loads.size()),
                    fmt::format("{:.1f}", volume),
                    count > 0 ? fmt::format("{:.2f}", volume / count) : "-", seconds(times.queue),
                    seconds(times.loading), seconds(times.haul), seconds(times.tip),
                    count > 1 ? seconds(times.back) : "-",
                    hours > 0 ? fmt::format("{:.1f}", volume / hours) : "-"});
  }
  std::string text = columns(rows, {2, 3, 4, 5, 6, 7, 8, 9, 10});
  const HauledTogether all = hauled_together(schedule);
  text += fmt::format("together {:.1f} m3 in {}, {:.1f} m3 per h", all.volume,
                      time_text(all.working), all.per_hour());
  if (schedule.costed && all.volume > 0) {
    text += fmt::format(", {:.3f} {} with diggers and trucks", all.cost / all.volume,
                        schedule.currency.empty() ? "cost per m3" : schedule.currency + " per m3");
  }
  if (schedule.burns_fuel && all.volume > 0) {
    text += fmt::format(", {:.3f} l per m3", all.fuel / all.volume);
  }
  if (all.match_factor) text += fmt::format(", match factor {:.2f}", *all.match_factor);
  text += "\n";
  return text;
}

void add_queues(const std::string& task, const std::vector<Queue>& queues,
                hauling::Nanoseconds time, std::vector<Row>& rows) {
  for (const Queue& queue : queues) {
    rows.push_back({fmt::format("{}.{}", task, queue.name),
                    queue.servers == 1 ? queue.by : fmt::format("{} ({})", queue.by, queue.servers),
                    fmt::format("{}", queue.served), time_text(queue.mean_wait()),
                    time_text(static_cast<double>(queue.longest) / kPerSecond),
                    fmt::format("{:.2f}", queue.mean_length(time)),
                    fmt::format("{:.1f} %", 100 * queue.utilisation(time))});
  }
}

std::string queue_table(const taskplan::Schedule& schedule) {
  std::vector<Row> rows = {
      {"queues", "before", "trucks", "mean wait", "longest", "that wait", "busy"}};
  for (const TaskOutcome& task : schedule.tasks) {
    if (dug(task)) add_queues(task.task, task.dig->result.queues, task.dig->result.time, rows);
    if (dug_by_robot(task)) {
      add_queues(task.task, task.motion_dig->queues, task.motion_dig->time, rows);
    }
  }
  return rows.size() > 1 ? columns(rows, {2, 3, 4, 5, 6}) : std::string();
}

}  // namespace

bool keeps_workspace(const taskplan::Schedule& schedule, const TaskOutcome& task) {
  return std::find(schedule.workspaces.begin(), schedule.workspaces.end(), task.robot) !=
         schedule.workspaces.end();
}

std::string workspaces_table(const taskplan::Schedule& schedule) {
  if (schedule.workspaces.empty()) return {};
  std::vector<Row> rows = {{"workspaces", "machine", "stops", "waited"}};
  if (schedule.foresees) {
    for (const char* name : {"ways foreseen to meet", "went round"}) rows.front().push_back(name);
  }
  if (schedule.watches) rows.front().push_back("overlaps");
  for (const TaskOutcome& task : schedule.tasks) {
    if (!keeps_workspace(schedule, task)) continue;
    Row& row = rows.emplace_back();
    row = {task.task, task.robot, fmt::format("{}", task.stops),
           time_text(static_cast<double>(task.waits.machine) / kPerSecond)};
    if (schedule.foresees) {
      for (const int count : {task.foreseen, task.rounds}) row.push_back(fmt::format("{}", count));
    }
    if (schedule.watches) row.push_back(fmt::format("{}", task.overlaps));
  }
  return columns(rows, {2, 3, 4, 5});
}

void write_workspaces(trace::JsonBuilder& json, const taskplan::Schedule& schedule,
                      const TaskOutcome& task) {
  if (!keeps_workspace(schedule, task)) return;
  json.key("workspaces").begin_object().field("stops", task.stops);
  if (schedule.foresees) json.field("foreseen", task.foreseen).field("rounds", task.rounds);
  if (schedule.watches) json.field("overlaps", task.overlaps);
  json.end_object();
}

std::string earthwork_table(const taskplan::Schedule& schedule) {
  const auto any = [&](const auto& holds) {
    return std::any_of(schedule.tasks.begin(), schedule.tasks.end(), holds);
  };
  std::vector<std::string> tables;
  if (any(dug)) tables.push_back(production_table(schedule));
  if (any(dug_by_robot)) tables.push_back(bucket_table(schedule));
  if (any(hauled)) tables.push_back(haul_table(schedule));
  if (tables.empty()) return {};
  tables.push_back(queue_table(schedule));
  if (tables.back().empty()) tables.pop_back();
  std::string text = fmt::format("{}", fmt::join(tables, "\n"));
  const auto by_means = [](const TaskOutcome& task) {
    return (dug(task) && task.dig->operation.uncertain_stages() > 0) ||
           (dug_by_robot(task) && task.motion_dig->uncertain);
  };
  if (!schedule.sample && std::any_of(schedule.tasks.begin(), schedule.tasks.end(), by_means)) {
    text +=
        "by the means of durations that are not certain: with chance queues are longer and "
        "production is less, --sample SEED and studies show it\n";
  }
  return text;
}

namespace {

void write_queue(trace::JsonBuilder& json, const Queue& queue, hauling::Nanoseconds time) {
  json.begin_object().field("stage", queue.name).field("by", queue.by);
  json.field("servers", queue.servers).field("served", queue.served);
  json.field("mean_wait", queue.mean_wait()).key("longest_wait").seconds(queue.longest);
  json.field("mean_length", queue.mean_length(time));
  json.field("utilisation", queue.utilisation(time)).end_object();
}

}  // namespace

void write_dig(trace::JsonBuilder& json, const taskplan::Schedule& schedule,
               const TaskOutcome& task) {
  const hauling::Operation& operation = task.dig->operation;
  const Result& result = task.dig->result;
  json.key("dig").begin_object().field("volume", cubic_metres(operation.volume));
  json.field("tipped", cubic_metres(result.tipped)).field("loads", result.loads);
  json.field("load", cubic_metres(operation.load));
  if (operation.bucket > 0) json.field("passes", result.passes);
  json.key("working").seconds(result.time).field("per_hour", result.per_hour());
  const auto per_volume = cost_per_cubic_metre(task);
  if (schedule.costed && per_volume) json.field("cost_per_m3", *per_volume);
  const auto litres = litres_per_cubic_metre(task, cubic_metres(result.tipped));
  if (schedule.burns_fuel && litres) json.field("fuel_per_m3", *litres);
  json.field("trucks", operation.trucks).field("mean_loading", operation.mean_loading());
  json.field("mean_round", operation.mean_round());
  json.field("match_factor", operation.match_factor()).key("queues").begin_array();
  for (const Queue& queue : result.queues) write_queue(json, queue, result.time);
  json.end_array().end_object();
}

void write_motion_dig(trace::JsonBuilder& json, const taskplan::Schedule& schedule,
                      const TaskOutcome& task) {
  const taskplan::MotionDigOutcome& dig = *task.motion_dig;
  json.key("motion_dig").begin_object().field("earth", dig.earth);
  json.field("volume", cubic_metres(dig.volume)).field("dug", cubic_metres(dig.dug()));
  json.field("buckets", static_cast<std::int64_t>(dig.buckets.size()));
  json.field("bucket", cubic_metres(dig.bucket)).key("working").seconds(dig.time);
  json.field("per_hour", dig.per_hour());
  const auto per_volume = cost_per_dug_metre(task);
  if (schedule.costed && per_volume) json.field("cost_per_m3", *per_volume);
  const auto litres = litres_per_cubic_metre(task, cubic_metres(dig.dug()));
  if (schedule.burns_fuel && litres) json.field("fuel_per_m3", *litres);
  json.key("mean").begin_object().field("cycle", dig.mean_cycle());
  json.field("to_the_cut", dig.mean_return()).field("cut", dig.mean_dig());
  json.field("swing", dig.mean_swing()).field("dump", dig.mean_dump()).end_object();
  if (dig.bodies > 0) {
    json.field("trucks", dig.bodies).field("loads", dig.body_loads);
    json.key("waited").seconds(dig.waited);
  } else if (!dig.trucks.empty()) {
    json.field("trucks", dig.truck_count).field("load", cubic_metres(dig.load));
    json.field("loads", static_cast<std::int64_t>(dig.loads.size()));
    json.key("waited").seconds(dig.waited);
    json.key("queues").begin_array();
    for (const Queue& queue : dig.queues) write_queue(json, queue, dig.time);
    json.end_array();
  }
  json.end_object();
}

void write_haul(trace::JsonBuilder& json, const TaskOutcome& task) {
  const taskplan::HaulOutcome& haul = *task.haul;
  json.key("haul").begin_object();
  json.field("hauled", cubic_metres(haul.hauled())).key("working").seconds(haul.time);
  const RoundTimes times = round_of(haul);
  json.key("mean").begin_object().field("queue", times.queue).field("loading", times.loading);
  json.field("haul", times.haul).field("tip", times.tip).field("back", times.back).end_object();
  json.key("loads").begin_array();
  for (const taskplan::HauledLoad& load : haul.loads) {
    json.begin_object().field("dig", std::string_view(load.dig));
    json.field("volume", cubic_metres(load.volume)).key("arrived").seconds(load.arrived);
    json.key("began").seconds(load.began).key("loaded").seconds(load.loaded);
    json.key("at_tip").seconds(load.at_tip).key("tipped").seconds(load.tipped).end_object();
  }
  json.end_array().end_object();
}

std::string hauling_json(const taskplan::Schedule& schedule) {
  if (std::none_of(schedule.tasks.begin(), schedule.tasks.end(), hauled)) return {};
  const HauledTogether all = hauled_together(schedule);
  trace::JsonBuilder json;
  json.begin_object().field("hauled", all.volume).field("working", all.working);
  json.field("per_hour", all.per_hour());
  if (schedule.costed && all.volume > 0) json.field("cost_per_m3", all.cost / all.volume);
  if (schedule.burns_fuel && all.volume > 0) json.field("fuel_per_m3", all.fuel / all.volume);
  if (all.match_factor) json.field("match_factor", *all.match_factor);
  return json.end_object().take();
}

std::string loads_csv(const interpreter::PlanModel& plan, const taskplan::Schedule& schedule) {
  std::string text;
  const auto seconds = [](hauling::Nanoseconds time) {
    return static_cast<double>(time) / kPerSecond;
  };
  const auto add = [&](const TaskOutcome& task, const std::string& by, const hauling::Load& load) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{:.3f},{:.3f},{:.3f},{:.3f},{:.6f}\r\n",
                   csv_field(task.task), load.number, load.truck + 1, csv_field(by),
                   seconds(load.arrived), seconds(load.began), seconds(load.loaded),
                   seconds(load.tipped), cubic_metres(load.volume));
  };
  for (const TaskOutcome& task : schedule.tasks) {
    if (hauled(task)) {
      if (text.empty()) text = "task,load,truck,by,arrived,began,loaded,tipped,volume\r\n";
      std::int64_t number = 0;
      for (const taskplan::HauledLoad& load : task.haul->loads) {
        add(task, load.dig,
            {++number, 0, -1, load.volume, load.arrived, load.began, load.loaded, load.tipped});
      }
      continue;
    }
    const bool has_loads = dug_by_robot(task) && !task.motion_dig->trucks.empty();
    if (!dug(task) && !has_loads) continue;
    if (text.empty()) text = "task,load,truck,by,arrived,began,loaded,tipped,volume\r\n";
    if (has_loads) {
      for (const hauling::Load& load : task.motion_dig->loads) add(task, task.robot, load);
      continue;
    }
    const hauling::Operation& operation = task.dig->operation;
    std::optional<hauling::Draws> draws;
    if (plan.sample) draws = {plan.sample->seed, plan.sample->run, task.task};
    simulate(operation, draws, [&](const hauling::Load& load) {
      add(task,
          load.diggers < 0 ? "" : operation.diggers[static_cast<std::size_t>(load.diggers)].name,
          load);
    });
  }
  return text;
}

}  // namespace rubicon::report
