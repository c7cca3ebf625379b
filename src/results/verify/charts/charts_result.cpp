#include "src/results/verify/charts/charts_result.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace rubicon::verify {

namespace {

/// 126 years: sums of two stay within 64 bits.
constexpr Ticks kLatestTime = 4'000'000'000'000'000'000;

class ChartsReader {
 public:
  explicit ChartsReader(const Json& json) : fields_(json, "the result of charts") {}

  ChartsResult read() {
    const JsonFields policy = fields_.object("policy");
    result_.tolerance = nanoseconds(policy, "tolerance_ns");
    result_.delay = nanoseconds(policy, "delay_ns");
    result_.clearance = nanoseconds(policy, "clearance_ns");
    result_.minimise = policy.text("minimise");
    if (result_.minimise != "time" && result_.minimise != "distance" &&
        result_.minimise != "cost") {
      policy.fail("time, distance or cost to be least");
    }
    result_.outcome = fields_.text("outcome");
    read_network();
    if (fields_.has("sensing")) read_sensing(fields_.object("sensing"));
    for (const Json& each : fields_.array("robots")) read_robot(each);
    if (fields_.has("barriers")) {
      for (const Json& each : fields_.array("barriers")) read_barrier(each);
    }
    for (const Json& each : fields_.array("steps")) read_step(each);
    for (const Json& each : fields_.array("ways")) read_way(each);
    if (result_.steps.empty()) fields_.fail("the first plan among the steps");
    if (result_.ways.size() != result_.robots.size()) fields_.fail("one way for each robot");
    return std::move(result_);
  }

 private:
  static Ticks nanoseconds(const JsonFields& fields, const char* name) {
    const Json& value = fields.any(name);
    if (!value.is_number_integer()) fields.fail(std::string(name) + " as a whole number");
    const auto ticks = value.get<std::int64_t>();
    if (ticks < 0 || ticks > kLatestTime) fields.fail(std::string(name) + " of 0 to 126 years");
    return ticks;
  }
  static Ticks nanoseconds_or_zero(const JsonFields& fields, const char* name) {
    return fields.has(name) ? nanoseconds(fields, name) : 0;
  }

  static double above_zero(const JsonFields& fields, const char* name) {
    const double value = fields.number(name);
    if (!(value > 0) || value > kLargestNumber) fields.fail(std::string(name) + " above 0");
    return value;
  }

  int node(const JsonFields& fields, const char* name) const {
    const auto found = node_index_.find(fields.text(name));
    if (found == node_index_.end()) fields.fail("a node that the network has");
    return found->second;
  }
  int node_or_none(const JsonFields& fields, const char* name) const {
    return fields.has(name) ? node(fields, name) : -1;
  }
  int lane_or_none(const JsonFields& fields, const char* name) const {
    if (!fields.has(name)) return -1;
    const int lane = fields.integer(name);
    if (lane < 0 || static_cast<std::size_t>(lane) >= lane_count_) {
      fields.fail("a lane that the network has");
    }
    return lane;
  }
  int robot(const JsonFields& fields, const char* name) const {
    const auto found = robot_index_.find(fields.text(name));
    if (found == robot_index_.end()) fields.fail("a robot that has an errand");
    return found->second;
  }

  double straight(std::size_t from, std::size_t to) const {
    const double x = result_.x[to] - result_.x[from], y = result_.y[to] - result_.y[from];
    return std::sqrt(x * x + y * y);
  }

  std::size_t place_of_robot(const JsonFields& fields) const {
    return static_cast<std::size_t>(robot(fields, "robot"));
  }

