#include "src/results/report/layout_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "src/results/report/columns.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::report {

namespace {

const char* rows_of(const layout::Layout& each) { return each.choice.along_y ? "y" : "x"; }

double to_millimetre(double value) { return std::round(value * 1000) / 1000; }

void write_layout(trace::JsonBuilder& json, const layout::Layout& each) {
  json.begin_object().field("rows_along", rows_of(each));
  json.field("lanes", name_of(each.choice.ways)).field("aisles", each.aisles);
  json.field("cross_aisles", each.choice.cross_aisles);
  json.field("shift", to_millimetre(each.choice.shift));
  json.field("mean_trip", to_millimetre(each.mean_trip));
  json.field("trips_per_hour", to_millimetre(each.trips_per_hour));
  json.field("lane_metres", to_millimetre(each.lane_metres));
  json.key("modules").begin_array();
  for (const layout::Module& module : each.modules) {
    json.begin_object().field("x0", to_millimetre(module.box.x0));
    json.field("y0", to_millimetre(module.box.y0)).field("x1", to_millimetre(module.box.x1));
    json.field("y1", to_millimetre(module.box.y1)).field("node", module.stop).end_object();
  }
  json.end_array().key("nodes").begin_array();
  for (const lanes::Node& node : each.network.nodes) {
    json.begin_object().field("name", node.name).field("x", to_millimetre(node.x));
    json.field("y", to_millimetre(node.y)).end_object();
  }
  json.end_array().key("lane_ends").begin_array();
  for (const lanes::Lane& lane : each.network.lanes) {
    json.begin_array().value(lane.from).value(lane.to).end_array();
  }
  json.end_array().end_object();
}

}  // namespace

std::string layout_table(const std::string& plan, const layout::BestLayouts& found, int chosen) {
  std::string text =
      fmt::format("{}: {} layouts tried, {} of them hold modules that every gate reaches\n\n", plan,
                  found.tried, found.worked);
  if (found.best.empty()) return text;
  std::vector<TableRow> rows = {{"", "modules", "mean trip", "trips per h at most", "rows along",
                                 "lanes", "aisles", "cross aisles", "shift", "lane length"}};
  for (std::size_t i = 0; i < found.best.size(); ++i) {
    const layout::Layout& each = found.best[i];
    const bool is_chosen = static_cast<int>(i) + 1 == chosen;
    rows.push_back(
        {fmt::format("{}{}", i + 1, is_chosen ? " *" : ""), fmt::format("{}", each.modules.size()),
         fmt::format("{:.1f} s", each.mean_trip), fmt::format("{:.0f}", each.trips_per_hour),
         rows_of(each), std::string(name_of(each.choice.ways)), fmt::format("{}", each.aisles),
         fmt::format("{}", each.choice.cross_aisles), fmt::format("{:.2f} m", each.choice.shift),
         fmt::format("{:.0f} m", each.lane_metres)});
  }
  text += columns(rows, {1, 2, 3, 6, 7, 8, 9});
  return text;
}

std::string layout_csv(const layout::BestLayouts& found) {
  std::string text =
      "layout,modules,mean_trip,trips_per_hour,rows_along,lanes,aisles,cross_aisles,shift,"
      "lane_metres\n";
  for (std::size_t i = 0; i < found.best.size(); ++i) {
    const layout::Layout& each = found.best[i];
    text +=
        fmt::format("{},{},{:.3f},{:.3f},{},{},{},{},{:.3f},{:.3f}\n", i + 1, each.modules.size(),
                    each.mean_trip, each.trips_per_hour, rows_of(each), name_of(each.choice.ways),
                    each.aisles, each.choice.cross_aisles, each.choice.shift, each.lane_metres);
  }
  return text;
}

std::string layout_json(const std::string& plan, const layout::BestLayouts& found) {
  trace::JsonBuilder json;
  json.begin_object().field("plan", plan).field("tried", found.tried);
  json.field("worked", found.worked).key("layouts").begin_array();
  for (const layout::Layout& each : found.best) write_layout(json, each);
  json.end_array().end_object();
  return json.take() + '\n';
}

}  // namespace rubicon::report
