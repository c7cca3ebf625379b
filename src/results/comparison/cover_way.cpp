#include "src/results/comparison/cover_way.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "src/results/report/columns.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::comparison {

namespace {

using interpreter::CoverSpec;
using interpreter::PlanModel;
using interpreter::TaskSpec;

const interpreter::AreaSpec& area_of(const PlanModel& plan, const TaskSpec& task) {
  return plan.areas[static_cast<std::size_t>(task.cover->area)];
}

/// Of the way: a key for programs, words for people, the value.
struct CoverFigure {
  const char* key;
  const char* words;
  double value;
  int digits;  ///< after the point, for people
};

std::vector<CoverFigure> figures_of(const CoverSpec& cover) {
  if (cover.holes > 0) {
    return {{"holes", "holes", static_cast<double>(cover.holes), 0},
            {"left_out", "holes left out", static_cast<double>(cover.holes_left_out), 0},
            {"length", "way, m", cover.length, 1}};
  }
  const coverage::Measures& found = cover.measures;
  const coverage::CoverageWay& way = *cover.way;
  double arcs = static_cast<double>(cover.turns);
  return {{"covered", "of what the tool can reach, %", 100 * found.coverage, 2},
          {"reachable", "the tool can reach, m2", found.reachable_area, 1},
          {"floor", "floor, m2", found.floor_area, 1},
          {"length", "way, m", cover.length, 1},
          {"bound", "no way that covers it is shorter, m", found.lower_bound, 1},
          {"working", "at work, m", found.working_length, 1},
          {"turns", way.arcs ? "arcs" : "turns", arcs, 0},
          {"inside_holes", "inside holes and their clearance, m", found.inside_holes, 2},
          {"outside", "outside the floor, m", found.outside, 2},
          {"direction", "direction of lines, degrees from x", way.direction_deg, 1},
          {"cells", "cells", static_cast<double>(way.cells.size()), 0},
          {"lines", "lines and passes", static_cast<double>(way.lines.size()), 0},
          {"cut_off", "lines that no way leads to", static_cast<double>(way.cut_off), 0}};
}

}  // namespace

std::string cover_way_text(const PlanModel& plan, const TaskSpec& task) {
  std::string text =
      fmt::format("{}: {} covers {}\n\n", plan.name, task.name, area_of(plan, task).name);
  std::vector<report::TableRow> rows = {{"way", "value"}};
  for (const CoverFigure& each : figures_of(*task.cover)) {
    rows.push_back({each.words, fmt::format("{:.{}f}", each.value, each.digits)});
  }
  return text + report::columns(rows, {1});
}

std::string cover_way_csv(const PlanModel& plan, const TaskSpec& task) {
  std::string heads = "task,area";
  std::string values = fmt::format("{},{}", task.name, area_of(plan, task).name);
  for (const CoverFigure& each : figures_of(*task.cover)) {
    heads += fmt::format(",{}", each.key);
    values += fmt::format(",{}", each.value);
  }
  return heads + "\n" + values + "\n";
}

std::string cover_way_json(const PlanModel& plan, const TaskSpec& task) {
  trace::JsonBuilder json;
  json.begin_object().field("plan", plan.name).field("task", task.name);
  json.field("area", area_of(plan, task).name);
  for (const CoverFigure& each : figures_of(*task.cover)) json.field(each.key, each.value);
  json.end_object();
  return json.take() + "\n";
}

}  // namespace rubicon::comparison
