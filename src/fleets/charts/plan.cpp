#include "src/fleets/charts/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace rubicon::charts {
namespace {

std::size_t place(std::int32_t i) { return static_cast<std::size_t>(i); }

// Later charts would leave no room for delays.
constexpr Nanoseconds kLatest = lanes::kEndOfTime / 4;

bool is_closed(const Plan& plan, LaneIndex lane) {
  return std::binary_search(plan.closed.begin(), plan.closed.end(), lane);
}

// A sum that ends at the end of time.
Nanoseconds later(Nanoseconds time, Nanoseconds by) {
  return by < lanes::kEndOfTime - time ? time + by : lanes::kEndOfTime;
}

// How many stops of a chart stay as they are when its robot plans again: the node where it stands
// or starts, the one to which it drives, and a bypass to its end.
std::size_t committed_stops(const Chart& chart) {
  const std::vector<Stop>& stops = chart.stops;
  const bool on_its_way = stops.front().node == kNone &&
                          (stops.front().lane != kNone || stops.front().leg != Leg::kAlong);
  std::size_t count = std::min<std::size_t>(on_its_way ? 2 : 1, stops.size());
  // It may stand at the node in the middle of a bypass.
  while (count < stops.size() && stops[count].leg != Leg::kAlong) ++count;
  return count;
}

// One step from plan to plan.
class Step {
 public:
  Step(const LaneNetwork& network, const PlanSettings& settings, Plan plan)
      : network_(network), settings_(settings), plan_(std::move(plan)) {
    plan_.records.clear();
  }

  Plan first() {
    for (std::size_t i = 0; i < plan_.robots.size(); ++i) {
      const Robot& robot = plan_.robots[i];
      check(robot);
      plan_.charts.push_back({{{robot.from, robot.start, kNone, Leg::kAlong, 0}}, kNone, 0});
      plan_.errands.push_back(Errand::kToGoal);
      plan_again(static_cast<RobotIndex>(i), false);
    }
    return finish();
  }

  Plan blocked(const LaneReport& report) {
    begin(report.robot, report.lane, report.time);
    close(report.robot, report.lane);
    turn_back_from_bypasses(report.lane);
    plan_again_round(report.lane);
    return finish();
  }

  Plan free(const LaneReport& report) {
    begin(report.robot, report.lane, report.time);
    const auto found = std::lower_bound(plan_.closed.begin(), plan_.closed.end(), report.lane);
    if (found == plan_.closed.end() || *found != report.lane) return finish();
    plan_.closed.erase(found);
    add(RecordKind::kReopened, report.robot, report.lane, kNone);
    for (std::size_t i = 0; i < plan_.robots.size(); ++i) take_better_way(i);
    return finish();
  }

  Plan pass(const BypassReport& report) {
    begin(report.robot, report.lane, report.time);
    const bool on_bypass = report.way == BypassWay::kReverse && is_passing(report);
    if (!is_in_lane(plan_.charts[place(report.robot)], report.lane) && !on_bypass) {
      throw std::invalid_argument(
          fmt::format("bypass: {} is not on {} at {} s", plan_.robots[place(report.robot)].name,
                      network_.name_of(report.lane),
                      static_cast<double>(report.time) / static_cast<double>(kSecond)));
    }
    if (!(report.travelled >= 0) || !(report.travelled < network_.length(report.lane))) {
      throw std::invalid_argument(fmt::format(
          "bypass: expected 0 m or more and less than the {} m "
          "of {}, found {}",
          network_.length(report.lane), network_.name_of(report.lane), report.travelled));
    }
    close(report.robot, report.lane);
    const bool in_lane =
        report.way == BypassWay::kRightInLane || report.way == BypassWay::kLeftInLane;
    if (in_lane && !somebody_comes_back(report)) {
      stay_in_lane(report);
    } else if (report.way == BypassWay::kLeftLane && can_borrow(report)) {
      borrow(report);
    } else {
      go_back(report);
    }
    if (on_bypass) {
      const LaneIndex beside = network_.lane(report.lane).beside;
      close(report.robot, beside);
      turn_back_from_bypasses(beside);
      plan_again_round(beside);
    }
    turn_back_from_bypasses(report.lane);
    plan_again_round(report.lane);
    return finish();
  }

