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
      : view_(view), q_from_(q_from), q_to_(q_to) {}

  /// False: nothing is known of how fast its bodies go.
  bool ask(collision::LegQuery& query) {
    const SiteRobot& robot = view_.robot();
    const robot::RobotModel& model = *robot.model;
    const auto chains = chains_from(model, robot.mounting, q_from_, q_to_, -1);
    std::vector<int> item_of(robot.bodies.size(), -1);
    for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
      const collision::Body* body = robot.bodies[i].get();
      if (body == nullptr) continue;
      const auto speed = chains[i].speed();
      const auto acceleration = chains[i].bound();
      if (!speed || !acceleration) return false;
      item_of[i] = static_cast<int>(query.items.size());
      bodies_.push_back(i);
      query.items.push_back(
          {body, {speed->origin, speed->turning}, {acceleration->origin, acceleration->turning}});
    }
    std::vector<std::vector<robot::ChainBound>> seen_from(robot.bodies.size());
    for (const OwnPair& pair : robot.own_pairs) {
      if (!pair.moves(q_from_, q_to_)) continue;
      const int base = common_base(model, pair.first, pair.second);
      const auto* seen = &chains;
      if (base >= 0) {
        auto& kept = seen_from[static_cast<std::size_t>(base)];
        if (kept.empty()) kept = chains_from(model, robot.mounting, q_from_, q_to_, base);
        seen = &kept;
      }
      const auto first = static_cast<std::size_t>(pair.first);
      const auto second = static_cast<std::size_t>(pair.second);
      const auto of_first = (*seen)[first].speed();
      const auto of_second = (*seen)[second].speed();
      if (!of_first || !of_second) return false;
      query.pairs.push_back({item_of[first],
                             item_of[second],
                             {of_first->origin, of_first->turning},
                             {of_second->origin, of_second->turning}});
    }
    return true;
  }

  void poses(double share, std::vector<math::Pose>& X_WB) const override {
    const SiteRobot& robot = view_.robot();
    q_.resize(q_from_.size());
    robot::configuration_at(q_from_, q_to_, share, q_);
    robot::body_poses(*robot.model, robot.mounting, q_, all_);
    X_WB.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) X_WB[i] = all_[bodies_[i]];
  }

  bool is_free(double from, double to) const override {
    const std::vector<double> q0 = robot::configuration_at(q_from_, q_to_, from);
    const std::vector<double> q1 = robot::configuration_at(q_from_, q_to_, to);
    refused_ = view_.swept_hit({q0, q1, 0, 0});
    return !refused_;
  }

  /// The pair that the exact test was refused for last.
  const std::optional<interpreter::HitPair>& refused() const { return refused_; }

  /// The body of the robot that an item is.
  int body_of(int item) const { return static_cast<int>(bodies_[static_cast<std::size_t>(item)]); }

 private:
  const RobotView& view_;
  std::span<const double> q_from_;
  std::span<const double> q_to_;
  std::vector<std::size_t> bodies_;  ///< of the items
  mutable std::optional<interpreter::HitPair> refused_;
  mutable std::vector<double> q_;
  mutable std::vector<math::Pose> all_;
};

/// Only where nothing can be met but what stands and its own bodies, and where all its bodies are
/// rigid.
bool RobotView::can_look_along() const {
  const SiteRobot& machine = robot();
  const auto& load = site_.load(index_);
  return !site_.has_others(index_) && !site_.may_enter(index_) && !site_.has_pits() &&
         machine.buffers.empty() && machine.ropes.empty() && !(load && load->body);
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
  look.free_until = answer.free_until;
  look.met_from = answer.met_from;
  if (!answer.hit) {
    look.pair = bodies.refused();
    return look;
  }
  const std::string& moved = part_name(bodies.body_of(answer.hit->item));
  if (answer.hit->obstacle) {
    look.pair = interpreter::HitPair{moved, site_.obstacle_name(*answer.hit->obstacle)};
  } else {
    look.pair =
        interpreter::HitPair{moved, part_name(bodies.body_of(answer.hit->other_item.value_or(0)))};
  }
  return look;
}

}  // namespace rubicon::site
