#include "src/motion/guides/lane_guide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "src/motion/guides/vehicle.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::guides {

namespace {

using math::at;

/// m: nearer than this no heading is driven along.
constexpr double kSamePlace = 1e-9;

/// The configuration at a place that it drives to from another.
std::vector<double> stand_at(const Vehicle& vehicle, const Leg& leg, std::span<const double> q,
                             const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  std::vector<double> stands(q.begin(), q.end());
  vehicle.set_place(to, stands);
  const Eigen::Vector2d along = to - from;
  if (leg.heading() >= 0 && along.norm() > kSamePlace) {
    stands[at(leg.heading())] = leg.heading_along(q, along);
  }
  return stands;
}

}  // namespace

Leg leg_between_nodes(const robot::RobotModel& model, const robot::Mounting& mounting,
                      robot::GoalClauses clauses) {
  const Leg whole(model, mounting, clauses);
  const Vehicle vehicle(model, mounting);
  for (const int parameter : whole.parameters()) {
    const bool drives =
        parameter == whole.heading() || parameter == vehicle.x() || parameter == vehicle.y();
    if (!drives) clauses.locked.push_back(parameter);
  }
  std::sort(clauses.locked.begin(), clauses.locked.end());
  return Leg(model, mounting, clauses);
}

GuideAnswer LaneGuide::begin(std::span<const double> q, MotionTests& tests) {
  return next(q, tests, false);
}

GuideAnswer LaneGuide::reached(std::span<const double> q, MotionTests& tests) {
  return next(q, tests, true);
}

GuideAnswer LaneGuide::ended_short(std::span<const double> q, MotionTests& tests) {
  GuideAnswer answer;
  if (beside_) {
    answer.reason = "the script ended short of the goal, beside the lanes";
    return answer;
  }
  if (++short_ <= static_cast<int>(spec_.replans)) return next(q, tests, false);
  answer.reason = fmt::format("the script ended {} times short of a node", short_);
  return answer;
}

GuideAnswer LaneGuide::next(std::span<const double> q, MotionTests& tests, bool reached) {
  const Vehicle vehicle(*task_.model, task_.mounting);
  const Leg leg(*task_.model, task_.mounting, task_.clauses);
  const std::vector<double>& q_goal = task_.goals.front();
  const Eigen::Vector2d place = vehicle.place(q);
  LaneAnswer lane = tests.next_node({place, vehicle.place(q_goal), reached});
  GuideAnswer answer;
  if (lane.tells_way) {
    PlanReport report;
    report.way.emplace_back(q.begin(), q.end());
    Eigen::Vector2d from = place;
    for (const Eigen::Vector2d& node : lane.way) {
      report.way.push_back(stand_at(vehicle, leg, report.way.back(), from, node));
      from = node;
    }
    report.way.push_back(q_goal);
    report.nodes = lane.way.size();
    report.metrics = way_metrics(*task_.model, task_.mounting, report.way, task_.loaded);
    answer.planned = std::move(report);
    given_ = 0;
  }
  switch (lane.kind) {
    case LaneAnswer::Kind::node:
      answer.q = stand_at(vehicle, leg, q, place, lane.place);
      break;
    case LaneAnswer::Kind::goal:
      beside_ = true;
      answer.q = q_goal;
      break;
    case LaneAnswer::Kind::waits:
    case LaneAnswer::Kind::no_way: {
      PlanReport report;
      report.outcome = PlanReport::Outcome::no_way;
      report.cause = std::move(lane.reason);
      answer.planned = std::move(report);
      return answer;
    }
  }
  answer.kind = GuideAnswer::Kind::way_point;
  answer.k = ++given_;
  answer.n = given_ + (lane.kind == LaneAnswer::Kind::goal ? 0 : lane.left + 1);
  return answer;
}

}  // namespace rubicon::guides
