#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "src/results/verify/input/fault.hpp"
#include "src/results/verify/input/json_fields.hpp"

namespace rubicon::verify {

/// A lane as a result of charts has it: -1 is none.
struct ChartLane {
  int from = -1, to = -1;
  int beside = -1;
  double length = 0;  ///< m
  double speed = 0;   ///< m/s, of its class
  double width = 0;   ///< m
  double cost = 0;    ///< of a metre
};

struct ChartRobot {
  std::string name;
  int priority = 0;
  int from = -1, goal = -1;
  Ticks start = 0;
  double speed = std::numeric_limits<double>::infinity();
  double width = 0;
};

enum class ChartLeg { along, against, across };

/// A line of a chart; node -1: where the robot is at present.
struct ChartStop {
  int node = -1;
  Ticks arrival = 0;
  int lane = -1;
  ChartLeg leg = ChartLeg::along;
  Ticks travel = 0;
  Ticks departure = 0;  ///< of a place of a way only
};

struct RobotChart {
  std::string errand;  ///< to_goal, back, stranded
  int passed = -1;     ///< the node behind it
  std::vector<ChartStop> stops;
};

struct ChartRecord {
  std::string kind;
  Ticks time = 0;
  std::string told;
  int robot = -1;
  int lane = -1;
  int node = -1;
  // Of a yield:
  int to = -1;
  std::string conflict;
  int stop = 0;
  Ticks before = 0, after = 0;
};

struct ChartReport {
  std::string kind;
  int robot = -1;
  int lane = -1;
  std::string told;
  bool is_doubted = false;
  // Of an obstacle:
  double from = 0, to = 0;  ///< m across
  double travelled = 0;     ///< m along the lane
  double gap = 0;           ///< m
  std::string way;
};

struct ChartStep {
  Ticks time = 0;
  std::optional<ChartReport> report;
  bool settled = true;
  std::vector<int> closed;
  std::vector<ChartRecord> records;
  std::vector<RobotChart> charts;  ///< by robot
};

struct ChartWay {
  std::string errand;
  Ticks arrival = 0, driving = 0, waiting = 0, alone = 0, delayed = 0;
  int yields = 0;
  std::vector<ChartStop> visits;
};

/// How far robots have to see in one class of lanes, m.
struct ChartSensingNeed {
  double class_speed = 0;
  double speed = 0;
  double until_brakes = 0, braked = 0, to_stop = 0, two_scans = 0, oncoming = 0;
};

struct ChartSensing {
  double braking = 0, scan = 0, reaction = 0, standoff = 0;
  double range = 0;  ///< 0: not said
  double greatest_speed = 0;
  std::vector<ChartSensingNeed> needs;  ///< by class
};

/// Something that stands at the beginning of a lane.
struct ChartBarrier {
  int lane = -1;
  Ticks since = 0;
  Ticks until = std::numeric_limits<Ticks>::max();
};

/// What `rubicon run` wrote of a network with policy charts.
struct ChartsResult {
  Ticks tolerance = 0, delay = 0, clearance = 0;
  std::string minimise;
  std::string outcome;
  std::vector<std::string> nodes;
  std::vector<double> x, y;  ///< of nodes
  std::vector<ChartLane> lanes;
  std::vector<ChartRobot> robots;
  std::vector<ChartBarrier> barriers;
  std::optional<ChartSensing> sensing;
  std::vector<ChartStep> steps;
  std::vector<ChartWay> ways;
};

/// Throws UnreadableInput.
ChartsResult read_charts(const Json& json);

}  // namespace rubicon::verify