 private:
  void check(const Robot& robot) const {
    const auto is_node = [this](NodeIndex i) { return i >= 0 && i < network_.node_count(); };
    if (!is_node(robot.from) || !is_node(robot.goal)) {
      throw std::invalid_argument(
          fmt::format("{}: expected its start and its goal among the {} nodes", robot.name,
                      network_.node_count()));
    }
    if (robot.start < 0 || robot.start > kLatest) {
      throw std::invalid_argument(
          fmt::format("{}: expected a start between 0 s and 71 years", robot.name));
    }
  }

  // A report from the site: everybody is where the chart says.
  void begin(RobotIndex robot, LaneIndex lane, Nanoseconds time) {
    if (robot < 0 || place(robot) >= plan_.robots.size()) {
      throw std::invalid_argument(fmt::format("report: there is no robot number {}", robot));
    }
    if (lane < 0 || lane >= network_.lane_count()) {
      throw std::invalid_argument(fmt::format("report: there is no lane number {}", lane));
    }
    if (time < plan_.now || time > kLatest) {
      throw std::invalid_argument("report: expected a time that is not before the last report");
    }
    plan_.now = time;
    for (Chart& chart : plan_.charts) chart = chart_at(chart, time);
  }

  void add(RecordKind kind, RobotIndex robot, LaneIndex lane, NodeIndex node) {
    Record record;
    record.kind = kind;
    record.time = plan_.now;
    record.robot = robot;
    record.lane = lane;
    record.node = node;
    plan_.records.push_back(record);
  }

  void close(RobotIndex robot, LaneIndex lane) {
    add(RecordKind::kSeen, robot, lane, kNone);
    if (is_closed(plan_, lane)) return;
    plan_.closed.insert(std::lower_bound(plan_.closed.begin(), plan_.closed.end(), lane), lane);
    add(RecordKind::kReported, robot, lane, kNone);
  }

  std::optional<lanes::Way> way_of(const Robot& robot, NodeIndex from, NodeIndex to) const {
    lanes::WayOptions options;
    options.criterion = settings_.criterion;
    options.vehicle_speed = robot.speed;
    options.vehicle_width = robot.width;
    options.closed = plan_.closed;
    std::optional<lanes::Way> way = lanes::shortest_way(network_, from, to, options);
    if (way && way->time > kLatest) way.reset();
    return way;
  }

  NodeIndex node_before(const Chart& chart, std::size_t stop) const {
    const NodeIndex node = chart.stops[stop - 1].node;
    return node == kNone ? chart.passed : node;
  }

  void append(Chart& chart, const std::vector<LaneIndex>& way, double speed) const {
    for (const LaneIndex lane : way) {
      const Nanoseconds travel = network_.time(lane, speed);
      chart.stops.push_back({network_.lane(lane).to, later(chart.stops.back().arrival, travel),
                             lane, Leg::kAlong, travel});
    }
  }

  void plan_again(RobotIndex index, bool tell) {
    const Robot& robot = plan_.robots[place(index)];
    Chart& chart = plan_.charts[place(index)];
    const std::size_t kept = committed_stops(chart);
    const NodeIndex from = node_before(chart, kept);
    chart.stops.resize(kept);
    Errand& errand = plan_.errands[place(index)];
    RecordKind kind = RecordKind::kPlannedAgain;
    errand = Errand::kToGoal;
    std::optional<lanes::Way> way = way_of(robot, from, robot.goal);
    if (!way) {
      kind = RecordKind::kReturns;
      errand = Errand::kBack;
      way = way_of(robot, from, robot.from);
      // Who is at its start has nowhere to return to: it has not left, or it is back.
      if (!way || from == robot.from) {
        kind = RecordKind::kStranded;
        errand = Errand::kStranded;
      }
    }
    if (way) append(chart, way->lanes, robot.speed);
    if (tell || kind != RecordKind::kPlannedAgain) add(kind, index, kNone, from);
  }

