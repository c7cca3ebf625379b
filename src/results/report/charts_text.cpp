#include "src/results/report/charts_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "src/results/report/columns.hpp"

namespace rubicon::report {

namespace {

using charts::Chart;
using charts::CourseStep;
using charts::Journey;
using charts::Record;
using charts::RecordKind;
using charts::Robot;
using charts::seconds_told;
using charts::SiteReport;
using charts::Stop;
using charts::Visit;
using ChartsJson = nlohmann::ordered_json;

/// A chart of all robots is printed as a table for so many robots at most.
constexpr std::size_t kMostInTable = 6;
/// Robots whose charts are printed, and yields of one plan.
constexpr std::size_t kMostCharts = 40;
constexpr std::size_t kMostYields = 30;

std::size_t place_of(std::int32_t i) { return static_cast<std::size_t>(i); }

const char* leg_name(charts::Leg leg) {
  if (leg == charts::Leg::kAlong) return "along";
  return leg == charts::Leg::kAgainst ? "against" : "across";
}

const char* ending(charts::Errand errand) {
  if (errand == charts::Errand::kToGoal) return "at its goal";
  return errand == charts::Errand::kBack ? "back at its start: no way to its goal"
                                         : "stranded: no way to its goal or back";
}

const char* outcome_name(ChartsOutcome outcome) {
  if (outcome == ChartsOutcome::all_at_goals) return "all_at_goals";
  return outcome == ChartsOutcome::not_all_at_goals ? "not_all_at_goals" : "not_settled";
}

class ChartsTable {
 public:
  explicit ChartsTable(const ChartsResult& result)
      : result_(result), robots_(result.course.steps.front().plan.robots) {}

  std::string write() {
    const charts::PlanSettings& settings = result_.spec.settings;
    text_ = fmt::format(
        "network {}: {} robots, {} nodes, {} lanes; least {}; tolerance {} s, delay {} s, "
        "clearance {} s\n",
        result_.description.name, robots_.size(), result_.network.node_count(),
        result_.network.lane_count(), lanes::name_of(settings.criterion),
        seconds_told(settings.avoidance.tolerance), seconds_told(settings.avoidance.delay),
        seconds_told(settings.avoidance.clearance));
    for (const CourseStep& step : result_.course.steps) add(step);
    if (!robots_.empty()) add_journeys();
    const std::string sensing = sensing_table(result_);
    if (!sensing.empty()) text_ += "\n" + sensing;
    const ChartsOutcome outcome = outcome_of(result_.course);
    if (outcome == ChartsOutcome::not_settled) {
      text_ += "\nnot settled: the robots push each other on without end; charts have conflicts\n";
    }
    return text_;
  }

 private:
  void add(const CourseStep& step) {
    text_ += "\n";
    if (step.report) add_report(step);
    std::vector<Chart> charts = charts_before_yields(step.plan);
    ++chart_;
    text_ += !step.report
                 ? fmt::format("chart {}, as planned\n", chart_)
                 : fmt::format("chart {}, from {} s on\n", chart_, seconds_told(step.time));
    add_charts(charts);
    std::size_t yields = 0;
    for (const Record& record : step.plan.records) {
      if (record.kind != RecordKind::kYields) continue;
      apply_yield(record, charts);
      ++chart_;
      if (++yields > kMostYields) continue;
      text_ +=
          fmt::format("\nchart {}: {}\n", chart_, told(result_.network, robots_, charts, record));
      if (robots_.size() <= kMostInTable) {
        add_charts(charts);
      } else {
        add_line(charts, record.robot);
      }
    }
    if (yields > kMostYields) {
      text_ += fmt::format("and {} more; --format json has all. Chart {}:\n", yields - kMostYields,
                           chart_);
      add_charts(charts);
    }
  }

  /// What the robot says, what the centre does.
  void add_report(const CourseStep& step) {
    text_ += fmt::format("{} s  {}\n", seconds_told(step.time), report_told(result_, step));
    for (const Record& record : step.plan.records) {
      if (record.kind == RecordKind::kYields) continue;
      text_ += "  " + told(result_.network, robots_, step.plan.charts, record) + "\n";
    }
    if (!step.doubt.empty()) text_ += "  " + step.doubt + "\n";
  }

  void add_charts(const std::vector<Chart>& charts) {
    if (charts.empty()) return;
    if (charts.size() <= kMostInTable) {
      text_ += table_text(result_.network, robots_, charts);
      return;
    }
    for (std::size_t i = 0; i < charts.size() && i < kMostCharts; ++i) {
      add_line(charts, static_cast<std::int32_t>(i));
    }
    if (charts.size() > kMostCharts) {
      text_ += fmt::format("  and {} more; --format json has all\n", charts.size() - kMostCharts);
    }
  }

