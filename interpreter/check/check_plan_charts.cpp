#include "interpreter/check/check_plan_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "src/fleets/lanes/shortest_way.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

using math::at;
using syntax::UnitKind;

constexpr double kMostRobotSpeed = 1000;  // m/s
constexpr double kMostRobotWidth = 1000;  // m
constexpr double kMostPriority = 1e6;
constexpr double kMostAcross = 1000;  // m, of a travelway
/// s, about a year: more is no delay.
constexpr double kMostDelay = 3e7;
/// s: less is below what a chart tells apart.
constexpr double kLeastDelay = 1e-3;
constexpr double kLeastBraking = 1e-3;   // m/s2
constexpr double kMostBraking = 100;     // m/s2, ten times what tyres can do
constexpr double kMostSensing = 10'000;  // m
/// Charts that are made in all, so that memory stays within bounds.
constexpr std::size_t kMostCharts = 200000;
/// Errands times nodes, so that ways are found within seconds.
constexpr std::size_t kMostSearched = 20'000'000;

class ChartsCheck {
 public:
  ChartsCheck(Subject& subject, const syntax::NetworkItem& item, const syntax::PolicyItem& policy)
      : subject_(subject),
        item_(item),
        policy_(policy),
        network_(subject.model.networks.back()),
        who_("network '" + item.name.text + "'") {}

  void run(bool is_whole) {
    const int errors = subject_.diagnostics.errors();
    check_alone();
    for (const syntax::NumberItem& number : policy_.numbers) take(number);
    check_criterion();
    check_sensing();
    for (std::size_t i = 0; i < network_.description.nodes.size(); ++i) {
      nodes_.emplace(network_.description.nodes[i].name, static_cast<int>(i));
    }
    const auto& lanes = network_.description.lanes;
    for (std::size_t i = 0; i < lanes.size(); ++i) {
      lanes_.emplace(std::pair(lanes[i].from, lanes[i].to), static_cast<int>(i));
    }
    for (const syntax::NetworkPart& part : item_.parts) {
      if (const auto* errand = std::get_if<syntax::ErrandItem>(&part)) add(*errand);
    }
    for (const syntax::NetworkPart& part : item_.parts) {
      if (const auto* report = std::get_if<syntax::LaneReportItem>(&part)) add(*report);
      if (const auto* barrier = std::get_if<syntax::BarrierItem>(&part)) add(*barrier);
      if (const auto* explore = std::get_if<syntax::ExploreItem>(&part)) {
        wrong(explore->span, "explore goes with policy tarry or fraenkel",
              "write errand ROBOT from NODE to NODE at 0 s;");
      }
    }
    if (spec_.robots.empty() && !subject_.plan.broken && subject_.diagnostics.errors() == errors) {
      subject_.diagnostics.warning("P60", item_.name.span,
                                   who_ + " has no errands: nothing will be done",
                                   "write errand ROBOT from NODE to NODE at 0 s;");
    }
    check_amount();
    const bool fine = is_whole && !subject_.plan.broken && subject_.diagnostics.errors() == errors;
    if (!fine) return;
    spec_.network = static_cast<int>(subject_.model.networks.size()) - 1;
    sort_reports();
    check_starts();
    const lanes::LaneNetwork network(network_.description);
    if (!check_ways(network) || !check_course(network)) return;
    subject_.model.charts = std::move(spec_);
  }

 private:
  void wrong(Span span, std::string message, std::string hint = {}) {
    subject_.error("P60", span, std::move(message), std::move(hint));
  }
  void doubt(Span span, std::string message, std::string hint = {}) {
    subject_.diagnostics.warning("P60", span, std::move(message), std::move(hint));
  }

  /// Nothing has a body there.
  void check_alone() {
    subject_.use("policy charts", policy_.span);
    if (subject_.plan.items.size() < 2) return;
    wrong(policy_.span,
          "a plan with policy charts has this network and nothing else: its robots are times at "
          "nodes, without bodies, tasks or loads",
          "vehicles with bodies drive the lanes of a network with policy order");
  }

