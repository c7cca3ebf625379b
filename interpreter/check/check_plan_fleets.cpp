#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "interpreter/check/check_plan_parts.hpp"
#include "src/motion/guides/leg.hpp"
#include "src/motion/guides/vehicle.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

using math::at;

constexpr double kMostVehicles = 10000;

Span span_of(const syntax::Name& name) { return name.span; }

/// A fleet whose robots are in the model.
class FleetCheck {
 public:
  FleetCheck(Subject& subject, const syntax::FleetItem& item)
      : subject_(subject), item_(item), who_("fleet '" + item.name.text + "'") {}

  void run(std::map<std::pair<int, int>, Span>& taken) {
    fleet_.name = item_.name.text;
    fleet_.span = item_.name.span;
    for (int i = 1;; ++i) {
      const auto robot = subject_.robots.find(fmt::format("{}_{}", fleet_.name, i));
      if (robot == subject_.robots.end()) break;
      const RobotSpec& spec = subject_.model.robots[at(robot->second)];
      if (spec.span.begin != item_.name.span.begin) break;
      fleet_.robots.push_back(robot->second);
    }
    const syntax::Name* network = only_one(subject_, item_.on, "the network of " + who_, span_of);
    if (network == nullptr || !find_network(*network) || fleet_.robots.empty()) return;
    const RobotSpec& first = subject_.model.robots[at(fleet_.robots.front())];
    if (!first.robot || !first.robot->usable || !drives(first)) return;
    if (!find_nodes(taken)) return;
    if (fleet_.nodes.size() < fleet_.robots.size()) return;
    for (std::size_t i = 0; i < fleet_.robots.size(); ++i) place(i);
    fleet_.guide = guides::default_guide(guides::GuideKind::lanes);
    fleet_.guide.name = network->text;
    subject_.model.fleets.push_back(std::move(fleet_));
  }

 private:
  bool find_network(const syntax::Name& name) {
    std::map<std::string, int> index;
    for (std::size_t i = 0; i < subject_.model.networks.size(); ++i) {
      index.emplace(subject_.model.networks[i].name, static_cast<int>(i));
    }
    fleet_.network = subject_.find(index, name, "network");
    return fleet_.network >= 0;
  }

  const NetworkSpec& network() const { return subject_.model.networks[at(fleet_.network)]; }

  /// Whether the robot can drive on lanes; how fast and how wide it is.
  bool drives(const RobotSpec& robot) {
    const robot::RobotModel& model = robot.robot->model;
    const Span span = item_.file.front().span;
    const robot::Mounting mounting{robot.X_WM, robot.start};
    const guides::Vehicle vehicle(model, mounting);
    if (!vehicle.travels()) {
      subject_.error("P51", span,
                     fmt::format("robot '{}' does not drive: a fleet needs machines with a body "
                                 "that has parameters x and y",
                                 model.name));
      return false;
    }
    if (!check_guided_robot(model, span, subject_.diagnostics)) return false;
    const guides::Leg leg(model, mounting);
    const int drive = leg.drive() >= 0 ? leg.drive() : vehicle.x();
    fleet_.speed = model.parameters[at(drive)].speed;
    if (!(fleet_.speed > 0)) {
      subject_.error("P51", span,
                     fmt::format("robot '{}' does not drive: {} has no speed", model.name,
                                 model.parameters[at(drive)].display_name));
      return false;
    }
    const double heading = leg.heading() < 0 ? 0 : robot.start[at(leg.heading())];
    const double along =
        leg.heading() < 0 ? 0 : heading - leg.heading_along(robot.start, Eigen::Vector2d(1, 0));
    const travel::Vec2 direction(math::cos_deg(along), math::sin_deg(along));
    fleet_.width = vehicle.width_across(direction, robot.start);
    check_width(span);
    return true;
  }

  void check_width(Span span) {
    const auto& classes = network().description.classes;
    double widest = 0;
    for (const lanes::LaneClass& each : classes) widest = std::max(widest, each.width);
    if (fleet_.width <= widest) return;
    subject_.error("P51", span,
                   fmt::format("{} is {:.2f} m wide, and the widest lanes of network '{}' are "
                               "{:.2f} m",
                               who_, fleet_.width, network().name, widest));
  }