  // All whose way leads onto the lane.
  void plan_again_round(LaneIndex lane) {
    for (std::size_t i = 0; i < plan_.charts.size(); ++i) {
      const Chart& chart = plan_.charts[i];
      if (chart.stops.empty()) continue;
      const auto rest = chart.stops.begin() + static_cast<std::ptrdiff_t>(committed_stops(chart));
      if (std::any_of(rest, chart.stops.end(),
                      [lane](const Stop& stop) { return stop.lane == lane; })) {
        plan_again(static_cast<RobotIndex>(i), true);
      }
    }
  }

  double measure(const std::vector<LaneIndex>& way, double speed) const {
    double sum = 0;
    for (const LaneIndex lane : way) {
      switch (settings_.criterion) {
        case lanes::Criterion::kTime:
          sum += static_cast<double>(network_.time(lane, speed));
          break;
        case lanes::Criterion::kDistance:
          sum += network_.length(lane);
          break;
        case lanes::Criterion::kCost:
          sum += network_.length(lane) * network_.class_of(lane).cost;
          break;
      }
    }
    return sum;
  }

  void take_better_way(std::size_t i) {
    const Robot& robot = plan_.robots[i];
    const Chart& chart = plan_.charts[i];
    if (chart.stops.empty()) return;
    const std::size_t kept = committed_stops(chart);
    const NodeIndex from = node_before(chart, kept);
    const std::optional<lanes::Way> way = way_of(robot, from, robot.goal);
    if (!way) {
      // Still not to its goal, but perhaps back.
      const std::optional<lanes::Way> back = way_of(robot, from, robot.from);
      const bool was_stranded = plan_.errands[i] == Errand::kStranded && from != robot.from;
      const bool returns = plan_.errands[i] == Errand::kBack;
      if (back && (was_stranded || (returns && is_better(*back, i, kept)))) {
        plan_again(static_cast<RobotIndex>(i), true);
      }
      return;
    }
    if (plan_.errands[i] == Errand::kToGoal && !is_better(*way, i, kept)) return;
    plan_again(static_cast<RobotIndex>(i), true);
  }

  // Than what the robot is going to do after the stops that it keeps.
  bool is_better(const lanes::Way& way, std::size_t i, std::size_t kept) const {
    const std::vector<Stop>& stops = plan_.charts[i].stops;
    std::vector<LaneIndex> rest;
    for (std::size_t k = kept; k < stops.size(); ++k) rest.push_back(stops[k].lane);
    // A share of what rounding makes of two sums of the same lanes.
    constexpr double kWorthwhile = 1 - 1e-9;
    const double speed = plan_.robots[i].speed;
    return measure(way.lanes, speed) < measure(rest, speed) * kWorthwhile;
  }

  // The lane beside has to run the other way: to begin nearer to the end of the lane than to its
  // start.
  bool can_borrow(const BypassReport& report) const {
    const lanes::Lane& lane = network_.lane(report.lane);
    if (lane.beside == kNone || is_closed(plan_, lane.beside)) return false;
    const NodeIndex begins = network_.lane(lane.beside).from;
    return network_.class_of(lane.beside).width >= plan_.robots[place(report.robot)].width &&
           network_.distance(begins, lane.to) < network_.distance(begins, lane.from);
  }

  static bool is_in_lane(const Chart& chart, LaneIndex lane) {
    return chart.stops.size() > 1 && chart.stops.front().node == kNone &&
           chart.stops.front().lane == lane && chart.stops.front().leg == Leg::kAlong;
  }

  // Still waiting to drive against the direction of a lane: the one beside, or back in its own.
  static bool is_about_to_take(const Chart& chart, LaneIndex lane) {
    return chart.stops[1].lane == lane && chart.stops[1].leg == Leg::kAgainst;
  }

  // In the lane beside, round an obstacle in the lane of the report.
  bool is_passing(const BypassReport& report) const {
    const Chart& chart = plan_.charts[place(report.robot)];
    return is_out_of_lane(chart) && chart.stops.front().leg == Leg::kAgainst &&
           chart.stops.front().lane == network_.lane(report.lane).beside &&
           chart.passed == network_.lane(report.lane).from;
  }

