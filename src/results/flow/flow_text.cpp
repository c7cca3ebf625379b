#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/results/flow/material_flow.hpp"
#include "src/results/report/columns.hpp"
#include "src/results/report/schedule_text.hpp"
#include "src/simulation/schedule/time_text.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::flow {

namespace {

using schedule::clock_text;

bool was_moved(const ComponentFlow& component) { return component.lifts > 0 || component.removed; }

std::string place_text(const std::string& storage) { return storage.empty() ? "-" : storage; }

std::string end_text(const ComponentFlow& component) {
  return component.removed ? "removed" : place_text(component.to);
}

std::string percent_text(Ticks part, Ticks whole) {
  if (whole <= 0) return "-";
  return fmt::format("{:.1f} %", 100 * static_cast<double>(part) / static_cast<double>(whole));
}

std::string components_table(const MaterialFlow& flow) {
  std::vector<report::TableRow> rows = {
      {"component", "from", "to", "lifts", "waited", "carried", "distance", "refused"}};
  ComponentFlow sum;
  for (const ComponentFlow& each : flow.components) {
    if (!was_moved(each)) continue;
    rows.push_back({each.name, place_text(each.from), end_text(each), std::to_string(each.lifts),
                    clock_text(each.waiting), clock_text(each.carried),
                    fmt::format("{:.1f} m", each.distance), std::to_string(each.refused)});
    sum.lifts += each.lifts;
    sum.carried += each.carried;
    sum.distance += each.distance;
    sum.refused += each.refused;
  }
  const std::size_t moved = rows.size() - 1;
  if (moved == 0) return "Nothing was moved.\n";
  rows.push_back({"together", "", "", std::to_string(sum.lifts), "", clock_text(sum.carried),
                  fmt::format("{:.1f} m", sum.distance), std::to_string(sum.refused)});
  return report::columns(rows, {3, 4, 5, 6, 7});
}

std::string storages_table(const MaterialFlow& flow) {
  std::vector<report::TableRow> rows = {
      {"storage", "at start", "in", "out", "at end", "most", "when", "mean stay"}};
  for (const StorageFlow& each : flow.storages) {
    rows.push_back({each.name, std::to_string(each.stock.front().count), std::to_string(each.in),
                    std::to_string(each.out), std::to_string(each.stock.back().count),
                    std::to_string(each.most.count), clock_text(each.most.time),
                    each.mean_stay ? clock_text(*each.mean_stay) : "-"});
  }
  return report::columns(rows, {1, 2, 3, 4, 5, 6, 7});
}

std::string vehicles_table(const MaterialFlow& flow) {
  std::vector<report::TableRow> rows = {
      {"vehicle", "tasks", "held", "of the time", "moved", "waits", "waited", "distance"}};
  for (const VehicleFlow& each : flow.lanes.vehicles) {
    rows.push_back({each.name, std::to_string(each.tasks), clock_text(each.held),
                    percent_text(each.held, flow.end), clock_text(each.moving),
                    std::to_string(each.waits), clock_text(each.waited),
                    fmt::format("{:.1f} m", each.distance)});
  }
  return report::columns(rows, {1, 2, 3, 4, 5, 6, 7});
}

std::string nodes_table(const MaterialFlow& flow) {
  std::vector<report::TableRow> rows = {{"node", "waits", "waited", "longest", "at most"}};
  for (const NodeWaits& each : flow.lanes.nodes) {
    rows.push_back({each.network + "." + each.node, std::to_string(each.waits),
                    clock_text(each.waited), clock_text(each.longest), std::to_string(each.most)});
  }
  if (rows.size() == 1) return "No vehicle waited for another machine.\n";
  std::string text = report::columns(rows, {1, 2, 3, 4});
  for (const NetworkQueue& queue : flow.lanes.queues) {
    const auto most = std::max_element(
        queue.lengths.begin(), queue.lengths.end(),
        [](const QueueLength& a, const QueueLength& b) { return a.count < b.count; });
    text += fmt::format("At most {} waited at the same time on {}, from {} on.\n", most->count,
                        queue.network, clock_text(most->time));
  }
  return text;
}

void write_lanes(trace::JsonBuilder& json, const LaneFlow& lanes) {
  json.key("lanes").begin_object().key("vehicles").begin_array();
  for (const VehicleFlow& each : lanes.vehicles) {
    json.begin_object().field("name", each.name).field("fleet", each.fleet);
    json.field("tasks", each.tasks).key("held").seconds(each.held);
    json.key("moving").seconds(each.moving).field("waits", each.waits);
    json.key("waited").seconds(each.waited);
    json.field("distance", std::round(each.distance * 1e4) / 1e4).end_object();
  }
  json.end_array().key("nodes").begin_array();
  for (const NodeWaits& each : lanes.nodes) {
    json.begin_object().field("network", each.network).field("node", each.node);
    json.field("waits", each.waits).key("waited").seconds(each.waited);
    json.key("longest").seconds(each.longest).field("most", each.most).end_object();
  }
  json.end_array().key("queues").begin_array();
  for (const NetworkQueue& each : lanes.queues) {
    json.begin_object().field("network", each.network).key("lengths").begin_array();
    for (const QueueLength& length : each.lengths) {
      json.begin_object().key("t").seconds(length.time).field("count", length.count).end_object();
    }
    json.end_array().end_object();
  }
  json.end_array().end_object();
}

}  // namespace

