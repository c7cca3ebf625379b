#include "src/simulation/trace/cover_header.hpp"

#include <vector>

namespace rubicon::trace {

namespace {

/// x and y in turn, m.
void write_places(JsonBuilder& json, const std::vector<coverage::Place>& places) {
  json.begin_array();
  for (const coverage::Place& p : places) json.value(p.x).value(p.y);
  json.end_array();
}

void write_floor(JsonBuilder& json, const coverage::FloorDescription& floor) {
  json.key("floor").begin_object();
  write_places(json.key("outline"), floor.outline);
  json.key("shafts").begin_array();
  for (const coverage::ShaftDescription& shaft : floor.shafts) write_places(json, shaft.corners);
  json.end_array().key("columns").begin_array();
  for (const coverage::ColumnDescription& column : floor.columns) {
    json.begin_array().value(column.centre.x).value(column.centre.y).value(column.size);
    json.value(column.round).end_array();
  }
  json.end_array().end_object();
}

void write_hypergraph(JsonBuilder& json, const coverage::Hypergraph& graph) {
  std::vector<coverage::Place> nodes;
  for (const coverage::Point& p : graph.nodes) nodes.push_back(coverage::metres(p));
  write_places(json.key("nodes"), nodes);
  json.key("pieces").begin_array();
  for (const coverage::BeamPiece& piece : graph.pieces) {
    json.begin_array().value(piece.from).value(piece.to).value(piece.is_edge);
    json.value(!piece.columns.empty()).end_array();
  }
  json.end_array();
}

void write_steps(JsonBuilder& json, const coverage::CoverageWay& way) {
  json.key("steps").begin_object().field("direction", way.direction_deg);
  write_hypergraph(json, way.hypergraph);
  json.key("cells").begin_array();
  for (const coverage::CoverageCell& cell : way.cells) write_places(json, cell.outline);
  json.end_array().key("doors").begin_array();
  for (const coverage::CoverageDoor& door : way.doors) {
    json.begin_array().value(door.a).value(door.b);
    json.value(door.from.x).value(door.from.y).value(door.to.x).value(door.to.y);
    json.value(!door.columns.empty()).end_array();
  }
  json.end_array().key("order").begin_array();
  for (const int cell : way.order) json.value(cell);
  json.end_array().key("lines").begin_array();
  for (const coverage::CoverageLine& line : way.lines) {
    json.begin_object().field("cell", line.cell).field("pass", line.is_pass);
    write_places(json.key("points"), line.points);
    json.end_object();
  }
  json.end_array().end_object();
}

}  // namespace

void write_cover(JsonBuilder& json, const interpreter::PlanModel& plan,
                 const interpreter::TaskSpec& task) {
  const interpreter::CoverSpec& cover = *task.cover;
  const interpreter::AreaSpec& area = plan.areas[static_cast<std::size_t>(cover.area)];
  json.key("cover").begin_object();
  json.field("area", area.name);
  json.key("pose").pose(area.X_WA);
  if (cover.holes > 0) {
    json.field("holes", cover.holes).field("depth", cover.depth);
  } else {
    json.field("width", cover.width);
  }
  if (cover.thickness > 0) json.field("thickness", cover.thickness);
  json.field("covered", cover.covered);
  if (cover.holes == 0) json.field("covered_area", cover.covered_area);
  json.field("length", cover.length);
  if (cover.holes == 0) json.field("turns", cover.turns);
  if (cover.pace > 0) json.field("pace", cover.pace);
  if (cover.turn_radius > 0) json.field("turn_radius", cover.turn_radius);
  if (cover.cold_after > 0) json.key("cold_after").seconds(cover.cold_after);
  if (!task.guides.empty()) json.field("guided", true).field("clearance", cover.clearance);
  json.key("working").begin_array();
  const auto works = [](const interpreter::GoalSpec& goal) {
    return goal.work == interpreter::GoalSpec::Work::working;
  };
  for (const interpreter::GoalSpec& goal : task.via) json.value(works(goal));
  json.value(works(*task.go)).end_array();
  if (cover.floor) write_floor(json, *cover.floor);
  if (cover.way && cover.holes == 0) write_steps(json, *cover.way);
  json.end_object();
}

}  // namespace rubicon::trace
