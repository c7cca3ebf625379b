#include "src/simulation/site/robot_view.hpp"

#include <algorithm>
#include <utility>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/body_motion.hpp"
#include "src/motion/robot/turns.hpp"
#include "src/simulation/site/load_chart.hpp"
#include "src/simulation/site/load_turn.hpp"

namespace rubicon::site {

namespace {

/// m: how exactly `free` is found. Far below every contact tolerance in use; each halving costs a
/// query.
constexpr double kFreeDistanceResolution = 1e-6;

/// m: by how much steps that count as on a line may be beside it. Far above the rounding of values
/// that FreeLine allows, on a robot of any size.
constexpr double kLineRounding = 1e-6;

std::vector<int> numbers_of(const std::vector<ReservedPart>& parts) {
  std::vector<int> numbers;
  for (const ReservedPart& part : parts) numbers.push_back(part.part);
  return numbers;
}

}  // namespace

/// What the robot sweeps along the line that was found free.
struct RobotView::LineVolume {
  explicit LineVolume(const StepQuery& step)
      : movers(step.against_others()),
        bodies(movers),
        standing(collision::MovingBodies(step.standing()).bounds()) {}

  collision::SweptQuery movers;
  collision::MovingBodies bodies;
  collision::Bounds standing;  ///< around the rest, ropes and buffers left out
};

std::optional<interpreter::HitPair> RobotView::propose(const interpreter::MotionStep& step) {
  if (auto pair = refusal(step)) return pair;
  site_.watch_workspaces(index_, step);
  std::vector<double> q(step.q_to.begin(), step.q_to.end());
  robot::normalise(*robot().model, q);
  site_.begin_step(index_, step, std::move(q), std::move(step_volume_));
  return std::nullopt;
}

bool RobotView::situation(const std::string& name, std::span<const double> q,
                          std::span<const double> q_goal) const {
  if (name == "safety") return people_below(q, q_goal);
  const auto& load = site_.load(index_);
  return load && load->component >= 0 && name == "transport";
}

bool RobotView::people_below(std::span<const double> q, std::span<const double> q_goal) const {
  if (!site_.has_people(index_)) return false;
  const SiteRobot& machine = robot();
  const auto& load = site_.load(index_);
  std::vector<double> q_to(q_goal.begin(), q_goal.end());
  for (std::size_t i = 0; i < q_to.size(); ++i) {
    q_to[i] = q[i] + robot::way_between(machine.model->parameters[i], q[i], q_goal[i]);
  }
  const std::vector<geometry::Motion> motions = part_motions(machine, load, q, q_to);
  const bool hangs = load && load->body;
  const auto part =
      hangs ? machine.bodies.size() : static_cast<std::size_t>(machine.model->tool_body);
  const collision::BodyPtr& body = hangs ? load->body : machine.bodies.at(part);
  if (!body) return false;
  collision::SweptQuery query;
  query.contact_tolerance = site_.contact_tolerance();
  query.items.push_back({{body.get(), motions[part]}, true});
  collision::MovingBodies bodies(query);
  return site_.people_below(index_, bodies);
}

bool RobotView::nothing_to_meet() const {
  return !site_.has_obstacles() && robot().own_pairs.empty() && !site_.load(index_) &&
         !site_.has_others(index_);
}

std::vector<interpreter::ForeseenWay> RobotView::foreseen(std::span<const double> q,
                                                          std::span<const double> q_goal) {
  foreseen_.clear();
  if (!site_.foresees(index_)) return {};
  std::vector<double> q_to(q_goal.begin(), q_goal.end());
  for (std::size_t i = 0; i < q_to.size(); ++i) {
    q_to[i] = q[i] + robot::way_between(robot().model->parameters[i], q[i], q_goal[i]);
  }
  foreseen_ = site_.foreseen_regions(index_);
  // Where none is met the others are of no interest.
  if (!foreseen_hit(q, q_to)) foreseen_.clear();
  std::vector<interpreter::ForeseenWay> ways;
  for (const ForeseenRegion& each : foreseen_) {
    interpreter::ForeseenWay& way = ways.emplace_back();
    way.machine = site_.robot(each.robot).name;
    way.seconds = each.seconds;
    way.q_aim = each.q_aim;
    for (const PlanPolygon& polygon : each.region.polygons) {
      std::vector<double>& outline = way.outlines.emplace_back();
      for (const Eigen::Vector2d& p : polygon) outline.insert(outline.end(), {p.x(), p.y()});
    }
  }
  return ways;
}

/// What others are foreseen to sweep that the robot would sweep, too.
std::optional<interpreter::HitPair> RobotView::foreseen_hit(std::span<const double> q_from,
                                                            std::span<const double> q_to) const {
  if (foreseen_.empty()) return std::nullopt;
  const PlanRegion own = site_.region_of(index_, q_from, q_to);
  for (const ForeseenRegion& each : foreseen_) {
    if (!own.overlaps(each.region)) continue;
    return interpreter::HitPair{
        robot().name, "what " + site_.robot(each.robot).name + " is foreseen to sweep", each.robot};
  }
  return std::nullopt;
}

std::optional<interpreter::HitPair> RobotView::refusal(const interpreter::MotionStep& step) const {
  step_volume_ = {};
  if (nothing_to_meet()) return std::nullopt;
  const bool on_line = look_ahead(step);
  if (auto pair = swept_hit(step, on_line)) return pair;
  if (keeps_out_ && step.duration == 0) {
    if (auto pair = foreseen_hit(step.q_from, step.q_to)) return pair;
  }
  if (const auto task = site_.pit_met(index_, step)) {
    return interpreter::HitPair{part_name(robot().model->tool_body), "the pit of " + *task};
  }
  if (const auto met = site_.workspace_met(index_, step)) {
    return interpreter::HitPair{"the workspace of " + robot().name, met->name, met->machine, -1,
                                met->moving};
  }
  return overload(step, on_line);
}

bool RobotView::has_chart_for_load() const {
  const auto& load = site_.load(index_);
  return load && load->mass > 0 && !robot().model->capacity.empty();
}

/// All along the way.
bool RobotView::is_allowed_by_chart(std::span<const double> q_from,
                                    std::span<const double> q_to) const {
  const SiteRobot& machine = robot();
  const std::vector<geometry::Motion> motions =
      robot::step_motions(*machine.model, machine.mounting, q_from, q_to);
  return allows_step(machine.model->capacity, site_.load(index_)->mass, machine.mounting.X_WM,
                     motions.back());
}

bool RobotView::is_within_chart(std::span<const double> q) const {
  const SiteRobot& machine = robot();
  const math::Vec3 p_WT = robot::tool_pose(*machine.model, machine.mounting, q).translation();
  return may_hang(machine.model->capacity, site_.load(index_)->mass,
                  chart_radius(machine.mounting.X_WM, p_WT));
}

std::optional<interpreter::HitPair> RobotView::overload(const interpreter::MotionStep& step,
                                                        bool on_line) const {
  if (!has_chart_for_load() || (on_line && line_is_within_chart_)) return std::nullopt;
  if (is_allowed_by_chart(step.q_from, step.q_to)) return std::nullopt;
  return interpreter::HitPair{site_.load(index_)->name, "the load chart of " + robot().name};
}

const std::string& RobotView::part_name(int part) const {
  return is_load(part) ? site_.load(index_)->name : robot().name_of(part);
}

/// Whether the step lies on the line that was found free, or on a new one that is. Where bodies may
/// cut into something, no lines are looked at.
bool RobotView::look_ahead(const interpreter::MotionStep& step) const {
  if (site_.may_enter(index_)) return false;
  const std::uint64_t version = site_.standing_version(index_);
  if (line_.covers(step.q_from, step.q_to, version)) return true;
  std::vector<double> q_end = line_.ahead(*robot().model, step.q_from, step.q_to);
  if (q_end.empty()) return false;
  const StepQuery query(robot(), site_.load(index_), step.q_from, q_end, site_.contact_tolerance(),
                        site_.has_obstacles());
  if (query.query().items.empty() || site_.obstacles().test(query.query()).hit) {
    line_.found_blocked();
    return false;
  }
  const auto volume = std::make_shared<LineVolume>(query);
  if (zone_met(volume->movers, query.parts_of_movers(), volume->bodies)) {
    line_.found_blocked();
    return false;
  }
  // Of a load that is too heavy each step is judged by where it begins.
  line_is_within_chart_ = has_chart_for_load() && is_within_chart(step.q_from) &&
                          is_allowed_by_chart(step.q_from, q_end);
  line_.found_free(step.q_from, std::move(q_end), version);
  line_volume_ = volume;
  return true;
}

/// A box around what it sweeps in a step that is on the line.
collision::Bounds RobotView::bounds_on_line(const interpreter::MotionStep& step) const {
  // The bodies of ropes were made for the test of the line alone.
  if (!robot().ropes.empty()) return line_volume_->bodies.bounds();
  // On the line the robot may go back, too.
  const auto [first, last] = std::minmax({line_.share(step.q_from), line_.share(step.q_to)});
  collision::Bounds bounds = line_volume_->bodies.bounds_between(first, last);
  bounds.grow(math::Vec3::Constant(kLineRounding));
  return bounds;
}

std::optional<interpreter::HitPair> RobotView::swept_hit(const interpreter::MotionStep& step,
                                                         bool on_line) const {
  if (on_line) {
    if (!site_.has_others(index_)) return std::nullopt;
    const collision::Bounds bounds = bounds_on_line(step);
    if (robot().ropes.empty() && robot().buffers.empty()) {
      step_volume_.bounds = bounds;
      step_volume_.bounds->add(line_volume_->standing);
    }
    if (site_.is_alone_in(index_, bounds)) return std::nullopt;
  }
  StepQuery query(robot(), site_.load(index_), step.q_from, step.q_to, site_.contact_tolerance(),
                  site_.has_obstacles());
  if (query.query().items.empty()) return std::nullopt;
  if (!on_line) {
    if (auto pair = own_hit(query)) return pair;
  }
  if (auto pair = others_hit(query, site_.now() + step.duration)) return pair;
  step_volume_.motions = query.take_motions();
  return std::nullopt;
}

/// As a test of the query, but that bodies may cut into some components: these against all but what
/// they may enter, and before that all others.
collision::SweptResult RobotView::entering_hit(const StepQuery& step) const {
  const auto& items = step.query().items;
  collision::SweptQuery others = step.query();
  std::vector<collision::SweptQuery> entering;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!items[i].against_world) continue;
    std::vector<collision::ObstacleId> ignored =
        site_.entered_by(index_, robot().body_of(step.part_of(static_cast<int>(i))));
    if (ignored.empty()) continue;
    others.items[i].against_world = false;
    collision::SweptQuery& alone = entering.emplace_back(step.query());
    alone.pairs.clear();
    for (std::size_t j = 0; j < items.size(); ++j) alone.items[j].against_world = j == i;
    alone.ignore = std::move(ignored);
  }
  collision::SweptResult result = site_.obstacles().test(others);
  for (std::size_t i = 0; i < entering.size() && !result.hit; ++i) {
    result = site_.obstacles().test(entering[i]);
  }
  return result;
}

