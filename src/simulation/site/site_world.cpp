#include "src/simulation/site/site_world.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "src/motion/geometry/above.hpp"
#include "src/simulation/site/load_turn.hpp"
#include "src/simulation/site/step_query.hpp"

namespace rubicon::site {

void SiteWorld::add_obstacle(const std::string& name, const collision::BodyPtr& body,
                             const math::Pose& X_WB) {
  insert(name, body, X_WB);
  ++changes_;
}

int SiteWorld::add_component(std::string name, collision::BodyPtr body, const math::Pose& X_WO,
                             double mass) {
  Component& component = components_.emplace_back();
  component.name = std::move(name);
  component.body = std::move(body);
  component.mass = mass;
  stand(component, X_WO);
  return static_cast<int>(components_.size()) - 1;
}

int SiteWorld::add_robot(SiteRobot robot, std::vector<double> q) {
  RobotEntry& added = robots_.emplace_back();
  added.robot = std::move(robot);
  added.q = std::move(q);
  ++changes_;
  return static_cast<int>(robots_.size()) - 1;
}

void SiteWorld::set_time(Ticks now) {
  now_ = now;
  for (RobotEntry& robot : robots_) {
    if (robot.turn && robot.turn->end <= now) {
      robot.turn.reset();
      changed(robot);
    }
    if (!robot.stepping || robot.step.end > now) continue;
    robot.stepping = false;
    changed(robot);
  }
}

void SiteWorld::attach(int robot, int component) {
  Component& taken = components_[static_cast<std::size_t>(component)];
  assert(taken.standing && !entry(robot).load);
  const math::Pose X_TW = tool_pose(robot).inverse(Eigen::Isometry);
  entry(robot).load = Load{taken.name, taken.body, X_TW * taken.X_WO, taken.mass, component};
  entry(robot).forget_volume();
  lift(taken);
}

void SiteWorld::attach_carry(int robot, collision::BodyPtr body) {
  entry(robot).load = Load{"load", std::move(body), math::Pose::Identity(), 0, -1};
  entry(robot).forget_volume();
  ++changes_;
}

void SiteWorld::detach(int robot) {
  assert(entry(robot).load && entry(robot).load->component >= 0);
  const Load load = *entry(robot).load;
  entry(robot).load.reset();
  entry(robot).forget_volume();
  stand(components_[static_cast<std::size_t>(load.component)], tool_pose(robot) * load.X_TO);
}

void SiteWorld::remove(int component) { lift(components_[static_cast<std::size_t>(component)]); }

void SiteWorld::begin_step(int robot, const interpreter::MotionStep& step, std::vector<double> q,
                           StepVolume known) {
  RobotEntry& moving = entry(robot);
  const bool waits = std::equal(step.q_from.begin(), step.q_from.end(), step.q_to.begin());
  if (waits && !moving.stepping && moving.q == q) return;
  moving.q = std::move(q);
  moving.stepping = !waits && step.duration > 0;
  if (moving.stepping) {
    moving.step.q_from.assign(step.q_from.begin(), step.q_from.end());
    moving.step.q_to.assign(step.q_to.begin(), step.q_to.end());
    moving.step.end = step.start + step.duration;
    moving.step.duration = step.duration;
    moving.step.q_goal.assign(step.q_goal.begin(), step.q_goal.end());
    moving.step.q_aim.assign(step.q_aim.begin(), step.q_aim.end());
  }
  changed(moving);
  if (moving.stepping) moving.known = std::move(known);
}

void SiteWorld::begin_turn(int robot, double angle_deg, Ticks end) {
  RobotEntry& standing = entry(robot);
  assert(standing.load && !standing.stepping);
  Load& load = *standing.load;
  standing.turn = LoadTurn{load.X_TO, angle_deg, end};
  ++standing.turns;
  load.X_TO = turned(tool_pose(robot), load.X_TO, angle_deg);
  changed(standing);
}

void SiteWorld::set_carries_soil(int robot, bool carries) {
  entry(robot).carries_soil = carries;
  ++changes_;
}

void SiteWorld::let_enter(int robot, std::vector<std::pair<int, int>> entered) {
  RobotEntry& machine = entry(robot);
  if (machine.entered == entered) return;
  machine.entered = std::move(entered);
  ++changes_;
}

std::vector<collision::ObstacleId> SiteWorld::entered_by(int robot, int body) const {
  std::vector<collision::ObstacleId> ids;
  for (const auto& [entering, component] : entry(robot).entered) {
    const auto& id = components_[static_cast<std::size_t>(component)].id;
    if (entering == body && id) ids.push_back(*id);
    const auto soil = entering == body ? soils_.find(component) : soils_.end();
    if (soil == soils_.end()) continue;
    const std::vector<collision::ObstacleId>& standing = soil->second.standing;
    ids.insert(ids.end(), standing.begin(), standing.end());
  }
  return ids;
}

MachineState SiteWorld::machine_state(int robot) const {
  const RobotEntry& machine = entry(robot);
  MachineState state{machine.q,         machine.load,         std::nullopt,
                     machine.turn,      machine.carries_soil, machine.partner,
                     machine.changed_at};
  if (machine.stepping) state.step = machine.step;
  return state;
}

void SiteWorld::set_machine_state(int robot, MachineState state) {
  RobotEntry& machine = entry(robot);
  machine.q = std::move(state.q);
  machine.load = std::move(state.load);
  machine.turn = std::move(state.turn);
  machine.carries_soil = state.carries_soil;
  machine.partner = state.partner;
  machine.changed_at = state.changed_at;
  machine.workspace_now.reset();
  machine.stepping = state.step.has_value();
  if (state.step) machine.step = std::move(*state.step);
  machine.forget_volume();
  note_machine_change();
  ++changes_;
}

ComponentState SiteWorld::component_state(int component) const {
  const Component& one = components_[static_cast<std::size_t>(component)];
  return {one.standing, one.X_WO, one.id};
}

void SiteWorld::set_component_state(int component, const ComponentState& state) {
  Component& one = components_[static_cast<std::size_t>(component)];
  const bool same = one.id == state.id && one.X_WO.matrix() == state.X_WO.matrix();
  if (one.standing && !(state.standing && same)) lift(one);
  one.X_WO = state.X_WO;
  if (!state.standing || one.standing) return;
  one.standing = true;
  look_up(one);
  note_change(one);
  one.id = state.id;
  if (one.id) {
    obstacles_.put_back(*one.id, one.body, one.X_WO);
    names_[*one.id] = one.name;
  }
  show_soil(component, true);
  ++changes_;
}

void SiteWorld::hold_zone(int task, const std::string& task_name, const PeopleZone& zone,
                          int exempt_robot) {
  release_zone(task);
  if (zone.shapes.empty()) return;
  zones_.emplace(
      task, Zone{"the zone of " + task_name, standing(zone.shapes),
                 "the air above the zone of " + task_name, standing(zone.overhead), exempt_robot});
  ++changes_;
}

/// What stands, as others meet it; nothing without shapes.
ReservedVolume SiteWorld::standing(const std::vector<geometry::Shape>& shapes_W) const {
  std::vector<ReservedPart> parts;
  if (!shapes_W.empty()) {
    parts.push_back(
        {collision::prepare(shapes_W), geometry::stationary(math::Pose::Identity()), 0});
  }
  return ReservedVolume(std::move(parts), reserved_growth(contact_tolerance_));
}

void SiteWorld::release_zone(int task) {
  if (zones_.erase(task) > 0) ++changes_;
}

namespace {

/// Shapes that stand, as a question.
collision::SweptQuery standing_query(const collision::BodyPtr& body, double contact_tolerance) {
  collision::SweptQuery query;
  query.contact_tolerance = contact_tolerance;
  query.items.push_back({{body.get(), geometry::stationary(math::Pose::Identity())}, true});
  return query;
}

}  // namespace

std::optional<std::string> SiteWorld::standing_in(
    const std::vector<geometry::Shape>& shapes) const {
  if (shapes.empty()) return std::nullopt;
  const collision::BodyPtr body = collision::prepare(shapes);
  const auto hit = obstacles_.test(standing_query(body, contact_tolerance_)).hit;
  return hit && hit->obstacle ? std::optional(obstacle_name(*hit->obstacle)) : std::nullopt;
}

std::optional<int> SiteWorld::machine_in(const PeopleZone& zone, int exempt_robot) const {
  if (zone.shapes.empty()) return std::nullopt;
  const collision::BodyPtr body = collision::prepare(zone.shapes);
  const collision::SweptQuery query = standing_query(body, contact_tolerance_);
  collision::MovingBodies bodies(query);
  const auto met = first_machine_met(exempt_robot, bodies, false);
  if (met || zone.overhead.empty()) return met ? std::optional(met->machine) : std::nullopt;
  const collision::BodyPtr air = collision::prepare(zone.overhead);
  const collision::SweptQuery above = standing_query(air, contact_tolerance_);
  collision::MovingBodies overhead(above);
  for (int i = 0; i < static_cast<int>(robots_.size()); ++i) {
    const RobotEntry& other = entry(i);
    if (i == exempt_robot || !other.load || !other.load->body) continue;
    if (load_volume(other)->meets(overhead)) return i;
  }
  return std::nullopt;
}

std::optional<OtherMet> SiteWorld::zone_around(int component, int robot) const {
  const Component& one = components_[static_cast<std::size_t>(component)];
  if (!one.body || zones_.empty()) return std::nullopt;
  collision::SweptQuery query;
  query.contact_tolerance = contact_tolerance_;
  query.items.push_back({{one.body.get(), geometry::stationary(one.X_WO)}, true});
  collision::MovingBodies bodies(query);
  auto met = first_zone_met(robot, bodies);
  return met ? met : first_zone_below(robot, bodies);
}

bool SiteWorld::has_others(int robot) const {
  const auto keeps_out = [robot](const auto& zone) { return zone.second.exempt_robot != robot; };
  return robots_.size() > 1 || !movings_.empty() ||
         std::any_of(zones_.begin(), zones_.end(), keeps_out);
}

bool SiteWorld::is_alone_in(int robot, const collision::Bounds& bounds) const {
  const auto never_comes = [&](const MovingThing& each) {
    return !each.has_people() && each.reach().disjoint(bounds);
  };
  if (!std::all_of(movings_.begin(), movings_.end(), never_comes)) return false;
  for (int i = 0; i < static_cast<int>(robots_.size()); ++i) {
    if (i != robot && !is_clear_of(entry(i), bounds)) return false;
  }
  return true;
}

namespace {

/// The first zone, by task, that keeps the robot out and whose volume the bodies meet.
template <typename Zones, typename Volume, typename Name>
std::optional<OtherMet> first_zone(const Zones& zones, int robot, collision::MovingBodies& bodies,
                                   Volume volume, Name name) {
  for (const auto& [task, zone] : zones) {
    if (zone.exempt_robot == robot) continue;
    if (const auto hit = (zone.*volume).meets(bodies)) {
      return OtherMet{hit->item, zone.*name, -1, task};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<OtherMet> SiteWorld::first_zone_met(int robot,
                                                  collision::MovingBodies& bodies) const {
  return first_zone(zones_, robot, bodies, &Zone::reserved, &Zone::name);
}

std::optional<OtherMet> SiteWorld::first_zone_below(int robot,
                                                    collision::MovingBodies& loads) const {
  return first_zone(zones_, robot, loads, &Zone::overhead, &Zone::overhead_name);
}

bool SiteWorld::has_people(int robot) const {
  if (std::any_of(movings_.begin(), movings_.end(),
                  [](const MovingThing& each) { return each.has_people(); })) {
    return true;
  }
  return std::any_of(zones_.begin(), zones_.end(),
                     [&](const auto& zone) { return zone.second.exempt_robot != robot; }) ||
         std::any_of(with_people_.begin(), with_people_.end(),
                     [&](int component) { return stands(component); });
}

bool SiteWorld::people_below(int robot, collision::MovingBodies& bodies) const {
  if (first_zone_met(robot, bodies) || first_zone_below(robot, bodies)) return true;
  for (const MovingThing& each : movings_) {
    if (!each.has_people() || !each.is_present(now_)) continue;
    if (each.volume(now_).meets(bodies) || each.overhead(now_).meets(bodies)) return true;
  }
  return std::any_of(with_people_.begin(), with_people_.end(), [&](int component) {
    const Component& each = components_[static_cast<std::size_t>(component)];
    return each.standing && each.people_above && each.people_above->meets(bodies);
  });
}

std::optional<OtherMet> SiteWorld::first_machine_met(int robot, collision::MovingBodies& bodies,
                                                     bool standing_only,
                                                     const std::vector<bool>& are_buffers) const {
  for (int i = 0; i < static_cast<int>(robots_.size()); ++i) {
    const RobotEntry& other = entry(i);
    if (i == robot || (standing_only && other.stepping)) continue;
    if (is_clear_of(other, bodies.bounds())) continue;
    if (const auto hit = reserved_volume(other).meets(bodies, are_buffers)) {
      OtherMet met{hit->item, part_name(other, hit->part), i};
      met.is_fixed = other.robot.is_fixed(hit->part);
      return met;
    }
  }
  return std::nullopt;
}

bool SiteWorld::stands(int component) const {
  return components_[static_cast<std::size_t>(component)].standing;
}

const math::Pose& SiteWorld::X_WO(int component) const {
  return components_[static_cast<std::size_t>(component)].X_WO;
}

const std::string& SiteWorld::component_name(int component) const {
  return components_[static_cast<std::size_t>(component)].name;
}

math::Pose SiteWorld::tool_pose(int robot) const {
  const RobotEntry& at_work = entry(robot);
  return robot::tool_pose(*at_work.robot.model, at_work.robot.mounting, at_work.q);
}

std::uint64_t SiteWorld::version(int robot) const {
  std::uint64_t version = changes_;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (static_cast<int>(i) != robot) version += robots_[i].changes;
  }
  if (entry(robot).near_moving) version += movings_gone_on();
  return version;
}

collision::ObstacleId SiteWorld::insert(const std::string& name, const collision::BodyPtr& body,
                                        const math::Pose& X_WB) {
  const collision::ObstacleId id = obstacles_.insert(body, X_WB);
  names_[id] = name;
  return id;
}

void SiteWorld::erase(collision::ObstacleId id) {
  obstacles_.remove(id);
  names_.erase(id);
}

void SiteWorld::note_change(const Component& component) {
  component_changes_.push_back(static_cast<int>(&component - components_.data()));
}

void SiteWorld::stand(Component& component, const math::Pose& X_WO) {
  component.X_WO = X_WO;
  component.standing = true;
  look_up(component);
  if (component.body) component.id = insert(component.name, component.body, X_WO);
  note_change(component);
  ++changes_;
}

void SiteWorld::add_people(int component, std::vector<geometry::Shape> shapes) {
  Component& one = components_[static_cast<std::size_t>(component)];
  one.people = std::move(shapes);
  if (!one.people.empty()) with_people_.push_back(component);
  look_up(one);
}

/// The air above people, where the component stands.
void SiteWorld::look_up(Component& component) const {
  if (component.people.empty()) return;
  std::vector<geometry::Shape> overhead_W;
  for (geometry::Shape shape : component.people) {
    shape.X_BS = component.X_WO * shape.X_BS;
    const double top = geometry::highest_point(shape) + geometry::kAirOverPeople;
    overhead_W.push_back(geometry::with_what_is_above(shape, top));
  }
  // shared: nobody changes it, and the component may be copied
  component.people_above = std::make_shared<const ReservedVolume>(standing(overhead_W));
}

void SiteWorld::lift(Component& component) {
  if (component.id) erase(*component.id);
  component.id.reset();
  show_soil(static_cast<int>(&component - components_.data()), false);
  component.standing = false;
  note_change(component);
  ++changes_;
}

void SiteWorld::changed(RobotEntry& robot) {
  ++robot.changes;
  robot.changed_at = now_;
  robot.forget_volume();
  robot.workspace_now.reset();
  note_machine_change();
}

bool SiteWorld::is_load(const RobotEntry& robot, int part) {
  return part == robot.robot.load_part();
}

/// By the boxes around them.
bool SiteWorld::is_clear_of(const RobotEntry& robot, const collision::Bounds& bounds) const {
  if (robot.known.bounds && robot.known.bounds->disjoint(bounds)) return true;
  return reserved_volume(robot).bounds().disjoint(bounds);
}

const ReservedVolume& SiteWorld::reserved_volume(const RobotEntry& robot) const {
  if (!robot.reserved) {
    robot.reserved = std::make_unique<ReservedVolume>(reserved_parts(robot),
                                                      reserved_growth(contact_tolerance_));
  }
  return *robot.reserved;
}

/// All that belongs to a machine now.
std::vector<ReservedPart> SiteWorld::reserved_parts(const RobotEntry& robot) const {
  const SiteRobot& machine = robot.robot;
  const std::vector<double>& from = robot.stepping ? robot.step.q_from : robot.q;
  const std::vector<double>& to = robot.stepping ? robot.step.q_to : robot.q;
  std::vector<geometry::Motion> motions = robot.known.motions;
  if (motions.empty()) motions = part_motions(machine, robot.load, from, to);
  std::vector<ReservedPart> parts;
  for (const int rope : machine.ropes) {
    for (RopeVolume& volume : rope_volumes(machine, rope, from, to, motions)) {
      parts.push_back({std::move(volume.body), std::move(volume.motion), rope});
    }
  }
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const bool is_body = i < machine.bodies.size();
    collision::BodyPtr body =
        is_body ? machine.bodies[i] : (robot.load ? robot.load->body : nullptr);
    if (body && !is_body && robot.turn) {
      const math::Pose X_WT = robot::tool_pose(*machine.model, machine.mounting, to);
      motions[i] = turn_motion(X_WT, robot.turn->X_TO, robot.turn->angle_deg);
    }
    if (body) parts.push_back({std::move(body), motions[i], static_cast<int>(i)});
  }
  for (std::size_t i = 0; i < machine.buffers.size(); ++i) {
    const Buffer& buffer = machine.buffers[i];
    parts.push_back({buffer.grown, std::move(motions[static_cast<std::size_t>(buffer.body)]),
                     machine.buffer_part(i), true});
  }
  return parts;
}

const std::string& SiteWorld::part_name(const RobotEntry& robot, int part) {
  return is_load(robot, part) ? robot.load->name : robot.robot.name_of(part);
}

}  // namespace rubicon::site
