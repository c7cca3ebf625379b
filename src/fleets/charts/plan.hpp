#pragma once

#include <string_view>
#include <vector>

#include "src/fleets/charts/avoidance.hpp"
#include "src/fleets/charts/chart.hpp"
#include "src/fleets/charts/decisions.hpp"
#include "src/fleets/lanes/shortest_way.hpp"

namespace rubicon::charts {

struct PlanSettings {
  AvoidanceSettings avoidance;
  lanes::Criterion criterion = lanes::Criterion::kTime;
};

/// Where a robot is bound for.
enum class Errand {
  kToGoal,
  kBack,      ///< to its start, because no way leads to its goal
  kStranded,  ///< nowhere: no way leads to its start either
};
std::string_view name_of(Errand errand);

/// What the centre knows: robots, their charts, and which lanes are blocked. A value: each step
/// takes one and gives the next.
struct Plan {
  std::vector<Robot> robots;
  std::vector<Chart> charts;      ///< by robot
  std::vector<Errand> errands;    ///< by robot
  std::vector<LaneIndex> closed;  ///< ascending
  Nanoseconds now = 0;            ///< of the last report
  std::vector<Record> records;    ///< what happened in the step that made this plan
  bool settled = true;            ///< whether charts are free of conflicts
};

/// The best way of each robot by A*, with its chart, and general collision avoidance (the Blackmon
/// paper, "Background"). Throws std::invalid_argument for robots whose nodes are unknown, whose
/// start is before 0 or after 71 years, or whose speed is not above 0; for lanes and settings as
/// shortest_way and avoid_conflicts do.
Plan make_plan(const LaneNetwork& network, std::vector<Robot> robots,
               const PlanSettings& settings = {}, std::vector<LaneIndex> closed = {});

/// A robot at a landmark that found the lane ahead blocked, or free again. With each report all
/// robots are taken to be where their charts say.
struct LaneReport {
  RobotIndex robot = kNone;
  LaneIndex lane = kNone;
  Nanoseconds time = 0;
};

/// Alternate planning: nobody enters the lane any more. Robots whose way led there, the reporting
/// one too, plan again from the node where they stand or to which they drive; without a way to the
/// goal they return to their start. Who is already in the lane keeps its chart: its own sensors
/// decide. Who was about to take it against its direction goes back. Then general avoidance. Throws
/// std::invalid_argument for an unknown robot or lane and a time before that of the plan.
Plan lane_blocked(const LaneNetwork& network, const Plan& plan, const LaneReport& report,
                  const PlanSettings& settings = {});

/// The barrier has gone. Who gave its goal up tries again, and who went a detour takes the lane if
/// that is still better from where it is.
Plan lane_free(const LaneNetwork& network, const Plan& plan, const LaneReport& report,
               const PlanSettings& settings = {});

/// A robot that found an obstacle in the lane that it is in.
struct BypassReport {
  RobotIndex robot = kNone;
  LaneIndex lane = kNone;
  Nanoseconds time = 0;
  double travelled = 0;  ///< m, of the lane
  BypassWay way = BypassWay::kLeftLane;
};

/// Bypass planning (the Blackmon paper, "Bypass Planning" and its example). All others avoid the
/// lane, even if there is room (the paper's rule). In its lane the robot keeps its chart, unless
/// somebody ahead of it comes back there: then it goes back too. In the lane beside it drives to
/// the node where that lane begins, the bypass node, from there to the node that it was bound for,
/// and on as before. Where no lane beside runs the other way, or that one is blocked or too narrow,
/// and where the report says so, it goes back to the node where it entered the lane, with all that
/// are behind it, and they plan again from there. So it does from the lane beside, where it finds
/// no way on there: `lane` and `travelled` are then still those of its own lane, and both lanes are
/// closed. Then avoidance, at nodes and head-on. Throws std::invalid_argument as lane_blocked does,
/// and if by its chart the robot is not in the lane at that time.
Plan bypass(const LaneNetwork& network, const Plan& plan, const BypassReport& report,
            const PlanSettings& settings = {});

}  // namespace rubicon::charts