  void add_line(const std::vector<Chart>& charts, charts::RobotIndex robot) {
    text_ += fmt::format("  {}: {}\n", robots_[place_of(robot)].name,
                         told(result_.network, charts[place_of(robot)]));
  }

  void add_journeys() {
    std::vector<TableRow> rows = {{"robot", "priority", "from", "to", "starts", "arrives", "drives",
                                   "alone", "waits", "yields", "ends"}};
    const charts::Plan& last = result_.course.steps.back().plan;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const Robot& robot = robots_[i];
      const Journey& journey = result_.course.journeys[i];
      rows.push_back({robot.name, std::to_string(robot.priority),
                      result_.network.node(robot.from).name, result_.network.node(robot.goal).name,
                      seconds_told(robot.start), seconds_told(journey.visits.back().arrival),
                      seconds_told(journey.driving()), seconds_told(journey.alone),
                      seconds_told(journey.waiting()), std::to_string(journey.yields),
                      ending(last.errands[i])});
    }
    text_ += "\n" + columns(rows, {1, 4, 5, 6, 7, 8, 9});
  }

  const ChartsResult& result_;
  const std::vector<Robot>& robots_;
  int chart_ = 0;
  std::string text_;
};

/// The same as objects.
class ChartsWriter {
 public:
  explicit ChartsWriter(const ChartsResult& result)
      : result_(result), robots_(result.course.steps.front().plan.robots) {}

  ChartsJson write() {
    const charts::PlanSettings& settings = result_.spec.settings;
    ChartsJson json;
    json["format"] = "rubicon-charts";
    json["version"] = 1;
    json["network"] = result_.description.name;
    json["outcome"] = outcome_name(outcome_of(result_.course));
    json["policy"] = {{"tolerance_ns", settings.avoidance.tolerance},
                      {"delay_ns", settings.avoidance.delay},
                      {"clearance_ns", settings.avoidance.clearance},
                      {"minimise", lanes::name_of(settings.criterion)}};
    add_network(json);
    add_sensing(json);
    json["robots"] = ChartsJson::array();
    for (const Robot& robot : robots_) {
      ChartsJson each = {{"name", robot.name},
                         {"priority", robot.priority},
                         {"from", node(robot.from)},
                         {"to", node(robot.goal)},
                         {"start_ns", robot.start}};
      if (std::isfinite(robot.speed)) each["speed"] = robot.speed;
      each["width"] = robot.width;
      json["robots"].push_back(std::move(each));
    }
    if (!result_.spec.barriers.empty()) {
      json["barriers"] = ChartsJson::array();
      for (const charts::Barrier& barrier : result_.spec.barriers) {
        ChartsJson each = {{"lane", barrier.lane}, {"since_ns", barrier.since}};
        if (barrier.until < lanes::kEndOfTime) each["until_ns"] = barrier.until;
        json["barriers"].push_back(std::move(each));
      }
    }
    json["steps"] = ChartsJson::array();
    for (const CourseStep& step : result_.course.steps) json["steps"].push_back(object_of(step));
    json["ways"] = ChartsJson::array();
    for (std::size_t i = 0; i < robots_.size(); ++i) json["ways"].push_back(way_of(i));
    return json;
  }

 private:
  ChartsJson node(charts::NodeIndex index) const {
    if (index == charts::kNone) return nullptr;
    return result_.network.node(index).name;
  }
  static ChartsJson lane(charts::LaneIndex index) {
    if (index == charts::kNone) return nullptr;
    return index;
  }

  void add_network(ChartsJson& json) const {
    json["classes"] = ChartsJson::array();
    for (const lanes::LaneClass& each : result_.network.classes()) {
      json["classes"].push_back(
          {{"name", each.name}, {"speed", each.speed}, {"width", each.width}, {"cost", each.cost}});
    }
    json["nodes"] = ChartsJson::array();
    for (std::int32_t i = 0; i < result_.network.node_count(); ++i) {
      const lanes::Node& each = result_.network.node(i);
      json["nodes"].push_back({{"name", each.name}, {"x", each.x}, {"y", each.y}});
    }
    json["lanes"] = ChartsJson::array();
    for (std::int32_t i = 0; i < result_.network.lane_count(); ++i) {
      const lanes::Lane& each = result_.network.lane(i);
      ChartsJson object = {{"from", node(each.from)},
                           {"to", node(each.to)},
                           {"class", each.lane_class},
                           {"beside", lane(each.beside)}};
      if (each.length) object["length"] = *each.length;
      json["lanes"].push_back(std::move(object));
    }
  }

