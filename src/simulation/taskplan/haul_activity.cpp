#include "src/simulation/taskplan/haul_activity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

#include "src/earth/soil/heap.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/simulation/site/ground_under.hpp"
#include "src/simulation/taskplan/stage.hpp"
#include "src/simulation/taskplan/tip_places.hpp"
#include "src/simulation/taskplan/work_activity.hpp"

namespace rubicon::taskplan {

namespace {

using math::at;

const SiteEvent kHaulage{-1, -1, -1, true};
/// m: loads that fall nearer to the truck lie in no row.
constexpr double kLeastWayOff = 1e-3;

/// m to where a task that digs has its trucks loaded.
double way_to(const Stage& stage, int robot, int dig) {
  const math::Vec3 there = stage.spec(dig).motion_dig->X_WL->translation();
  const auto by_lanes = stage.site.lane_distance(robot, there.head<2>());
  return by_lanes ? *by_lanes : (there - stage.site.tool_pose(robot).translation()).norm();
}

/// m: a truck that is so near to a place stands there.
constexpr double kStandsThere = 0.05;

bool is_at(const Stage& stage, int robot, const math::Pose& X_WL) {
  const math::Vec3 off = X_WL.translation() - stage.site.tool_pose(robot).translation();
  return off.norm() <= kStandsThere;
}

std::vector<interpreter::GoalSpec> values_goal(const std::vector<std::pair<int, double>>& values) {
  std::vector<interpreter::GoalSpec> goals(1);
  goals.front().values = values;
  return goals;
}

/// What lies on the cells now, as boxes in the world.
std::vector<geometry::Shape> boxes_on(const soil::Terrain& surface, const math::Pose& X_WE,
                                      const std::map<int, soil::Millimetres>& heights) {
  std::vector<geometry::Shape> shapes;
  const double side = static_cast<double>(surface.cell) * 1e-3;
  for (const auto& [cell, height] : heights) {
    const double x = cell % surface.columns * side;
    const double y = static_cast<double>(cell / surface.columns) * side;
    geometry::Box box;
    box.lower = {x, y, static_cast<double>(surface.heights[at(cell)]) * 1e-3};
    box.upper = {x + side, y + side, static_cast<double>(height) * 1e-3};
    geometry::Shape& shape = shapes.emplace_back();
    shape.solid = box;
    shape.X_BS = X_WE;
  }
  return shapes;
}

}  // namespace

const interpreter::HaulSpec& HaulActivity::spec_of(const ActiveTask& task, const Stage& stage) {
  return *stage.spec(task.task).haul;
}

schedule::Ticks HaulActivity::worked(const ActiveTask& task, const Stage& stage) const {
  return stage.calendar(task.task).work_between(begun_, stage.now());
}

Step HaulActivity::begin(ActiveTask& task, Stage& stage) {
  begun_ = stage.now();
  task.account.outcome.haul.emplace();
  const std::vector<double>& q = stage.site.configuration(stage.spec(task.task).robot);
  for (const auto& each : spec_of(task, stage).raised) {
    lowered_.emplace_back(each.first, q[at(each.first)]);
  }
  return go_on(task, stage, choose(task, stage));
}

Step HaulActivity::resume(ActiveTask& task, Stage& stage) {
  if (inner_) return go_on(task, stage, inner_->resume(task, stage));
  if (part_ == Part::choosing) return go_on(task, stage, choose(task, stage));
  if (part_ == Part::queueing) return go_on(task, stage, look_in_queue(task, stage));
  if (part_ == Part::parting) return go_on(task, stage, go_to_tip(task, stage));
  return go_on(task, stage, look_at_load(task, stage));
}

/// Whatever is over is followed by what comes next, until something takes time.
Step HaulActivity::go_on(ActiveTask& task, Stage& stage, Step step) {
  while (step == Step::over && part_ != Part::done) {
    inner_ = {};
    step = next(task, stage);
  }
  return step;
}

Step HaulActivity::next(ActiveTask& task, Stage& stage) {
  if (!rest_.empty()) return begin_leg(task, stage, std::exchange(rest_, {}), situation_, what_);
  switch (part_) {
    case Part::coming:
    case Part::entering:
      return stand(task, stage);
    case Part::leaving:
      return go_to_tip(task, stage);
    case Part::going:
      return arrive_at_tip(task, stage);
    case Part::raising:
      return tip(task, stage);
    case Part::tipping:
      load_.tipped = worked(task, stage);
      task.account.outcome.haul->loads.push_back(load_);
      stage.made_progress();
      part_ = Part::lowering;
      if (lowered_.empty()) return Step::over;
      return begin_leg(task, stage, values_goal(lowered_), "dumping", "lowering what it raised");
    case Part::lowering:
      note_where_it_tipped(task, stage);
      back_ = 0;
      return choose(task, stage);
    case Part::clearing:
      stage.announce(kHaulage);
      return choose(task, stage);
    case Part::choosing:
    case Part::queueing:
    case Part::loading:
    case Part::parting:
    case Part::done:
      break;
  }
  return Step::over;
}

/// It stands until others come further.
Step HaulActivity::wait(ActiveTask& task, Stage& stage) {
  if (!waits_) since_ = stage.now();
  waits_ = true;
  stage.begins_to_wait(task.task);
  return Step::pending;
}

void HaulActivity::end_wait(ActiveTask& task, Stage& stage, const std::string& whom) {
  if (!std::exchange(waits_, false)) return;
  task.account.outcome.waits.resource += stage.now() - since_;
  stage.pause(task.task, "truck", whom, since_);
}

/// Whether another that waits for a place to go to is nearer to this one: where trucks stood in a
/// queue they go on in that order.
bool HaulActivity::is_behind_another(const ActiveTask& task, const Stage& stage, int dig,
                                     double distance) const {
  const std::map<int, int>& idle = stage.haulage.idle;
  return std::any_of(idle.begin(), idle.end(), [&](const auto& each) {
    const auto [other, stays_with] = each;
    if (other == task.task || stage.is_over(other)) return false;
    if (stays_with >= 0 && stays_with != stage.spec(dig).robot) return false;
    const interpreter::TaskSpec& spec = stage.spec(other);
    const std::vector<int>& digs = spec.haul->digs;
    return std::find(digs.begin(), digs.end(), dig) != digs.end() &&
           way_to(stage, spec.robot, dig) < distance;
  });
}

/// To the open place with the fewest trucks, of these to the nearest, then the first. A truck goes
/// where there is a place for it to stand.
Step HaulActivity::choose(ActiveTask& task, Stage& stage) {
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  const interpreter::HaulSpec& haul = *spec.haul;
  part_ = Part::choosing;
  if (all_is_dug(stage, haul)) {
    const bool any_dug = std::any_of(haul.digs.begin(), haul.digs.end(), [&](int dig) {
      const auto place = stage.haulage.places.find(dig);
      return place != stage.haulage.places.end() && place->second.is_over;
    });
    if (!any_dug) {
      stage.reject(task.task, "none of the tasks that it hauls for digs", haul.digs);
      return Step::pending;
    }
    if (const auto step = clear_the_tip(task, stage, true)) return *step;
    stage.site.set_partner(spec.robot, -1);
    stage.haulage.idle.erase(task.task);
    end_wait(task, stage,
             stage.spec(haul.digs.back()).robot < 0
                 ? std::string()
                 : stage.robot_spec(stage.spec(haul.digs.back()).robot).name);
    task.account.outcome.haul->time = worked(task, stage);
    part_ = Part::done;
    return Step::over;
  }
  dig_ = -1;
  std::tuple<std::ptrdiff_t, double> best;
  for (const int dig : haul.digs) {
    const auto found = stage.haulage.places.find(dig);
    const bool is_its_own = stays_with_ < 0 || stage.spec(dig).robot == stays_with_;
    if (found == stage.haulage.places.end() || !found->second.is_open || !is_its_own) continue;
    const LoadingPlace& place = found->second;
    const auto trucks = static_cast<std::ptrdiff_t>(place.coming.size()) +
                        std::count_if(place.claims.begin(), place.claims.end(),
                                      [](int truck) { return truck >= 0; });
    if (trucks >= static_cast<std::ptrdiff_t>(place.claims.size())) continue;
    const double distance = way_to(stage, spec.robot, dig);
    if (is_behind_another(task, stage, dig, distance)) continue;
    if (dig_ >= 0 && std::tuple(trucks, distance) >= best) continue;
    best = {trucks, distance};
    dig_ = dig;
  }
  if (dig_ < 0) {
    if (const auto step = clear_the_tip(task, stage, false)) return *step;
    stage.haulage.idle[task.task] = stays_with_;
    return wait(task, stage);
  }
  stage.haulage.idle.erase(task.task);
  stage.announce(kHaulage);
  end_wait(task, stage, stage.robot_spec(stage.spec(dig_).robot).name);
  LoadingPlace& place = stage.haulage.places.at(dig_);
  TruckLoad truck;
  truck.dig = dig_;
  stage.haulage.trucks[task.task] = truck;
  const interpreter::MotionDigSpec& dig = *stage.spec(dig_).motion_dig;
  spot_ = behind(task, stage);
  const math::Pose& X_WE = dig.queue.empty() ? *dig.X_WL : dig.queue.back();
  if (dig.queue.empty()) stage.site.set_partner(spec.robot, stage.spec(dig_).robot);
  if (spot_ < place.claims.size() || is_at(stage, spec.robot, X_WE)) {
    stage.haulage.trucks.at(task.task).arrived = arrived_.value_or(worked(task, stage));
    arrived_.reset();
    part_ = Part::queueing;
    return look_in_queue(task, stage);
  }
  arrived_.reset();
  place.coming.insert(task.task);
  part_ = Part::coming;
  std::vector<interpreter::GoalSpec> goals;
  // The way back is one from where it tipped.
  const std::size_t from = std::exchange(back_, std::nullopt).value_or(haul.back.size());
  for (std::size_t i = from; i < haul.back.size(); ++i) goals.emplace_back().X_WG = haul.back[i];
  goals.emplace_back().X_WG = X_WE;
  return begin_leg(task, stage, std::move(goals), "empty", "on its way to be loaded");
}

/// Where it has tipped and others have nowhere else to tip, it goes on to the first waypoint of its
/// way back, whether or not it knows where to go from there.
std::optional<Step> HaulActivity::clear_the_tip(ActiveTask& task, Stage& stage, bool for_good) {
  const interpreter::HaulSpec& haul = spec_of(task, stage);
  if (back_ != 0 || haul.back.empty()) return std::nullopt;
  const int other = who_wants_the_tip_of(stage, task.task, for_good);
  if (other < 0) return std::nullopt;
  end_wait(task, stage, stage.robot_spec(stage.spec(other).robot).name);
  stage.haulage.idle.erase(task.task);
  part_ = Part::clearing;
  back_ = 1;
  std::vector<interpreter::GoalSpec> goals(1);
  goals.front().X_WG = haul.back.front();
  return begin_leg(task, stage, std::move(goals), "empty", "leaving the tip");
}

/// The place behind which it stands already: one that stood in the queue of this robot keeps its
/// place there, when another dig begins. All others come to the end of the queue.
std::size_t HaulActivity::behind(const ActiveTask& task, const Stage& stage) {
  const LoadingPlace& place = stage.haulage.places.at(dig_);
  const interpreter::MotionDigSpec& dig = *stage.spec(dig_).motion_dig;
  const bool stays = std::exchange(stays_with_, -1) >= 0;
  for (std::size_t i = 0; i < dig.queue.size(); ++i) {
    if (place.claims[i + 1] < 0 && is_at(stage, stage.spec(task.task).robot, dig.queue[i])) {
      return i + 2;
    }
  }
  return stays && place.claims[0] < 0 ? 1 : place.claims.size();
}

/// It stands where it was going.
Step HaulActivity::stand(ActiveTask& task, Stage& stage) {
  LoadingPlace& place = stage.haulage.places.at(dig_);
  if (place.is_over) return go_elsewhere(task, stage);
  TruckLoad& truck = stage.haulage.trucks.at(task.task);
  if (part_ == Part::coming) {
    place.coming.erase(task.task);
    truck.arrived = worked(task, stage);
    part_ = Part::queueing;
    return look_in_queue(task, stage);
  }
  if (spot_ == 0) {
    truck.began = worked(task, stage);
    place.standing = task.task;
    part_ = Part::loading;
    stage.announce(kHaulage);
    return look_at_load(task, stage);
  }
  part_ = Part::queueing;
  return look_in_queue(task, stage);
}

/// In the queue: it moves up as far as the places before its own are free.
Step HaulActivity::look_in_queue(ActiveTask& task, Stage& stage) {
  LoadingPlace& place = stage.haulage.places.at(dig_);
  if (!place.is_over && place.claims[spot_ - 1] >= 0) return wait(task, stage);
  end_wait(task, stage, stage.robot_spec(stage.spec(dig_).robot).name);
  if (place.is_over) return go_elsewhere(task, stage);
  if (spot_ < place.claims.size()) place.claims[spot_] = -1;
  while (spot_ > 0 && place.claims[spot_ - 1] < 0) --spot_;
  place.claims[spot_] = task.task;
  const interpreter::MotionDigSpec& dig = *stage.spec(dig_).motion_dig;
  if (spot_ == 0) {
    stage.site.set_partner(stage.spec(task.task).robot, stage.spec(dig_).robot);
  }
  part_ = Part::entering;
  stage.announce(kHaulage);
  std::vector<interpreter::GoalSpec> goals(1);
  goals.front().X_WG = spot_ == 0 ? *dig.X_WL : dig.queue[spot_ - 1];
  return begin_leg(task, stage, std::move(goals), "empty",
                   spot_ == 0 ? "from the queue to be loaded" : "moving up in the queue");
}

/// All is dug here: it stays with the robot that dug if that has more to dig.
Step HaulActivity::go_elsewhere(ActiveTask& task, Stage& stage) {
  const int robot = stage.spec(dig_).robot;
  const std::vector<int>& digs = spec_of(task, stage).digs;
  const bool has_more = std::any_of(digs.begin(), digs.end(), [&](int dig) {
    const auto place = stage.haulage.places.find(dig);
    const bool is_over =
        stage.is_over(dig) || (place != stage.haulage.places.end() && place->second.is_over);
    return stage.spec(dig).robot == robot && !is_over;
  });
  arrived_.reset();
  if (has_more && part_ != Part::coming) {
    arrived_ = stage.haulage.trucks.at(task.task).arrived;
  }
  forget_truck(task, stage);
  stays_with_ = has_more ? robot : -1;
  return choose(task, stage);
}

/// Where it is loaded: it leaves when it is full, or when all is dug.
Step HaulActivity::look_at_load(ActiveTask& task, Stage& stage) {
  const LoadingPlace& place = stage.haulage.places.at(dig_);
  const TruckLoad& truck = stage.haulage.trucks.at(task.task);
  if (!place.is_over && !truck.is_full) return wait(task, stage);
  end_wait(task, stage, stage.robot_spec(stage.spec(dig_).robot).name);
  if (truck.volume == 0) return go_elsewhere(task, stage);
  return leave(task, stage);
}

/// Others may have its place.
void HaulActivity::forget_truck(const ActiveTask& task, Stage& stage) {
  LoadingPlace& place = stage.haulage.places.at(dig_);
  place.coming.erase(task.task);
  std::replace(place.claims.begin(), place.claims.end(), task.task, -1);
  if (place.standing == task.task) place.standing = -1;
  stage.haulage.trucks.erase(task.task);
  stage.announce(kHaulage);
}

Step HaulActivity::leave(ActiveTask& task, Stage& stage) {
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  const TruckLoad truck = stage.haulage.trucks.at(task.task);
  load_ = {};
  load_.dig = stage.spec(dig_).name;
  load_.volume = truck.volume;
  load_.arrived = truck.arrived;
  load_.began = truck.began;
  load_.loaded = worked(task, stage);
  const Ticks stands_since = stage.calendar(task.task).finish(begun_, truck.began);
  if (auto* const trace = stage.trace_of(task.task)) {
    trace->soil(stage.site.component_name(stage.spec(dig_).motion_dig->soil), truck.volume, {},
                std::min(stands_since, stage.now()), stage.now());
  }
  stage.site.set_carries_soil(spec.robot, true);
  forget_truck(task, stage);
  stage.made_progress();
  const interpreter::HaulSpec& haul = *spec.haul;
  if (haul.out.empty()) return go_to_tip(task, stage);
  part_ = Part::leaving;
  std::vector<interpreter::GoalSpec> goals(1);
  goals.front().X_WG = haul.out.front();
  return begin_leg(task, stage, std::move(goals), "loaded", "on its way to tip");
}

/// Of its places that nobody else has the first where there is room. If others have those with room
/// it waits.
Step HaulActivity::go_to_tip(ActiveTask& task, Stage& stage) {
  const interpreter::HaulSpec& haul = spec_of(task, stage);
  std::optional<TipPlace> chosen;
  const math::Pose* place = nullptr;
  at_tips_.clear();
  for (const math::Pose& X : haul.tips) {
    if (const int other = who_tips_at(stage, X, task.task); other >= 0) {
      at_tips_.push_back(stage.spec(other).robot);
      continue;
    }
    chosen = place_to_tip(task, stage, X);
    if (stage.rejection) return Step::pending;
    place = &X;
    if (chosen) break;
  }
  if (!chosen && !at_tips_.empty()) {
    part_ = Part::parting;
    return wait(task, stage);
  }
  end_wait(task, stage, stage.robot_spec(stage.spec(dig_).robot).name);
  if (!chosen) {
    stage.reject(task.task,
                 fmt::format("load {}: there is no room left to tip {:.2f} m3 at any of its places",
                             task.account.outcome.haul->loads.size() + 1,
                             static_cast<double>(load_.volume) * 1e-9));
    return Step::pending;
  }
  const bool comes_from_dig = part_ != Part::going && part_ != Part::raising;
  tip_ = *chosen;
  stage.haulage.tips[task.task] = {*place, std::nullopt};
  stage.announce(kHaulage);
  part_ = Part::going;
  std::vector<interpreter::GoalSpec> goals;
  // From where it chose the others of its waypoints lead to it, from another place none.
  if (comes_from_dig) {
    for (std::size_t i = 1; i < haul.out.size(); ++i) goals.emplace_back().X_WG = haul.out[i];
  }
  goals.emplace_back().X_WG = tip_.X_WL;
  return begin_leg(task, stage, std::move(goals), "loaded", "on its way to tip");
}

/// The ground of its heap is known from the first load on.
void HaulActivity::open_heap(const ActiveTask& task, Stage& stage) const {
  const int earth = spec_of(task, stage).earth;
  HeapLedger& ledger = stage.haulage.heaps[earth];
  if (ledger.ground) return;
  const interpreter::EarthSpec& spec = stage.plan.earths[at(earth)];
  ledger.ground = std::make_shared<const soil::Terrain>(spec.before);
  stage.site_changes.open_heap(spec.heap, ledger.ground);
}

/// Where its load falls if its tool frame is there, as seen from the earth.
math::Vec3 HaulActivity::fall_E(const ActiveTask& task, const Stage& stage,
                                const math::Pose& X_WT) const {
  const interpreter::HaulSpec& haul = spec_of(task, stage);
  const math::Vec3 p_W = X_WT * haul.p_TH;
  return stage.plan.earths[at(haul.earth)].X_WE.inverse(Eigen::Isometry) * p_W;
}

/// How its load would lie; nothing where it would not lie on the earth, or in a pit.
std::optional<HaulActivity::TippedLoad> HaulActivity::lie(ActiveTask& task, Stage& stage,
                                                          const math::Pose& X_WT) const {
  const interpreter::HaulSpec& haul = spec_of(task, stage);
  const interpreter::EarthSpec& earth = stage.plan.earths[at(haul.earth)];
  const HeapLedger& ledger = stage.haulage.heaps.at(haul.earth);
  const soil::Terrain& surface = *stage.site.surface(earth.heap);
  const math::Vec3 p_E = fall_E(task, stage, X_WT);
  const double side = static_cast<double>(surface.cell) * 1e-3;
  const double column = std::floor(p_E.x() / side);
  const double row = std::floor(p_E.y() / side);
  if (!(column >= 0 && row >= 0 && column < surface.columns && row < surface.rows)) {
    return std::nullopt;
  }
  TippedLoad tipped;
  tipped.loose =
      std::llround(static_cast<double>(load_.volume) * (1 + stage.spec(dig_).motion_dig->swell));
  tipped.placed =
      std::max((ledger.loose + tipped.loose) / (surface.cell * surface.cell), ledger.placed + 1);
  const int cell = static_cast<int>(surface.index(static_cast<int>(column), static_cast<int>(row)));
  const soil::HeapGrowth growth =
      tip_over(surface, cell, tipped.placed - ledger.placed, *earth.repose_deg);
  const bool in_pit =
      std::any_of(growth.heights.begin(), growth.heights.end(), [&](const auto& each) {
        return earth.before.heights[at(each.first)] != earth.after.heights[at(each.first)];
      });
  if (growth.reaches_border || in_pit) return std::nullopt;
  tipped.heights = growth.heights;
  return tipped;
}

/// The same where it stands now; nothing, too, where it would lie on a machine or on what stands.
std::optional<HaulActivity::TippedLoad> HaulActivity::room(ActiveTask& task, Stage& stage) const {
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  const interpreter::EarthSpec& earth = stage.plan.earths[at(spec.haul->earth)];
  std::optional<TippedLoad> tipped = lie(task, stage, stage.site.tool_pose(spec.robot));
  if (!tipped) return std::nullopt;
  const std::vector<geometry::Shape> boxes =
      boxes_on(*stage.site.surface(earth.heap), earth.X_WE, tipped->heights);
  if (stage.site.machine_in({boxes, {}}, -1) || stage.site.standing_in(boxes)) return std::nullopt;
  return tipped;
}

/// Where it stands to tip at a place of the plan: there, or as many cells farther away from where
/// loads fall as it takes to stand clear of the heap, its own load included. A row of heaps comes
/// of that. Nothing where no load would lie on the earth any more. A load that falls beside the
/// earth from the place itself is a mistake of the plan: the task is rejected.
std::optional<HaulActivity::TipPlace> HaulActivity::place_to_tip(ActiveTask& task, Stage& stage,
                                                                 const math::Pose& X_WL) const {
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  const interpreter::HaulSpec& haul = *spec.haul;
  if (haul.earth < 0) return TipPlace{X_WL, 0};
  open_heap(task, stage);
  const interpreter::EarthSpec& earth = stage.plan.earths[at(haul.earth)];
  const soil::Terrain& surface = *stage.site.surface(earth.heap);
  const soil::Terrain& ground = *stage.haulage.heaps.at(haul.earth).ground;
  const double side = static_cast<double>(surface.cell) * 1e-3;
  const auto is_on_earth = [&](const math::Pose& X_WT) {
    const math::Vec3 p_E = fall_E(task, stage, X_WT);
    return p_E.x() >= 0 && p_E.y() >= 0 && p_E.x() < surface.columns * side &&
           p_E.y() < surface.rows * side;
  };
  if (!is_on_earth(X_WL)) {
    const math::Vec3 p_W = X_WL * haul.p_TH;
    stage.reject(
        task.task,
        fmt::format("load {}: it would fall beside earth '{}', at ({:.2f}, {:.2f})",
                    task.account.outcome.haul->loads.size() + 1, earth.name, p_W.x(), p_W.y()));
    return std::nullopt;
  }
  const robot::RobotModel& model = stage.robot_spec(spec.robot).robot->model;
  const site::SiteRobot& machine = stage.site.robot(spec.robot);
  const site::BodyCorners corners = site::corners_of(model);
  const std::vector<double>& q = stage.site.configuration(spec.robot);
  math::Vec3 away = X_WL.linear() * -haul.p_TH;
  away.z() = 0;
  const bool has_row = away.norm() > kLeastWayOff;
  if (has_row) away.normalize();
  int cells = 0;
  for (const auto& [place, reached] : stage.haulage.rows) {
    if (is_same_place(place, X_WL)) cells = reached;
  }
  for (;; ++cells) {
    TipPlace place{X_WL, cells};
    place.X_WL.translation() += away * (cells * side);
    if (!is_on_earth(place.X_WL)) return std::nullopt;
    const robot::GoalSolution goal =
        robot::solve_goal(model, machine.mounting, q, place.X_WL, {}, spec.clauses);
    if (goal.reachable) {
      const site::PlanRegion footprint = site::footprint_of(machine, corners, goal.q);
      const bool is_on_heap = site::has_cell_under(
          footprint, earth.X_WE, surface,
          [&](std::size_t cell) { return surface.heights[cell] > ground.heights[cell]; });
      std::optional<TippedLoad> tipped;
      if (!is_on_heap) tipped = lie(task, stage, place.X_WL);
      const bool lies_clear =
          tipped && !site::has_cell_under(footprint, earth.X_WE, surface, [&](std::size_t cell) {
            return tipped->heights.contains(static_cast<int>(cell));
          });
      if (lies_clear) return place;
    }
    if (!has_row) return std::nullopt;
  }
}

/// It stands where it tips. Where its load would lie on somebody it goes farther, or elsewhere.
Step HaulActivity::arrive_at_tip(ActiveTask& task, Stage& stage) {
  const interpreter::HaulSpec& haul = spec_of(task, stage);
  load_.at_tip = worked(task, stage);
  stage.site.set_partner(stage.spec(task.task).robot, -1);
  if (haul.earth >= 0 && !room(task, stage)) return stand_farther(task, stage);
  part_ = Part::raising;
  if (haul.raised.empty()) return Step::over;
  return begin_leg(task, stage, values_goal(haul.raised), "dumping", "raising to tip");
}

/// There is no room from this place on, up to one cell farther.
Step HaulActivity::stand_farther(ActiveTask& task, Stage& stage) {
  note_row(task, stage, tip_.cells_from_it + 1);
  return go_to_tip(task, stage);
}

void HaulActivity::note_row(const ActiveTask& task, Stage& stage, int cells) const {
  const math::Pose& X_WL = stage.haulage.tips.at(task.task).X_WL;
  auto& rows = stage.haulage.rows;
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const auto& each) { return is_same_place(each.first, X_WL); });
  if (row == rows.end()) {
    rows.emplace_back(X_WL, cells);
  } else {
    row->second = cells;
  }
}

