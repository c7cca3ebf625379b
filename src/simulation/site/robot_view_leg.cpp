#include <algorithm>
#include <utility>

#include "src/motion/collision/leg_query.hpp"
#include "src/motion/robot/frame_chain.hpp"
#include "src/motion/robot/leg_frames.hpp"
#include "src/simulation/site/robot_view.hpp"

namespace rubicon::site {

namespace {

/// The last body that both stand on, or are; -1: none.
int common_base(const robot::RobotModel& model, int a, int b) {
  while (a != b) {
    int& later = a > b ? a : b;
    later = model.bodies[static_cast<std::size_t>(later)].parent;
  }
  return a;
}

collision::LegQuery::Acceleration at_arm(const robot::AccelerationBound& bound, double arm) {
  return {bound.origin + bound.turning * arm, bound.turning};
}

}  // namespace

/// The frames of a robot on a leg, and what its queries have in common.
struct RobotView::Legs {
  explicit Legs(const SiteRobot& robot) : frames(*robot.model, robot.mounting) {
    for (const OwnPair& pair : robot.own_pairs) add_base(robot, pair.first, pair.second);
    for (const OwnPair& pair : robot.load_pairs) add_base(robot, robot.load_part(), pair.first);
  }

  void add_base(const SiteRobot& robot, int a, int b) {
    bases.push_back(common_base(*robot.model, robot.body_of(a), robot.body_of(b)));
  }

  robot::LegFrames frames;
  std::vector<int> bases;  ///< of the own pairs, then of those of the load
  collision::LegQuery query;
  std::vector<int> parts;    ///< of the items
  std::vector<int> item_of;  ///< of the parts
};

/// The bodies of a robot on a leg.
class RobotView::BodiesOnLeg : public collision::LegMotion {
 public:
  BodiesOnLeg(const RobotView& view, Legs& legs, std::span<const double> q_from,
              std::span<const double> q_to)
      : view_(view), legs_(legs), q_from_(q_from), q_to_(q_to) {}

  /// False: nothing is known of how its bodies go.
  bool ask(double contact_tolerance, bool whole, double least) {
    if (!legs_.frames.set_leg(q_from_, q_to_)) return false;
    const SiteRobot& robot = view_.robot();
    const auto& load = view_.site_.load(view_.index_);
    collision::LegQuery& query = legs_.query;
    query.frames = load_frame() + 1;
    query.contact_tolerance = contact_tolerance;
    query.whole = whole;
    query.least = least;
    query.items.clear();
    query.pairs.clear();
    legs_.parts.clear();
    legs_.item_of.assign(robot.bodies.size() + 1, -1);
    const auto add = [&](const collision::Body* body, int part) {
      legs_.item_of[static_cast<std::size_t>(part)] = static_cast<int>(query.items.size());
      legs_.parts.push_back(part);
      const robot::LegFrames::Motion& motion = legs_.frames.motion(-1, frame_of(part));
      query.items.push_back({body, part == robot.load_part() ? load_frame() : part, motion.moves,
                             at_arm(motion.acceleration, arm_of(part))});
    };
    for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
      if (robot.bodies[i]) add(robot.bodies[i].get(), static_cast<int>(i));
    }
    if (load && load->body) add(load->body.get(), robot.load_part());
    const auto add_pair = [&](const OwnPair& pair, int first, int second, int base) {
      if (!pair.moves(q_from_, q_to_)) return;
      query.pairs.push_back({legs_.item_of[static_cast<std::size_t>(first)],
                             legs_.item_of[static_cast<std::size_t>(second)], base});
    };
    std::size_t n = 0;
    for (const OwnPair& pair : robot.own_pairs) {
      add_pair(pair, pair.first, pair.second, legs_.bases[n++]);
    }
    if (load && load->body) {
      for (const OwnPair& pair : robot.load_pairs) {
        add_pair(pair, robot.load_part(), pair.first, legs_.bases[n++]);
      }
    }
    return true;
  }

  void frames(const double (&shares)[math::kLanes], math::LaneFrame* X_WF) const override {
    legs_.frames.poses(shares, X_WF);
    const auto& load = view_.site_.load(view_.index_);
    math::LaneFrame& X_WO = X_WF[load_frame()];
    X_WO = X_WF[legs_.frames.tool_frame()];
    if (load && load->body) robot::append(X_WO, load->X_TO);
  }