  bool find_nodes(std::map<std::pair<int, int>, Span>& taken) {
    std::map<std::string, int> index;
    const auto& nodes = network().description.nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      index.emplace(nodes[i].name, static_cast<int>(i));
    }
    const int errors = subject_.diagnostics.errors();
    for (const syntax::Name& name : item_.at) {
      if (fleet_.nodes.size() == fleet_.robots.size()) break;
      const auto found = index.find(name.text);
      if (found == index.end()) {
        subject_.unknown(name.span, "node", name.text, {&index},
                         " of network '" + network().name + "'");
        continue;
      }
      const auto [place, is_new] =
          taken.emplace(std::pair(fleet_.network, found->second), name.span);
      if (!is_new) {
        Diagnostic diagnostic;
        diagnostic.code = "P51";
        diagnostic.span = name.span;
        diagnostic.message = fmt::format("two vehicles begin at node {}", name.text);
        diagnostic.notes.push_back({place->second, "the other one"});
        subject_.diagnostics.add(std::move(diagnostic));
      }
      fleet_.nodes.push_back(found->second);
    }
    return subject_.diagnostics.errors() == errors;
  }

  /// Stands member i at its node, with the heading of the node; there it parks, too.
  void place(std::size_t i) {
    RobotSpec& robot = subject_.model.robots[at(fleet_.robots[i])];
    const robot::RobotModel& model = robot.robot->model;
    std::vector<std::pair<int, double>> values = guides::values_at(
        model, {robot.X_WM, robot.start}, robot.start, network().X_WN[at(fleet_.nodes[i])]);
    for (const auto& [parameter, value] : values) {
      const robot::Parameter& p = model.parameters[at(parameter)];
      robot.start[at(parameter)] = value;
      if (p.cyclic || (value >= p.lower && value <= p.upper)) continue;
      subject_.error(
          "P51", item_.at[i].span,
          fmt::format("{} cannot stand at node {}: {} would be {:g}, and its range is "
                      "{:g} to {:g}",
                      robot.name, item_.at[i].text, p.display_name, value, p.lower, p.upper));
    }
    robot::update_derived(model, {robot.X_WM, robot.start}, robot.start);
    robot.park = std::move(values);
    robot.fleet = static_cast<int>(subject_.model.fleets.size());
  }

  Subject& subject_;
  const syntax::FleetItem& item_;
  std::string who_;
  FleetSpec fleet_;
};

}  // namespace

std::vector<syntax::RobotUse> members_of(Subject& subject, const syntax::FleetItem& item) {
  const std::string who = "fleet '" + item.name.text + "'";
  const auto missing = [&](const char* what, const char* hint) {
    if (subject.plan.broken) return;
    subject.error("P51", item.name.span, fmt::format("{} has no {}", who, what), hint);
  };
  const auto span_of_file = [](const syntax::String& file) { return file.span; };
  const auto span_of_number = [](const syntax::Number& number) { return number.span; };
  const int errors = subject.diagnostics.errors();
  const syntax::String* file = only_one(subject, item.file, "the robot of " + who, span_of_file);
  if (item.file.empty()) missing("robot", "write robot \"FILE\";");
  if (item.on.empty()) missing("network", "write on NETWORK;");
  if (item.at.empty()) missing("place to begin at", "write at NODE, NODE;");
  double size = static_cast<double>(item.at.size());
  if (const auto* given = only_one(subject, item.size, "the size of " + who, span_of_number)) {
    const auto value =
        bounded(subject, *given, syntax::UnitKind::none, "the size of " + who, 1, kMostVehicles);
    if (value && std::floor(*value) != *value) {
      subject.error("P51", given->span,
                    fmt::format("the size of {} is a whole number, found {}", who, *value));
    } else if (value && *value > size && !item.at.empty()) {
      subject.error("P51", given->span,
                    fmt::format("{} of {} vehicles has {} {} to begin at", who, *value, size,
                                size == 1 ? "node" : "nodes"));
    } else if (value) {
      size = *value;
    }
  }
  std::vector<syntax::RobotUse> members;
  if (subject.diagnostics.errors() != errors || file == nullptr || item.at.empty()) return members;
  for (int i = 1; i <= static_cast<int>(size); ++i) {
    syntax::RobotUse member = item.member;
    member.name = syntax::Name{fmt::format("{}_{}", item.name.text, i), item.name.span};
    member.file = *file;
    member.span = item.name.span;
    members.push_back(std::move(member));
  }
  return members;
}

void check_fleets(Subject& subject) {
  std::map<std::pair<int, int>, Span> taken;  // node of a network, and where that is said
  for (const syntax::PlanItem& each : subject.plan.items) {
    const auto* item = std::get_if<syntax::FleetItem>(&each);
    if (item == nullptr) continue;
    FleetCheck(subject, *item).run(taken);
    syntax::PoolItem pool;
    pool.name = item->name;
    pool.span = item->span;
    pool.choose = item->choose;
    for (std::size_t i = 1;; ++i) {
      std::string name = fmt::format("{}_{}", item->name.text, i);
      const auto robot = subject.robots.find(name);
      if (robot == subject.robots.end() ||
          subject.model.robots[at(robot->second)].span.begin != item->name.span.begin) {
        break;
      }
      pool.of.push_back({std::move(name), item->name.span});
    }
    if (!pool.of.empty()) add_pool(subject, pool);
  }
}

}  // namespace rubicon::interpreter::plan_check