/// Its place is another's as soon as it does not stand there any more.
void HaulActivity::note_where_it_tipped(const ActiveTask& task, Stage& stage) const {
  const int robot = stage.spec(task.task).robot;
  const site::BodyCorners corners = site::corners_of(stage.robot_spec(robot).robot->model);
  stage.haulage.tips.at(task.task).stood =
      site::footprint_of(stage.site.robot(robot), corners, stage.site.configuration(robot));
  stage.announce(kHaulage);
}

/// The load lies there from the moment it begins to tip.
Step HaulActivity::tip(ActiveTask& task, Stage& stage) {
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  const interpreter::HaulSpec& haul = *spec.haul;
  TippedLoad tipped;
  int component = stage.spec(dig_).motion_dig->soil;
  if (haul.earth >= 0) {
    auto found = room(task, stage);
    if (!found) return stand_farther(task, stage);
    tipped = *std::move(found);
    component = stage.plan.earths[at(haul.earth)].heap;
    HeapLedger& ledger = stage.haulage.heaps[haul.earth];
    ledger.loose += tipped.loose;
    ledger.bank += load_.volume;
    ledger.placed = tipped.placed;
    note_row(task, stage, tip_.cells_from_it);
    stage.site_changes.set_surface(component, tipped.heights);
  }
  if (auto* const trace = stage.trace_of(task.task)) {
    trace->soil(stage.site.component_name(component), -load_.volume, tipped.heights, stage.now(),
                stage.now());
  }
  stage.site.set_carries_soil(spec.robot, false);
  part_ = Part::tipping;
  task.phases[task.phase].work = &haul.tip;
  task.phases[task.phase].what = "tip";
  inner_ = Snapshot<Activity>(std::make_unique<WorkActivity>());
  return inner_->begin(task, stage);
}