std::string flow_text(const MaterialFlow& flow) {
  std::string text = fmt::format("{}: the flow of material\n\n", flow.plan);
  // Vehicles may drive with nothing to carry.
  if (!flow.components.empty() || flow.lanes.vehicles.empty()) text += components_table(flow);
  const auto still = std::count_if(flow.components.begin(), flow.components.end(),
                                   [](const ComponentFlow& each) { return !was_moved(each); });
  if (still > 0)
    text += fmt::format("{} more {} never moved.\n", still, still == 1 ? "was" : "were");
  if (!flow.storages.empty()) text += '\n' + storages_table(flow);
  if (!flow.lanes.vehicles.empty()) {
    if (!flow.components.empty() || !flow.storages.empty()) text += '\n';
    text += vehicles_table(flow) + '\n' + nodes_table(flow);
  }
  return text;
}

std::string flow_csv(const MaterialFlow& flow) {
  std::string text = "component,mass,from,to,lifts,waited,carried,distance,refused\n";
  for (const ComponentFlow& each : flow.components) {
    text += fmt::format("{},{},{},{},{},{},{},{:.3f},{}\n", report::csv_field(each.name), each.mass,
                        report::csv_field(each.from),
                        each.removed ? "removed" : report::csv_field(each.to), each.lifts,
                        report::seconds_text(each.waiting), report::seconds_text(each.carried),
                        each.distance, each.refused);
  }
  return text;
}

std::string flow_json(const MaterialFlow& flow) {
  trace::JsonBuilder json;
  json.begin_object().field("plan", flow.plan).key("end").seconds(flow.end);
  json.key("components").begin_array();
  for (const ComponentFlow& each : flow.components) {
    json.begin_object().field("name", each.name).field("mass", each.mass);
    json.field("from", each.from).field("to", each.to).field("removed", each.removed);
    json.field("lifts", each.lifts).key("waited").seconds(each.waiting);
    json.key("carried").seconds(each.carried);
    // Rounded to 0.1 mm: the way is measured along chords.
    json.field("distance", std::round(each.distance * 1e4) / 1e4);
    json.field("refused", each.refused).end_object();
  }
  json.end_array().key("storages").begin_array();
  for (const StorageFlow& each : flow.storages) {
    json.begin_object().field("name", each.name).field("in", each.in).field("out", each.out);
    json.key("mean_stay");
    if (each.mean_stay) {
      json.seconds(*each.mean_stay);
    } else {
      json.null();
    }
    json.key("stock").begin_array();
    for (const Stock& stock : each.stock) {
      json.begin_object().key("t").seconds(stock.time).field("count", stock.count);
      json.field("mass", stock.mass).end_object();
    }
    json.end_array().end_object();
  }
  json.end_array();
  if (!flow.lanes.vehicles.empty()) write_lanes(json, flow.lanes);
  json.end_object();
  return json.take() + '\n';
}

}  // namespace rubicon::flow
