#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "src/fleets/lanes/lane_network.hpp"

namespace rubicon::charts {

using lanes::kNone;
using lanes::kSecond;
using lanes::LaneIndex;
using lanes::LaneNetwork;
using lanes::Nanoseconds;
using lanes::NodeIndex;

/// Robots are known by their place in a plan.
using RobotIndex = std::int32_t;

/// A vehicle and its errand.
struct Robot {
  std::string name;
  int priority = 0;  ///< the larger number has right of way
  Nanoseconds start = 0;
  NodeIndex from = kNone;
  NodeIndex goal = kNone;
  double speed = std::numeric_limits<double>::infinity();  ///< m/s; on slower lanes, as these allow
  double width = 0;                                        ///< m; keeps to lanes that are as wide
};

/// How a robot comes from one stop to the next.
enum class Leg {
  kAlong,    ///< on a lane, in its direction
  kAgainst,  ///< on a lane against its direction: part of a bypass, or back from an obstacle
  kAcross,   ///< part of a bypass, on no lane or in the direction of one
};

/// A line of a chart.
struct Stop {
  NodeIndex node = kNone;  ///< kNone: where the robot is at present ("Cur-Pos")
  Nanoseconds arrival = 0;
  /// From the stop before to this one; at the present place: the lane that the robot is on, kNone
  /// where it stands at a node.
  LaneIndex lane = kNone;
  Leg leg = Leg::kAlong;
  Nanoseconds travel = 0;  ///< driving time from the stop before
};

/// The node-time chart of a robot (the Blackmon paper, "Background"): the nodes of its way and when
/// it arrives there. Between two stops it may take longer than `travel`: then it waits at the
/// first.
struct Chart {
  std::vector<Stop> stops;
  NodeIndex passed = kNone;  ///< the last node before the present place; kNone before the start
  Nanoseconds entered = 0;   ///< when it left that node
};

/// When a robot arrives at a stop and when it leaves: the chart with its waits told.
struct Stay {
  NodeIndex node = kNone;
  Nanoseconds arrival = 0;
  Nanoseconds departure = 0;
};
std::vector<Stay> stays_of(const Chart& chart);

/// The chart as it is at `now`: what lies behind is dropped, and the present place comes first.
/// Unchanged before the start, and while the robot waits at its present place.
Chart chart_at(const Chart& chart, Nanoseconds now);

/// Whether a robot is on a bypass or on its way back from an obstacle, and no longer in its lane.
bool is_out_of_lane(const Chart& chart);

/// What happened in a step of planning; later records of the trace.
enum class RecordKind {
  kSeen,          ///< `robot` saw `lane` blocked
  kReported,      ///< the centre knows; nobody enters `lane` from here on
  kPassesInLane,  ///< `robot` passes the obstacle inside its own lane: its chart stays
  kBypasses,      ///< `robot` takes the lane beside, `lane`, against its direction
  kGoesBack,      ///< `robot` goes back to `node`, where it entered `lane`
  kPlannedAgain,  ///< `robot` has a new way from `node`
  kReturns,       ///< the same, but to its start: no way leads to its goal
  kStranded,      ///< no way leads from `node` to its goal nor back to its start
  kReopened,      ///< `lane` may be entered again
  kYields,        ///< `robot` moved its chart from `stop` on, for `other`
};
std::string_view name_of(RecordKind kind);

/// Why a robot yields.
enum class Conflict {
  kNode,    ///< both arrive at `node` within the tolerance
  kLane,    ///< head-on in the lane that a bypassing robot borrows
  kAcross,  ///< head-on on its way from the borrowed lane to its next node
};
std::string_view name_of(Conflict conflict);

struct Record {
  RecordKind kind = RecordKind::kSeen;
  Nanoseconds time = 0;  ///< of the report; kYields: when the two would have met
  RobotIndex robot = kNone;
  LaneIndex lane = kNone;
  NodeIndex node = kNone;
  // kYields only:
  RobotIndex other = kNone;  ///< who has right of way
  Conflict conflict = Conflict::kNode;
  std::int32_t stop = 0;  ///< from which on the chart of `robot` was moved
  Nanoseconds before = 0;
  Nanoseconds after = 0;
};

/// "ROB3 yields to ROB1 at B8: B3B5 at 145 s, not 60 s (lane)".
std::string told(const LaneNetwork& network, const std::vector<Robot>& robots,
                 const std::vector<Chart>& charts, const Record& record);

/// Does what a record of kind kYields says; nothing for other kinds.
void apply_yield(const Record& record, std::vector<Chart>& charts);

/// "Cur-Pos 35, B8 70, B3B5 90": times in seconds.
std::string told(const LaneNetwork& network, const Chart& chart);

/// All charts side by side, as the paper prints them.
std::string table_text(const LaneNetwork& network, const std::vector<Robot>& robots,
                       const std::vector<Chart>& charts);

}  // namespace rubicon::charts
