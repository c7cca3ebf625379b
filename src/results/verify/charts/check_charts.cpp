#include "src/results/verify/charts/check_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "src/results/verify/charts/chart_records.hpp"
#include "src/results/verify/charts/charts_result.hpp"
#include "src/results/verify/charts/least_ways.hpp"
#include "src/results/verify/charts/whereabouts.hpp"

namespace rubicon::verify {

namespace {

constexpr std::size_t kMostChartFaults = 20;
/// Driving times are rounded once each; parts of a lane, which are differences of such, to 2 ns,
/// and a lane that was left half way to as many more.
constexpr Ticks kRounding = 4;
/// A share of what rounding may make of two sums of the same lanes, as a detour is worth it only
/// beyond.
constexpr double kWorthwhile = 1e-9;

/// Lengths, as a share or in m: they are written in full.
constexpr double kSameLength = 1e-9;

std::size_t place(int i) { return static_cast<std::size_t>(i); }

bool nearly(Ticks a, Ticks b) { return std::abs(a - b) <= kRounding; }

class ChartsCheck {
 public:
  explicit ChartsCheck(ChartsResult result) : result_(std::move(result)), least_(result_) {}

  ChartsVerdict run() {
    verdict_.robots = static_cast<int>(result_.robots.size());
    verdict_.plans = static_cast<int>(result_.steps.size());
    for (std::size_t i = 0; i < result_.steps.size(); ++i) {
      step_ = i;
      check_step();
    }
    step_ = 0;
    check_sensing();
    check_ways();
    check_outcome();
    return std::move(verdict_);
  }

 private:
  const ChartStep& step() const { return result_.steps[step_]; }
  const ChartRobot& robot(std::size_t i) const { return result_.robots[i]; }
  const ChartLane& lane(int i) const { return result_.lanes[place(i)]; }
  std::string node_name(int i) const {
    return i < 0 ? std::string("its present place") : result_.nodes[place(i)];
  }
  std::string lane_name(int i) const {
    return i < 0 ? std::string("no lane")
                 : node_name(lane(i).from) + " to " + node_name(lane(i).to);
  }
  static std::string seconds(Ticks time) {
    return fmt::format("{:.9g} s", static_cast<double>(time) / 1e9);
  }

  void fault(std::string text) {
    if (verdict_.faults.size() < kMostChartFaults) {
      verdict_.faults.push_back(
          step_ == 0 ? std::move(text)
                     : fmt::format("plan of {}: {}", seconds(result_.steps[step_].time), text));
    }
  }

  Ticks full_time(int i, std::size_t of) const {
    return driving_time(lane(i), lane(i).length, robot(of).speed);
  }

  // ---- how far robots see

  /// By what a robot that brakes does: it drives on until it brakes, then its energy is used up.
  void check_sensing() {
    if (!result_.sensing) return;
    const ChartSensing& sensing = *result_.sensing;
    const auto differ = [](double a, double b) {
      return !(std::abs(a - b) <= kSameLength * std::max(1.0, std::abs(b)));
    };
    double fastest = result_.robots.empty() ? std::numeric_limits<double>::infinity() : 0;
    for (const ChartRobot& each : result_.robots) fastest = std::max(fastest, each.speed);
    // What is left of a range at a speed when the robot stands.
    const auto left = [&](double range, double speed) {
      const double stops_after = speed / sensing.braking;
      return range - sensing.standoff - speed * (sensing.scan + sensing.reaction) -
             speed * stops_after / 2;
    };
    for (const ChartSensingNeed& need : sensing.needs) {
      const std::string at = fmt::format("sensing at {:.9g} m/s: ", need.speed);
      if (differ(need.speed, std::min(need.class_speed, fastest))) {
        fault(at + fmt::format("the class has {:.9g} m/s", need.class_speed));
      }
      if (differ(left(need.to_stop, need.speed), 0)) fault(at + "the range is not what it takes");
      if (differ(need.until_brakes, need.speed * (sensing.scan + sensing.reaction))) {
        fault(at + "it brakes sooner or later than that");
      }
      if (differ(need.until_brakes + need.braked + sensing.standoff, need.to_stop)) {
        fault(at + "the parts of the range are not the range");
      }
      if (differ(need.two_scans - need.to_stop, need.speed * sensing.scan)) {
        fault(at + "a second scan takes another length");
      }
      if (differ(need.oncoming + sensing.standoff, 2 * need.to_stop)) {
        fault(at + "two that stop need another range");
      }
    }
    const bool is_far = sensing.range > sensing.standoff;
    if (sensing.range > 0 && (is_far ? differ(left(sensing.range, sensing.greatest_speed), 0)
                                     : sensing.greatest_speed != 0)) {
      fault(
          fmt::format("sensing: {:.9g} m/s is not the most for its range", sensing.greatest_speed));
    }
  }

