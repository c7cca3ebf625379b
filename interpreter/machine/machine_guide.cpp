#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "interpreter/machine/floor_fence.hpp"
#include "interpreter/machine/machine.hpp"
#include "interpreter/machine/world_tests.hpp"
#include "src/motion/guides/lane_guide.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::interpreter {

namespace {

using guides::GuideAnswer;
using guides::PlanReport;

/// Waypoints in a row without any step before the guide is given up.
constexpr int kIdleWayPoints = 2;

/// Where a goal frame cannot be stood at as it is reached first, it is solved from so many other
/// configurations.
constexpr int kGoalStarts = 32;

/// A part that met something in so many checks.
struct Meeting {
  HitPair pair;
  std::size_t checks = 0;
  std::size_t first = 0;  ///< the check that met it first
};

}  // namespace

/// What a guide asks of the world, with all that was met.
class Machine::GuideTests : public guides::MotionTests {
 public:
  GuideTests(const Machine& machine, World& world) : machine_(machine), world_(world) {}

  bool stands(std::span<const double> q) override {
    const int limit = machine_.first_out_of_range(q);
    if (limit >= 0) return note(out_of_range(limit));
    if (auto pair = world_.blocked_at(q)) return note(*pair);
    return true;
  }

  guides::Nearness nearest(std::span<const double> q, double range,
                           const guides::PairsLeftOut& left_out) override {
    return world_.nearest(q, range, left_out);
  }

  bool sweeps_free(std::span<const double> q_from, std::span<const double> q_to) override {
    const int limit = machine_.first_out_of_range(q_to);
    if (limit >= 0) return note(out_of_range(limit));
    if (auto pair = world_.refusal({q_from, q_to, machine_.time_, 0})) return note(*pair);
    // On the way to the floor nothing is a fence yet.
    if (!machine_.task_.fence || machine_.way_point_ == 0) return true;
    auto crossed =
        machine_.task_.fence->crossed(*machine_.model_, machine_.task_.mounting, q_from, q_to);
    if (crossed) return note({"the tool", *std::move(crossed)});
    return true;
  }

  guides::LegShares look_along(std::span<const double> q_from, std::span<const double> q_to,
                               bool whole, double least) override {
    if (machine_.task_.fence && machine_.way_point_ != 0) return {};
    const LegLook look = world_.look_along(q_from, q_to, whole, least);
    const bool refused = look.met_from <= 1 && look.free_until < std::min(least, 1.0);
    if (refused && look.pair) note(*look.pair);
    return {look.free_until, look.met_from};
  }

  std::vector<guides::Thing> things() const override { return world_.things(); }

  void note_barring(const guides::Thing& thing) override {
    note({"its way", thing.name, thing.machine, -1, thing.moving});
  }

  guides::LaneAnswer next_node(const guides::LaneQuestion& question) override {
    std::optional<HitPair> before;
    guides::LaneAnswer answer = world_.next_node(question, before);
    if (before) note(*before);
    return answer;
  }

  const World& world() const { return world_; }

  /// The pair that was met most; of equals the one met first. Null: nothing was.
  const Meeting* most() const {
    const Meeting* most = nullptr;
    for (const auto& [names, meeting] : met_) {
      const bool more = most == nullptr || meeting.checks > most->checks ||
                        (meeting.checks == most->checks && meeting.first < most->first);
      if (more) most = &meeting;
    }
    return most;
  }

  /// Pairs with what may leave: other machines, zones, what keeps a timetable.
  std::vector<HitPair> others() const {
    std::vector<HitPair> pairs;
    for (const auto& [names, meeting] : met_) {
      if (meeting.pair.may_leave()) pairs.push_back(meeting.pair);
    }
    return pairs;
  }

 private:
  HitPair out_of_range(int limit) const {
    return {machine_.parameter(limit).display_name, "its range"};
  }

  bool note(const HitPair& pair) {
    Meeting& meeting = met_[{pair.moved, pair.met}];
    if (meeting.checks == 0) meeting.first = ++checks_;
    meeting.pair = pair;
    ++meeting.checks;
    return false;
  }

