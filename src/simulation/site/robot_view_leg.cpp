#include <algorithm>
#include <utility>

#include "src/motion/collision/leg_query.hpp"
#include "src/motion/robot/chain_bound.hpp"
#include "src/motion/robot/frame_chain.hpp"
#include "src/simulation/site/robot_view.hpp"

namespace rubicon::site {

namespace {

/// Bounds of the motions of all bodies while q runs from q0 to q1, as seen from `base` (-1: the
/// world); only of bodies that stand on it.
std::vector<robot::ChainBound> chains_from(const robot::RobotModel& model,
                                           const robot::Mounting& mounting,
                                           std::span<const double> q0, std::span<const double> q1,
                                           int base) {
  std::vector<robot::ChainBound> chains(model.bodies.size());
  for (std::size_t i = static_cast<std::size_t>(base + 1); i < chains.size(); ++i) {
    const int parent = model.bodies[i].parent;
    if (parent < base) continue;
    if (parent != base) chains[i] = chains[static_cast<std::size_t>(parent)];
    for (const robot::FrameElement& each : model.bodies[i].frame) {
      chains[i].append(each, q0, q1, mounting.starts);
    }
  }
  return chains;
}

/// The last body that both stand on, or are; -1: none.
int common_base(const robot::RobotModel& model, int a, int b) {
  while (a != b) {
    int& later = a > b ? a : b;
    later = model.bodies[static_cast<std::size_t>(later)].parent;
  }
  return a;
}

}  // namespace

/// The bodies of a robot on a leg.
class RobotView::BodiesOnLeg : public collision::LegMotion {
 public:
  BodiesOnLeg(const RobotView& view, std::span<const double> q_from, std::span<const double> q_to)
      : view_(view),
        q_from_(q_from),
        q_to_(q_to),
        item_of_(view.robot().bodies.size() + 1, -1),
        chains_(view.robot().bodies.size() + 1) {}

  /// False: nothing is known of how fast its bodies go.
  bool ask(collision::LegQuery& query) {
    const SiteRobot& robot = view_.robot();
    const auto& load = view_.site_.load(view_.index_);
    bool known = true;
    const auto add = [&](const collision::Body* body, int part) {
      item_of_[static_cast<std::size_t>(part)] = static_cast<int>(query.items.size());
      parts_.push_back(part);
      const auto motion = motion_of(part, -1);
      known = known && motion;
      if (motion) query.items.push_back({body, motion->speed, motion->acceleration});
    };
    for (std::size_t i = 0; i < robot.bodies.size() && known; ++i) {
      if (robot.bodies[i]) add(robot.bodies[i].get(), static_cast<int>(i));
    }
    if (load && load->body && known) add(load->body.get(), robot.load_part());
    const auto add_pair = [&](const OwnPair& pair, int first, int second) {
      if (!known || !pair.moves(q_from_, q_to_)) return;
      const int base = common_base(*robot.model, robot.body_of(first), robot.body_of(second));
      const auto of_first = motion_of(first, base);
      const auto of_second = motion_of(second, base);
      known = of_first && of_second;
      if (!known) return;
      query.pairs.push_back({item_of_[static_cast<std::size_t>(first)],
                             item_of_[static_cast<std::size_t>(second)], of_first->speed,
                             of_second->speed});
    };
    for (const OwnPair& pair : robot.own_pairs) add_pair(pair, pair.first, pair.second);
    if (load && load->body) {
      for (const OwnPair& pair : robot.load_pairs) add_pair(pair, robot.load_part(), pair.first);
    }
    return known;
  }

  void poses(double share, std::vector<math::Pose>& X_WB) const override {
    const SiteRobot& robot = view_.robot();
    q_.resize(q_from_.size());
    robot::configuration_at(q_from_, q_to_, share, q_);
    robot::body_poses(*robot.model, robot.mounting, q_, all_);
    X_WB.resize(parts_.size());
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (parts_[i] != robot.load_part()) {
        X_WB[i] = all_[static_cast<std::size_t>(parts_[i])];
        continue;
      }
      X_WB[i] = all_[static_cast<std::size_t>(robot.model->tool_body)];
      robot::append(X_WB[i], robot.model->tool_frame, {q_, {}, robot.mounting.starts});
      X_WB[i] = X_WB[i] * view_.site_.load(view_.index_)->X_TO;
    }
  }

  bool is_free(double from, double to) const override {
    const std::vector<double> q0 = robot::configuration_at(q_from_, q_to_, from);
    const std::vector<double> q1 = robot::configuration_at(q_from_, q_to_, to);
    refused_ = view_.swept_hit({q0, q1, 0, 0});
    return !refused_;
  }

  /// The pair that the exact test was refused for last.
  const std::optional<interpreter::HitPair>& refused() const { return refused_; }

  /// The part of the robot that an item is.
  int part_of(int item) const { return parts_[static_cast<std::size_t>(item)]; }

 private:
  struct PartMotion {
    collision::LegQuery::Speed speed;
    collision::LegQuery::Speed acceleration;
  };

  /// How a part moves as seen from a body that carries it (-1: the world), where that is known.
  std::optional<PartMotion> motion_of(int part, int base) {
    const SiteRobot& robot = view_.robot();
    auto& chains = chains_[static_cast<std::size_t>(base + 1)];
    if (chains.empty()) chains = chains_from(*robot.model, robot.mounting, q_from_, q_to_, base);
    robot::ChainBound chain = chains[static_cast<std::size_t>(robot.body_of(part))];
    double arm = 0;  // m, from the origin of the frame at the end of the chain to that of the part
    if (part == robot.load_part()) {
      for (const robot::FrameElement& each : robot.model->tool_frame) {
        chain.append(each, q_from_, q_to_, robot.mounting.starts);
      }
      arm = view_.site_.load(view_.index_)->X_TO.translation().norm();
    }
    const auto speed = chain.speed();
    const auto acceleration = chain.bound();
    if (!speed || !acceleration) return std::nullopt;
    return PartMotion{{speed->origin + speed->turning * arm, speed->turning},
                      {acceleration->origin + acceleration->turning * arm, acceleration->turning}};
  }

  const RobotView& view_;
  std::span<const double> q_from_;
  std::span<const double> q_to_;
  std::vector<int> parts_;                              ///< of the items
  std::vector<int> item_of_;                            ///< of the parts
  std::vector<std::vector<robot::ChainBound>> chains_;  ///< as seen from the world, from bodies
  mutable std::optional<interpreter::HitPair> refused_;
  mutable std::vector<double> q_;
  mutable std::vector<math::Pose> all_;
};

/// Only where all that the robot moves is rigid, and meets no more than shapes.
bool RobotView::can_look_along() const {
  const SiteRobot& machine = robot();
  const auto& load = site_.load(index_);
  const bool has_chart = load && load->mass > 0 && !machine.model->capacity.empty();
  const bool keeps_out = keeps_out_ && !foreseen_.empty();
  return !keeps_out && !site_.may_enter(index_) && !site_.has_pits() && machine.buffers.empty() &&
         machine.ropes.empty() && !has_chart;
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
  BodiesOnLeg bodies(*this, q_from, q_to);
  collision::LegQuery query;
  query.contact_tolerance = site_.contact_tolerance();
  query.whole = whole;
  query.least = least;
  if (!bodies.ask(query)) return look;
  const collision::LegAnswer answer = site_.obstacles().look_along(query, bodies);
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