/// Obstacles and own pairs.
std::optional<interpreter::HitPair> RobotView::own_hit(const StepQuery& step) const {
  const collision::SweptResult result =
      site_.may_enter(index_) ? entering_hit(step) : site_.obstacles().test(step.query(), budget_);
  if (!result.hit) return std::nullopt;
  int moved = step.part_of(result.hit->item);
  if (result.hit->obstacle) {
    return interpreter::HitPair{part_name(moved), site_.obstacle_name(*result.hit->obstacle)};
  }
  int met = step.part_of(result.hit->other_item.value_or(0));
  if (!is_load(moved) && !step.moves(moved)) std::swap(moved, met);
  return interpreter::HitPair{part_name(moved), part_name(met)};
}

std::optional<interpreter::HitPair> RobotView::turn_hit(double angle_deg, Ticks until) const {
  const Load& load = *site_.load(index_);
  if (!load.body) return std::nullopt;
  const SiteRobot& machine = robot();
  const std::vector<ReservedPart> parts = parts_at(site_.configuration(index_));
  collision::SweptQuery query;
  query.contact_tolerance = site_.contact_tolerance();
  query.items.push_back(
      {{load.body.get(), turn_motion(site_.tool_pose(index_), load.X_TO, angle_deg)}, true});
  const collision::SweptQuery alone = query;
  std::vector<int> part_of = {machine.load_part()};
  for (const ReservedPart& part : parts) {
    const bool barred = std::any_of(machine.load_pairs.begin(), machine.load_pairs.end(),
                                    [&](const OwnPair& pair) { return pair.first == part.part; });
    if (!barred) continue;
    query.pairs.emplace_back(0, static_cast<int>(query.items.size()));
    query.items.push_back({{part.body.get(), part.motion}, false});
    part_of.push_back(part.part);
  }
  if (const auto hit = site_.obstacles().test(query).hit) {
    if (hit->obstacle) return interpreter::HitPair{load.name, site_.obstacle_name(*hit->obstacle)};
    const int met = std::max(hit->item, hit->other_item.value_or(0));
    return interpreter::HitPair{load.name, part_name(part_of[static_cast<std::size_t>(met)])};
  }
  const auto others = other_met(alone, std::span(part_of).first(1), until);
  if (!others) return std::nullopt;
  return interpreter::HitPair{load.name, others->name, others->machine_that_may_leave(),
                              others->zone_task, others->moving};
}