  const Machine& machine_;
  World& world_;
  std::map<std::pair<std::string, std::string>, Meeting> met_;
  std::size_t checks_ = 0;
};

const guides::Leg& Machine::leg() {
  const bool on_lanes =
      guide_ && !leads_to_goal_ && task_.guides[guide_index_].kind == guides::GuideKind::lanes;
  if (on_lanes) {
    if (!lane_leg_) {
      lane_leg_ = std::make_shared<const guides::Leg>(
          guides::leg_between_nodes(*model_, task_.mounting, task_.clauses));
    }
    return *lane_leg_;
  }
  const double radius = guide_ ? task_.guides[guide_index_].turn_radius : 0;
  if (radius > 0) {
    if (!arc_leg_ || arc_radius_ != radius) {
      arc_leg_ =
          std::make_shared<const guides::Leg>(*model_, task_.mounting, task_.clauses, radius);
      arc_radius_ = radius;
    }
    return *arc_leg_;
  }
  if (!leg_) leg_ = std::make_shared<const guides::Leg>(*model_, task_.mounting, task_.clauses);
  return *leg_;
}

guides::GuideTask Machine::guide_task(const World& world) const {
  guides::GuideTask task;
  task.model = model_;
  task.mounting = task_.mounting;
  task.goals = {goal_.q};
  task.loaded = world.loaded();
  task.clauses = task_.clauses;
  return task;
}

/// Asks the guides for a first waypoint, from guide `first` on. False: the motion has ended.
bool Machine::begin_guides(std::size_t first, World& world, EventSink* events) {
  if (try_guides(first, world, events)) return true;
  give_up();
  return false;
}

bool Machine::try_guides(std::size_t first, World& world, EventSink* events) {
  for (guide_index_ = first; guide_index_ < task_.guides.size(); ++guide_index_) {
    const guides::GuideSpec& spec = task_.guides[guide_index_];
    GuideTests tests(*this, world);
    guides::GuideTask task = guide_task(world);
    if (goal_.X_WG && !tests.stands(goal_.q)) add_goals(spec, tests, task.goals);
    guide_ = guides::GuideValue(guides::make_guide(spec, std::move(task)));
    idle_way_points_ = 0;
    way_point_given_ = {time_, world.version()};
    if (take(guide_->begin(q_, tests), tests, events)) return true;
  }
  return false;
}

/// Where the way to the next waypoint meets what others are foreseen to sweep the guides plan one
/// round that, from here. Where they find none all goes on as it was, and who comes too near stops.
void Machine::look_ahead(World& world, EventSink* events) {
  if (!task_.looks_ahead || task_.guides.empty() || looked_ahead_ == time_) return;
  looked_ahead_ = time_;
  if (looks_left_ == 0 || task_.goals[way_point_].work == GoalSpec::Work::working) return;
  const std::vector<ForeseenWay> ways = world.foreseen(q_, target_.q);
  std::vector<std::vector<double>> goals;
  for (const ForeseenWay& way : ways) goals.push_back(way.q_aim);
  if (ways.empty() || goals == no_round_) return;
  --looks_left_;
  ++foreseen_;
  if (events) {
    for (const ForeseenWay& way : ways) events->foreseen(way, time_);
  }
  const guides::GuideValue guide = guide_;
  const WayPoint target = target_;
  const auto before = std::tuple(leads_to_goal_, guide_point_, guide_index_, guide_cause_,
                                 guide_found_no_way_, goal_.q);
  world.keep_out_of_foreseen(true);
  const bool found = try_guides(0, world, events);
  world.keep_out_of_foreseen(false);
  if (found) {
    ++rounds_;
    no_round_.clear();
    return;
  }
  no_round_ = std::move(goals);
  guide_ = guide;
  target_ = target;
  std::tie(leads_to_goal_, guide_point_, guide_index_, guide_cause_, guide_found_no_way_, goal_.q) =
      before;
}