  void read_network() {
    struct Class {
      double speed, width, cost;
    };
    std::vector<Class> classes;
    for (const Json& each : fields_.array("classes")) {
      const JsonFields fields(each, "a class of lanes");
      classes.push_back(
          {above_zero(fields, "speed"), above_zero(fields, "width"), above_zero(fields, "cost")});
    }
    for (const Json& each : fields_.array("nodes")) {
      const JsonFields fields(each, "a node");
      node_index_.emplace(fields.text("name"), static_cast<int>(result_.nodes.size()));
      result_.nodes.push_back(fields.text("name"));
      result_.x.push_back(fields.number("x"));
      result_.y.push_back(fields.number("y"));
    }
    lane_count_ = fields_.array("lanes").size();
    for (const Json& each : fields_.array("lanes")) {
      const JsonFields fields(each, "a lane");
      ChartLane lane;
      lane.from = node(fields, "from");
      lane.to = node(fields, "to");
      lane.beside = lane_or_none(fields, "beside");
      const int its_class = fields.integer("class");
      if (its_class < 0 || static_cast<std::size_t>(its_class) >= classes.size()) {
        fields.fail("a class that the network has");
      }
      const Class& of = classes[static_cast<std::size_t>(its_class)];
      lane.speed = of.speed;
      lane.width = of.width;
      lane.cost = of.cost;
      const auto from = static_cast<std::size_t>(lane.from), to = static_cast<std::size_t>(lane.to);
      lane.length = fields.has("length") ? above_zero(fields, "length") : straight(from, to);
      result_.lanes.push_back(lane);
    }
  }

  void read_sensing(const JsonFields& fields) {
    ChartSensing sensing;
    sensing.braking = above_zero(fields, "braking");
    sensing.scan = fields.number("scan_s");
    sensing.reaction = fields.number("reaction_s");
    sensing.standoff = fields.number("standoff");
    if (fields.has("range")) {
      sensing.range = above_zero(fields, "range");
      sensing.greatest_speed = fields.number("greatest_speed");
    }
    const Json& classes = fields_.array("classes");
    const Json& needs = fields.array("needs");
    if (needs.size() != classes.size()) fields.fail("a need for each class of lanes");
    for (std::size_t i = 0; i < needs.size(); ++i) {
      const JsonFields of(classes[i], "a class of lanes");
      const JsonFields each(needs[i], "a need of sensing");
      if (each.text("class") != of.text("name")) each.fail("the class '" + of.text("name") + "'");
      sensing.needs.push_back({above_zero(of, "speed"), above_zero(each, "speed"),
                               each.number("until_brakes"), each.number("braked"),
                               each.number("to_stop"), each.number("two_scans"),
                               each.number("oncoming")});
    }
    result_.sensing = std::move(sensing);
  }

  void read_robot(const Json& json) {
    const JsonFields fields(json, "a robot");
    ChartRobot robot;
    robot.name = fields.text("name");
    robot.priority = fields.integer("priority");
    robot.from = node(fields, "from");
    robot.goal = node(fields, "to");
    robot.start = nanoseconds(fields, "start_ns");
    if (fields.has("speed")) robot.speed = above_zero(fields, "speed");
    robot.width = fields.number("width");
    robot_index_.emplace(robot.name, static_cast<int>(result_.robots.size()));
    result_.robots.push_back(std::move(robot));
  }

  void read_barrier(const Json& json) {
    const JsonFields fields(json, "a barrier");
    ChartBarrier barrier;
    barrier.lane = lane_or_none(fields, "lane");
    if (barrier.lane < 0) fields.fail("a lane");
    barrier.since = nanoseconds(fields, "since_ns");
    if (fields.has("until_ns")) barrier.until = nanoseconds(fields, "until_ns");
    result_.barriers.push_back(barrier);
  }

  ChartStop stop_of(const Json& json) const {
    const JsonFields fields(json, "a place of a chart");
    ChartStop stop;
    stop.node = node_or_none(fields, "node");
    stop.arrival = nanoseconds(fields, "arrival_ns");
    stop.lane = lane_or_none(fields, "lane");
    stop.travel = nanoseconds_or_zero(fields, "travel_ns");
    stop.departure = nanoseconds_or_zero(fields, "departure_ns");
    const std::string leg = fields.text_or("leg", "along");
    if (leg != "along" && leg != "against" && leg != "across") {
      fields.fail("along, against or across");
    }
    stop.leg = leg == "along"     ? ChartLeg::along
               : leg == "against" ? ChartLeg::against
                                  : ChartLeg::across;
    return stop;
  }

