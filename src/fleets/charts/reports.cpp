#include "src/fleets/charts/reports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

namespace rubicon::charts {
namespace {

std::size_t index_of(std::int32_t i) { return static_cast<std::size_t>(i); }

/// A robot does not reach the end of a lane and is still in it.
constexpr double kMostOfLane = 1 - 1e-9;

bool has_started(const Chart& present) { return present.stops.front().node == kNone; }
bool is_in(const Chart& present, LaneIndex lane) {
  const Stop& front = present.stops.front();
  return front.node == kNone && front.lane == lane && front.leg == Leg::kAlong &&
         present.stops.size() > 1;
}
bool stands(const Chart& present) {
  const Stop& front = present.stops.front();
  return front.node == kNone && front.lane == kNone && front.leg == Leg::kAlong;
}

/// The way of one robot as it is gone.
class Logbook {
 public:
  explicit Logbook(const Robot& robot) {
    journey_.visits.push_back({robot.from, robot.start, robot.start, kNone, Leg::kAlong, 0});
  }

  /// What the robot does by its chart up to and at `until`.
  void follow(const Chart& chart, Nanoseconds until) {
    const std::vector<Stop>& stops = chart.stops;
    if (stops.empty() || stops.front().arrival > until) return;
    std::size_t last = 0;
    for (; last + 1 < stops.size() && stops[last + 1].arrival <= until; ++last) {
      go(stops[last + 1]);
    }
    if (last + 1 == stops.size()) return;
    Stop next = stops[last + 1];
    const Nanoseconds left = std::max(stops[last].arrival, next.arrival - next.travel);
    if (left >= until) return;
    next.node = kNone;
    next.arrival = until;
    next.travel = until - left;
    go(next);
  }

  Journey take() {
    std::vector<Visit> kept;
    for (const Visit& visit : journey_.visits) {
      // A robot that drove on was nowhere in particular.
      const bool drove_on = !kept.empty() && kept.back().node == kNone &&
                            kept.back().arrival == kept.back().departure &&
                            kept.back().lane == visit.lane && kept.back().leg == visit.leg;
      if (drove_on) {
        const Nanoseconds before = kept.back().travel;
        kept.back() = visit;
        kept.back().travel += before;
      } else {
        kept.push_back(visit);
      }
    }
    journey_.visits = std::move(kept);
    return std::move(journey_);
  }

  Journey& journey() { return journey_; }

 private:
  void go(const Stop& stop) {
    Visit& here = journey_.visits.back();
    here.departure = std::max(here.arrival, stop.arrival - stop.travel);
    journey_.visits.push_back(
        {stop.node, stop.arrival, stop.arrival, stop.lane, stop.leg, stop.travel});
  }

  Journey journey_;
};

class CourseMaker {
 public:
  CourseMaker(const LaneNetwork& network, const PlanSettings& settings,
              const std::vector<SiteReport>& reports, const std::vector<Barrier>& barriers)
      : network_(network), settings_(settings), reports_(reports), barriers_(barriers) {}

  std::variant<Course, ReportFault> run(const std::vector<Robot>& robots) {
    CourseStep first;
    first.plan = make_plan(network_, robots, settings_);
    for (const Robot& robot : robots) logbooks_.emplace_back(robot);
    const std::vector<Chart> planned = charts_before_yields(first.plan);
    for (std::size_t i = 0; i < robots.size(); ++i) {
      for (const Stop& stop : planned[i].stops) logbooks_[i].journey().alone += stop.travel;
    }
    add(std::move(first));
    std::size_t next = 0;
    while (next < reports_.size() || !barriers_.empty()) {
      const std::optional<SiteReport> found = next_found();
      const bool is_given =
          next < reports_.size() && (!found || reports_[next].time <= found->time);
      if (!is_given && !found) break;
      listed_ = is_given ? static_cast<std::int32_t>(next++) : -1;
      report_ = is_given ? reports_[next - 1] : *found;
      answer();
      if (fault_) return *std::move(fault_);
    }
    follow(std::numeric_limits<Nanoseconds>::max());
    for (Logbook& logbook : logbooks_) course_.journeys.push_back(logbook.take());
    return std::move(course_);
  }