  // From the end of the lane on as the old chart has it, but without its waits; a new way if the
  // robot was about to go back.
  void go_on(RobotIndex index, const Chart& old) {
    Chart& chart = plan_.charts[place(index)];
    const std::size_t ahead = committed_stops(old);
    if (old.stops[ahead - 1].node != chart.stops.back().node) {
      plan_again(index, true);
      return;
    }
    std::vector<LaneIndex> rest;
    for (std::size_t i = ahead; i < old.stops.size(); ++i) rest.push_back(old.stops[i].lane);
    append(chart, rest, plan_.robots[place(index)].speed);
  }

  Nanoseconds rest_of_lane(const BypassReport& report) const {
    return network_.time_of_part(report.lane, network_.length(report.lane) - report.travelled,
                                 plan_.robots[place(report.robot)].speed);
  }

  void stay_in_lane(const BypassReport& report) {
    Chart& chart = plan_.charts[place(report.robot)];
    add(RecordKind::kPassesInLane, report.robot, report.lane, kNone);
    if (chart.stops[1].leg == Leg::kAlong) return;
    // It was about to leave the lane, and need not.
    const Chart old = chart;
    const Nanoseconds travel = rest_of_lane(report);
    chart.stops.resize(1);
    chart.stops.front().arrival = plan_.now;
    chart.stops.push_back({network_.lane(report.lane).to, later(plan_.now, travel), report.lane,
                           Leg::kAlong, travel});
    go_on(report.robot, old);
  }

  void borrow(const BypassReport& report) {
    const Robot& robot = plan_.robots[place(report.robot)];
    Chart& chart = plan_.charts[place(report.robot)];
    const LaneIndex beside = network_.lane(report.lane).beside;
    const NodeIndex node = network_.lane(beside).from;
    const NodeIndex next = network_.lane(report.lane).to;
    const Chart old = chart;
    chart.stops.resize(1);
    chart.stops.front().arrival = plan_.now;

    const auto push = [&chart](NodeIndex to, LaneIndex lane, Leg leg, Nanoseconds travel) {
      chart.stops.push_back({to, later(chart.stops.back().arrival, travel), lane, leg, travel});
    };
    push(node, beside, Leg::kAgainst, rest_of_lane(report));
    if (node != next) {
      const LaneIndex with = network_.find_lane(node, next);
      const LaneIndex against = network_.find_lane(next, node);
      if (with != kNone) {
        push(next, with, Leg::kAcross, network_.time(with, robot.speed));
      } else if (against != kNone) {
        push(next, against, Leg::kAgainst, network_.time(against, robot.speed));
      } else {
        push(next, kNone, Leg::kAcross,
             network_.time_of_part(report.lane, network_.distance(node, next), robot.speed));
      }
    }
    add(RecordKind::kBypasses, report.robot, beside, node);
    go_on(report.robot, old);
  }

  // How far a robot is in a lane: what is left of it, as a share. Of two that have as much left the
  // later one is behind.
  struct PlaceInLane {
    double left = 0;
    Nanoseconds entered = 0;
  };

  bool is_behind(std::size_t i, LaneIndex lane, const PlaceInLane& other) const {
    const Chart& chart = plan_.charts[i];
    const double left = static_cast<double>(chart.stops[1].travel) /
                        static_cast<double>(network_.time(lane, plan_.robots[i].speed));
    constexpr double kSamePlace = 1e-6;
    if (std::abs(left - other.left) > kSamePlace) return left > other.left;
    return chart.entered > other.entered;
  }

  // Whether a robot ahead of the one of the report drives back towards it, or is about to: then
  // room beside the obstacle is no help.
  bool somebody_comes_back(const BypassReport& report) const {
    const double its_left = 1 - report.travelled / network_.length(report.lane);
    for (std::size_t i = 0; i < plan_.charts.size(); ++i) {
      const Chart& chart = plan_.charts[i];
      if (static_cast<RobotIndex>(i) == report.robot || chart.stops.size() < 2) continue;
      const bool is_there =
          chart.stops.front().node == kNone && chart.stops.front().lane == report.lane;
      if (!is_there || !is_about_to_take(chart, report.lane)) continue;
      const double driven = static_cast<double>(chart.stops[1].travel) /
                            static_cast<double>(network_.time(report.lane, plan_.robots[i].speed));
      if (1 - driven < its_left) return true;
    }
    return false;
  }