  std::pair<collision::LegQuery::Acceleration, collision::LegQuery::Acceleration> seen_from_base(
      const collision::LegQuery::Pair& pair) const override {
    return {seen_from(pair.base, part_of(pair.first)), seen_from(pair.base, part_of(pair.second))};
  }

  bool is_free(double from, double to) const override {
    const std::vector<double> q0 = robot::configuration_at(q_from_, q_to_, from);
    const std::vector<double> q1 = robot::configuration_at(q_from_, q_to_, to);
    const interpreter::MotionStep step{q0, q1, 0, 0};
    refused_ = view_.swept_hit(step, view_.look_ahead(step));
    return !refused_;
  }

  /// The pair that the exact test was refused for last.
  const std::optional<interpreter::HitPair>& refused() const { return refused_; }

  /// The part of the robot that an item is.
  int part_of(int item) const { return legs_.parts[static_cast<std::size_t>(item)]; }

 private:
  int load_frame() const { return legs_.frames.count(); }
  /// Which carries a part: of the load that of the tool.
  int frame_of(int part) const {
    return part == view_.robot().load_part() ? legs_.frames.tool_frame() : part;
  }
  /// m, from its origin to that of the part.
  double arm_of(int part) const {
    if (part != view_.robot().load_part()) return 0;
    return view_.site_.load(view_.index_)->X_TO.translation().norm();
  }
  collision::LegQuery::Acceleration seen_from(int base, int part) const {
    return at_arm(legs_.frames.motion(base, frame_of(part)).acceleration, arm_of(part));
  }

  const RobotView& view_;
  Legs& legs_;
  std::span<const double> q_from_;
  std::span<const double> q_to_;
  mutable std::optional<interpreter::HitPair> refused_;
};

/// Only where all that the robot moves is rigid, and meets no more than shapes.
bool RobotView::can_look_along() const {
  const SiteRobot& machine = robot();
  const bool keeps_out = keeps_out_ && !foreseen_.empty();
  return !keeps_out && !site_.may_enter(index_) && !site_.has_pits() && machine.buffers.empty() &&
         machine.ropes.empty() && !has_chart_for_load();
}

/// Of others only what the free part meets is looked at: what they are in the way of stays open.
bool RobotView::others_leave_free(std::span<const double> q_from, std::span<const double> q_to,
                                  double share) const {
  if (!site_.has_others(index_)) return true;
  const std::vector<double> q = robot::configuration_at(q_from, q_to, share);
  const StepQuery query(robot(), site_.load(index_), q_from, q, site_.contact_tolerance(),
                        site_.has_obstacles());
  return query.query().items.empty() || !others_hit(query, site_.now());
}

interpreter::LegLook RobotView::look_along(std::span<const double> q_from,
                                           std::span<const double> q_to, bool whole,
                                           double least) const {
  interpreter::LegLook look;
  if (!can_look_along()) return look;
  if (!legs_) legs_ = std::make_shared<Legs>(robot());
  BodiesOnLeg bodies(*this, *legs_, q_from, q_to);
  if (!bodies.ask(site_.contact_tolerance(), whole, least)) return look;
  const collision::LegAnswer answer = site_.obstacles().look_along(legs_->query, bodies);
  const bool free = answer.free_until > 0 && answer.free_until >= std::min(least, 1.0) &&
                    others_leave_free(q_from, q_to, answer.free_until);
  look.free_until = free ? answer.free_until : 0;
  look.met_from = answer.met_from;
  if (!answer.hit) {
    look.pair = bodies.refused();
    return look;
  }
  const std::string& moved = part_name(bodies.part_of(answer.hit->item));
  if (answer.hit->obstacle) {
    look.pair = interpreter::HitPair{moved, site_.obstacle_name(*answer.hit->obstacle)};
  } else {
    look.pair =
        interpreter::HitPair{moved, part_name(bodies.part_of(answer.hit->other_item.value_or(0)))};
  }
  return look;
}

}  // namespace rubicon::site