  /// A time with its unit: of a bare number nobody knows whether seconds or minutes are meant.
  std::optional<charts::Nanoseconds> time(const syntax::Number& number, const std::string& what,
                                          double least, double most = kMaxDuration) {
    if (number.dimension.is_bare() && number.value != 0) {
      wrong(number.span, fmt::format("{} has no unit, found {:g}", what, number.value),
            fmt::format("write {0:g} s or {0:g} min", number.value));
      return std::nullopt;
    }
    const auto value = bounded(subject_, number, UnitKind::time, what, least, most);
    if (!value) return std::nullopt;
    return *value == 0 ? 0 : lanes::nanoseconds_of(*value);
  }

  bool first(const std::string& key, Span span, const std::string& of) {
    const auto [place, is_new] = given_.emplace(key, span);
    if (!is_new) subject_.twice(span, key + " of " + of + " is given twice", place->second);
    return is_new;
  }

  void take(const syntax::NumberItem& item) {
    charts::AvoidanceSettings& settings = spec_.settings.avoidance;
    const std::map<std::string, charts::Nanoseconds*> known = {{"tolerance", &settings.tolerance},
                                                               {"delay", &settings.delay},
                                                               {"clearance", &settings.clearance}};
    const auto found = known.find(item.name.text);
    if (found == known.end() && take_stopping(item)) return;
    if (found == known.end()) {
      const std::string near =
          did_you_mean(item.name.text, {"tolerance", "delay", "clearance", "minimise", "braking",
                                        "scan", "reaction", "standoff", "sensing"});
      wrong(item.name.span,
            fmt::format("expected tolerance, delay, clearance, minimise, braking, scan, reaction, "
                        "standoff or sensing, found '{}'{}",
                        item.name.text, near.empty() ? "" : "; did you mean " + near + "?"),
            "policy charts { tolerance 5 s; delay 5 s; minimise time; }");
      return;
    }
    if (!first(item.name.text, item.name.span, "policy charts")) return;
    const double least = item.name.text == "tolerance" ? 0 : kLeastDelay;
    if (const auto value = time(item.value, "the " + item.name.text, least, kMostDelay)) {
      *found->second = *value;
    }
  }

  /// What is said of how robots see and stop; false if it is something else.
  bool take_stopping(const syntax::NumberItem& item) {
    charts::Stopping& stopping = spec_.stopping;
    const std::string& key = item.name.text;
    const std::string what = "the " + key + " of policy charts";
    if (key == "scan" || key == "reaction") {
      if (!first(key, item.name.span, "policy charts")) return true;
      const auto value = time(item.value, "the " + key, 0, kMostDelay);
      if (value)
        (key == "scan" ? stopping.scan : stopping.reaction) =
            static_cast<double>(*value) / static_cast<double>(lanes::kSecond);
    } else if (key == "braking") {
      if (!first(key, item.name.span, "policy charts")) return true;
      const auto value =
          bounded(subject_, item.value, UnitKind::acceleration, what, kLeastBraking, kMostBraking);
      stopping.braking = value.value_or(0);
    } else if (key == "standoff" || key == "sensing") {
      if (!first(key, item.name.span, "policy charts")) return true;
      const double least = key == "sensing" ? 1e-3 : 0;
      const auto value = bounded(subject_, item.value, UnitKind::length, what, least, kMostSensing);
      (key == "standoff" ? stopping.standoff : stopping.sensing) = value.value_or(0);
    } else {
      return false;
    }
    if (stopping_span_ == nullptr) stopping_span_ = &item.name;
    return true;
  }