/// Other configurations that bring the tool to the goal frame: from random ones, the first in which
/// the robot may stand.
void Machine::add_goals(const guides::GuideSpec& spec, guides::MotionTests& tests,
                        std::vector<std::vector<double>>& goals) const {
  guides::Random random(static_cast<std::uint64_t>(spec.seed));
  const guides::Leg leg(*model_, task_.mounting, task_.clauses);
  const GoalSpec& goal = task_.goals[way_point_];
  robot::GoalClauses clauses = frame_clauses(goal);
  clauses.near.clear();
  for (int n = 0; n < kGoalStarts; ++n) {
    std::vector<double> q = q_;
    for (const int i : leg.parameters()) {
      const robot::Parameter& p = parameter(i);
      q[static_cast<std::size_t>(i)] =
          p.cyclic ? random.between(-180, 180) : random.between(p.lower, p.upper);
    }
    for (const auto& [index, value] : goal.values) q[static_cast<std::size_t>(index)] = value;
    robot::update_derived(*model_, task_.mounting, q);
    const robot::GoalSolution solution =
        robot::solve_goal(*model_, task_.mounting, q, *goal_.X_WG, frame_tolerance(), clauses);
    if (!solution.reachable || !tests.stands(solution.q)) continue;
    goals.push_back(solution.q);
    return;
  }
}

/// Takes what the guide answers, or has it think about that; false where it gave up, which
/// `guide_cause_` then has the reason of.
bool Machine::take(GuideAnswer answer, const GuideTests& tests, EventSink* events) {
  const guides::GuideSpec& spec = task_.guides[guide_index_];
  const bool no_way = answer.planned && !answer.planned->found();
  if (answer.planned) {
    const std::string cause = no_way ? cause_of(*answer.planned, tests) : std::string();
    if (no_way) answer.reason = cause;
    if (events) {
      const std::vector<HitPair> others = tests.others();
      GuidePlan plan;
      plan.name = spec.name;
      plan.kind = guides::full_name(spec);
      plan.seed = answer.planned->seed;
      plan.report = &*answer.planned;
      plan.cause = cause;
      plan.others = others;
      plan.time = time_;
      if (!answer.planned->tree.empty()) {
        plan.forbidden = [&] {
          WorldTests unnoted(*model_, tests.world());
          return guides::sample_forbidden(spec, guide_task(tests.world()), q_, *answer.planned,
                                          unnoted);
        };
      }
      events->guide(plan);
    }
  }
  return think(answer, events) || use(answer, events);
}

/// Whether what was planned takes time: then the machine stands meanwhile, and `thought_` is what
/// the guide will have said.
bool Machine::think(GuideAnswer& answer, EventSink* events) {
  if (!answer.planned) return false;
  const std::size_t checks = answer.planned->checks;
  const Ticks takes =
      ticks_from_seconds(task_.guides[guide_index_].thinks * static_cast<double>(checks));
  if (takes <= 0) return false;
  stop(events);
  time_ += takes;
  thinking_ += takes;
  if (events) events->think({checks, time_});
  thought_ = std::move(answer);
  return true;
}

/// The guide has done thinking: where its way is no longer free it plans again, from here. False:
/// the motion has ended.
bool Machine::end_thinking(World& world, EventSink* events) {
  GuideAnswer answer = *std::move(thought_);
  thought_.reset();
  const bool stale =
      answer.kind == GuideAnswer::Kind::way_point && !is_still_free(*answer.planned, world);
  if (stale) {
    GuideTests tests(*this, world);
    if (take(guide_->ended_short(q_, tests), tests, events)) return true;
  } else if (use(answer, events)) {
    return true;
  }
  return begin_guides(guide_index_ + 1, world, events);
}

bool Machine::is_still_free(const PlanReport& plan, World& world) {
  GuideTests tests(*this, world);
  return guides::way_is_free(task_.guides[guide_index_], guide_task(world), q_, plan.way, tests);
}

bool Machine::use(const GuideAnswer& answer, EventSink* events) {
  if (answer.kind == GuideAnswer::Kind::gave_up) {
    const guides::GuideSpec& spec = task_.guides[guide_index_];
    if (guide_cause_.empty()) {
      guide_cause_ =
          fmt::format("guide {} ({}): {}", spec.name, guides::full_name(spec), answer.reason);
      guide_found_no_way_ = answer.planned && !answer.planned->found();
    }
    guide_.reset();
    return false;
  }
  set_target(answer);
  if (events) events->way_point(answer.k, answer.n);
  return true;
}