  // Those behind a place in the lane, but for who goes back already.
  void turn_back_behind(LaneIndex lane, const PlaceInLane& place_in_lane) {
    for (std::size_t i = 0; i < plan_.charts.size(); ++i) {
      const Chart& chart = plan_.charts[i];
      if (!is_in_lane(chart, lane) || is_about_to_take(chart, lane) ||
          !is_behind(i, lane, place_in_lane)) {
        continue;
      }
      turn_back(static_cast<RobotIndex>(i), lane,
                network_.time(lane, plan_.robots[i].speed) - chart.stops[1].travel);
    }
  }

  // The robot of the report, and those behind it in the lane.
  void go_back(const BypassReport& report) {
    const Chart& chart = plan_.charts[place(report.robot)];
    const PlaceInLane at{1 - report.travelled / network_.length(report.lane), chart.entered};
    const bool is_in_it = is_in_lane(chart, report.lane);
    turn_back(report.robot, report.lane,
              network_.time_of_part(report.lane, report.travelled,
                                    plan_.robots[place(report.robot)].speed));
    if (is_in_it) turn_back_behind(report.lane, at);
  }

  void turn_back(RobotIndex index, LaneIndex lane, Nanoseconds driven) {
    const NodeIndex node = network_.lane(lane).from;
    const Nanoseconds back = std::max<Nanoseconds>(1, driven);
    Chart& chart = plan_.charts[place(index)];
    chart.stops.resize(1);
    chart.stops.front().arrival = plan_.now;
    chart.stops.push_back({node, later(plan_.now, back), lane, Leg::kAgainst, back});
    add(RecordKind::kGoesBack, index, lane, node);
    plan_again(index, true);
  }

  // Those that were about to take this lane against its direction, round an obstacle in the one
  // beside it, find no way there either: they go back, with those behind them.
  void turn_back_from_bypasses(LaneIndex lane) {
    const LaneIndex own = network_.lane(lane).beside;
    for (std::size_t i = 0; own != kNone && i < plan_.charts.size(); ++i) {
      const Chart& chart = plan_.charts[i];
      if (!is_in_lane(chart, own) || !is_about_to_take(chart, lane)) continue;
      const Nanoseconds full = network_.time(own, plan_.robots[i].speed);
      const Nanoseconds left = chart.stops[1].travel;
      const PlaceInLane at{static_cast<double>(left) / static_cast<double>(full), chart.entered};
      turn_back(static_cast<RobotIndex>(i), own, full - left);
      turn_back_behind(own, at);
    }
  }

  Plan finish() {
    plan_.settled = avoid_conflicts(plan_.robots, plan_.charts, settings_.avoidance, plan_.records);
    return std::move(plan_);
  }

  const LaneNetwork& network_;
  const PlanSettings& settings_;
  Plan plan_;
};

}  // namespace

std::string_view name_of(Errand errand) {
  switch (errand) {
    case Errand::kToGoal:
      return "to_goal";
    case Errand::kBack:
      return "back";
    case Errand::kStranded:
      return "stranded";
  }
  return "";
}

Plan make_plan(const LaneNetwork& network, std::vector<Robot> robots, const PlanSettings& settings,
               std::vector<LaneIndex> closed) {
  Plan plan;
  plan.robots = std::move(robots);
  plan.closed = std::move(closed);
  return Step(network, settings, std::move(plan)).first();
}

Plan lane_blocked(const LaneNetwork& network, const Plan& plan, const LaneReport& report,
                  const PlanSettings& settings) {
  return Step(network, settings, plan).blocked(report);
}

Plan lane_free(const LaneNetwork& network, const Plan& plan, const LaneReport& report,
               const PlanSettings& settings) {
  return Step(network, settings, plan).free(report);
}

Plan bypass(const LaneNetwork& network, const Plan& plan, const BypassReport& report,
            const PlanSettings& settings) {
  return Step(network, settings, plan).pass(report);
}

}  // namespace rubicon::charts