  // ---- one plan

  void check_step() {
    check_time();
    check_closed();
    least_.close(step().closed);
    make_planned();
    for (std::string& each : chart_record_faults(result_, step_, planned_)) fault(std::move(each));
    for (std::size_t i = 0; i < result_.robots.size(); ++i) {
      verdict_.arrivals += static_cast<long long>(step().charts[i].stops.size());
      if (!check_start(i)) continue;
      check_chart(i);
    }
    if (!step().settled) {
      verdict_.settled = false;
      return;
    }
    check_nodes();
    check_head_on();
  }

  void check_time() {
    if (step_ == 0) {
      if (step().report) fault("the first plan answers a report");
      if (step().time != 0) fault("the first plan is made at 0 s");
      return;
    }
    if (!step().report) {
      fault("a plan answers no report");
    } else if (step().report->kind == "obstacle") {
      check_room(*step().report);
    }
    if (step().time < result_.steps[step_ - 1].time) fault("it is older than the plan before");
  }

  /// Which way round an obstacle the widths allow.
  void check_room(const ChartReport& report) {
    const ChartLane& own = lane(report.lane);
    const double wide = robot(place(report.robot)).width;
    const double both = own.width + (own.beside < 0 ? 0 : lane(own.beside).width);
    std::string way = "reverse";
    if (own.beside >= 0 && both - report.to >= wide) way = "left_lane";
    if (own.width - report.to >= wide) way = "left_in_lane";
    if (std::min(own.width, report.from) >= wide) way = "right_in_lane";
    if (report.way != way) {
      fault(fmt::format("{} is said to go {} past the obstacle, and has room for {}",
                        robot(place(report.robot)).name, report.way, way));
    }
  }

  /// Closed lanes are those before, and what the report says.
  void check_closed() {
    std::set<int> closed;
    if (step_ > 0) {
      const auto& before = result_.steps[step_ - 1].closed;
      closed.insert(before.begin(), before.end());
    }
    if (step().report) {
      const ChartReport& report = *step().report;
      if (report.kind == "reopened") {
        closed.erase(report.lane);
      } else {
        closed.insert(report.lane);
        // Who finds no way on in the lane beside closes that one too.
        if (is_out_round(report)) closed.insert(lane(report.lane).beside);
      }
    }
    if (std::vector<int>(closed.begin(), closed.end()) != step().closed) {
      fault("the closed lanes are not those that were reported");
    }
  }

  /// Whether the reporting robot was in the lane beside the one that it reports.
  bool is_out_round(const ChartReport& report) const {
    if (report.kind != "obstacle" || step_ == 0) return false;
    const auto& stops = result_.steps[step_ - 1].charts[place(report.robot)].stops;
    const Whereabouts at = whereabouts(stops, step().time);
    if (at.next >= stops.size()) return false;
    if (at.kind == Whereabouts::Kind::in_motion) {
      return stops[at.next].leg == ChartLeg::against &&
             stops[at.next].lane == lane(report.lane).beside;
    }
    return at.kind == Whereabouts::Kind::at_present_place &&
           stops[at.next - 1].leg == ChartLeg::against &&
           stops[at.next - 1].lane == lane(report.lane).beside;
  }