  /// Whether robots can stop before what they see, at the speed of each class.
  void check_sensing() {
    const charts::Stopping& stopping = spec_.stopping;
    if (stopping_span_ == nullptr) return;
    if (given_.count("braking") == 0) {
      wrong(stopping_span_->span,
            fmt::format("{} needs braking, how hard robots brake", stopping_span_->text),
            "write braking 1 m/s2;");
      return;
    }
    if (!stopping.is_known() || stopping.sensing <= 0) return;
    for (const syntax::NetworkPart& part : item_.parts) {
      const auto* item = std::get_if<syntax::LaneClassItem>(&part);
      if (item == nullptr) continue;
      const auto& classes = network_.description.classes;
      const auto found =
          std::find_if(classes.begin(), classes.end(),
                       [&](const lanes::LaneClass& each) { return each.name == item->name.text; });
      if (found == classes.end()) continue;
      const charts::SensingNeed need = charts::sensing_need(stopping, found->speed);
      if (need.to_stop <= stopping.sensing) continue;
      const double fastest = charts::greatest_speed(stopping, stopping.sensing);
      doubt(item->name.span,
            fmt::format("robots cannot stop before what they see in class '{}': at {:.4g} m/s that "
                        "takes {:.4g} m, and they see {:.4g} m",
                        item->name.text, found->speed, need.to_stop, stopping.sensing),
            fastest > 0 ? fmt::format("with that range {:.4g} m/s is the most", fastest)
                        : std::string("the range is no longer than the standoff"));
    }
  }

  void check_criterion() {
    const auto span_of = [](const syntax::Name& name) { return name.span; };
    const syntax::Name* name =
        only_one(subject_, policy_.minimise, "minimise of policy charts", span_of);
    if (name == nullptr) return;
    for (const lanes::Criterion each :
         {lanes::Criterion::kTime, lanes::Criterion::kDistance, lanes::Criterion::kCost}) {
      if (lanes::name_of(each) != name->text) continue;
      spec_.settings.criterion = each;
      if (each == lanes::Criterion::kCost) check_costs(*name);
      return;
    }
    const std::string near = did_you_mean(name->text, {"time", "distance", "cost"});
    wrong(name->span, fmt::format("expected time, distance or cost, found '{}'{}", name->text,
                                  near.empty() ? "" : "; did you mean " + near + "?"));
  }

  void check_costs(const syntax::Name& criterion) {
    for (const syntax::NetworkPart& part : item_.parts) {
      const auto* lane_class = std::get_if<syntax::LaneClassItem>(&part);
      if (lane_class == nullptr || !lane_class->cost.empty()) continue;
      Diagnostic diagnostic;
      diagnostic.code = "P60";
      diagnostic.span = lane_class->name.span;
      diagnostic.message = fmt::format("class '{}' has no cost", lane_class->name.text);
      diagnostic.notes.push_back({criterion.span, "least cost is asked for here"});
      diagnostic.hint = "write cost 0.5 per m;";
      subject_.diagnostics.add(std::move(diagnostic));
    }
  }

  int node(const syntax::Name& name) {
    const auto found = nodes_.find(name.text);
    if (found != nodes_.end()) return found->second;
    subject_.unknown(name.span, "node", name.text, {&nodes_}, " of " + who_);
    return -1;
  }