/// To the first of the goals; to the others, one by one, when it stands there.
Step HaulActivity::begin_leg(ActiveTask& task, Stage& stage,
                             std::vector<interpreter::GoalSpec> goals, const char* situation,
                             const char* what) {
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  MotionLeg leg;
  situation_ = situation;
  what_ = what;
  goals.front().span = spec.span;
  leg.goals.push_back(std::move(goals.front()));
  rest_.assign(std::make_move_iterator(goals.begin() + 1), std::make_move_iterator(goals.end()));
  leg.situation = situation;
  leg.guided = part_ != Part::raising && part_ != Part::lowering;
  leg.what = fmt::format("load {}, {}", task.account.outcome.haul->loads.size() + 1, what);
  inner_ = Snapshot<Activity>(std::make_unique<MotionActivity>(std::move(leg)));
  return inner_->begin(task, stage);
}

Step HaulActivity::granted(ActiveTask& task, Stage& stage, const ResourceAllocator::Grant& grant) {
  return inner_ ? go_on(task, stage, inner_->granted(task, stage, grant)) : Step::pending;
}

/// It goes on as soon as one of those who dig does, or a truck that has its place.
WaitSet HaulActivity::waits(const ActiveTask& task, const Stage& stage) const {
  if (inner_) return inner_->waits(task, stage);
  WaitSet waits;
  waits.any = true;
  if (!waits_) return waits;
  if (part_ == Part::parting) {
    for (std::size_t i = 0; i < at_tips_.size(); ++i) {
      waits.targets.push_back(
          stage.move_of(at_tips_[i], WaitTarget::Kind::activity, static_cast<int>(i)));
    }
    return waits;
  }
  WaitTarget target;
  for (const int dig : spec_of(task, stage).digs) {
    if (part_ != Part::choosing && dig != dig_) continue;
    if (!stage.is_over(dig)) target.by.push_back(dig);
    if (part_ == Part::loading) continue;
    const auto place = stage.haulage.places.find(dig);
    if (place == stage.haulage.places.end()) continue;
    for (const int truck : place->second.claims) {
      if (truck >= 0 && truck != task.task) target.by.push_back(truck);
    }
  }
  waits.targets.push_back(std::move(target));
  return waits;
}