  /// The charts before anybody yielded, and each yield on its way from there.
  void make_planned() {
    planned_.clear();
    for (const RobotChart& chart : step().charts) planned_.push_back(chart.stops);
    for (auto yield = step().records.rbegin(); yield != step().records.rend(); ++yield) {
      if (yield->kind == "yields") move(*yield, yield->before - yield->after);
    }
    std::vector<std::vector<ChartStop>> charts = planned_;
    for (const ChartRecord& record : step().records) {
      if (record.kind == "yields") check_yield(record, charts);
    }
  }

  void move(const ChartRecord& yield, Ticks by) {
    std::vector<ChartStop>& stops = planned_[place(yield.robot)];
    for (std::size_t i = place(std::max(0, yield.stop)); i < stops.size(); ++i) {
      stops[i].arrival += by;
    }
  }

  void check_yield(const ChartRecord& yield, std::vector<std::vector<ChartStop>>& charts) {
    const std::string& who = robot(place(yield.robot)).name;
    const std::string& other = robot(place(yield.to)).name;
    std::vector<ChartStop>& stops = charts[place(yield.robot)];
    if (yield.stop < 0 || place(yield.stop) >= stops.size() || yield.after <= yield.before ||
        stops[place(yield.stop)].arrival != yield.before) {
      fault(fmt::format("{} does not yield to {} as its chart says", who, other));
      return;
    }
    if (yield.conflict == "node") {
      bool meets = false;
      for (const ChartStop& a : stops) {
        for (const ChartStop& b : charts[place(yield.to)]) {
          meets = meets || (a.node == yield.node && b.node == yield.node && yield.node >= 0 &&
                            std::abs(a.arrival - b.arrival) < result_.tolerance);
        }
      }
      if (!meets) fault(fmt::format("{} yields to {}, which is not there", who, other));
      if (yield.after - yield.before != result_.delay) {
        fault(fmt::format("{} yields by {}, and the delay is {}", who,
                          seconds(yield.after - yield.before), seconds(result_.delay)));
      }
    }
    const bool plain = is_along(charts[place(yield.robot)]) && is_along(charts[place(yield.to)]);
    if (plain &&
        std::none_of(charts.begin(), charts.end(),
                     [](const auto& each) { return !is_along(each); }) &&
        goes_first(yield.robot, yield.to)) {
      fault(fmt::format("{} yields to {}, and has right of way", who, other));
    }
    const Ticks by = yield.after - yield.before;
    for (std::size_t i = place(yield.stop); i < stops.size(); ++i) stops[i].arrival += by;
  }

  static bool is_along(const std::vector<ChartStop>& stops) {
    return std::all_of(stops.begin(), stops.end(),
                       [](const ChartStop& stop) { return stop.leg == ChartLeg::along; });
  }

  bool goes_first(int a, int b) const {
    const auto key = [&](int i) {
      const ChartRobot& of = robot(place(i));
      return std::tuple(-of.priority, of.start, i);
    };
    return key(a) < key(b);
  }

  // ---- where a chart begins

  bool check_start(std::size_t i) {
    const std::vector<ChartStop>& stops = step().charts[i].stops;
    const std::string& who = robot(i).name;
    if (step_ == 0) {
      if (stops.front().node == robot(i).from && planned_[i].front().arrival == robot(i).start) {
        return true;
      }
      fault(fmt::format("{} does not begin at {} at {}", who, node_name(robot(i).from),
                        seconds(robot(i).start)));
      return false;
    }
    const std::vector<ChartStop>& before = result_.steps[step_ - 1].charts[i].stops;
    const Whereabouts at = whereabouts(before, step().time);
    const ChartStop& front = stops.front();
    bool fine = false;
    switch (at.kind) {
      case Whereabouts::Kind::not_started:
        fine = front.node == before.front().node && front.arrival >= before.front().arrival;
        break;
      case Whereabouts::Kind::at_node:
        fine = front.node < 0 && front.lane < 0 && front.leg == ChartLeg::along &&
               step().charts[i].passed == at.node && front.arrival >= step().time;
        break;
      case Whereabouts::Kind::at_present_place:
        fine = front.node < 0 && front.lane == before[at.next - 1].lane &&
               front.leg == before[at.next - 1].leg && front.arrival >= step().time;
        break;
      case Whereabouts::Kind::in_motion:
        fine = front.node < 0 && front.lane == before[at.next].lane &&
               front.leg == before[at.next].leg && front.arrival >= step().time;
        break;
    }
    if (!fine) {
      fault(fmt::format("the chart of {} does not begin where {} is", who, who));
      return false;
    }
    return check_turn(i, before, at);
  }