  void add(const syntax::ErrandItem& item) {
    const std::string who = "errand '" + item.name.text + "'";
    const auto [place, is_new] =
        robots_.emplace(item.name.text, static_cast<int>(spec_.robots.size()));
    if (!is_new) {
      subject_.twice(item.name.span, who + " is declared twice",
                     errands_[at(place->second)]->name.span);
      return;
    }
    charts::Robot robot;
    robot.name = item.name.text;
    robot.from = node(item.from);
    robot.goal = node(item.to);
    if (robot.from >= 0 && robot.from == robot.goal) {
      wrong(item.to.span, who + " ends where it begins");
    }
    robot.start = time(item.start, "the start of " + who, 0).value_or(0);
    given_.clear();
    for (const syntax::NumberItem& number : item.numbers) {
      const std::string& key = number.name.text;
      if (!first(key, number.name.span, who)) continue;
      const std::string what = "the " + key + " of " + who;
      if (key == "priority") {
        const auto value =
            bounded(subject_, number.value, UnitKind::none, what, -kMostPriority, kMostPriority);
        if (value && std::floor(*value) != *value) {
          wrong(number.value.span, fmt::format("{} is a whole number, found {:g}", what, *value));
        } else if (value) {
          robot.priority = static_cast<int>(*value);
        }
      } else if (key == "speed") {
        robot.speed = bounded(subject_, number.value, UnitKind::speed, what, 1e-6, kMostRobotSpeed)
                          .value_or(robot.speed);
      } else {
        robot.width = bounded(subject_, number.value, UnitKind::length, what, 1e-3, kMostRobotWidth)
                          .value_or(robot.width);
      }
    }
    spec_.robots.push_back(std::move(robot));
    errands_.push_back(&item);
  }

  void add(const syntax::LaneReportItem& item) {
    charts::SiteReport report;
    report.kind = item.what.text == "blocked"    ? charts::SiteReport::Kind::kBlocked
                  : item.what.text == "reopened" ? charts::SiteReport::Kind::kReopened
                                                 : charts::SiteReport::Kind::kObstacle;
    report.lane = lane(item.from, item.to);
    report.robot = subject_.find(robots_, item.by, "robot");
    report.time = time(item.time, "the time of a report", 0).value_or(0);
    if (report.kind == charts::SiteReport::Kind::kObstacle && item.edges.size() == 2) {
      take_edges(item, report);
    }
    spec_.reports.push_back(report);
    spec_.report_spans.push_back(item.span);
  }

  void add(const syntax::BarrierItem& item) {
    charts::Barrier barrier;
    barrier.lane = lane(item.from, item.to);
    const auto since = time(item.since, "the time when a barrier comes", 0);
    if (since) barrier.since = *since;
    if (item.until) {
      const auto until = time(*item.until, "the time when a barrier goes", 0);
      if (since && until && *until <= *since) {
        wrong(item.until->span,
              fmt::format("the barrier goes at {} s, and comes at {} s",
                          charts::seconds_told(*until), charts::seconds_told(*since)));
      }
      if (until) barrier.until = *until;
    }
    spec_.barriers.push_back(barrier);
  }

  int lane(const syntax::Name& from_name, const syntax::Name& to_name) {
    const int from = node(from_name);
    const int to = node(to_name);
    if (from < 0 || to < 0) return -1;
    const auto found = lanes_.find({from, to});
    if (found != lanes_.end()) return found->second;
    wrong(from_name.span,
          fmt::format("there is no lane from {} to {}", from_name.text, to_name.text),
          lanes_.contains({to, from})
              ? fmt::format("the lane goes from {} to {}", to_name.text, from_name.text)
              : std::string());
    return -1;
  }

  void take_edges(const syntax::LaneReportItem& item, charts::SiteReport& report) {
    const auto edge = [&](std::size_t i) {
      return bounded(subject_, item.edges[i], UnitKind::length, "the edge of an obstacle", 0,
                     kMostAcross);
    };
    const auto from = edge(0), to = edge(1);
    if (!from || !to) return;
    if (*to < *from) {
      wrong(item.edges[1].span,
            fmt::format("the obstacle ends at {:g} m, before it begins at {:g} m", *to, *from),
            "both are measured across the lane, from the right-hand wall");
    }
    report.obstacle_from = *from;
    report.obstacle_to = *to;
    if (report.robot >= 0 && !(spec_.robots[at(report.robot)].width > 0)) {
      wrong(item.by.span,
            fmt::format("how wide {} is decides whether it passes the obstacle", item.by.text),
            fmt::format("write errand {} ... {{ width 1 m; }}", item.by.text));
    }
    if (report.lane < 0) return;
    const auto& lanes = network_.description.lanes;
    require_width(item, lanes[at(report.lane)].lane_class);
    // Said of one of the two only.
    for (std::size_t i = 0; i < lanes.size(); ++i) {
      const bool is_beside =
          lanes[at(report.lane)].beside == static_cast<int>(i) || lanes[i].beside == report.lane;
      if (is_beside) require_width(item, lanes[i].lane_class);
    }
  }

