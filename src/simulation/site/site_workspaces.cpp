#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "src/motion/geometry/extent.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/robot/turns.hpp"
#include "src/simulation/site/site_world.hpp"

namespace rubicon::site {

namespace {

using math::at;

constexpr double kSecondInTicks = 1e9;
/// s between the places at which people with a timetable are looked for.
constexpr double kLookApart = 0.5;

}  // namespace

void SiteWorld::set_workspaces(WorkspaceRules rules) {
  workspaces_ = std::move(rules);
  for (const int robot : workspaces_.order)
    entry(robot).corners = corners_of(*entry(robot).robot.model);
  moving_corners_.assign(shown_movings_.size(), {});
  for (std::size_t i = 0; i < shown_movings_.size(); ++i) {
    if (!movings_[i].has_people() || shown_movings_[i] == nullptr) continue;
    std::vector<math::Vec3>& corners = moving_corners_[i].emplace_back();
    for (const geometry::Shape& shape : *shown_movings_[i]) {
      const Eigen::AlignedBox3d box = geometry::extent_of(shape);
      for (int corner = 0; corner < 8; ++corner) {
        corners.emplace_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
      }
    }
  }
}

void SiteWorld::set_partner(int robot, int other) {
  entry(robot).partner = other;
  ++changes_;
}

const PlanRegion& SiteWorld::workspace(int robot) const {
  const RobotEntry& machine = entry(robot);
  if (!machine.workspace_now) {
    const MachineStep& step = machine.step;
    machine.workspace_now =
        machine.stepping ? workspace_of(machine.robot, machine.corners,
                                        {step.q_from, step.q_to, step.q_goal,
                                         static_cast<double>(step.duration) / kSecondInTicks},
                                        workspaces_)
                         : footprint_of(machine.robot, machine.corners, machine.q);
  }
  return *machine.workspace_now;
}

/// The loaded before the others, then by their order.
bool SiteWorld::goes_before(int robot, int other) const {
  const auto key = [&](int each) {
    const bool loaded = entry(each).carries_soil || entry(each).load.has_value();
    return std::tuple(!loaded, workspaces_.rank_of(each));
  };
  return key(robot) < key(other);
}

/// Those named before the robot, in a step of which it is known where it leads: they go on straight
/// to their next waypoint or goal, all parameters together, as fast as the slowest of them allows.
std::vector<ForeseenRegion> SiteWorld::foreseen_regions(int robot) const {
  std::vector<ForeseenRegion> regions;
  for (const int other : workspaces_.order) {
    if (other == robot) break;
    const RobotEntry& machine = entry(other);
    if (!machine.stepping || machine.step.q_aim.empty() || machine.partner == robot) continue;
    const MachineStep& step = machine.step;
    const auto& parameters = machine.robot.model->parameters;
    const bool loaded = machine.carries_soil || machine.load.has_value();
    std::vector<double> way(step.q_to.size());
    double needs = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
      way[i] = robot::way_between(parameters[i], step.q_to[i], step.q_aim[i]);
      const double speed = loaded ? parameters[i].loaded_speed : parameters[i].speed;
      if (speed > 0) needs = std::max(needs, std::fabs(way[i]) / speed);
    }
    const double left =
        workspaces_.foreseen - static_cast<double>(step.end - now_) / kSecondInTicks;
    const double share = needs > 0 ? std::clamp(left / needs, 0.0, 1.0) : 1;
    std::vector<double> q_end = step.q_to;
    for (std::size_t i = 0; i < way.size(); ++i) q_end[i] += way[i] * share;
    ForeseenRegion& foreseen = regions.emplace_back();
    foreseen.robot = other;
    foreseen.seconds = workspaces_.foreseen;
    foreseen.q_aim = step.q_aim;
    foreseen.region = swept_region(machine.robot, machine.corners, step.q_from, step.q_to);
    PlanRegion rest = swept_region(machine.robot, machine.corners, step.q_to, q_end);
    for (PlanPolygon& polygon : rest.polygons) foreseen.region.add(std::move(polygon));
  }
  return regions;
}

void SiteWorld::watch_workspaces(int robot, const interpreter::MotionStep& step) {
  if (!workspaces_.watch || workspaces_.rank_of(robot) < 0) return;
  if (std::equal(step.q_from.begin(), step.q_from.end(), step.q_to.begin())) return;
  RobotEntry& own = entry(robot);
  const PlanRegion region = workspace_of(
      own.robot, own.corners,
      {step.q_from, step.q_to, step.q_goal, static_cast<double>(step.duration) / kSecondInTicks},
      workspaces_);
  for (const int other : workspaces_.order) {
    RobotEntry& machine = entry(other);
    if (other == robot || own.partner == other || machine.partner == robot) continue;
    if (!region.overlaps(workspace(other))) {
      own.too_near.erase(other);
      machine.too_near.erase(robot);
    } else if (own.too_near.insert(other).second) {
      machine.too_near.insert(robot);
      ++own.overlaps;
    }
  }
}

std::optional<OtherMet> SiteWorld::workspace_met(int robot,
                                                 const interpreter::MotionStep& step) const {
  if (step.duration <= 0 || workspaces_.watch) return std::nullopt;
  if (workspaces_.rank_of(robot) < 0) return std::nullopt;
  if (std::equal(step.q_from.begin(), step.q_from.end(), step.q_to.begin())) return std::nullopt;
  const RobotEntry& own = entry(robot);
  const auto seconds = static_cast<double>(step.duration) / kSecondInTicks;
  const PlanRegion region = workspace_of(
      own.robot, own.corners, {step.q_from, step.q_to, step.q_goal, seconds}, workspaces_);
  for (const int other : workspaces_.order) {
    const RobotEntry& machine = entry(other);
    if (other == robot || own.partner == other || machine.partner == robot) continue;
    bool meets = region.overlaps(workspace(other));
    if (!meets && machine.stepping && goes_before(other, robot)) {
      const MachineStep& next = machine.step;
      meets = region.overlaps(workspace_of(machine.robot, machine.corners,
                                           {next.q_from, next.q_to, next.q_goal,
                                            static_cast<double>(next.duration) / kSecondInTicks},
                                           workspaces_, 1));
    }
    if (meets) return OtherMet{0, "the workspace of " + machine.robot.name, other, -1};
  }
  const double ahead = seconds + workspaces_.reaction;
  for (std::size_t i = 0; i < moving_corners_.size(); ++i) {
    const MovingThing& people = movings_[i];
    if (moving_corners_[i].empty() || !people.is_present(now_)) continue;
    for (double time = 0; time <= ahead; time += kLookApart) {
      const math::Pose X_WO = people.state().stop
                                  ? people.pose(now_)
                                  : people.pose(now_ + static_cast<Ticks>(time * kSecondInTicks));
      std::vector<Eigen::Vector2d> points;
      for (const math::Vec3& p : moving_corners_[i].front()) {
        points.emplace_back((X_WO * p).head<2>());
      }
      PlanRegion place;
      place.add(std::move(points));
      if (region.overlaps(place)) {
        return OtherMet{0, people.name(), -1, -1, static_cast<int>(i)};
      }
    }
  }
  return std::nullopt;
}

}  // namespace rubicon::site