  /// Who is between two nodes drives on, unless the report is of its lane.
  bool check_turn(std::size_t i, const std::vector<ChartStop>& before, const Whereabouts& at) {
    const std::vector<ChartStop>& stops = step().charts[i].stops;
    const bool is_between = at.kind == Whereabouts::Kind::in_motion ||
                            (at.kind == Whereabouts::Kind::at_present_place &&
                             at.next < before.size() && before[at.next - 1].lane >= 0);
    if (!is_between) return true;
    const ChartStop& next = before[at.next];
    const Ticks remaining = at.kind == Whereabouts::Kind::in_motion ? at.remaining : next.travel;
    if (stops.size() < 2) {
      fault(fmt::format("{} stays in {}", robot(i).name, lane_name(stops.front().lane)));
      return false;
    }
    const ChartStop& now = stops[1];
    if (now.node == next.node && now.lane == next.lane && now.leg == next.leg) {
      if (nearly(now.travel, remaining)) return true;
      fault(fmt::format("{} has {} to drive to {}, and is said to have {}", robot(i).name,
                        seconds(remaining), node_name(now.node), seconds(now.travel)));
      return false;
    }
    const ChartReport& report = *step().report;
    const int own = own_lane(stops.front());
    const bool concerns = own == report.lane || (own >= 0 && lane(own).beside == report.lane);
    if (!concerns) {
      fault(fmt::format("{} leaves {} without a report of it", robot(i).name,
                        lane_name(stops.front().lane)));
      return false;
    }
    // How much of its own lane it has behind it.
    const Ticks full = full_time(own, i);
    const bool was_going_back = next.leg == ChartLeg::against && next.lane == own;
    const Ticks ahead = was_going_back ? full - remaining : remaining;
    Ticks expected = -1;
    const bool is_beside = now.lane >= 0 && now.lane == lane(own).beside &&
                           now.leg == ChartLeg::against && now.node == lane(now.lane).from;
    if ((now.lane == own && now.leg == ChartLeg::along && now.node == lane(own).to) || is_beside) {
      expected = ahead;
    } else if (now.lane == own && now.leg == ChartLeg::against && now.node == lane(own).from) {
      expected = std::max<Ticks>(1, full - ahead);
    }
    if (expected >= 0 && nearly(now.travel, expected)) return true;
    fault(fmt::format("{} cannot be at {} after driving {}", robot(i).name, node_name(now.node),
                      seconds(now.travel)));
    return false;
  }

  /// The lane that a robot out of it, or in it, came by.
  int own_lane(const ChartStop& front) const {
    if (front.lane < 0) return -1;
    if (front.leg == ChartLeg::along) return front.lane;
    // Against: back in its own, or on the lane beside its own.
    if (!step().report) return front.lane;
    const int reported = step().report->lane;
    return lane(front.lane).beside == reported ? reported : front.lane;
  }

  // ---- the rest of a chart