std::vector<bool> RobotView::are_buffers(std::span<const int> parts) const {
  if (robot().buffers.empty()) return {};
  std::vector<bool> result;
  for (const int part : parts) result.push_back(robot().is_buffer(part));
  return result;
}

/// Zones, what is above them and above moving people, other machines, what keeps a timetable.
/// `parts`: by item of the query; `until`: when the bodies have made their way.
std::optional<OtherMet> RobotView::other_met(const collision::SweptQuery& query,
                                             std::span<const int> parts, Ticks until) const {
  collision::MovingBodies bodies(query);
  if (auto met = site_.first_zone_met(index_, bodies)) return met;
  if (auto met = people_under_load(query, parts, until)) return met;
  if (auto met = site_.first_machine_met(index_, bodies, false, are_buffers(parts))) return met;
  return site_.first_moving_met(index_, bodies, until, false);
}

/// What of the query hangs on the tool, and their places in it.
std::pair<collision::SweptQuery, std::vector<int>> RobotView::loads_of(
    const collision::SweptQuery& query, std::span<const int> parts) const {
  std::pair<collision::SweptQuery, std::vector<int>> result;
  auto& [loads, items] = result;
  loads.contact_tolerance = query.contact_tolerance;
  for (std::size_t i = 0; i < query.items.size(); ++i) {
    if (!is_load(parts[i])) continue;
    loads.items.push_back(query.items[i]);
    items.push_back(static_cast<int>(i));
  }
  return result;
}