  void require_width(const syntax::LaneReportItem& item, int lane_class) {
    if (lane_class < 0) return;
    const std::string& name = network_.description.classes[at(lane_class)].name;
    for (const syntax::NetworkPart& part : item_.parts) {
      const auto* written = std::get_if<syntax::LaneClassItem>(&part);
      if (written == nullptr || written->name.text != name || !written->width.empty()) continue;
      wrong(item.what.span,
            fmt::format("how wide lanes of class '{}' are decides whether there is room beside "
                        "the obstacle",
                        name),
            fmt::format("write class {} {{ ... width 4 m; }}", name));
      return;
    }
  }

  void check_amount() {
    const std::size_t nodes = std::max<std::size_t>(1, network_.description.nodes.size());
    if (spec_.robots.size() > kMostSearched / nodes) {
      wrong(item_.name.span, fmt::format("{} errands on {} nodes: the product is at most {}",
                                         spec_.robots.size(), nodes, kMostSearched));
    }
    // A barrier is found, and found to be gone.
    const std::size_t plans = spec_.reports.size() + 2 * spec_.barriers.size() + 1;
    if (spec_.robots.size() <= kMostCharts / plans) return;
    wrong(
        item_.name.span,
        fmt::format("{} errands with {} reports and {} barriers make more than {} charts",
                    spec_.robots.size(), spec_.reports.size(), spec_.barriers.size(), kMostCharts));
  }