  void check_chart(std::size_t i) {
    const RobotChart& chart = step().charts[i];
    const std::vector<ChartStop>& stops = chart.stops;
    int at = stops.front().node >= 0 ? stops.front().node : chart.passed;
    std::size_t k = 1;
    // Between two nodes: to the next one, and a bypass to its end.
    if (stops.front().node < 0 &&
        (stops.front().lane >= 0 || stops.front().leg != ChartLeg::along)) {
      if (stops.size() < 2) return;
      at = stops[1].node;
      k = 2;
    }
    for (; k < stops.size() && stops[k].leg != ChartLeg::along; ++k) {
      if (!check_bypass_leg(i, at, stops[k])) return;
      at = stops[k].node;
    }
    const std::size_t committed = k;
    const int from = at;
    Ticks sum = 0;
    for (; k < stops.size(); ++k) {
      const ChartStop& stop = stops[k];
      if (stop.lane < 0 || stop.leg != ChartLeg::along || lane(stop.lane).from != at ||
          lane(stop.lane).to != stop.node) {
        fault(fmt::format("{} comes from {} to {} by no lane", robot(i).name, node_name(at),
                          node_name(stop.node)));
        return;
      }
      if (std::abs(stop.travel - full_time(stop.lane, i)) > 1) {
        fault(fmt::format("{} takes {} for {}, and is said to take {}", robot(i).name,
                          seconds(full_time(stop.lane, i)), lane_name(stop.lane),
                          seconds(stop.travel)));
      }
      if (std::binary_search(step().closed.begin(), step().closed.end(), stop.lane)) {
        fault(fmt::format("{} enters {}, which is closed", robot(i).name, lane_name(stop.lane)));
      }
      if (lane(stop.lane).width < robot(i).width) {
        fault(fmt::format("{} is too wide for {}", robot(i).name, lane_name(stop.lane)));
      }
      sum += least_.weight(stop.lane, robot(i));
      at = stop.node;
    }
    for (std::size_t m = 1; m < stops.size(); ++m) {
      if (stops[m].arrival - stops[m - 1].arrival >= stops[m].travel) continue;
      fault(fmt::format("{} is at {} before it can be there", robot(i).name,
                        node_name(stops[m].node)));
    }
    check_unchanged(i, committed);
    check_errand(i, from, at, sum, stops.size() - committed);
  }

  /// On a lane against its direction, or across from the lane beside to the own one.
  bool check_bypass_leg(std::size_t i, int at, const ChartStop& stop) {
    Ticks expected = -1;
    if (stop.lane >= 0) {
      const bool against = stop.leg == ChartLeg::against;
      const ChartLane& of = lane(stop.lane);
      if ((against ? of.to : of.from) == at && (against ? of.from : of.to) == stop.node) {
        expected = full_time(stop.lane, i);
      }
    } else {
      expected = stop.travel;  // as the crow flies, at the speed of a lane: at most this fast
      const double x = result_.x[place(at)] - result_.x[place(stop.node)];
      const double y = result_.y[place(at)] - result_.y[place(stop.node)];
      const double metres = std::sqrt(x * x + y * y);
      double fastest = 0;
      for (const ChartLane& each : result_.lanes) fastest = std::max(fastest, each.speed);
      const double least = metres / std::min(fastest, robot(i).speed) * 1e9;
      if (static_cast<double>(stop.travel) < least - 1) expected = -1;
    }
    if (expected >= 0 && nearly(stop.travel, expected)) return true;
    fault(fmt::format("{} cannot come from {} to {} in {}", robot(i).name, node_name(at),
                      node_name(stop.node), seconds(stop.travel)));
    return false;
  }

  bool has_new_way(std::size_t i) const {
    return std::any_of(step().records.begin(), step().records.end(), [i](const ChartRecord& each) {
      return place(each.robot) == i &&
             (each.kind == "planned_again" || each.kind == "returns" || each.kind == "stranded" ||
              each.kind == "bypasses" || each.kind == "goes_back" || each.kind == "passes_in_lane");
    });
  }