void Machine::set_target(const GuideAnswer& answer) {
  target_ = goal_;
  leads_to_goal_ = answer.leads_to_goal();
  target_.via = goal_.via || !answer.leads_to_goal();
  target_.q = answer.q;
  // Values run on from where the robot stands, as those of goals do.
  for (const int i : leg().parameters()) {
    const auto index = static_cast<std::size_t>(i);
    target_.q[index] = robot::nearest_turn_equivalent(parameter(i), answer.q[index], q_[index]);
  }
  if (!answer.leads_to_goal() || !goal_.X_WG) {
    target_.p_WG = robot::tool_pose(*model_, task_.mounting, target_.q).translation();
  }
  // Of a frame the guide may have taken another configuration than the nearest.
  if (answer.leads_to_goal() && goal_.X_WG) goal_.q = target_.q;
  guide_point_ = answer.k;
  accepted_at_way_point_ = accepted_;
  begin_script();
}

/// The script has ended under a guide. True: it begins again, at the next waypoint; false: at its
/// goal, or the motion has ended.
bool Machine::next_way_point(World& world, EventSink* events) {
  const bool there = leg().is_there(q_, target_.q);
  if (there ? leads_to_goal_ : is_near_goal()) return false;
  const bool is_idle = accepted_ == accepted_at_way_point_;
  idle_way_points_ = is_idle ? idle_way_points_ + 1 : 0;
  const std::pair now(time_, world.version());
  const bool is_same_again = std::exchange(way_point_given_, now) == now && is_idle;
  GuideTests tests(*this, world);
  GuideAnswer answer;
  if (there) {
    answer = guide_->reached(q_, tests);
  } else if (is_same_again && task_.guides[guide_index_].kind == guides::GuideKind::lanes) {
    answer.reason = "the script made no step along the lane";
  } else if (idle_way_points_ < kIdleWayPoints) {
    answer = guide_->ended_short(q_, tests);
  } else {
    answer.reason = fmt::format("at {} waypoints in a row the script made no step", kIdleWayPoints);
  }
  return take(std::move(answer), tests, events) || begin_guides(guide_index_ + 1, world, events);
}

/// Whether the goal counts as reached, as far from it as `within` allows.
bool Machine::is_near_goal() {
  finish(MotionStatus::done);
  const bool reached = end_->reached;
  end_.reset();
  return reached;
}

/// No guide is left: the motion ends where the robot stands.
void Machine::give_up() {
  if (guide_found_no_way_) {
    finish(MotionStatus::no_way, guide_cause_);
    return;
  }
  finish(MotionStatus::done);
  if (!end_->reached) end_->message += "; " + guide_cause_;
}

std::string Machine::cause_of(const PlanReport& report, const GuideTests& tests) const {
  using Outcome = PlanReport::Outcome;
  const Meeting* const most = tests.most();
  const std::string pair =
      most ? fmt::format("{} meets {}", most->pair.moved, most->pair.met) : std::string();
  switch (report.outcome) {
    case Outcome::found:
      return {};
    case Outcome::start_blocked:
      return "no way: the robot may not stand where it does: " + pair;
    case Outcome::goal_blocked:
      return "no way: the robot may not stand at the goal: " + pair;
    case Outcome::start_not_kept:
      return "no way: what the guide keeps does not hold where the robot stands";
    case Outcome::goal_not_kept:
      return "no way: what the guide keeps does not hold at the goal";
    case Outcome::not_certified:
      return fmt::format("no way: {}{}",
                         report.cause.empty()
                             ? "none of the ways found could be followed step by step"
                             : report.cause,
                         most ? "; most often " + pair : "");
    case Outcome::no_way:
      return "no way: " + report.cause;
    case Outcome::out_of_nodes:
    case Outcome::out_of_checks:
      break;
  }
  return fmt::format("no way found with {} nodes and {} checks, {} of them refused{}", report.nodes,
                     report.checks, report.refused,
                     most ? fmt::format("; most often (in {}): {}", most->checks, pair) : "");
}

}  // namespace rubicon::interpreter