/// Whether bodies meet a zone, or what hangs on the tool would be over one. `bodies`: of the query.
bool RobotView::zone_met(const collision::SweptQuery& query, std::span<const int> parts,
                         collision::MovingBodies& bodies) const {
  if (site_.first_zone_met(index_, bodies)) return true;
  if (!site_.has_people(index_)) return false;
  const auto [loads, items] = loads_of(query, parts);
  if (items.empty()) return false;
  collision::MovingBodies hanging(loads);
  return site_.first_zone_below(index_, hanging).has_value();
}

std::optional<OtherMet> RobotView::people_under_load(const collision::SweptQuery& query,
                                                     std::span<const int> parts,
                                                     Ticks until) const {
  if (!site_.has_people(index_)) return std::nullopt;
  const auto [loads, items] = loads_of(query, parts);
  if (items.empty()) return std::nullopt;
  collision::MovingBodies hanging(loads);
  auto met = site_.first_zone_below(index_, hanging);
  if (!met) met = site_.first_moving_met(index_, hanging, until, true);
  if (met) met->item = items[static_cast<std::size_t>(met->item)];
  return met;
}

std::optional<interpreter::HitPair> RobotView::others_hit(const StepQuery& step,
                                                          Ticks until) const {
  if (!site_.has_others(index_)) return std::nullopt;
  const collision::SweptQuery movers = step.against_others();
  const std::vector<int> moving = step.parts_of_movers();
  const auto met = other_met(movers, moving, until);
  if (!met) return std::nullopt;
  return interpreter::HitPair{part_name(moving[static_cast<std::size_t>(met->item)]), met->name,
                              met->machine_that_may_leave(), met->zone_task, met->moving};
}

/// The robot's bodies, its load and its buffers, standing at q.
std::vector<ReservedPart> RobotView::parts_at(std::span<const double> q) const {
  const SiteRobot& machine = robot();
  std::vector<math::Pose> X_WB;
  robot::body_poses(*machine.model, machine.mounting, q, X_WB);
  std::vector<ReservedPart> parts;
  for (std::size_t i = 0; i < machine.bodies.size(); ++i) {
    if (machine.is_rope(static_cast<int>(i))) {
      RopeVolume rope = standing_rope(machine, static_cast<int>(i), q);
      parts.push_back({std::move(rope.body), std::move(rope.motion), static_cast<int>(i)});
    }
    if (!machine.bodies[i]) continue;
    parts.push_back({machine.bodies[i], geometry::stationary(X_WB[i]), static_cast<int>(i)});
  }
  const auto& load = site_.load(index_);
  if (load && load->body) {
    const math::Pose X_WT = robot::tool_pose(*machine.model, machine.mounting, q);
    parts.push_back({load->body, geometry::stationary(X_WT * load->X_TO), machine.load_part()});
  }
  for (std::size_t i = 0; i < machine.buffers.size(); ++i) {
    const auto body = static_cast<std::size_t>(machine.buffers[i].body);
    parts.push_back(
        {machine.buffers[i].grown, geometry::stationary(X_WB[body]), machine.buffer_part(i), true});
  }
  return parts;
}

