#include "src/results/why/scene.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <tuple>
#include <variant>

#include "src/motion/collision/pair/body_depth.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/simulation/site/make_site.hpp"

namespace rubicon::why {

namespace {

bool is_zone_of(const std::string& name, const std::string& task) {
  return name == "the zone of " + task || name == "the air above the zone of " + task;
}

using replay::Leg;
using replay::LoadChange;

/// m: the two bounds of a clearance differ by no more.
constexpr double kClearanceResolution = 1e-3;

collision::BodyPtr prepared(const std::vector<geometry::Shape>& shapes) {
  return shapes.empty() ? nullptr : collision::prepare(shapes);
}

}  // namespace

// ---- what stands there

std::optional<collision::ObstacleId> Scene::World::insert(const std::string& name,
                                                          const collision::BodyPtr& body,
                                                          const math::Pose& X_WB) {
  if (!body) return std::nullopt;
  const collision::ObstacleId id = bodies.insert(body, X_WB);
  things.emplace(id, Thing{name, body, X_WB});
  return id;
}

void Scene::World::remove(collision::ObstacleId id) {
  bodies.remove(id);
  things.erase(id);
}

std::vector<collision::ObstacleId> Scene::World::excepted(int part, const Touches& touches) const {
  std::vector<collision::ObstacleId> ids;
  for (const auto& [id, thing] : things) {
    if (touches.contains({part, thing.name})) ids.push_back(id);
  }
  return ids;
}

Scene::Scene(const replay::Replay& replay, const replay::TaskRun& run)
    : replay_(replay),
      run_(run),
      component_bodies_(replay.header.components.size()),
      components_(replay.header.components.size()) {
  const auto& shapes = replay.header.site;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    obstacles_.insert(site::site_shape_name(replay.header.site_names, i, shapes.size()),
                      prepared({shapes[i]}), math::Pose::Identity());
  }
  add_machines();
  add_changes();
}

void Scene::add_machines() {
  for (const replay::Machine& machine : replay_.machines) {
    // shared: the replay outlives it
    const std::shared_ptr<const robot::RobotModel> model(std::shared_ptr<void>(), &machine.model);
    robots_.push_back(site::make_site_robot(machine.name, model, machine.mounting));
  }
}

void Scene::add_changes() {
  for (const replay::TaskRun& run : replay_.runs) {
    if (!run.happened && &run != &run_) continue;
    for (const replay::Event& event : run.events) {
      if (std::holds_alternative<LoadChange>(event.what) ||
          std::holds_alternative<replay::LoadTurn>(event.what)) {
        changes_.push_back({&event, &run});
      }
    }
  }
  std::sort(changes_.begin(), changes_.end(), [](const Change& a, const Change& b) {
    return std::tie(a.event->time, a.event->line) < std::tie(b.event->time, b.event->line);
  });
}

/// Of its own task the line tells; of others the time does, since a rejected task stands elsewhere
/// in a trace than what went on beside it.
bool Scene::is_past(const Change& change) const {
  return change.run == &run_ ? change.event->line < moment_.line
                             : change.event->time <= moment_.time;
}

void Scene::set_moment(const Moment& moment) {
  moment_ = moment;
  stand_components();
  hang_load();
  stand_others();
}

const collision::BodyPtr& Scene::component_body(std::size_t component) {
  auto& body = component_bodies_[component];
  if (!body) body = prepared(replay_.header.components[component].shapes);
  return *body;
}

void Scene::stand_components() {
  std::vector<Standing> now(components_.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    now[i].stands = true;
    now[i].X_WO = replay_.header.components[i].X_WO;
  }
  for (const Change& change : changes_) {
    if (!is_past(change) || !std::holds_alternative<LoadChange>(change.event->what)) continue;
    const auto& what = std::get<LoadChange>(change.event->what);
    Standing& component = now[index(what.component)];
    component.stands = what.kind == LoadChange::Kind::detach;
    if (component.stands) component.X_WO = what.X;
    component.change = component.stands ? &change : nullptr;
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    Standing& before = components_[i];
    const bool same = before.id && now[i].stands && before.X_WO.matrix() == now[i].X_WO.matrix();
    if (same) {
      now[i].id = before.id;
    } else {
      if (before.id) obstacles_.remove(*before.id);
      if (now[i].stands) {
        now[i].id =
            obstacles_.insert(replay_.header.components[i].name, component_body(i), now[i].X_WO);
      }
    }
  }
  components_ = std::move(now);
}