std::string HaulActivity::text_of(const ActiveTask& task, const Stage& stage,
                                  const WaitTarget& target) const {
  if (inner_) return inner_->text_of(task, stage, target);
  if (part_ == Part::parting) {
    return fmt::format("{} waits until {} has left the place where it is to tip",
                       stage.who_is(task.task), stage.robot_spec(at_tips_[at(target.number)]).name);
  }
  const char* what = part_ == Part::loading ? "to be loaded by" : "for its turn at";
  const int dig = dig_ < 0 ? spec_of(task, stage).digs.front() : dig_;
  return fmt::format("{} waits {} {}", stage.who_is(task.task), what, stage.spec(dig).name);
}

std::string HaulActivity::standstill_reason(const ActiveTask& task, const Stage& stage) const {
  if (inner_) return inner_->standstill_reason(task, stage);
  if (part_ != Part::parting) return "nobody ever loads it";
  const interpreter::RobotSpec& machine = stage.robot_spec(at_tips_.front());
  return fmt::format("{} never leaves the place where it is to tip{}", machine.name,
                     machine.park ? "" : fmt::format("; give {} a park position", machine.name));
}

bool HaulActivity::wakes_at(const ActiveTask& task, const Stage& stage,
                            const SiteEvent& event) const {
  if (inner_) return inner_->wakes_at(task, stage, event);
  if (!waits_) return false;
  if (event.haulage || part_ != Part::parting) return event.haulage;
  return std::find(at_tips_.begin(), at_tips_.end(), event.robot) != at_tips_.end();
}

std::vector<int> HaulActivity::robots_in_the_way(const Stage& stage) const {
  if (inner_) return inner_->robots_in_the_way(stage);
  return waits_ && part_ == Part::parting ? at_tips_ : std::vector<int>();
}

}  // namespace rubicon::taskplan