collision::SweptQuery RobotView::pushed(const std::vector<ReservedPart>& parts, double heading_deg,
                                        double distance) const {
  const math::Vec3 heading(math::cos_deg(heading_deg), math::sin_deg(heading_deg), 0);
  collision::SweptQuery query;
  query.contact_tolerance = site_.contact_tolerance();
  for (const ReservedPart& part : parts) {
    const math::Pose X = part.motion.pose(0);
    query.items.push_back({{part.body.get(), geometry::translating(X, heading * distance)}, true});
  }
  return query;
}

bool RobotView::is_met_moving(std::span<const double> q, double heading_deg, double range) const {
  if (!(range > 0) || !site_.has_others(index_)) return false;
  const double free = free_distance(q, heading_deg, range);
  if (free >= range) return false;
  const std::vector<ReservedPart> parts = parts_at(q);
  const collision::SweptQuery query =
      pushed(parts, heading_deg, std::min(range, free + 2 * kFreeDistanceResolution));
  if (site_.obstacles().test(query).hit) return false;
  const auto met = other_met(query, numbers_of(parts), site_.now());
  if (!met) return false;
  if (met->machine >= 0) return !met->is_fixed && site_.is_in_step(met->machine);
  return met->moving >= 0 && site_.is_on_its_way(met->moving);
}

double RobotView::free_distance(std::span<const double> q, double heading_deg, double range) const {
  if (!(range > 0)) return 0;
  const bool has_others = site_.has_others(index_);
  if (!site_.has_obstacles() && !has_others) return range;
  const std::vector<ReservedPart> parts = parts_at(q);
  const std::vector<int> moving = numbers_of(parts);
  const auto is_free = [&](double distance) {
    const collision::SweptQuery query = pushed(parts, heading_deg, distance);
    return !site_.obstacles().test(query).hit &&
           !(has_others && other_met(query, moving, site_.now()));
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
  if (keeps_out_) {
    if (auto pair = foreseen_hit(q, q)) return pair;
  }
  const SiteRobot& machine = robot();
  const double tolerance = site_.contact_tolerance();
  const std::vector<ReservedPart> parts = parts_at(q);
  std::vector<const ReservedPart*> by_number(machine.bodies.size() + 1, nullptr);
  for (const ReservedPart& part : parts) {
    if (!part.is_buffer) by_number[static_cast<std::size_t>(part.part)] = &part;
    if (const auto id =
            site_.obstacles().blocked_at(*part.body, part.motion.pose(0), tolerance,
                                         site_.entered_by(index_, machine.body_of(part.part)))) {
      return interpreter::HitPair{part_name(part.part), site_.obstacle_name(*id)};
    }
  }
  const auto overlap = [&](int first, int second) {
    const ReservedPart& a = *by_number[static_cast<std::size_t>(first)];
    const ReservedPart& b = *by_number[static_cast<std::size_t>(second)];
    return collision::overlaps(*a.body, a.motion.pose(0), *b.body, b.motion.pose(0), tolerance);
  };
  for (const OwnPair& pair : machine.own_pairs) {
    if (overlap(pair.first, pair.second)) {
      return interpreter::HitPair{part_name(pair.first), part_name(pair.second)};
    }
  }
  const int load_part = machine.load_part();
  if (by_number.back() != nullptr) {
    for (const OwnPair& pair : machine.load_pairs) {
      if (overlap(load_part, pair.first)) {
        return interpreter::HitPair{part_name(load_part), part_name(pair.first)};
      }
    }
  }
  return standing_machine_at(parts);
}

/// Machines in a step need no test: their steps were tested against where this one stands.
std::optional<interpreter::HitPair> RobotView::standing_machine_at(
    const std::vector<ReservedPart>& parts) const {
  collision::SweptQuery query;
  query.contact_tolerance = site_.contact_tolerance();
  std::vector<bool> buffers;
  for (const ReservedPart& part : parts) {
    query.items.push_back({{part.body.get(), part.motion}, true});
    buffers.push_back(part.is_buffer);
  }
  collision::MovingBodies bodies(query);
  auto met = site_.first_machine_met(index_, bodies, true, buffers);
  if (!met) met = site_.first_moving_met(index_, bodies, site_.now(), false);
  if (!met) return std::nullopt;
  const ReservedPart& part = parts[static_cast<std::size_t>(met->item)];
  return interpreter::HitPair{part_name(part.part), met->name, met->machine_that_may_leave(), -1,
                              met->moving};
}

}  // namespace rubicon::site