  void add_sensing(ChartsJson& json) const {
    const charts::Stopping& stopping = result_.spec.stopping;
    if (!stopping.is_known()) return;
    ChartsJson& object = json["sensing"];
    object = {{"braking", stopping.braking},
              {"scan_s", stopping.scan},
              {"reaction_s", stopping.reaction},
              {"standoff", stopping.standoff}};
    if (stopping.sensing > 0) {
      object["range"] = stopping.sensing;
      object["greatest_speed"] = charts::greatest_speed(stopping, stopping.sensing);
    }
    object["needs"] = ChartsJson::array();
    const std::vector<charts::SensingNeed> needs = sensing_needs(result_);
    for (std::size_t i = 0; i < needs.size(); ++i) {
      object["needs"].push_back({{"class", result_.network.classes()[i].name},
                                 {"speed", needs[i].speed},
                                 {"until_brakes", needs[i].until_brakes},
                                 {"braked", needs[i].braked},
                                 {"to_stop", needs[i].to_stop},
                                 {"two_scans", needs[i].two_scans},
                                 {"oncoming", needs[i].oncoming}});
    }
  }

  ChartsJson object_of(const CourseStep& step) const {
    ChartsJson object;
    object["time_ns"] = step.time;
    if (step.report) object["report"] = report_of(step);
    object["settled"] = step.plan.settled;
    object["closed"] = step.plan.closed;
    object["records"] = ChartsJson::array();
    std::vector<Chart> charts = charts_before_yields(step.plan);
    for (const Record& record : step.plan.records) {
      apply_yield(record, charts);
      object["records"].push_back(record_of(record, charts));
    }
    object["charts"] = ChartsJson::array();
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const Chart& chart = step.plan.charts[i];
      ChartsJson each = {{"robot", robots_[i].name}, {"errand", name_of(step.plan.errands[i])}};
      if (chart.passed != charts::kNone) each["passed"] = node(chart.passed);
      each["stops"] = ChartsJson::array();
      for (const Stop& stop : chart.stops) {
        ChartsJson at = {{"node", node(stop.node)}, {"arrival_ns", stop.arrival}};
        if (stop.lane != charts::kNone) at["lane"] = stop.lane;
        if (stop.leg != charts::Leg::kAlong) at["leg"] = leg_name(stop.leg);
        if (stop.travel > 0) at["travel_ns"] = stop.travel;
        each["stops"].push_back(std::move(at));
      }
      object["charts"].push_back(std::move(each));
    }
    return object;
  }

  ChartsJson report_of(const CourseStep& step) const {
    const SiteReport& report = *step.report;
    ChartsJson object = {{"kind", name_of(report.kind)},
                         {"robot", robots_[place_of(report.robot)].name},
                         {"lane", report.lane},
                         {"told", report_told(result_, step)}};
    if (report.kind == SiteReport::Kind::kObstacle) {
      object["obstacle_from"] = report.obstacle_from;
      object["obstacle_to"] = report.obstacle_to;
      object["travelled"] = step.travelled;
      object["way"] = name_of(step.bypass.way);
      object["gap"] = step.bypass.gap;
    }
    if (!step.doubt.empty()) object["doubt"] = step.doubt;
    return object;
  }

  ChartsJson record_of(const Record& record, const std::vector<Chart>& charts) const {
    ChartsJson object = {{"kind", name_of(record.kind)},
                         {"robot", robots_[place_of(record.robot)].name},
                         {"time_ns", record.time}};
    if (record.lane != charts::kNone) object["lane"] = record.lane;
    if (record.node != charts::kNone) object["node"] = node(record.node);
    if (record.kind == RecordKind::kYields) {
      object["to"] = robots_[place_of(record.other)].name;
      object["conflict"] = name_of(record.conflict);
      object["stop"] = record.stop;
      object["before_ns"] = record.before;
      object["after_ns"] = record.after;
    }
    object["told"] = told(result_.network, robots_, charts, record);
    return object;
  }

  ChartsJson way_of(std::size_t i) const {
    const Journey& journey = result_.course.journeys[i];
    ChartsJson way = {{"robot", robots_[i].name},
                      {"errand", name_of(result_.course.steps.back().plan.errands[i])},
                      {"arrival_ns", journey.visits.back().arrival},
                      {"driving_ns", journey.driving()},
                      {"waiting_ns", journey.waiting()},
                      {"alone_ns", journey.alone},
                      {"yields", journey.yields},
                      {"delayed_ns", journey.delayed},
                      {"visits", ChartsJson::array()}};
    for (const Visit& visit : journey.visits) {
      ChartsJson at = {{"node", node(visit.node)},
                       {"arrival_ns", visit.arrival},
                       {"departure_ns", visit.departure}};
      if (visit.lane != charts::kNone) at["lane"] = visit.lane;
      if (visit.leg != charts::Leg::kAlong) at["leg"] = leg_name(visit.leg);
      way["visits"].push_back(std::move(at));
    }
    return way;
  }

  const ChartsResult& result_;
  const std::vector<Robot>& robots_;
};

}  // namespace