  /// Before anybody yielded: who has no new way has the times of before; a new way has no waits.
  void check_unchanged(std::size_t i, std::size_t committed) {
    const std::vector<ChartStop>& stops = planned_[i];
    if (step_ == 0 || has_new_way(i)) {
      for (std::size_t k = std::max<std::size_t>(1, committed); k < stops.size(); ++k) {
        if (stops[k].arrival == stops[k - 1].arrival + stops[k].travel) continue;
        if (step_ > 0 && passes_in_lane(i)) return;
        fault(fmt::format("{} waits before {}, and yields to nobody", robot(i).name,
                          node_name(stops[k].node)));
        return;
      }
      return;
    }
    const std::vector<ChartStop>& before = result_.steps[step_ - 1].charts[i].stops;
    const Whereabouts at = whereabouts(before, step().time);
    const std::size_t skip = at.kind == Whereabouts::Kind::not_started ? 0 : 1;
    bool same = stops.size() - skip == before.size() - std::min(before.size(), at.next);
    for (std::size_t k = skip; same && k < stops.size(); ++k) {
      const ChartStop& old = before[at.next + k - skip];
      same = old.node == stops[k].node && old.arrival == stops[k].arrival;
    }
    if (!same) fault(fmt::format("{} has another chart without a cause", robot(i).name));
  }

  bool passes_in_lane(std::size_t i) const {
    return std::any_of(step().records.begin(), step().records.end(), [i](const ChartRecord& each) {
      return place(each.robot) == i && each.kind == "passes_in_lane";
    });
  }

  void check_errand(std::size_t i, int from, int end, Ticks sum, std::size_t lanes) {
    const std::string& errand = step().charts[i].errand;
    const Ticks to_goal = least_.least(from, robot(i).goal, robot(i));
    const Ticks to_start = least_.least(from, robot(i).from, robot(i));
    const auto good = [&](Ticks least) {
      const double slack = static_cast<double>(least) * kWorthwhile + static_cast<double>(lanes);
      return static_cast<double>(std::abs(sum - least)) <= slack;
    };
    if (errand == "to_goal") {
      if (end != robot(i).goal) {
        fault(fmt::format("{} ends at {}, not at its goal {}", robot(i).name, node_name(end),
                          node_name(robot(i).goal)));
      } else if (!good(to_goal)) {
        fault(fmt::format("the way of {} from {} has {} {}, and the best one {}", robot(i).name,
                          node_name(from), result_.minimise, static_cast<double>(sum) / 1e9,
                          static_cast<double>(to_goal) / 1e9));
      }
      return;
    }
    if (to_goal < LeastWays::kNoWayThere) {
      fault(fmt::format("{} gives up, and a way leads from {} to its goal", robot(i).name,
                        node_name(from)));
    } else if (errand == "back" && (end != robot(i).from || !good(to_start))) {
      fault(fmt::format("{} does not return to {} by the best way", robot(i).name,
                        node_name(robot(i).from)));
    } else if (errand == "stranded" &&
               (end != from || (from != robot(i).from && to_start < LeastWays::kNoWayThere))) {
      fault(fmt::format("{} is said to be stranded, and a way leads back", robot(i).name));
    } else if (errand != "back" && errand != "stranded") {
      fault(fmt::format("{} has an unknown errand", robot(i).name));
    }
  }

  // ---- who meets whom

  void check_nodes() {
    std::map<int, std::vector<std::pair<Ticks, std::size_t>>> arrivals;
    for (std::size_t i = 0; i < step().charts.size(); ++i) {
      for (const ChartStop& stop : step().charts[i].stops) {
        if (stop.node >= 0) arrivals[stop.node].emplace_back(stop.arrival, i);
      }
    }
    for (auto& [node, at] : arrivals) {
      std::sort(at.begin(), at.end());
      for (std::size_t a = 0; a < at.size(); ++a) {
        for (std::size_t b = a + 1; b < at.size() && at[b].first - at[a].first < result_.tolerance;
             ++b) {
          if (at[a].second == at[b].second) continue;
          fault(fmt::format("{} and {} are both at {} about {}", robot(at[a].second).name,
                            robot(at[b].second).name, node_name(node), seconds(at[a].first)));
        }
      }
    }
  }