  /// By time; of one time in the order of the file.
  void sort_reports() {
    std::vector<std::size_t> order(spec_.reports.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return spec_.reports[a].time < spec_.reports[b].time;
    });
    std::vector<charts::SiteReport> reports;
    std::vector<Span> spans;
    for (const std::size_t i : order) {
      reports.push_back(spec_.reports[i]);
      spans.push_back(spec_.report_spans[i]);
    }
    spec_.reports = std::move(reports);
    spec_.report_spans = std::move(spans);
  }

  /// Two robots that begin at one node at one time.
  void check_starts() {
    std::map<std::pair<lanes::NodeIndex, charts::Nanoseconds>, std::size_t> taken;
    for (std::size_t i = 0; i < spec_.robots.size(); ++i) {
      const charts::Robot& robot = spec_.robots[i];
      const auto [place, is_new] = taken.emplace(std::pair(robot.from, robot.start), i);
      if (is_new) continue;
      Diagnostic diagnostic;
      diagnostic.severity = Severity::warning;
      diagnostic.code = "P60";
      diagnostic.span = errands_[i]->from.span;
      diagnostic.message =
          fmt::format("{} and {} begin at node {} at the same time: one of them will start later",
                      spec_.robots[place->second].name, robot.name,
                      network_.description.nodes[at(robot.from)].name);
      diagnostic.notes.push_back({errands_[place->second]->from.span, "the other one"});
      subject_.diagnostics.add(std::move(diagnostic));
    }
  }

  bool check_ways(const lanes::LaneNetwork& network) {
    bool all = true;
    for (std::size_t i = 0; i < spec_.robots.size(); ++i) {
      const charts::Robot& robot = spec_.robots[i];
      lanes::WayOptions options;
      options.criterion = spec_.settings.criterion;
      options.vehicle_speed = robot.speed;
      options.vehicle_width = robot.width;
      auto way = lanes::shortest_way(network, robot.from, robot.goal, options);
      if (way && way->time <= lanes::nanoseconds_of(kMaxDuration)) continue;
      all = false;
      // A way that takes for ever is none; by its length it is one.
      options.criterion = lanes::Criterion::kDistance;
      if (!way) way = lanes::shortest_way(network, robot.from, robot.goal, options);
      if (way) {
        wrong(errands_[i]->to.span,
              fmt::format("the way of {} takes {:.3g} s or more; charts hold {:.0f} s at most",
                          robot.name, static_cast<double>(way->time) / charts::kSecond,
                          kMaxDuration));
        continue;
      }
      options.vehicle_width = 0;
      const bool is_too_wide =
          lanes::shortest_way(network, robot.from, robot.goal, options).has_value();
      wrong(errands_[i]->to.span,
            fmt::format(
                "no lanes lead {} from {} to {}{}", robot.name, network.node(robot.from).name,
                network.node(robot.goal).name,
                is_too_wide ? fmt::format(" that are {:g} m wide", robot.width) : std::string()),
            is_too_wide ? std::string() : "lanes have one direction; both gives two of them");
    }
    return all;
  }

  /// All of it, to find what cannot be.
  bool check_course(const lanes::LaneNetwork& network) {
    const auto result =
        charts::carry_out(network, spec_.robots, spec_.settings, spec_.reports, spec_.barriers);
    if (const auto* fault = std::get_if<charts::ReportFault>(&result)) {
      wrong(spec_.report_spans[fault->report], fault->message, fault->hint);
      return false;
    }
    for (const charts::CourseStep& step : std::get<charts::Course>(result).steps) {
      if (!step.doubt.empty()) doubt(spec_.report_spans[at(step.listed)], step.doubt);
    }
    return true;
  }

  Subject& subject_;
  const syntax::NetworkItem& item_;
  const syntax::PolicyItem& policy_;
  const NetworkSpec& network_;
  std::string who_;
  ChartsSpec spec_;
  std::map<std::string, Span> given_;
  const syntax::Name* stopping_span_ = nullptr;  ///< of the first that is said of stopping
  std::map<std::string, int> nodes_, robots_;
  std::map<std::pair<int, int>, int> lanes_;
  std::vector<const syntax::ErrandItem*> errands_;  ///< of each robot
};

}  // namespace

const syntax::PolicyItem* charts_policy(const syntax::NetworkItem& item) {
  for (const syntax::NetworkPart& part : item.parts) {
    const auto* policy = std::get_if<syntax::PolicyItem>(&part);
    if (policy != nullptr && policy->name.text == "charts") return policy;
  }
  return nullptr;
}

void check_charts(Subject& subject, const syntax::NetworkItem& item,
                  const syntax::PolicyItem& policy, bool is_whole) {
  ChartsCheck(subject, item, policy).run(is_whole);
}

void refuse_charts(Subject& subject, const syntax::NetworkItem& item) {
  const auto wrong = [&](Span span, const std::string& what) {
    subject.error("P60", span, what + " goes with policy charts", "write policy charts;");
  };
  for (const syntax::NetworkPart& part : item.parts) {
    if (const auto* errand = std::get_if<syntax::ErrandItem>(&part)) wrong(errand->span, "errand");
    if (const auto* report = std::get_if<syntax::LaneReportItem>(&part)) {
      wrong(report->span, "report");
    }
    if (const auto* barrier = std::get_if<syntax::BarrierItem>(&part)) {
      wrong(barrier->span, "barrier");
    }
    if (const auto* lane_class = std::get_if<syntax::LaneClassItem>(&part)) {
      for (const syntax::Number& cost : lane_class->cost) wrong(cost.span, "the cost of a metre");
    }
    if (const auto* policy = std::get_if<syntax::PolicyItem>(&part)) {
      for (const syntax::Name& minimise : policy->minimise) wrong(minimise.span, "minimise");
    }
  }
}

}  // namespace rubicon::interpreter::plan_check
