#pragma once

#include "src/motion/guides/guide.hpp"

namespace rubicon::guides {

/// The leg of a vehicle from node to node: it drives and turns, and nothing else of it moves.
Leg leg_between_nodes(const robot::RobotModel& model, const robot::Mounting& mounting,
                      robot::GoalClauses clauses);

/// Drives a vehicle of a fleet along its network, one node after the other: the site says which is
/// next and when it may be entered (`MotionTests::next_node`). From the last node it goes straight
/// to the goal. What stands beside the lanes is the behaviour's.
class LaneGuide : public Guide {
 public:
  LaneGuide(GuideSpec spec, GuideTask task) : spec_(std::move(spec)), task_(std::move(task)) {}
  std::unique_ptr<Guide> copy() const override { return std::make_unique<LaneGuide>(*this); }
  GuideAnswer begin(std::span<const double> q, MotionTests& tests) override;
  GuideAnswer reached(std::span<const double> q, MotionTests& tests) override;
  GuideAnswer ended_short(std::span<const double> q, MotionTests& tests) override;

 private:
  GuideAnswer next(std::span<const double> q, MotionTests& tests, bool reached);

  GuideSpec spec_;
  GuideTask task_;
  int given_ = 0;        ///< waypoints
  int short_ = 0;        ///< how often the script ended short of one
  bool beside_ = false;  ///< it has left the last node for the goal
};

}  // namespace rubicon::guides