 private:
  const Plan& plan() const { return course_.steps.back().plan; }
  const Robot& reporter() const { return plan().robots[index_of(report_.robot)]; }

  bool is_closed(LaneIndex lane) const {
    return std::binary_search(plan().closed.begin(), plan().closed.end(), lane);
  }
  bool is_barred(LaneIndex lane, Nanoseconds time) const {
    return std::any_of(barriers_.begin(), barriers_.end(), [&](const Barrier& barrier) {
      return barrier.lane == lane && barrier.since <= time && time < barrier.until;
    });
  }

  /// What a robot is the first to find of barriers, as plans are now.
  std::optional<SiteReport> next_found() const {
    std::optional<SiteReport> first;
    const auto take = [&](SiteReport::Kind kind, std::size_t robot, LaneIndex lane,
                          Nanoseconds time) {
      if (!first || time < first->time) {
        first = SiteReport{kind, static_cast<RobotIndex>(robot), lane, time, 0, 0};
      }
    };
    for (std::size_t robot = 0; robot < plan().charts.size(); ++robot) {
      const Chart& chart = plan().charts[robot];
      for (const Barrier& barrier : barriers_) {
        if (is_closed(barrier.lane)) {
          if (const auto time = sees_it_gone(chart, barrier)) {
            take(SiteReport::Kind::kReopened, robot, barrier.lane, *time);
          }
        } else if (const auto time = meets(chart, barrier)) {
          take(SiteReport::Kind::kBlocked, robot, barrier.lane, *time);
        }
      }
    }
    return first;
  }

  /// When a robot is about to enter the lane while something stands there.
  std::optional<Nanoseconds> meets(const Chart& chart, const Barrier& barrier) const {
    const std::vector<Stop>& stops = chart.stops;
    for (std::size_t i = 1; i < stops.size(); ++i) {
      if (stops[i].lane != barrier.lane || stops[i].leg != Leg::kAlong) continue;
      const bool is_in_it = i == 1 && stops[0].node == kNone && stops[0].lane == barrier.lane;
      const Nanoseconds leaves = stops[i].arrival - stops[i].travel;
      if (!is_in_it && barrier.since <= leaves && leaves < barrier.until) {
        return std::max(leaves, plan().now);
      }
    }
    return std::nullopt;
  }

  /// When a robot is at the beginning of the lane and nothing stands there any more.
  std::optional<Nanoseconds> sees_it_gone(const Chart& chart, const Barrier& barrier) const {
    const NodeIndex node = network_.lane(barrier.lane).from;
    const std::vector<Stop>& stops = chart.stops;
    for (std::size_t i = 0; i < stops.size(); ++i) {
      const bool is_there =
          stops[i].node == node || (i == 0 && stands(chart) && chart.passed == node);
      if (!is_there) continue;
      const bool stays = i + 1 == stops.size();
      const Nanoseconds leaves =
          stays ? lanes::kEndOfTime / 8
                : std::max(stops[i].arrival, stops[i + 1].arrival - stops[i + 1].travel);
      const Nanoseconds time = std::max({stops[i].arrival, barrier.until, plan().now});
      // A robot that has not started is not there.
      if (time <= leaves && !is_barred(barrier.lane, time)) return time;
    }
    return std::nullopt;
  }

  void add(CourseStep step) {
    for (const Record& record : step.plan.records) {
      if (record.kind != RecordKind::kYields) continue;
      Journey& journey = logbooks_[index_of(record.robot)].journey();
      ++journey.yields;
      journey.delayed += record.after - record.before;
    }
    course_.steps.push_back(std::move(step));
  }

  void follow(Nanoseconds until) {
    for (std::size_t i = 0; i < logbooks_.size(); ++i) logbooks_[i].follow(plan().charts[i], until);
  }