ChartsOutcome outcome_of(const charts::Course& course) {
  const bool settled = std::all_of(course.steps.begin(), course.steps.end(),
                                   [](const CourseStep& step) { return step.plan.settled; });
  if (!settled) return ChartsOutcome::not_settled;
  const std::vector<charts::Errand>& errands = course.steps.back().plan.errands;
  const bool all = std::all_of(errands.begin(), errands.end(), [](charts::Errand errand) {
    return errand == charts::Errand::kToGoal;
  });
  return all ? ChartsOutcome::all_at_goals : ChartsOutcome::not_all_at_goals;
}

std::string report_told(const ChartsResult& result, const CourseStep& step) {
  const SiteReport& report = *step.report;
  const std::string who = result.spec.robots[place_of(report.robot)].name;
  const std::string lane = result.network.name_of(report.lane);
  switch (report.kind) {
    case SiteReport::Kind::kBlocked:
      return fmt::format("{} reports: {} is blocked", who, lane);
    case SiteReport::Kind::kReopened:
      return fmt::format("{} reports: {} is free again", who, lane);
    case SiteReport::Kind::kObstacle:
      return fmt::format(
          "{} reports: an obstacle lies in {}, {:.4g} m along, from {:g} m to {:g} m across", who,
          lane, step.travelled, report.obstacle_from, report.obstacle_to);
  }
  return {};
}

std::vector<charts::SensingNeed> sensing_needs(const ChartsResult& result) {
  std::vector<charts::SensingNeed> needs;
  const charts::Stopping& stopping = result.spec.stopping;
  if (!stopping.is_known()) return needs;
  double fastest = result.spec.robots.empty() ? std::numeric_limits<double>::infinity() : 0;
  for (const Robot& robot : result.spec.robots) fastest = std::max(fastest, robot.speed);
  for (const lanes::LaneClass& each : result.network.classes()) {
    needs.push_back(charts::sensing_need(stopping, std::min(each.speed, fastest)));
  }
  return needs;
}

std::string sensing_table(const ChartsResult& result) {
  const std::vector<charts::SensingNeed> needs = sensing_needs(result);
  if (needs.empty()) return {};
  const charts::Stopping& stopping = result.spec.stopping;
  std::string text = fmt::format(
      "sensing range: a scan every {:g} s, reaction {:g} s, braking {:g} m/s2, standoff {:g} m\n",
      stopping.scan, stopping.reaction, stopping.braking, stopping.standoff);
  const bool has_range = stopping.sensing > 0;
  std::vector<TableRow> rows = {
      {"class", "speed", "until it brakes", "brakes", "range needed", "for two scans", "oncoming"}};
  if (has_range) rows.front().push_back(fmt::format("sees {:g} m", stopping.sensing));
  const auto metres = [](double length) { return fmt::format("{:.2f} m", length); };
  for (std::size_t i = 0; i < needs.size(); ++i) {
    const charts::SensingNeed& need = needs[i];
    rows.push_back({result.network.classes()[i].name, fmt::format("{:.4g} m/s", need.speed),
                    metres(need.until_brakes), metres(need.braked), metres(need.to_stop),
                    metres(need.two_scans), metres(need.oncoming)});
    if (!has_range) continue;
    const double left = stopping.sensing - need.to_stop;
    rows.back().push_back(left >= 0 ? "enough" : fmt::format("{} short", metres(-left)));
  }
  text += columns(rows, {1, 2, 3, 4, 5, 6});
  if (has_range) {
    text += fmt::format("with {:g} m they can stop from {:.4g} m/s\n", stopping.sensing,
                        charts::greatest_speed(stopping, stopping.sensing));
  }
  return text;
}

std::string charts_table(const ChartsResult& result) { return ChartsTable(result).write(); }

std::string charts_csv(const ChartsResult& result) {
  std::string text = "robot,place,arrival_s,departure_s,wait_s,lane,leg\n";
  for (std::size_t i = 0; i < result.spec.robots.size(); ++i) {
    for (const Visit& visit : result.course.journeys[i].visits) {
      text += fmt::format(
          "{},{},{},{},{},{},{}\n", csv_field(result.spec.robots[i].name),
          visit.node == charts::kNone ? "" : csv_field(result.network.node(visit.node).name),
          seconds_told(visit.arrival), seconds_told(visit.departure),
          seconds_told(visit.departure - visit.arrival),
          visit.lane == charts::kNone ? "" : csv_field(result.network.name_of(visit.lane)),
          leg_name(visit.leg));
    }
  }
  return text;
}

std::string charts_json(const ChartsResult& result) {
  return ChartsWriter(result).write().dump(1, ' ', false, ChartsJson::error_handler_t::replace) +
         "\n";
}

}  // namespace rubicon::report
