#include "src/site/robot_view.hpp"

#include <algorithm>
#include <utility>

#include "src/math/angles.hpp"
#include "src/robot/body_motion.hpp"
#include "src/site/attached_motion.hpp"
#include "src/site/load_chart.hpp"

namespace rubicon::site {

namespace {

/// m: how exactly `free` is found. Far below every contact tolerance in use; each halving costs a
/// query.
constexpr double kFreeDistanceResolution = 1e-6;

/// m: rounding of a radius along a step that keeps it. A load at the limit of its chart must still
/// be allowed to turn.
constexpr double kRadiusRounding = 1e-9;

}  // namespace

std::optional<interpreter::HitPair> RobotView::propose(const interpreter::MotionStep& step) {
  if (auto pair = refusal(step)) return pair;
  std::vector<double> q(step.q_to.begin(), step.q_to.end());
  robot::normalise(*robot().model, q);
  site_.set_configuration(index_, std::move(q));
  return std::nullopt;
}

bool RobotView::would_accept(const interpreter::MotionStep& step) const { return !refusal(step); }

bool RobotView::situation(const std::string& name) const {
  const auto& load = site_.load(index_);
  return load && load->component >= 0 && name == "transport";
}

bool RobotView::nothing_to_meet() const {
  return !site_.has_obstacles() && robot().own_pairs.empty() && !site_.load(index_);
}

std::optional<interpreter::HitPair> RobotView::refusal(const interpreter::MotionStep& step) const {
  if (nothing_to_meet()) return std::nullopt;
  if (auto pair = swept_hit(step)) return pair;
  return overload(step);
}

/// The load chart: a load heavier than the chart allows may only come nearer in.
std::optional<interpreter::HitPair> RobotView::overload(const interpreter::MotionStep& step) const {
  const SiteRobot& machine = robot();
  const auto& load = site_.load(index_);
  if (!load || load->mass <= 0 || machine.model->capacity.empty()) return std::nullopt;
  const auto radius = [&](std::span<const double> q) {
    return chart_radius(machine.mounting.X_WM,
                        robot::tool_pose(*machine.model, machine.mounting, q).translation());
  };
  const double after = radius(step.q_to);
  if (after <= radius(step.q_from) + kRadiusRounding) return std::nullopt;
  if (load->mass <= capacity_at(machine.model->capacity, after)) return std::nullopt;
  return interpreter::HitPair{load->name, "the load chart of " + machine.name};
}

/// Name of a moving part: a body, or after the last body the load.
const std::string& RobotView::part_name(int part) const {
  const auto& names = robot().body_names;
  return static_cast<std::size_t>(part) < names.size() ? names[static_cast<std::size_t>(part)]
                                                       : site_.load(index_)->name;
}

std::optional<interpreter::HitPair> RobotView::swept_hit(
    const interpreter::MotionStep& step) const {
  const SiteRobot& machine = robot();
  const auto& load = site_.load(index_);
  std::vector<geometry::Motion> motions =
      robot::step_motions(*machine.model, machine.mounting, step.q_from, step.q_to);
  const std::size_t load_part = machine.bodies.size();
  const bool carries = load && load->body;
  if (carries) motions[load_part] = attached_motion(motions[load_part], load->X_TO);

  collision::SweptQuery query;
  query.contact_tolerance = site_.contact_tolerance();
  std::vector<int> item_of(load_part + 1, -1);  // per part: its item in the query
  std::vector<int> part_of;
  std::vector<bool> moves(load_part + 1, false);
  const auto item = [&](std::size_t part) {
    if (item_of[part] < 0) {
      item_of[part] = static_cast<int>(query.items.size());
      const collision::Body* body =
          part < load_part ? machine.bodies[part].get() : load->body.get();
      query.items.push_back({{body, motions[part]}, moves[part] && site_.has_obstacles()});
      part_of.push_back(static_cast<int>(part));
    }
    return item_of[part];
  };
  for (std::size_t part = 0; part <= load_part; ++part) {
    const bool there = part < load_part ? machine.bodies[part] != nullptr : carries;
    if (!there) continue;
    moves[part] = motions[part].moves();
    if (moves[part]) item(part);
  }
  for (const OwnPair& pair : machine.own_pairs) {
    if (!pair.moves(step.q_from, step.q_to)) continue;
    const int first = item(static_cast<std::size_t>(pair.first));
    query.pairs.emplace_back(first, item(static_cast<std::size_t>(pair.second)));
  }
  if (carries) {
    for (const OwnPair& pair : machine.load_pairs) {
      if (!pair.moves(step.q_from, step.q_to)) continue;
      const int body = item(static_cast<std::size_t>(pair.first));
      query.pairs.emplace_back(item(load_part), body);
    }
  }
  if (query.items.empty()) return std::nullopt;
  const collision::SweptResult result = site_.obstacles().test(query, budget_);
  if (!result.hit) return std::nullopt;
  int moved = part_of[static_cast<std::size_t>(result.hit->item)];
  if (result.hit->obstacle) {
    return interpreter::HitPair{part_name(moved), site_.obstacle_name(*result.hit->obstacle)};
  }
  int met = part_of[static_cast<std::size_t>(result.hit->other_item.value_or(0))];
  const bool first_is_load = static_cast<std::size_t>(moved) == load_part;
  if (!first_is_load && !moves[static_cast<std::size_t>(moved)]) std::swap(moved, met);
  return interpreter::HitPair{part_name(moved), part_name(met)};
}

double RobotView::free_distance(std::span<const double> q, double heading_deg, double range) const {
  if (!(range > 0)) return 0;
  if (!site_.has_obstacles()) return range;
  const SiteRobot& machine = robot();
  std::vector<math::Pose> X_WB;
  robot::body_poses(*machine.model, machine.mounting, q, X_WB);
  std::vector<std::pair<const collision::Body*, math::Pose>> parts;
  for (std::size_t i = 0; i < machine.bodies.size(); ++i) {
    if (machine.bodies[i]) parts.emplace_back(machine.bodies[i].get(), X_WB[i]);
  }
  const auto& load = site_.load(index_);
  if (load && load->body) {
    const math::Pose X_WT = robot::tool_pose(*machine.model, machine.mounting, q);
    parts.emplace_back(load->body.get(), X_WT * load->X_TO);
  }
  const math::Vec3 heading(math::cos_deg(heading_deg), math::sin_deg(heading_deg), 0);
  const auto is_free = [&](double distance) {
    collision::SweptQuery query;
    query.contact_tolerance = site_.contact_tolerance();
    for (const auto& [body, X] : parts) {
      query.items.push_back({{body, geometry::translating(X, heading * distance)}, true});
    }
    return !site_.obstacles().test(query).hit;
  };
  if (is_free(range)) return range;
  // The swept volume only grows with the distance, so halving finds where it first meets anything.
  double accepted = 0;
  double refused = range;
  while (refused - accepted > kFreeDistanceResolution) {
    const double middle = accepted + (refused - accepted) / 2;
    if (middle <= accepted || middle >= refused) break;
    (is_free(middle) ? accepted : refused) = middle;
  }
  return accepted;
}

std::optional<interpreter::HitPair> RobotView::blocked_at(std::span<const double> q) const {
  if (nothing_to_meet()) return std::nullopt;
  const SiteRobot& machine = robot();
  const double tolerance = site_.contact_tolerance();
  std::vector<math::Pose> X_WB;
  robot::body_poses(*machine.model, machine.mounting, q, X_WB);
  for (std::size_t i = 0; i < machine.bodies.size(); ++i) {
    if (!machine.bodies[i]) continue;
    if (const auto id = site_.obstacles().blocked_at(*machine.bodies[i], X_WB[i], tolerance, {})) {
      return interpreter::HitPair{machine.body_names[i], site_.obstacle_name(*id)};
    }
  }
  const auto body = [&](int i) -> const collision::Body& {
    return *machine.bodies[static_cast<std::size_t>(i)];
  };
  const auto pose = [&](int i) -> const math::Pose& { return X_WB[static_cast<std::size_t>(i)]; };
  const auto& load = site_.load(index_);
  const bool carries = load && load->body;
  const math::Pose X_WO = carries
                              ? robot::tool_pose(*machine.model, machine.mounting, q) * load->X_TO
                              : math::Pose::Identity();
  if (carries) {
    if (const auto id = site_.obstacles().blocked_at(*load->body, X_WO, tolerance, {})) {
      return interpreter::HitPair{load->name, site_.obstacle_name(*id)};
    }
  }
  for (const OwnPair& pair : machine.own_pairs) {
    if (collision::overlaps(body(pair.first), pose(pair.first), body(pair.second),
                            pose(pair.second), tolerance)) {
      return interpreter::HitPair{part_name(pair.first), part_name(pair.second)};
    }
  }
  if (!carries) return std::nullopt;
  for (const OwnPair& pair : machine.load_pairs) {
    if (collision::overlaps(*load->body, X_WO, body(pair.first), pose(pair.first), tolerance)) {
      return interpreter::HitPair{load->name, part_name(pair.first)};
    }
  }
  return std::nullopt;
}

}  // namespace rubicon::site
