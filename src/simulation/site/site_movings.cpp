#include <algorithm>
#include <utility>

#include "src/simulation/site/site_world.hpp"

namespace rubicon::site {

int SiteWorld::add_moving(std::string name, collision::BodyPtr body, collision::BodyPtr overhead,
                          geometry::Timetable timetable) {
  movings_.emplace_back(std::move(name), std::move(body), std::move(overhead), std::move(timetable),
                        contact_tolerance_);
  ++changes_;
  return static_cast<int>(movings_.size()) - 1;
}

void SiteWorld::set_moving_state(int index, MovingState state) {
  movings_[static_cast<std::size_t>(index)].set_state(std::move(state));
  ++changes_;
}

void SiteWorld::note_machine_change() {
  ++machine_changes_;
  moved_before_ = movings_gone_on();
  quiet_since_ = now_;
}

std::uint64_t SiteWorld::movings_gone_on() const {
  const Ticks until = std::min(now_, movings_worth_waiting());
  return moved_before_ + static_cast<std::uint64_t>(std::max<Ticks>(until - quiet_since_, 0));
}

Ticks SiteWorld::movings_worth_waiting() const {
  Ticks until = 0;
  for (const MovingThing& each : movings_) {
    if (each.is_gone(now_)) continue;
    const Ticks its = each.repeats() ? quiet_since_ + each.period() : each.last_time();
    until = std::max(until, its);
  }
  return schedule::within_time(until);
}

std::optional<ReservedVolume> SiteWorld::load_volume(const RobotEntry& robot) const {
  if (!robot.load || !robot.load->body) return std::nullopt;
  std::vector<ReservedPart> parts = reserved_parts(robot);
  std::erase_if(parts, [&](const ReservedPart& part) { return !is_load(robot, part.part); });
  return ReservedVolume(std::move(parts), reserved_growth(contact_tolerance_));
}

/// The first machine whose volume the thing would enter, or whose load would hang over it.
std::optional<MovingStop> SiteWorld::machine_on_way(const collision::SweptQuery& query,
                                                    bool has_people) const {
  collision::SweptQuery alone = query;
  alone.items.resize(1);
  collision::MovingBodies bodies(alone);
  for (int i = 0; i < static_cast<int>(robots_.size()); ++i) {
    const RobotEntry& robot = entry(i);
    if (const auto hit = reserved_volume(robot).meets(bodies)) {
      return MovingStop{now_, part_name(robot, hit->part), i, -1};
    }
  }
  if (!has_people) return std::nullopt;
  collision::SweptQuery above = query;
  above.items.erase(above.items.begin());
  collision::MovingBodies air(above);
  for (int i = 0; i < static_cast<int>(robots_.size()); ++i) {
    const auto load = load_volume(entry(i));
    if (load && load->meets(air)) return MovingStop{now_, entry(i).load->name, i, -1};
  }
  return std::nullopt;
}

bool SiteWorld::is_free_of_obstacles(const MovingThing& thing, int window) const {
  const std::uint64_t changes = component_changes_.size() + 1;
  if (thing.known(window).standing == changes) return true;
  if (has_obstacles() && obstacles_.test(thing.query(window)).hit) return false;
  thing.known(window).standing = changes;
  return true;
}

/// What is on its way in a window: a machine, what stands, another thing with a timetable.
std::optional<MovingStop> SiteWorld::what_stops(int moving, int window) const {
  const MovingThing& thing = this->moving(moving);
  const collision::SweptQuery& query = thing.query(window);
  if (thing.known(window).machines != all_changes()) {
    if (auto stop = machine_on_way(query, thing.has_people())) return stop;
    thing.known(window).machines = all_changes();
  }
  if (!is_free_of_obstacles(thing, window)) {
    const auto hit = obstacles_.test(query).hit;
    return MovingStop{now_, obstacle_name(*hit->obstacle), -1, -1};
  }
  collision::SweptQuery alone = query;
  alone.items.resize(1);
  collision::MovingBodies bodies(alone);
  for (int i = 0; i < movings(); ++i) {
    const MovingThing& other = this->moving(i);
    if (i == moving || !other.is_present(now_)) continue;
    if (other.volume(now_).meets(bodies)) return MovingStop{now_, other.name(), -1, i};
  }
  return std::nullopt;
}

/// Whether anything may be on its way in the window, seen by boxes where that is enough.
bool SiteWorld::has_to_look(int moving, int window) const {
  const MovingThing& thing = this->moving(moving);
  const collision::Bounds& bounds = thing.bounds(window);
  if (thing.known(window).machines != all_changes()) {
    for (const RobotEntry& robot : robots_) {
      if (!reserved_volume(robot).bounds().disjoint(bounds)) return true;
    }
    thing.known(window).machines = all_changes();
  }
  if (!is_free_of_obstacles(thing, window)) return true;
  return std::any_of(movings_.begin(), movings_.end(), [&](const MovingThing& other) {
    return &other != &thing && !other.is_gone(now_) && !other.reach().disjoint(bounds);
  });
}

/// What has to change before a thing that stands looks again.
std::uint64_t SiteWorld::changes_of(const MovingStop& stop) const {
  if (stop.moving >= 0) return all_changes() + static_cast<std::uint64_t>(now_);
  return changes_ + (stop.machine >= 0 ? entry(stop.machine).changes : 0);
}

std::vector<MovingEvent> SiteWorld::look_at_movings() {
  std::vector<MovingEvent> events;
  looked_at_.resize(movings_.size(), 0);
  for (int i = 0; i < movings(); ++i) {
    MovingThing& thing = movings_[static_cast<std::size_t>(i)];
    std::uint64_t& looked_at = looked_at_[static_cast<std::size_t>(i)];
    if (thing.is_gone(now_)) continue;
    const bool stood = thing.state().stop.has_value();
    const int window = thing.window_at(now_);
    if (stood && looked_at == changes_of(*thing.state().stop)) continue;
    if (!stood && (thing.window_begin(now_, 0) != now_ || !has_to_look(i, window))) continue;
    std::optional<MovingStop> stop = what_stops(i, window);
    if (stop) looked_at = changes_of(*stop);
    if (stop && stood) {
      stop->since = thing.state().stop->since;
      const bool by_same = stop->by == thing.state().stop->by;
      thing.stop(*stop);
      if (by_same) continue;
    } else if (stop) {
      thing.stop(*stop);
    } else if (stood) {
      thing.go_on(now_);
    } else {
      continue;
    }
    const std::optional<MovingStop>& stands = thing.state().stop;
    const Ticks stood_for = stands ? now_ - stands->since : 0;
    events.push_back({i, now_, std::move(stop), thing.state().delay + stood_for});
    // Whether it stands or goes decides what machines may do, and other things with a timetable.
    ++changes_;
    if (thing.state().stop) looked_at = changes_of(*thing.state().stop);
  }
  return events;
}

/// When the first window after the present one begins in which it has to look.
Ticks SiteWorld::find_next_look(int moving) const {
  const MovingThing& thing = this->moving(moving);
  if (thing.is_gone(now_)) return schedule::kEndOfTime;
  if (const auto& stop = thing.state().stop) {
    return stop->moving < 0 ? schedule::kEndOfTime : this->moving(stop->moving).next_window(now_);
  }
  const int first = thing.is_present(now_) ? 1 : 0;
  for (int ahead = first; ahead < thing.windows() + first; ++ahead) {
    const int window = thing.window_after(now_, ahead);
    if (window < 0) break;
    if (has_to_look(moving, window)) return thing.window_begin(now_, ahead);
  }
  return schedule::kEndOfTime;
}

Ticks SiteWorld::next_moving_look() {
  if (movings_.empty()) return schedule::kEndOfTime;
  if (looks_.size() != movings_.size() || looks_at_ != all_changes()) {
    looks_.assign(movings_.size(), -1);
    looks_at_ = all_changes();
  }
  Ticks next = schedule::kEndOfTime;
  for (int i = 0; i < movings(); ++i) {
    Ticks& look = looks_[static_cast<std::size_t>(i)];
    if (look <= now_) look = find_next_look(i);
    next = std::min(next, look);
  }
  return next;
}

bool SiteWorld::is_on_its_way(int moving) const {
  const MovingThing& thing = this->moving(moving);
  if (thing.state().stop || !thing.is_present(now_)) return false;
  const Ticks soon = now_ + schedule::kSecond / 1000;
  constexpr double kStands = 1e-9;  // m, and of directions
  return (thing.pose(now_).matrix() - thing.pose(soon).matrix()).cwiseAbs().maxCoeff() > kStands;
}

std::optional<OtherMet> SiteWorld::first_moving_met(int robot, collision::MovingBodies& bodies,
                                                    Ticks until, bool overhead) const {
  for (int i = 0; i < movings(); ++i) {
    const MovingThing& thing = movings_[static_cast<std::size_t>(i)];
    if (overhead && !thing.has_people()) continue;
    if (!bodies.bounds().disjoint(thing.reach())) entry(robot).near_moving = true;
    if (const auto hit = thing.meets(bodies, now_, until, overhead)) {
      OtherMet met{hit->item, overhead ? "the air above " + thing.name() : thing.name()};
      met.moving = i;
      return met;
    }
  }
  return std::nullopt;
}

}  // namespace rubicon::site
