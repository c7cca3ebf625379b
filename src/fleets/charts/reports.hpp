#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "src/fleets/charts/plan.hpp"

namespace rubicon::charts {

/// What a robot tells the centre of a lane.
struct SiteReport {
  enum class Kind {
    kBlocked,   ///< something stands in the lane ahead
    kReopened,  ///< it has gone
    kObstacle   ///< something lies in the lane that the robot is in
  };
  Kind kind = Kind::kBlocked;
  RobotIndex robot = kNone;
  LaneIndex lane = kNone;
  Nanoseconds time = 0;
  /// kObstacle only: from where to where it lies across the travelway, in m from the right-hand
  /// wall.
  double obstacle_from = 0;
  double obstacle_to = 0;
};
std::string_view name_of(SiteReport::Kind kind);

/// Something that stands at the beginning of a lane for some time. Who is about to enter the lane
/// finds it and reports; who comes to that node when it has gone reports that too.
struct Barrier {
  LaneIndex lane = kNone;
  Nanoseconds since = 0;
  Nanoseconds until = lanes::kEndOfTime;  ///< from here on it is gone
};

/// A plan that was made, and the report that it answers.
struct CourseStep {
  Nanoseconds time = 0;              ///< of the report; 0 of the first plan
  std::optional<SiteReport> report;  ///< none: the first plan
  std::int32_t listed = -1;          ///< its place among those that were given; -1: of a barrier
  Plan plan;
  // Of an obstacle:
  BypassResult bypass;
  double travelled = 0;  ///< m of the lane, when the robot met it
  /// What a reader should doubt: the robot is not where it could see the lane. Empty: nothing.
  std::string doubt;
};

/// A place on the way that a robot went: its arrival and departure there.
struct Visit {
  NodeIndex node = kNone;  ///< kNone: in a lane, where it stopped, turned or left it
  Nanoseconds arrival = 0;
  Nanoseconds departure = 0;
  // How it came there:
  LaneIndex lane = kNone;
  Leg leg = Leg::kAlong;
  Nanoseconds travel = 0;  ///< driving time
};

/// What a robot did from its start to the end of its last chart.
struct Journey {
  std::vector<Visit> visits;
  Nanoseconds alone = 0;    ///< driving time of its first way
  int yields = 0;           ///< how often its chart was moved
  Nanoseconds delayed = 0;  ///< by how much, in all
  Nanoseconds driving() const;
  Nanoseconds waiting() const;
};

/// Plans one after the other, and what came of them.
struct Course {
  std::vector<CourseStep> steps;  ///< the first plan, then one for each report
  std::vector<Journey> journeys;  ///< by robot
};

/// A report that cannot be: the robot is not where it would have to be.
struct ReportFault {
  std::size_t report = 0;
  std::string message;
  std::string hint;
};

/// Makes the first plan, and carries out the reports in their order, which has to be that of time:
/// each robot is where its chart says until the next report. A lane that is blocked is closed to
/// all (alternate planning); an obstacle in the lane of the robot is passed by the widths of gaps
/// and robot (bypass planning). What robots find of barriers on their way they report in between;
/// at one time the given reports first, then the robots in their order. Throws as make_plan does.
std::variant<Course, ReportFault> carry_out(const LaneNetwork& network,
                                            const std::vector<Robot>& robots,
                                            const PlanSettings& settings,
                                            const std::vector<SiteReport>& reports,
                                            const std::vector<Barrier>& barriers = {});

/// The charts of a plan before anybody yielded, by robot.
std::vector<Chart> charts_before_yields(const Plan& plan);

/// Where a robot is by its chart as it is at present: "it stands at B6", "it is on its way from B3
/// to B3B5", "it starts at 30 s only".
std::string place_told(const LaneNetwork& network, const Chart& present);

/// "20", "2.5": seconds.
std::string seconds_told(Nanoseconds time);

}  // namespace rubicon::charts
