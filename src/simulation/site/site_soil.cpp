#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <utility>

#include "src/earth/soil/blocks.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/robot/frame_chain.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/simulation/site/ground_under.hpp"
#include "src/simulation/site/site_world.hpp"

namespace rubicon::site {

namespace {

using math::at;

/// Blocks of a piece of soil as boxes in the frame of its earth.
std::vector<geometry::Shape> boxes_of(const std::vector<soil::Block>& blocks, int first_column,
                                      int first_row, soil::Millimetres cell) {
  const auto metres = [](soil::Millimetres value) { return static_cast<double>(value) * 1e-3; };
  std::vector<geometry::Shape> shapes;
  for (const soil::Block& block : blocks) {
    geometry::Box box;
    box.lower = {metres((first_column + block.first_column) * cell),
                 metres((first_row + block.first_row) * cell), metres(block.bottom)};
    box.upper = {metres((first_column + block.end_column) * cell),
                 metres((first_row + block.end_row) * cell), metres(block.top)};
    shapes.emplace_back().solid = box;
  }
  return shapes;
}

/// m: a machine drives over ground that is so much lower than its wheels.
constexpr double kDrivenOver = 0.15;

/// A box round all places of a body in a step: between its ends it goes aside by less than it goes
/// on.
Eigen::AlignedBox2d around_step(const SiteRobot& robot, int body, double reach,
                                std::span<const double> q_from, std::span<const double> q_to) {
  const auto place = [&](std::span<const double> q) -> Eigen::Vector2d {
    return robot::body_pose(*robot.model, robot.mounting, q, body).translation().head<2>();
  };
  const Eigen::Vector2d from = place(q_from);
  const Eigen::Vector2d to = place(q_to);
  Eigen::AlignedBox2d box(from);
  box.extend(to);
  const Eigen::Vector2d more = Eigen::Vector2d::Constant(reach + (to - from).norm());
  return {box.min() - more, box.max() + more};
}

}  // namespace

void SiteWorld::set_drives(int robot) {
  RobotEntry& machine = entry(robot);
  machine.wheels = corners_of(*machine.robot.model);
  const auto tool = at(machine.robot.model->tool_body);
  for (std::size_t i = 0; i < machine.wheels.size(); ++i) {
    if (i != tool) machine.wheels[i].clear();
  }
  for (const math::Vec3& corner : machine.wheels[tool]) {
    machine.wheels_reach = std::max(machine.wheels_reach, corner.norm());
  }
}

void SiteWorld::add_pit(Pit pit) {
  const soil::Terrain& ground = *pit.before;
  const double side = static_cast<double>(ground.cell) * 1e-3;
  ground.heights.for_each_difference(pit.after->heights, [&](std::size_t cell) {
    const int column = static_cast<int>(cell) % ground.columns;
    const int row = static_cast<int>(cell) / ground.columns;
    for (const int right : {0, 1}) {
      for (const int up : {0, 1}) {
        const math::Vec3 corner((column + right) * side, (row + up) * side, 0);
        pit.around.extend((pit.X_WE * corner).head<2>());
      }
    }
  });
  if (pits_.size() % kPitsTogether == 0) around_pits_.emplace_back();
  around_pits_.back().extend(pit.around);
  pits_.push_back(std::move(pit));
}

void SiteWorld::set_being_dug(int component, bool is_dug) {
  if (is_dug) {
    being_dug_.insert(component);
  } else {
    being_dug_.erase(component);
  }
  ++changes_;
}

std::optional<std::string> SiteWorld::pit_met(int robot,
                                              const interpreter::MotionStep& step) const {
  const RobotEntry& machine = entry(robot);
  if (pits_.empty() || machine.wheels.empty()) return std::nullopt;
  if (std::equal(step.q_from.begin(), step.q_from.end(), step.q_to.begin())) return std::nullopt;
  const Eigen::AlignedBox2d around = around_step(machine.robot, machine.robot.model->tool_body,
                                                 machine.wheels_reach, step.q_from, step.q_to);
  std::optional<PlanRegion> region;
  double lowest = 0;  // that the ground may be
  for (std::size_t i = 0; i < pits_.size(); ++i) {
    if (i % kPitsTogether == 0 && !around.intersects(around_pits_[i / kPitsTogether])) {
      i += kPitsTogether - 1;
      continue;
    }
    const Pit& pit = pits_[i];
    if (!around.intersects(pit.around)) continue;
    const auto opened = soils_.find(pit.component);
    // Nobody has dug there yet.
    const bool is_soil = components_[at(pit.component)].standing;
    if (opened == soils_.end() && is_soil && !being_dug_.contains(pit.component)) continue;
    const soil::Terrain& now = opened == soils_.end() ? *pit.after : opened->second.surface;
    if (!region) {
      region = workspace_of(machine.robot, machine.wheels, {step.q_from, step.q_to, {}, 0}, {});
      lowest = robot::tool_pose(*machine.robot.model, machine.robot.mounting, step.q_to)
                   .translation()
                   .z() -
               kDrivenOver;
    }
    if (!region->bounds.intersects(pit.around)) continue;
    const double z = pit.X_WE.translation().z();
    const bool is_over = has_cell_under(*region, pit.X_WE, now, [&](std::size_t cell) {
      const auto height = [&](const soil::Terrain& ground) {
        return z + static_cast<double>(ground.heights[cell]) * 1e-3;
      };
      // What hangs over the ground as it was is no vehicle there.
      return pit.before->heights[cell] != pit.after->heights[cell] && height(now) < lowest &&
             height(*pit.before) >= lowest;
    });
    if (is_over) return pit.task;
  }
  return std::nullopt;
}

void SiteWorld::open_soil(int component, soil::Terrain surface,
                          std::shared_ptr<const soil::Terrain> bottom) {
  Component& one = components_[at(component)];
  if (one.id) erase(*one.id);
  one.id.reset();
  Soil soil;
  soil.surface = std::move(surface);
  soil.bottom = std::move(bottom);
  const int rows = (soil.surface.rows + kPiece - 1) / kPiece;
  const auto pieces = at(pieces_in_row(soil) * rows);
  soil.ids.resize(pieces);
  soil.stands.resize(pieces, false);
  soils_.insert_or_assign(component, std::move(soil));
  show_soil(component, true);
  note_change(one);
  ++changes_;
}

const soil::Terrain* SiteWorld::surface(int component) const {
  const auto found = soils_.find(component);
  return found == soils_.end() ? nullptr : &found->second.surface;
}

void SiteWorld::set_surface(int component, const std::map<int, soil::Millimetres>& heights) {
  Soil& soil = soils_.at(component);
  std::set<int> pieces;
  for (const auto& [cell, height] : heights) {
    soil.surface.heights.set(at(cell), height);
    const int row = cell / soil.surface.columns / kPiece;
    const int column = cell % soil.surface.columns / kPiece;
    pieces.insert(row * pieces_in_row(soil) + column);
  }
  bool is_listed = true;
  for (const int piece : pieces) {
    const bool stood = soil.stands[at(piece)];
    set_piece(components_[at(component)], soil, piece);
    is_listed = is_listed && soil.stands[at(piece)] == stood;
  }
  if (!is_listed) list_standing(soil);
  ++changes_;
}

void SiteWorld::close_soil(int component, const ComponentState& before) {
  Component& one = components_[at(component)];
  show_soil(component, false);
  soils_.erase(component);
  one.id = before.id;
  if (one.standing && one.id) {
    obstacles_.put_back(*one.id, one.body, one.X_WO);
    names_[*one.id] = one.name;
  }
  note_change(one);
  ++changes_;
}

/// What there is of a piece now is in the way, and nothing else of it.
void SiteWorld::set_piece(const Component& component, Soil& soil, int piece) {
  const int first_column = piece % pieces_in_row(soil) * kPiece;
  const int first_row = piece / pieces_in_row(soil) * kPiece;
  const int columns = std::min(kPiece, soil.surface.columns - first_column);
  const int rows = std::min(kPiece, soil.surface.rows - first_row);
  const soil::Millimetres cell = soil.surface.cell;
  soil::Terrain under = soil::flat(columns, rows, cell, 0);
  soil::Terrain above = under;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const std::size_t from = soil.surface.index(first_column + column, first_row + row);
      under.heights.set(under.index(column, row), soil.bottom->heights[from]);
      above.heights.set(under.index(column, row), soil.surface.heights[from]);
    }
  }
  const std::vector<geometry::Shape> shapes =
      boxes_of(soil::blocks_between(under, above), first_column, first_row, cell);
  std::optional<collision::ObstacleId>& id = soil.ids[at(piece)];
  const bool stood = soil.stands[at(piece)];
  const bool stands = component.standing && !shapes.empty();
  soil.stands[at(piece)] = stands;
  if (stood && !stands) erase(*id);
  if (!stands) return;
  collision::BodyPtr body = collision::prepare(shapes);
  if (stood) {
    obstacles_.replace(*id, std::move(body), component.X_WO);
  } else if (id) {
    obstacles_.put_back(*id, std::move(body), component.X_WO);
    names_[*id] = component.name;
  } else {
    id = insert(component.name, body, component.X_WO);
  }
}