  /// On each lane: those who drive against its direction, and those along it.
  void check_head_on() {
    struct Drive {
      Ticks begin, end;
      std::size_t robot;
      bool is_first;  ///< it is in the lane at the time of the plan
      Ticks remaining;
    };
    std::map<int, std::pair<std::vector<Drive>, std::vector<Drive>>> drives;
    for (std::size_t i = 0; i < step().charts.size(); ++i) {
      const std::vector<ChartStop>& stops = step().charts[i].stops;
      for (std::size_t k = 1; k < stops.size(); ++k) {
        if (stops[k].lane < 0) continue;
        const bool is_first = k == 1 && stops[0].node < 0 && stops[0].lane == stops[k].lane;
        const Drive drive{stops[k].arrival - stops[k].travel, stops[k].arrival, i, is_first,
                          stops[k].travel};
        auto& [against, with] = drives[stops[k].lane];
        (stops[k].leg == ChartLeg::against ? against : with).push_back(drive);
      }
    }
    for (const auto& [lane_index, both] : drives) {
      for (const Drive& against : both.first) {
        for (const Drive& with : both.second) {
          if (with.robot == against.robot || with.begin > against.end || against.begin > with.end) {
            continue;
          }
          // Ahead of one that turns back in the same lane: they part.
          const double full = static_cast<double>(full_time(lane_index, against.robot));
          const double behind = static_cast<double>(against.remaining) / full;
          const double ahead = static_cast<double>(with.remaining) /
                               static_cast<double>(full_time(lane_index, with.robot));
          if (against.is_first && with.is_first && 1 - ahead >= behind - 1e-6) continue;
          fault(fmt::format("{} meets {} head-on in {} about {}", robot(against.robot).name,
                            robot(with.robot).name, lane_name(lane_index),
                            seconds(std::max(with.begin, against.begin))));
        }
      }
    }
  }

  // ---- the sums

  void check_ways() {
    step_ = 0;
    for (std::size_t i = 0; i < result_.robots.size(); ++i) {
      const ChartWay& way = result_.ways[i];
      // What each chart had until the next one.
      std::vector<std::pair<int, Ticks>> expected = {{robot(i).from, robot(i).start}};
      int yields = 0;
      Ticks delayed = 0;
      for (std::size_t s = 0; s < result_.steps.size(); ++s) {
        const bool is_last = s + 1 == result_.steps.size();
        const std::vector<ChartStop>& stops = result_.steps[s].charts[i].stops;
        for (std::size_t k = 1; k < stops.size(); ++k) {
          if (is_last || stops[k].arrival <= result_.steps[s + 1].time) {
            expected.emplace_back(stops[k].node, stops[k].arrival);
          }
        }
        for (const ChartRecord& record : result_.steps[s].records) {
          if (record.kind != "yields" || place(record.robot) != i) continue;
          ++yields;
          delayed += record.after - record.before;
        }
      }
      std::vector<std::pair<int, Ticks>> found;
      Ticks waiting = 0;
      for (const ChartStop& visit : way.visits) {
        if (visit.node >= 0) found.emplace_back(visit.node, visit.arrival);
        if (visit.departure < visit.arrival) {
          fault(fmt::format("{} leaves {} before it comes", robot(i).name, node_name(visit.node)));
        }
        waiting += visit.departure - visit.arrival;
      }
      if (found != expected) {
        fault(fmt::format("the way of {} is not that of its charts", robot(i).name));
      }
      const Ticks arrival = way.visits.back().arrival;
      if (way.arrival != arrival || way.waiting != waiting ||
          way.waiting + way.driving != arrival - robot(i).start) {
        fault(fmt::format("arrival, driving and waiting of {} do not add up", robot(i).name));
      }
      if (way.yields != yields || way.delayed != delayed) {
        fault(fmt::format("{} is said to yield {} times, and does {} times", robot(i).name,
                          way.yields, yields));
      }
      Ticks alone = 0;
      for (const ChartStop& stop : result_.steps.front().charts[i].stops) alone += stop.travel;
      if (way.alone != alone) {
        fault(fmt::format("{} is said to take {} alone, and takes {}", robot(i).name,
                          seconds(way.alone), seconds(alone)));
      }
      check_barriers(i, way.visits);
      check_lanes(i, way.visits);
      if (way.errand != result_.steps.back().charts[i].errand) {
        fault(fmt::format("the errand of {} is not that of its last chart", robot(i).name));
      }
    }
  }