std::optional<site::Load> Scene::load_of(const replay::Hanging& hanging) {
  if (hanging.component < 0) {
    return site::Load{"load", prepared(replay_.header.carry), hanging.X_TO, 0, -1};
  }
  const std::size_t i = index(hanging.component);
  const trace::HeaderComponent& component = replay_.header.components[i];
  return site::Load{component.name, component_body(i), hanging.X_TO, component.mass,
                    hanging.component};
}

void Scene::hang_load() {
  load_.reset();
  if (run_.robot == 0 && !replay_.header.carry.empty()) load_ = load_of({});
  for (const Change& change : changes_) {
    if (change.run != &run_ || !is_past(change)) continue;
    if (const auto* turn = std::get_if<replay::LoadTurn>(&change.event->what)) {
      if (load_) load_->X_TO = turn->X_TO;
      continue;
    }
    const auto& what = std::get<LoadChange>(change.event->what);
    if (what.kind == LoadChange::Kind::attach) load_ = load_of({what.component, what.X, 0});
    if (what.kind == LoadChange::Kind::detach) load_.reset();
  }
}

const Leg* Scene::leg_at(std::size_t robot) const {
  const std::vector<Leg>& legs = replay_.tracks[robot].legs;
  const auto after = std::upper_bound(legs.begin(), legs.end(), moment_.time,
                                      [](Ticks time, const Leg& leg) { return time < leg.to; });
  return after == legs.end() ? nullptr : &*after;
}

void Scene::stand_machine(std::size_t robot) {
  const Leg* leg = leg_at(robot);
  if (leg == nullptr || leg->moves()) return;
  // A load that people turn moves, too.
  const bool turns =
      leg->hanging >= 0 && replay_.tracks[robot].loads[index(leg->hanging)].turn_deg != 0;
  const site::SiteRobot& machine = robots_[robot];
  std::vector<math::Pose> X_WB;
  robot::body_poses(*machine.model, machine.mounting, leg->q0, X_WB);
  for (std::size_t i = 0; i < machine.bodies.size(); ++i) {
    others_.insert(machine.body_names[i], machine.bodies[i], X_WB[i]);
  }
  for (const int part : machine.ropes) {
    const site::RopeVolume rope = site::standing_rope(machine, part, leg->q0);
    others_.insert(machine.body_names[index(part)], rope.body, rope.motion.pose(0));
  }
  for (std::size_t i = 0; i < machine.buffers.size(); ++i) {
    const site::Buffer& buffer = machine.buffers[i];
    buffers_.insert(machine.buffer_names[i], buffer.grown, X_WB[index(buffer.body)]);
  }
  if (leg->hanging < 0 || turns) return;
  const auto load = load_of(replay_.tracks[robot].loads[index(leg->hanging)]);
  const math::Pose X_WT = robot::tool_pose(*machine.model, machine.mounting, leg->q0);
  others_.insert(load->name, load->body, X_WT * load->X_TO);
}

/// Zones first, then machines, as the site tests them.
void Scene::stand_others() {
  others_ = {};
  buffers_ = {};
  over_people_ = {};
  for (const replay::TaskRun& run : replay_.runs) {
    if (!run.happened || run.task < 0 || run.robot == run_.robot) continue;
    if (run.start > moment_.time || run.end <= moment_.time) continue;
    const trace::HeaderTask& task = replay_.header.tasks[index(run.task)];
    others_.insert("the zone of " + task.name, prepared(task.zones), math::Pose::Identity());
    if (task.zones_overhead.empty()) continue;
    over_people_.insert("the air above the zone of " + task.name, prepared(task.zones_overhead),
                        math::Pose::Identity());
  }
  for (std::size_t robot = 0; robot < robots_.size(); ++robot) {
    if (static_cast<int>(robot) != run_.robot) stand_machine(robot);
  }
}