/// Those where the surface is not at the bottom; ascending.
std::set<int> SiteWorld::pieces_with_soil(const Soil& soil) {
  const soil::Terrain& surface = soil.surface;
  std::set<int> pieces;
  surface.heights.for_each_difference(soil.bottom->heights, [&](std::size_t cell) {
    const int row = static_cast<int>(cell) / surface.columns / kPiece;
    const int column = static_cast<int>(cell) % surface.columns / kPiece;
    pieces.insert(row * pieces_in_row(soil) + column);
  });
  return pieces;
}

/// All pieces of soil of a component that was opened: in the way, or not any more.
void SiteWorld::show_soil(int component, bool stands) {
  const auto found = soils_.find(component);
  if (found == soils_.end()) return;
  Soil& soil = found->second;
  if (stands) {
    for (const int piece : pieces_with_soil(soil)) {
      set_piece(components_[at(component)], soil, piece);
    }
  } else {
    for (std::size_t piece = 0; piece < soil.ids.size(); ++piece) {
      if (soil.stands[piece]) erase(*soil.ids[piece]);
    }
    soil.stands.assign(soil.stands.size(), false);
  }
  list_standing(soil);
}

void SiteWorld::list_standing(Soil& soil) {
  soil.standing.clear();
  for (std::size_t piece = 0; piece < soil.ids.size(); ++piece) {
    if (soil.stands[piece]) soil.standing.push_back(*soil.ids[piece]);
  }
}

}  // namespace rubicon::site
