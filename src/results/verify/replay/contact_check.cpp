#include "src/results/verify/replay/contact_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/replay/dug_soil.hpp"

namespace rubicon::verify {

namespace {

using math::at;

const Solid& solid_in(const RobotPart& part, const PartState& state) {
  return state.solid ? *state.solid : *part.solid;
}

class ContactCheck {
 public:
  ContactCheck(const Trace& trace, const std::vector<TaskRun>& runs,
               const std::vector<RobotTrack>& tracks, const SiteParts& site,
               const std::vector<MovingPath>& movings, Faults& faults)
      : trace_(trace),
        runs_(runs),
        tracks_(tracks),
        site_(site),
        movings_(movings),
        faults_(faults),
        cuts_(trace, runs) {
    obstacles_ = site.obstacles;
    obstacles_.insert(obstacles_.end(), site.zones.begin(), site.zones.end());
    std::vector<Bounds> boxes;
    for (const Obstacle& each : obstacles_) boxes.push_back(each.solid->bounds.placed(each.X_WS));
    tree_ = BoxTree(boxes);
  }

  ContactCounts check() {
    const int robots = static_cast<int>(tracks_.size());
    for (int robot = 0; robot < robots; ++robot) check_robot(robot);
    for (int a = 0; a < robots; ++a) {
      for (int b = a + 1; b < robots; ++b) check_robots(a, b);
    }
    check_zones();
    forget_beginning();
    for (const MovingPath& moving : movings_) check_moving(moving);
    return counts_;
  }

 private:
  const Leg& leg(int robot, std::size_t index) const { return tracks_[at(robot)].legs[index]; }

  /// Whether anything of the robot moves.
  bool moves(int robot, const Leg& leg) const {
    return leg.moves() ||
           (leg.hanging >= 0 && tracks_[at(robot)].loads[at(leg.hanging)].turn_deg != 0);
  }

  /// A robot's bodies, then what hangs on its tool, then the buffers.
  std::vector<RobotPart> parts_of(int robot, const Leg& leg) const {
    const RobotParts& machine = site_.robots[at(robot)];
    std::vector<RobotPart> parts = machine.bodies;
    if (leg.hanging >= 0) add_load(tracks_[at(robot)].loads[at(leg.hanging)], machine, parts);
    parts.insert(parts.end(), machine.buffers.begin(), machine.buffers.end());
    return parts;
  }

  void add_load(const Hanging& load, const RobotParts& machine,
                std::vector<RobotPart>& parts) const {
    const auto& solid = load.component < 0 ? site_.carry : site_.components[at(load.component)];
    if (!solid) return;
    parts.push_back({solid.get(), machine.mechanism->tool(), load.X_TO,
                     load.component < 0 ? "load" : trace_.scene.components[at(load.component)].name,
                     nullptr, load.turn_deg});
  }

  void check_robot(int robot) {
    std::vector<Bounds>& boxes = leg_boxes_.emplace_back();
    for (const Leg& each : tracks_[at(robot)].legs) {
      const LegFrames frames(*site_.robots[at(robot)].mechanism, each);
      const std::vector<RobotPart> parts = parts_of(robot, each);
      Bounds whole;
      for (const RobotPart& part : parts) {
        const PartState state = LegPart(frames, part).state(0, 1);
        const double reach = state.reach.most();
        if (!std::isfinite(reach) || !state.X_WS.matrix().allFinite()) {
          fault(FaultKind::motion, each, each.from, part.name + " moves without bound");
          continue;
        }
        const Bounds box =
            solid_in(part, state).bounds.placed(state.X_WS).grown(reach + kBoundsMargin);
        whole.add(box);
        if (reach > 0) check_obstacles(robot, frames, part, is_load(robot, parts, part), box);
      }
      boxes.push_back(whole);
      if (!moves(robot, each)) continue;
      ++counts_.steps;
      check_own_pairs(robot, frames, parts);
    }
  }

  /// What hangs on the robot comes after its bodies.
  bool is_load(int robot, const std::vector<RobotPart>& parts, const RobotPart& part) const {
    return !part.is_buffer &&
           static_cast<std::size_t>(&part - parts.data()) >= site_.robots[at(robot)].bodies.size();
  }