  void wrong(std::string message, std::string hint = {}) {
    fault_ = ReportFault{index_of(std::max(0, listed_)), std::move(message), std::move(hint)};
  }

  void answer() {
    const SiteReport& report = report_;
    const Chart present = chart_at(plan().charts[index_of(report.robot)], report.time);
    if (!has_started(present)) {
      wrong(fmt::format("{} starts at {} s: at {} s it sees nothing", reporter().name,
                        seconds_told(present.stops.front().arrival), seconds_told(report.time)));
      return;
    }
    CourseStep step;
    step.time = report.time;
    step.report = report;
    step.listed = listed_;
    try {
      switch (report.kind) {
        case SiteReport::Kind::kBlocked:
          block(report, present, step);
          break;
        case SiteReport::Kind::kReopened:
          reopen(report, present, step);
          break;
        case SiteReport::Kind::kObstacle:
          meet_obstacle(report, present, step);
          break;
      }
    } catch (const std::invalid_argument& error) {
      wrong(error.what());
    }
    if (fault_) return;
    follow(report.time);
    add(std::move(step));
  }

  void block(const SiteReport& report, const Chart& present, CourseStep& step) {
    if (is_in(present, report.lane)) {
      wrong(fmt::format("{} is in the lane {} at {} s itself: what it finds there is an obstacle",
                        reporter().name, network_.name_of(report.lane), seconds_told(report.time)),
            "write obstacle 0 m to 2 m: from where to where it lies, from the right-hand wall");
      return;
    }
    const bool sees = stands(present) && present.passed == network_.lane(report.lane).from;
    if (!sees) step.doubt = doubt(report, present);
    step.plan = lane_blocked(network_, plan(), {report.robot, report.lane, report.time}, settings_);
  }

  void reopen(const SiteReport& report, const Chart& present, CourseStep& step) {
    if (!std::binary_search(plan().closed.begin(), plan().closed.end(), report.lane)) {
      wrong(fmt::format("the lane {} is open at {} s: nobody reported that it is blocked",
                        network_.name_of(report.lane), seconds_told(report.time)));
      return;
    }
    const lanes::Lane& lane = network_.lane(report.lane);
    const bool sees =
        is_in(present, report.lane) ||
        (stands(present) && (present.passed == lane.from || present.passed == lane.to));
    if (!sees) step.doubt = doubt(report, present);
    step.plan = lane_free(network_, plan(), {report.robot, report.lane, report.time}, settings_);
  }

  void meet_obstacle(const SiteReport& report, const Chart& present, CourseStep& step) {
    const LaneIndex beside = network_.lane(report.lane).beside;
    const Stop& front = present.stops.front();
    const bool on_bypass = front.leg == Leg::kAgainst && beside != kNone && front.lane == beside &&
                           present.passed == network_.lane(report.lane).from;
    if (!is_in(present, report.lane) && !on_bypass) {
      wrong(fmt::format("{} is not in the lane {} at {} s: {}", reporter().name,
                        network_.name_of(report.lane), seconds_told(report.time),
                        place_told(network_, present)),
            times_in_lane(report));
      return;
    }
    BypassQuery query;
    query.obstacle_from = report.obstacle_from;
    query.obstacle_to = report.obstacle_to;
    query.robot_width = reporter().width;
    query.lane_width = network_.class_of(report.lane).width;
    query.travelway_width = query.lane_width;
    if (beside != kNone) query.travelway_width += network_.class_of(beside).width;
    step.bypass = choose_bypass(query);
    if (on_bypass && step.bypass.way != BypassWay::kReverse) {
      wrong(fmt::format("{} passes an obstacle in the lane {} already at {} s", reporter().name,
                        network_.name_of(report.lane), seconds_told(report.time)),
            "an obstacle over the whole width of both lanes sends it back");
      return;
    }
    step.travelled = travelled(report, present);
    step.plan = bypass(network_, plan(),
                       {report.robot, report.lane, report.time, step.travelled, step.bypass.way},
                       settings_);
  }