// ---- questions

const std::string& Scene::part_name(int part) const {
  const site::SiteRobot& robot = robots_[index(run_.robot)];
  return part == robot.load_part() ? load_->name : robot.name_of(part);
}

std::vector<Blocked> Scene::blocking(const AskedStep& asked) const {
  const site::SiteRobot& robot = robots_[index(run_.robot)];
  const site::StepQuery step(robot, load_, asked.q_from, asked.q_to, contact_tolerance(), true);
  std::vector<Blocked> result;
  const auto add = [&](const collision::Contact& contact, const collision::MovingBody& moving,
                       const collision::MovingBody& other, const std::string& moved,
                       const std::string& met) {
    const double depth = collision::body_depth(moving, other, 1);
    result.push_back({moved, met, {contact.fraction, contact.point_W, depth}});
  };
  const auto add_standing = [&](const World& world, const collision::SweptQuery& query,
                                const collision::BlockingPair& pair, int part) {
    const World::Thing& thing = world.things.at(pair.hit.obstacle.value_or(0));
    add(pair.contact, query.items[index(pair.hit.item)].moving,
        {thing.body.get(), geometry::stationary(thing.X_WB)}, part_name(part), thing.name);
  };
  for (const collision::BlockingPair& pair : obstacles_.bodies.explain(step.query())) {
    int moved = step.part_of(pair.hit.item);
    if (pair.hit.obstacle) {
      add_standing(obstacles_, step.query(), pair, moved);
      continue;
    }
    const int other = pair.hit.other_item.value_or(0);
    int met = step.part_of(other);
    if (moved != robot.load_part() && !step.moves(moved)) std::swap(moved, met);
    add(pair.contact, step.query().items[index(pair.hit.item)].moving,
        step.query().items[index(other)].moving, part_name(moved), part_name(met));
  }
  const collision::SweptQuery against_others = step.against_others();
  for (const collision::BlockingPair& pair : others_.bodies.explain(against_others)) {
    add_standing(others_, against_others, pair, step.part_of_mover(pair.hit.item));
  }
  const auto add_some = [&](const World& world, const auto& is_tested) {
    collision::SweptQuery some;
    some.contact_tolerance = against_others.contact_tolerance;
    std::vector<int> parts;
    for (std::size_t i = 0; i < against_others.items.size(); ++i) {
      const int part = step.part_of_mover(static_cast<int>(i));
      if (!is_tested(part)) continue;
      some.items.push_back(against_others.items[i]);
      parts.push_back(part);
    }
    for (const collision::BlockingPair& pair : world.bodies.explain(some)) {
      add_standing(world, some, pair, parts[index(pair.hit.item)]);
    }
  };
  add_some(buffers_, [&](int part) { return !robot.is_buffer(part); });
  add_some(over_people_, [&](int part) { return part == robot.load_part(); });
  return result;
}

bool Scene::look_for_miss(const AskedStep& asked, const Touches& except,
                          NearestMiss& nearest) const {
  const site::SiteRobot& robot = robots_[index(run_.robot)];
  const site::StepQuery step(robot, load_, asked.q_from, asked.q_to, contact_tolerance(), true);
  const collision::SweptQuery movers = step.against_others();
  bool nearer = false;
  for (std::size_t i = 0; i < movers.items.size(); ++i) {
    const int part = step.part_of_mover(static_cast<int>(i));
    if (robot.is_buffer(part)) continue;
    for (const World* world : worlds()) {
      collision::SweptQuery query;
      query.contact_tolerance = movers.contact_tolerance;
      query.items = {movers.items[i]};
      query.ignore = world->excepted(part, except);
      const double range = nearest.found ? nearest.at_most : nearest.range;
      const collision::Clearance found =
          world->bodies.clearance(query, range, kClearanceResolution);
      nearest.at_least = std::min(nearest.at_least, found.lower_bound);
      if (!found.pair || (nearest.found && found.upper_bound >= nearest.at_most)) continue;
      nearer = nearest.found = true;
      nearest.at_most = found.upper_bound;
      nearest.share = found.fraction;
      nearest.moved = part_name(part);
      nearest.met = world->things.at(found.pair->obstacle.value_or(0)).name;
      nearest.moved_point_W = found.point_moving_W;
      nearest.met_point_W = found.point_met_W;
    }
  }
  return nearer;
}