  /// From place to place over the lane that is said: along it, or against its direction; from the
  /// middle of one on it or on the one beside.
  void check_lanes(std::size_t i, const std::vector<ChartStop>& visits) {
    for (std::size_t k = 1; k < visits.size(); ++k) {
      const ChartStop& from = visits[k - 1];
      const ChartStop& to = visits[k];
      if (to.lane < 0 && to.leg != ChartLeg::along) continue;  // across, where no lane is
      if (to.lane >= 0 && leads(from, to)) continue;
      fault(fmt::format("the way of {} comes to {} by {}", robot(i).name,
                        to.node < 0 ? std::string("a place in a lane") : node_name(to.node),
                        lane_name(to.lane)));
    }
  }

  bool leads(const ChartStop& from, const ChartStop& to) const {
    const ChartLane& over = lane(to.lane);
    const bool against = to.leg == ChartLeg::against;
    const bool ends = to.node < 0 || to.node == (against ? over.from : over.to);
    const bool begins = from.node < 0 ? from.lane == to.lane || over.beside == from.lane
                                      : from.node == (against ? over.to : over.from);
    return begins && ends;
  }

  /// Nobody enters a lane while something stands at its beginning.
  void check_barriers(std::size_t i, const std::vector<ChartStop>& visits) {
    for (std::size_t k = 1; k < visits.size(); ++k) {
      if (visits[k - 1].node < 0 || visits[k].leg != ChartLeg::along) continue;
      for (const ChartBarrier& barrier : result_.barriers) {
        const Ticks enters = visits[k - 1].departure;
        if (barrier.lane != visits[k].lane || enters < barrier.since || enters >= barrier.until) {
          continue;
        }
        fault(fmt::format("{} enters {} at {}, where a barrier stands", robot(i).name,
                          lane_name(barrier.lane), seconds(enters)));
      }
    }
  }

  void check_outcome() {
    const bool all = std::all_of(result_.ways.begin(), result_.ways.end(),
                                 [](const ChartWay& way) { return way.errand == "to_goal"; });
    const std::string outcome = !verdict_.settled ? "not_settled"
                                : all             ? "all_at_goals"
                                                  : "not_all_at_goals";
    if (result_.outcome != outcome) {
      fault(fmt::format("the outcome is said to be {}, and is {}", result_.outcome, outcome));
    }
  }

  ChartsResult result_;
  LeastWays least_;
  std::size_t step_ = 0;
  std::vector<std::vector<ChartStop>> planned_;  ///< of this step, before anybody yielded
  ChartsVerdict verdict_;
};

}  // namespace

bool is_charts_result(const std::string& text) { return has_format(text, "rubicon-charts"); }

ChartsVerdict check_charts(const std::string& text) {
  const Json json = parse_json(text);
  return ChartsCheck(read_charts(json)).run();
}

std::string charts_verdict_text(const ChartsVerdict& verdict, const std::string& name) {
  std::string text;
  for (const std::string& fault : verdict.faults) text += name + ": " + fault + "\n";
  if (!verdict.faults.empty()) return text;
  if (!verdict.settled) return "not settled: its charts have conflicts, and say so\n";
  return fmt::format(
      "verified: {} robots, {} plans, {} arrivals: the best ways, nobody in a closed lane, no two "
      "at a node within the tolerance, none head-on\n",
      verdict.robots, verdict.plans, verdict.arrivals);
}

std::string charts_verdict_json(const ChartsVerdict& verdict) {
  const Json json = {{"faults", verdict.faults},
                     {"robots", verdict.robots},
                     {"plans", verdict.plans},
                     {"arrivals", verdict.arrivals},
                     {"settled", verdict.settled}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rubicon::verify