  void check_obstacles(int robot, const LegFrames& frames, const RobotPart& part, bool is_load,
                       const Bounds& box) {
    const Leg& each = frames.leg();
    const int load = each.hanging < 0 ? -1 : tracks_[at(robot)].loads[at(each.hanging)].component;
    tree_.meeting(box, [&](int index) {
      const Obstacle& obstacle = obstacles_[at(index)];
      if (obstacle.exempt == robot || (load >= 0 && obstacle.component == load)) return;
      if (obstacle.for_loads && !is_load) return;
      if (may_enter(robot, each, part, obstacle)) return;
      const auto [s0, s1] = shares(each, obstacle.from, obstacle.to);
      if (!(s0 < s1)) return;
      const LegPart motion(frames, part, -1, s0, s1);
      const auto contact = sweep(*part.solid, motion, *obstacle.solid, StandingPart(obstacle.X_WS));
      if (contact) report(each, s0 + contact->u * (s1 - s0), part.name, obstacle.name, *contact);
    });
  }

  std::string tool_name(int robot) const {
    const SceneRobot& one = trace_.scene.robots[at(robot)];
    return one.name + "." + one.bodies[at(one.tool_body)].name;
  }

  /// Whether the task says that the body may cut into the component.
  bool may_enter(int robot, const Leg& each, const RobotPart& part,
                 const Obstacle& obstacle) const {
    if (each.run < 0 || obstacle.component < 0 || runs_[at(each.run)].task < 0) return false;
    if (cuts_.allow(each, obstacle.component) && part.name == tool_name(robot)) {
      return true;
    }
    const auto& entered = trace_.scene.tasks[at(runs_[at(each.run)].task)].entered;
    const std::string prefix = trace_.scene.robots[at(robot)].name + ".";
    return std::any_of(entered.begin(), entered.end(), [&](const auto& pair) {
      return pair.second == obstacle.component &&
             (part.name == pair.first || part.name == prefix + pair.first ||
              part.name == buffer_name(prefix + pair.first));
    });
  }

  /// The shares of a leg between which two moments lie, both 0 if they do not.
  static std::pair<double, double> shares(const Leg& leg, Ticks from, Ticks to) {
    if (leg.from >= leg.to) {
      const bool then = from <= leg.from && leg.from <= to;
      return then ? std::pair(0.0, 1.0) : std::pair(0.0, 0.0);
    }
    const Ticks begin = std::max(leg.from, from);
    const Ticks end = std::min(leg.to, to);
    if (begin >= end) return {0, 0};
    const auto share = [&](Ticks time) {
      return static_cast<double>(time - leg.from) / static_cast<double>(leg.to - leg.from);
    };
    return {share(begin), share(end)};
  }

  std::optional<Contact> sweep(const Solid& a, const PartMotion& motion_a, const Solid& b,
                               const PartMotion& motion_b) {
    ++counts_.pairs;
    return PairSweep(a, motion_a, b, motion_b, trace_.scene.contact).run();
  }

  /// A robot's own bodies against each other, and its load against them but for the tool.
  void check_own_pairs(int robot, const LegFrames& frames, const std::vector<RobotPart>& parts) {
    const RobotParts& machine = site_.robots[at(robot)];
    std::vector<std::pair<int, int>> pairs = machine.own_pairs;
    if (parts.size() > machine.bodies.size() + machine.buffers.size()) {
      const int load = static_cast<int>(machine.bodies.size());
      for (int i = 0; i < load; ++i) {
        const int tool = trace_.scene.robots[at(robot)].tool_body;
        const RobotPart& part = parts[at(i)];
        if (part.frame == tool || (part.rope != nullptr && part.rope->from == tool)) continue;
        pairs.emplace_back(load, i);
      }
    }
    for (const auto& [first, second] : pairs) {
      const RobotPart& a = parts[at(first)];
      const RobotPart& b = parts[at(second)];
      int base = machine.mechanism->common_frame(a.frame, b.frame);
      for (const RobotPart* part : {&a, &b}) {
        if (part->rope != nullptr) base = machine.mechanism->common_frame(base, part->rope->from);
      }
      const LegPart motion_a(frames, a, base);
      const LegPart motion_b(frames, b, base);
      const PartState state_a = motion_a.state(0, 1);
      const PartState state_b = motion_b.state(0, 1);
      const double reach = (state_a.reach + state_b.reach).most();
      const Bounds box_a =
          solid_in(a, state_a).bounds.placed(state_a.X_WS).grown(reach + kBoundsMargin);
      if (!(reach > 0) || !box_a.meets(solid_in(b, state_b).bounds.placed(state_b.X_WS))) continue;
      const auto contact = sweep(*a.solid, motion_a, *b.solid, motion_b);
      if (contact) report(frames.leg(), contact->u, a.name, b.name, *contact);
    }
  }