void Scene::add_touches(std::span<const double> q, double gap, Touches& touches) const {
  const site::SiteRobot& robot = robots_[index(run_.robot)];
  const std::vector<geometry::Motion> motions = site::part_motions(robot, load_, q, q);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const int part = static_cast<int>(i);
    collision::BodyPtr body = i < robot.bodies.size() ? robot.bodies[i]
                              : load_                 ? load_->body
                                                      : nullptr;
    math::Pose X_WB = motions[i].pose(0);
    if (robot.is_rope(part)) {
      site::RopeVolume rope = site::standing_rope(robot, part, q);
      body = std::move(rope.body);
      X_WB = rope.motion.pose(0);
    }
    if (body == nullptr) continue;
    for (const World* world : worlds()) {
      collision::SweptQuery query;
      query.contact_tolerance = contact_tolerance();
      query.items = {{{body.get(), geometry::stationary(X_WB)}, true}};
      while (true) {
        query.ignore = world->excepted(part, touches);
        const auto near = world->bodies.clearance(query, gap, kClearanceResolution);
        if (!near.pair) break;
        touches.emplace(part, world->things.at(near.pair->obstacle.value_or(0)).name);
      }
    }
  }
}

// ---- who put it there

const std::string& Scene::task_name(const replay::TaskRun& run) const {
  static const std::string kParking = "parking";
  return run.task < 0 ? kParking : replay_.header.tasks[index(run.task)].name;
}

std::optional<Origin> Scene::machine_origin(std::size_t robot) const {
  Origin origin;
  origin.kind = static_cast<int>(robot) == run_.robot ? Origin::Kind::own : Origin::Kind::machine;
  if (origin.kind == Origin::Kind::own) return origin;
  const replay::TaskRun* last = nullptr;
  for (const replay::TaskRun& run : replay_.runs) {
    if (!run.happened || run.robot != static_cast<int>(robot) || run.start > moment_.time) continue;
    if (last == nullptr || last->start <= run.start) last = &run;
  }
  if (last == nullptr) return origin;
  origin.task = task_name(*last);
  origin.at_work = last->end > moment_.time;
  origin.since = trace::seconds(origin.at_work ? last->start : last->end);
  return origin;
}

std::optional<Origin> Scene::origin_of(const std::string& name) const {
  const auto& shapes = replay_.header.site;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (site::site_shape_name(replay_.header.site_names, i, shapes.size()) == name) return Origin{};
  }
  for (std::size_t i = 0; i < components_.size(); ++i) {
    if (!components_[i].id || replay_.header.components[i].name != name) continue;
    Origin origin;
    origin.kind = Origin::Kind::component;
    if (const Change* change = components_[i].change) {
      origin.task = task_name(*change->run);
      origin.since = trace::seconds(change->event->time);
    }
    return origin;
  }
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    for (const auto* names : {&robots_[i].body_names, &robots_[i].buffer_names}) {
      if (std::find(names->begin(), names->end(), name) != names->end()) return machine_origin(i);
    }
  }
  for (const replay::TaskRun& run : replay_.runs) {
    if (!run.happened || run.task < 0 || !is_zone_of(name, task_name(run))) continue;
    return Origin{Origin::Kind::zone, task_name(run), trace::seconds(run.start), true};
  }
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const Leg* leg = static_cast<int>(i) == run_.robot ? nullptr : leg_at(i);
    if (leg == nullptr || leg->hanging < 0) continue;
    const int component = replay_.tracks[i].loads[index(leg->hanging)].component;
    if (component >= 0 && replay_.header.components[index(component)].name == name) {
      return machine_origin(i);
    }
  }
  return std::nullopt;
}

}  // namespace rubicon::why