  void read_step(const Json& json) {
    const JsonFields fields(json, "a step");
    ChartStep step;
    step.time = nanoseconds(fields, "time_ns");
    step.settled = fields.truth("settled");
    if (fields.has("report")) step.report = report_of(fields.object("report"));
    for (const Json& each : fields.array("closed")) {
      step.closed.push_back(
          integer_of(each, "a closed lane", 0, static_cast<int>(lane_count_) - 1));
    }
    for (const Json& each : fields.array("records")) step.records.push_back(record_of(each));
    for (const Json& each : fields.array("charts")) {
      const JsonFields chart_fields(each, "a chart");
      if (place_of_robot(chart_fields) != step.charts.size()) {
        chart_fields.fail("the charts in the order of the robots");
      }
      RobotChart chart;
      chart.errand = chart_fields.text("errand");
      chart.passed = node_or_none(chart_fields, "passed");
      for (const Json& stop : chart_fields.array("stops")) chart.stops.push_back(stop_of(stop));
      if (chart.stops.empty()) chart_fields.fail("one place at least");
      step.charts.push_back(std::move(chart));
    }
    if (step.charts.size() != result_.robots.size()) fields.fail("one chart for each robot");
    result_.steps.push_back(std::move(step));
  }

  ChartReport report_of(const JsonFields& fields) const {
    ChartReport report;
    report.kind = fields.text("kind");
    report.robot = robot(fields, "robot");
    report.lane = lane_or_none(fields, "lane");
    if (report.lane < 0) fields.fail("a lane");
    report.told = fields.text("told");
    report.is_doubted = fields.has("doubt");
    if (report.kind == "obstacle") {
      report.travelled = fields.number("travelled");
      report.gap = fields.number("gap");
      report.from = fields.number("obstacle_from");
      report.to = fields.number("obstacle_to");
      report.way = fields.text("way");
    } else if (report.kind != "blocked" && report.kind != "reopened") {
      fields.fail("blocked, reopened or obstacle");
    }
    return report;
  }

  ChartRecord record_of(const Json& json) const {
    const JsonFields fields(json, "a record");
    ChartRecord record;
    record.kind = fields.text("kind");
    record.robot = robot(fields, "robot");
    record.time = nanoseconds(fields, "time_ns");
    record.told = fields.text("told");
    record.lane = lane_or_none(fields, "lane");
    record.node = node_or_none(fields, "node");
    if (record.kind == "yields") {
      record.to = robot(fields, "to");
      record.conflict = fields.text("conflict");
      record.stop = fields.integer("stop");
      record.before = nanoseconds(fields, "before_ns");
      record.after = nanoseconds(fields, "after_ns");
    }
    return record;
  }

  void read_way(const Json& json) {
    const JsonFields fields(json, "a way");
    if (place_of_robot(fields) != result_.ways.size()) {
      fields.fail("the ways in the order of the robots");
    }
    ChartWay way;
    way.errand = fields.text("errand");
    way.arrival = nanoseconds(fields, "arrival_ns");
    way.driving = nanoseconds(fields, "driving_ns");
    way.waiting = nanoseconds(fields, "waiting_ns");
    way.alone = nanoseconds(fields, "alone_ns");
    way.delayed = nanoseconds(fields, "delayed_ns");
    way.yields = fields.integer("yields");
    for (const Json& each : fields.array("visits")) way.visits.push_back(stop_of(each));
    if (way.visits.empty()) fields.fail("one place at least");
    result_.ways.push_back(std::move(way));
  }

  JsonFields fields_;
  ChartsResult result_;
  std::size_t lane_count_ = 0;
  std::map<std::string, int> node_index_, robot_index_;
};

}  // namespace

ChartsResult read_charts(const Json& json) { return ChartsReader(json).read(); }

}  // namespace rubicon::verify