  /// Two robots through the whole plan.
  void check_robots(int a, int b) {
    const auto& legs_a = tracks_[at(a)].legs;
    const auto& legs_b = tracks_[at(b)].legs;
    std::size_t first = 0;
    for (std::size_t i = 0; i < legs_a.size(); ++i) {
      while (first < legs_b.size() && legs_b[first].to < legs_a[i].from) ++first;
      for (std::size_t j = first; j < legs_b.size() && legs_b[j].from <= legs_a[i].to; ++j) {
        if (!moves(a, legs_a[i]) && !moves(b, legs_b[j])) continue;
        if (!leg_boxes_[at(a)][i].meets(leg_boxes_[at(b)][j])) continue;
        check_legs(a, legs_a[i], b, legs_b[j]);
      }
    }
  }

  void check_legs(int a, const Leg& leg_a, int b, const Leg& leg_b) {
    const auto [a0, a1] = shares(leg_a, leg_b.from, leg_b.to);
    const auto [b0, b1] = shares(leg_b, leg_a.from, leg_a.to);
    if (!(a0 < a1) || !(b0 < b1)) return;
    const LegFrames frames_a(*site_.robots[at(a)].mechanism, leg_a);
    const LegFrames frames_b(*site_.robots[at(b)].mechanism, leg_b);
    // The one who began later is the one who should not have.
    const bool b_is_later = moves(b, leg_b) && (!moves(a, leg_a) || leg_b.from > leg_a.from);
    for (const RobotPart& part_a : parts_of(a, leg_a)) {
      for (const RobotPart& part_b : parts_of(b, leg_b)) {
        if (part_a.is_buffer && part_b.is_buffer) continue;
        const LegPart motion_a(frames_a, part_a, -1, a0, a1);
        const LegPart motion_b(frames_b, part_b, -1, b0, b1);
        const PartState state_a = motion_a.state(0, 1);
        const PartState state_b = motion_b.state(0, 1);
        const double reach = (state_a.reach + state_b.reach).most() + kBoundsMargin;
        if (!solid_in(part_a, state_a)
                 .bounds.placed(state_a.X_WS)
                 .grown(reach)
                 .meets(solid_in(part_b, state_b).bounds.placed(state_b.X_WS))) {
          continue;
        }
        const auto contact = sweep(*part_a.solid, motion_a, *part_b.solid, motion_b);
        if (!contact) continue;
        if (b_is_later) {
          report(leg_b, b0 + contact->u * (b1 - b0), part_b.name, part_a.name, *contact);
        } else {
          report(leg_a, a0 + contact->u * (a1 - a0), part_a.name, part_b.name, *contact);
        }
      }
    }
  }

  /// Robots that stand where people work.
  void check_zones() {
    for (const Obstacle& zone : site_.zones) {
      const Bounds box = zone.solid->bounds.grown(kBoundsMargin);
      for (int robot = 0; robot < static_cast<int>(tracks_.size()); ++robot) {
        const auto& legs = tracks_[at(robot)].legs;
        for (std::size_t i = 0; robot != zone.exempt && i < legs.size(); ++i) {
          const bool meanwhile = std::max(legs[i].from, zone.from) < std::min(legs[i].to, zone.to);
          if (legs[i].moves() || !meanwhile || !leg_boxes_[at(robot)][i].meets(box)) continue;
          check_standing(robot, legs[i], zone);
        }
      }
    }
  }

  void check_standing(int robot, const Leg& each, const Obstacle& zone) {
    const LegFrames frames(*site_.robots[at(robot)].mechanism, each);
    const std::vector<RobotPart> parts = parts_of(robot, each);
    for (const RobotPart& part : parts) {
      if (zone.for_loads && !is_load(robot, parts, part)) continue;
      const auto contact =
          sweep(*part.solid, LegPart(frames, part), *zone.solid, StandingPart(zone.X_WS));
      if (contact) report(each, 0, part.name, zone.name, *contact);
    }
  }

  static Bounds box_of(const Solid& solid, const PartMotion& motion) {
    const PartState state = motion.state(0, 1);
    return solid.bounds.placed(state.X_WS).grown(state.reach.most() + kBoundsMargin);
  }

  /// Where something with a timetable begins in what stands the header tells it.
  void forget_beginning() {
    if (!trace_.scene.beginning) return;
    for (const SceneOverlap& each : trace_.scene.beginning->overlaps) {
      const bool is_moving = std::any_of(movings_.begin(), movings_.end(), [&](const auto& moving) {
        return moving.name() == each.second;
      });
      if (!is_moving) continue;
      reported_.emplace(-1, each.first, each.second);
      reported_.emplace(-1, each.second, each.first);
    }
  }