  /// m of the lane of the report that the robot has behind it.
  double travelled(const SiteReport& report, const Chart& present) const {
    const double length = network_.length(report.lane);
    const Stop& next = present.stops[1];
    const double share = static_cast<double>(next.travel) /
                         static_cast<double>(network_.time(report.lane, reporter().speed));
    const bool turns = next.leg == Leg::kAgainst && next.lane == report.lane;
    return length * std::clamp(turns ? share : 1 - share, 0.0, kMostOfLane);
  }

  std::string doubt(const SiteReport& report, const Chart& present) const {
    return fmt::format("{} can hardly see the lane {} at {} s: {}", reporter().name,
                       network_.name_of(report.lane), seconds_told(report.time),
                       place_told(network_, present));
  }

  /// When the robot is in the lane of a report, by its chart.
  std::string times_in_lane(const SiteReport& report) const {
    const std::vector<Stop>& stops = plan().charts[index_of(report.robot)].stops;
    for (std::size_t i = 1; i < stops.size(); ++i) {
      if (stops[i].lane != report.lane || stops[i].leg != Leg::kAlong) continue;
      return fmt::format("it is there after {} s and before {} s",
                         seconds_told(stops[i].arrival - stops[i].travel),
                         seconds_told(stops[i].arrival));
    }
    return {};
  }

  const LaneNetwork& network_;
  const PlanSettings& settings_;
  const std::vector<SiteReport>& reports_;
  const std::vector<Barrier>& barriers_;
  SiteReport report_;         // that is being answered
  std::int32_t listed_ = -1;  // its place among the given ones
  std::vector<Logbook> logbooks_;
  std::optional<ReportFault> fault_;
  Course course_;
};

}  // namespace

std::string_view name_of(SiteReport::Kind kind) {
  switch (kind) {
    case SiteReport::Kind::kBlocked:
      return "blocked";
    case SiteReport::Kind::kReopened:
      return "reopened";
    case SiteReport::Kind::kObstacle:
      return "obstacle";
  }
  return "";
}

Nanoseconds Journey::driving() const {
  Nanoseconds sum = 0;
  for (const Visit& visit : visits) sum += visit.travel;
  return sum;
}

Nanoseconds Journey::waiting() const {
  Nanoseconds sum = 0;
  for (const Visit& visit : visits) sum += visit.departure - visit.arrival;
  return sum;
}

std::variant<Course, ReportFault> carry_out(const LaneNetwork& network,
                                            const std::vector<Robot>& robots,
                                            const PlanSettings& settings,
                                            const std::vector<SiteReport>& reports,
                                            const std::vector<Barrier>& barriers) {
  return CourseMaker(network, settings, reports, barriers).run(robots);
}

std::vector<Chart> charts_before_yields(const Plan& plan) {
  std::vector<Chart> charts = plan.charts;
  for (auto record = plan.records.rbegin(); record != plan.records.rend(); ++record) {
    Record back = *record;
    std::swap(back.before, back.after);
    apply_yield(back, charts);
  }
  return charts;
}

std::string place_told(const LaneNetwork& network, const Chart& present) {
  const Stop& front = present.stops.front();
  if (front.node != kNone) {
    return fmt::format("it starts at {} s only", seconds_told(front.arrival));
  }
  if (stands(present)) {
    return present.passed == kNone ? "it has not moved yet"
                                   : "it stands at " + network.node(present.passed).name;
  }
  if (front.lane == kNone || present.stops.size() < 2) return "it is on its way across";
  const NodeIndex to = present.stops[1].node;
  return front.leg == Leg::kAlong
             ? "it is on its way from " + network.node(network.lane(front.lane).from).name +
                   " to " + network.node(network.lane(front.lane).to).name
             : "it is on its way to " + network.node(to).name + ", out of its lane";
}

std::string seconds_told(Nanoseconds time) {
  std::string text = fmt::format("{}.{:09}", time / kSecond, time % kSecond);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace rubicon::charts