  /// Something with a timetable against every robot at the same time, what is above its people
  /// against their loads, and itself against all that stands meanwhile.
  void check_moving(const MovingPath& moving) {
    if (moving.solid() == nullptr) return;
    for (int robot = 0; robot < static_cast<int>(tracks_.size()); ++robot) {
      const auto& legs = tracks_[at(robot)].legs;
      for (std::size_t i = 0; i < legs.size(); ++i) {
        const Leg& each = legs[i];
        moving.stretches(each.from, each.to, !moves(robot, each),
                         [&](const MovingStretch& stretch) {
                           check_beside(robot, each, leg_boxes_[at(robot)][i], moving, stretch);
                         });
      }
    }
    for (const Obstacle& obstacle : site_.obstacles) {
      const Bounds box = obstacle.solid->bounds.placed(obstacle.X_WS);
      moving.stretches(obstacle.from, obstacle.to, true, [&](const MovingStretch& stretch) {
        const MovingPart part(*moving.solid(), stretch);
        if (!box_of(*moving.solid(), part).meets(box)) return;
        const auto contact =
            sweep(*moving.solid(), part, *obstacle.solid, StandingPart(obstacle.X_WS));
        if (!contact || !reported_.emplace(-1, moving.name(), obstacle.name).second) return;
        faults_.push_back(
            {FaultKind::contact, ResultFile::trace, 0, "",
             stretch.from +
                 static_cast<Ticks>(contact->u * static_cast<double>(stretch.to - stretch.from)),
             fmt::format("{} meets {}", moving.name(), obstacle.name)});
      });
    }
  }

  void check_beside(int robot, const Leg& each, const Bounds& leg_box, const MovingPath& moving,
                    const MovingStretch& stretch) {
    const auto [s0, s1] =
        each.from < each.to ? shares(each, stretch.from, stretch.to) : std::pair(0.0, 1.0);
    if (!(s0 < s1)) return;
    for (const Solid* solid : {moving.solid(), moving.overhead()}) {
      if (solid == nullptr) continue;
      const MovingPart motion_b(*solid, stretch);
      const Bounds box = box_of(*solid, motion_b);
      if (!box.meets(leg_box)) continue;
      const LegFrames frames(*site_.robots[at(robot)].mechanism, each);
      const std::vector<RobotPart> parts = parts_of(robot, each);
      for (const RobotPart& part : parts) {
        if (solid == moving.overhead() && !is_load(robot, parts, part)) continue;
        const LegPart motion_a(frames, part, -1, s0, s1);
        const PartState state = motion_a.state(0, 1);
        if (!solid_in(part, state)
                 .bounds.placed(state.X_WS)
                 .grown(state.reach.most() + kBoundsMargin)
                 .meets(box)) {
          continue;
        }
        const auto contact = sweep(*part.solid, motion_a, *solid, motion_b);
        if (!contact) continue;
        report(each, s0 + contact->u * (s1 - s0), part.name,
               solid == moving.solid() ? moving.name() : air_above(moving.name()), *contact);
      }
    }
  }

  /// Once for each pair and task: what comes after the first contact follows from it.
  void report(const Leg& each, double share, const std::string& moved, const std::string& met,
              const Contact& contact) {
    if (!reported_.emplace(each.run, moved, met).second) return;
    const auto time =
        each.from + static_cast<Ticks>(share * static_cast<double>(each.to - each.from));
    const std::string how = contact.depth > 0
                                ? fmt::format("at least {:.1f} mm deep", contact.depth * 1000)
                                : "they cannot be told apart";
    fault(FaultKind::contact, each, time, fmt::format("{} meets {} ({})", moved, met, how));
  }

  void fault(FaultKind kind, const Leg& each, Ticks time, std::string text) {
    const std::string task = each.run < 0 ? "" : trace_.runs[at(runs_[at(each.run)].run)];
    faults_.push_back({kind, ResultFile::trace, each.line, task, time, std::move(text)});
  }

  const Trace& trace_;
  const std::vector<TaskRun>& runs_;
  const std::vector<RobotTrack>& tracks_;
  const SiteParts& site_;
  const std::vector<MovingPath>& movings_;
  Faults& faults_;
  Cuts cuts_;
  std::vector<Obstacle> obstacles_;
  BoxTree tree_;
  std::vector<std::vector<Bounds>> leg_boxes_;  ///< by robot and leg
  std::set<std::tuple<int, std::string, std::string>> reported_;
  ContactCounts counts_;
};

}  // namespace

ContactCounts check_contacts(const Trace& trace, const std::vector<TaskRun>& runs,
                             const std::vector<RobotTrack>& tracks, const SiteParts& site,
                             const std::vector<MovingPath>& movings, Faults& faults) {
  return ContactCheck(trace, runs, tracks, site, movings, faults).check();
}

}  // namespace rubicon::verify
