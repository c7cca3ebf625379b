#include "interpreter/check/check_plan_networks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "interpreter/check/check_grid.hpp"
#include "interpreter/check/check_plan_charts.hpp"
#include "interpreter/check/check_plan_explore.hpp"
#include "interpreter/check/check_plan_parts.hpp"
#include "interpreter/parse/parse_grid.hpp"
#include "interpreter/syntax/name_suggestion.hpp"
#include "src/motion/geometry/above.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

using math::at;
using syntax::UnitKind;

/// m/s and m: more is a slip of the pen.
constexpr double kMostSpeed = 1000;
constexpr double kMostWidth = 1000;
constexpr double kMostLength = 1e6;
/// For a metre, in any currency.
constexpr double kMostCost = 1e6;

class NetworkCheck {
 public:
  NetworkCheck(Subject& subject, const syntax::NetworkItem& item)
      : subject_(subject), item_(item), who_("network '" + item.name.text + "'") {}

  NetworkSpec run() {
    network_.name = item_.name.text;
    network_.span = item_.name.span;
    for (const syntax::NetworkPart& part : item_.parts) {
      if (const auto* policy = std::get_if<syntax::PolicyItem>(&part)) add_policy(*policy);
      if (const auto* lane_class = std::get_if<syntax::LaneClassItem>(&part)) add(*lane_class);
      if (const auto* node = std::get_if<syntax::NodeItem>(&part)) add(*node);
    }
    for (const syntax::NetworkPart& part : item_.parts) {
      if (const auto* lane = std::get_if<syntax::LaneItem>(&part)) add(*lane);
    }
    for (const auto& [lane, written] : beside_) set_beside(lane, *written);
    if (network_.description.nodes.empty() && !subject_.plan.broken) {
      wrong(network_.span, who_ + " has no node", "write node NAME at trans(x, y, 0);");
    }
    if (is_whole_) report_faults();
    return std::move(network_);
  }
  bool is_whole() const { return is_whole_; }

 private:
  void wrong(Span span, std::string message, std::string hint = {}) {
    subject_.error("P50", span, std::move(message), std::move(hint));
    is_whole_ = false;
  }

  void add_policy(const syntax::PolicyItem& item) {
    if (policy_) subject_.twice(item.span, "the policy of " + who_ + " is given twice", *policy_);
    policy_ = item.span;
    const std::string& name = item.name.text;
    if (name == "charts") return;
    if (name == "order" || name == "tarry" || name == "fraenkel") {
      for (const syntax::NumberItem& number : item.numbers) {
        wrong(number.name.span,
              fmt::format("policy {} has no numbers, found '{}'", name, number.name.text),
              "tolerance, delay and clearance go with policy charts, expansions, seed and the like "
              "with policy grid");
      }
      return;
    }
    wrong(item.name.span,
          fmt::format("unknown policy '{}'; expected order, charts, tarry, fraenkel or grid", name),
          "order: each node is entered in the order of the plan, whatever is late; charts: times "
          "at nodes, planned ahead, without bodies; tarry, fraenkel: lanes are explored without a "
          "map; grid: agents on the cells of a map, one cell a tick");
  }

  void add(const syntax::LaneClassItem& item) {
    const std::string who = "class '" + item.name.text + "'";
    const auto [place, is_new] =
        classes_.emplace(item.name.text, static_cast<int>(network_.description.classes.size()));
    if (!is_new) {
      subject_.twice(item.name.span, fmt::format("{} is declared twice", who),
                     class_spans_[at(place->second)]);
      return;
    }
    class_spans_.push_back(item.name.span);
    lanes::LaneClass lane_class;
    lane_class.name = item.name.text;
    lane_class.width = kMostWidth;
    const auto span_of = [](const syntax::Number& number) { return number.span; };
    if (const auto* speed = only_one(subject_, item.speed, "the speed of " + who, span_of)) {
      const auto value =
          bounded(subject_, *speed, UnitKind::speed, "the speed of " + who, 1e-6, kMostSpeed);
      if (value) lane_class.speed = *value;
      is_whole_ = is_whole_ && value;
    } else if (!subject_.plan.broken) {
      wrong(item.name.span, who + " has no speed", "write speed 2 m/s;");
    }
    if (const auto* width = only_one(subject_, item.width, "the width of " + who, span_of)) {
      const auto value =
          bounded(subject_, *width, UnitKind::length, "the width of " + who, 1e-3, kMostWidth);
      if (value) lane_class.width = *value;
      is_whole_ = is_whole_ && value;
    }
    if (const auto* cost = only_one(subject_, item.cost, "the cost of " + who, span_of)) {
      const auto value = cost_per_metre(*cost, who);
      if (value) lane_class.cost = *value;
      is_whole_ = is_whole_ && value;
    }
    network_.description.classes.push_back(std::move(lane_class));
  }

  /// In any currency: 0.5 per m.
  std::optional<double> cost_per_metre(const syntax::Number& number, const std::string& who) {
    const bool is_per_length = number.dimension == syntax::Dimension{-1, 0, 0, 0};
    if (!is_per_length && !number.dimension.is_bare()) {
      wrong(number.span,
            fmt::format("the cost of {} is what a metre costs, but '{}' is {}", who,
                        number.unit_text, syntax::dimension_text(number.dimension)),
            "write cost 0.5 per m;");
      return std::nullopt;
    }
    if (number.value >= 1e-6 && number.value <= kMostCost) return number.value;
    subject_.error("P09", number.span,
                   fmt::format("the cost of {} must be between 1e-06 and {:g} per m, found {:g}",
                               who, kMostCost, number.value));
    return std::nullopt;
  }

  void add(const syntax::NodeItem& item) {
    const auto [place, is_new] =
        nodes_.emplace(item.name.text, static_cast<int>(network_.description.nodes.size()));
    if (!is_new) {
      subject_.twice(item.name.span,
                     fmt::format("node '{}' of {} is declared twice", item.name.text, who_),
                     node_spans_[at(place->second)]);
      return;
    }
    node_spans_.push_back(item.name.span);
    const math::Pose X_WN = resolve_frame_or_identity(subject_, item.at);
    if (!geometry::stands_upright(X_WN)) {
      wrong(item.at.span, fmt::format("node '{}' leans: vehicles stand upright", item.name.text),
            "turn it with rotz only");
    }
    lanes::Node node;
    node.name = item.name.text;
    node.x = X_WN.translation().x();
    node.y = X_WN.translation().y();
    node.heading_deg = math::atan2_deg(X_WN.linear()(1, 0), X_WN.linear()(0, 0));
    network_.description.nodes.push_back(std::move(node));
    network_.X_WN.push_back(X_WN);
  }

  int node_of(const syntax::Name& name) {
    const auto found = nodes_.find(name.text);
    if (found != nodes_.end()) return found->second;
    subject_.unknown(name.span, "node", name.text, {&nodes_}, " of " + who_);
    is_whole_ = false;
    return -1;
  }

  void add(const syntax::LaneItem& item) {
    lanes::Lane lane;
    lane.from = node_of(item.from);
    lane.to = node_of(item.to);
    const auto span_of_name = [](const syntax::Name& name) { return name.span; };
    const auto span_of_number = [](const syntax::Number& number) { return number.span; };
    const auto span_of_pair = [](const auto& names) { return names.first.span; };
    only_one(subject_, item.both, "both", span_of_name);
    if (const auto* name =
            only_one(subject_, item.lane_class, "the class of a lane", span_of_name)) {
      lane.lane_class = subject_.find(classes_, *name, "class");
      is_whole_ = is_whole_ && lane.lane_class >= 0;
    } else if (network_.description.classes.size() != 1) {
      wrong(item.span,
            network_.description.classes.empty()
                ? who_ + " has no class of lanes"
                : std::string("expected the class of this lane: the network has several"),
            network_.description.classes.empty() ? "write class road { speed 2 m/s; }"
                                                 : "write lane A to B CLASS;");
      lane.lane_class = -1;
    }
    if (const auto* length = only_one(subject_, item.length, "length", span_of_number)) {
      lane.length =
          bounded(subject_, *length, UnitKind::length, "the length of a lane", 1e-3, kMostLength);
      is_whole_ = is_whole_ && lane.length;
    }
    if (only_one(subject_, item.beside, "beside", span_of_pair) != nullptr) {
      beside_.emplace_back(network_.description.lanes.size(), &item);
    }
    network_.description.lanes.push_back(lane);
    lane_spans_.push_back(item.span);
    if (item.both.empty()) return;
    std::swap(lane.from, lane.to);
    network_.description.lanes.push_back(lane);
    lane_spans_.push_back(item.span);
  }

  void set_beside(std::size_t lane, const syntax::LaneItem& item) {
    const int from = node_of(item.beside.front().first);
    const int to = node_of(item.beside.front().second);
    if (from < 0 || to < 0) return;
    auto& all = network_.description.lanes;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].from != from || all[i].to != to) continue;
      all[lane].beside = static_cast<int>(i);
      return;
    }
    wrong(item.beside.front().first.span,
          fmt::format("there is no lane from {} to {} that this one could lie beside",
                      item.beside.front().first.text, item.beside.front().second.text));
  }

  /// What the network itself finds.
  void report_faults() {
    for (const lanes::NetworkFault& fault : lanes::faults_of(network_.description)) {
      const Span span = fault.lane >= 0   ? lane_spans_[at(fault.lane)]
                        : fault.node >= 0 ? node_spans_[at(fault.node)]
                                          : network_.span;
      wrong(span, fault.message);
    }
  }

  Subject& subject_;
  const syntax::NetworkItem& item_;
  std::string who_;
  NetworkSpec network_;
  std::map<std::string, int> classes_, nodes_;
  std::vector<Span> class_spans_, node_spans_, lane_spans_;
  std::vector<std::pair<std::size_t, const syntax::LaneItem*>> beside_;
  std::optional<Span> policy_;
  bool is_whole_ = true;
};

}  // namespace

std::optional<math::Pose> NodePlaces::place_of(const syntax::QualifiedName& node,
                                               Diagnostics& diagnostics) {
  const std::string network = node.body ? node.body->text : std::string();
  std::vector<std::string> known;
  for (const NetworkSpec& each : networks_) {
    known.push_back(each.name);
    if (each.name != network) continue;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < each.X_WN.size(); ++i) {
      if (each.description.nodes[i].name == node.name.text) return each.X_WN[i];
      names.push_back(each.description.nodes[i].name);
    }
    const std::string near = did_you_mean(node.name.text, names);
    diagnostics.error("P01", node.name.span,
                      fmt::format("unknown node '{}' of network '{}'{}", node.name.text, network,
                                  near.empty() ? "" : fmt::format("; did you mean {}?", near)));
    return std::nullopt;
  }
  const std::string near = did_you_mean(network, known);
  diagnostics.error("P01", node.span,
                    fmt::format("unknown network '{}'{}", network,
                                near.empty() ? "" : fmt::format("; did you mean {}?", near)));
  return std::nullopt;
}

namespace {

const syntax::PolicyItem* grid_policy(const syntax::NetworkItem& item) {
  for (const syntax::NetworkPart& part : item.parts) {
    const auto* policy = std::get_if<syntax::PolicyItem>(&part);
    if (policy != nullptr && policy->name.text == "grid") return policy;
  }
  return nullptr;
}

/// A network of cells. It stands alone: nothing has a body there.
void check_cells(Subject& subject, const syntax::NetworkItem& item,
                 const syntax::PolicyItem& policy, const syntax::GridItem& grid) {
  subject.use("policy grid", policy.span);
  for (const syntax::Name& minimise : policy.minimise) {
    subject.error("P57", minimise.span, "policy grid has no minimise: least ticks are sought");
  }
  if (subject.plan.items.size() > 1) {
    subject.error(
        "P57", policy.span,
        "a plan with policy grid has this network and nothing else: its agents are points "
        "on cells",
        "vehicles with bodies drive the lanes of a network with policy order");
  }
  for (const syntax::NetworkPart& part : item.parts) {
    const auto* other = std::get_if<syntax::PolicyItem>(&part);
    if (other == &policy) continue;
    if (other != nullptr) {
      subject.twice(other->span, "the policy of network '" + item.name.text + "' is given twice",
                    policy.span);
      continue;
    }
    subject.error("P57",
                  std::visit(
                      [](const auto& each) {
                        if constexpr (requires { each.span; }) {
                          return each.span;
                        } else {
                          return each->span;
                        }
                      },
                      part),
                  "classes, nodes and lanes do not go with policy grid: its cells are those of the "
                  "map");
  }
  if (subject.plan.broken) return;
  check_grid(grid, subject.model.path, subject.sources, subject.files, subject.diagnostics);
}

/// What only a network of cells may have.
void refuse_cells(Subject& subject, const syntax::GridItem& grid) {
  const auto wrong = [&](Span span, const std::string& what) {
    subject.error("P57", span, what + " goes with policy grid", "write policy grid;");
  };
  for (const auto& number : grid.numbers) wrong(number.span, number.name.text);
  for (const auto& file : grid.files) wrong(file.key.span, file.key.text);
  for (const auto& number : grid.agents) wrong(number.span, "agents");
  for (const auto& agent : grid.named) wrong(agent.span, "agent");
  for (const auto& number : grid.jobs) wrong(number.span, "jobs");
  for (const auto& job : grid.named_jobs) wrong(job.span, "job");
}

}  // namespace

bool is_of_cells(const syntax::NetworkItem& item) { return grid_policy(item) != nullptr; }

void check_networks(Subject& subject) {
  std::map<std::string, Span> seen;
  std::vector<syntax::GridItem> grids;
  const bool has_network = std::any_of(
      subject.plan.items.begin(), subject.plan.items.end(),
      [](const auto& each) { return std::holds_alternative<syntax::NetworkItem>(each); });
  if (has_network) grids = parse_grids(subject.sources, subject.plan.name.span.file);
  for (const syntax::PlanItem& each : subject.plan.items) {
    const auto* item = std::get_if<syntax::NetworkItem>(&each);
    if (item == nullptr) continue;
    const auto [place, is_new] = seen.emplace(item->name.text, item->name.span);
    if (!is_new) {
      subject.twice(item->name.span, fmt::format("network '{}' is declared twice", item->name.text),
                    place->second);
      continue;
    }
    const auto grid = std::find_if(grids.begin(), grids.end(), [&](const auto& each_grid) {
      return each_grid.network.span.begin == item->name.span.begin;
    });
    const syntax::PolicyItem* policy = grid_policy(*item);
    if (policy != nullptr && grid != grids.end()) {
      check_cells(subject, *item, *policy, *grid);
      continue;
    }
    if (grid != grids.end()) refuse_cells(subject, *grid);
    NetworkCheck check(subject, *item);
    subject.model.networks.push_back(check.run());
    if (const syntax::PolicyItem* charts = charts_policy(*item)) {
      check_charts(subject, *item, *charts, check.is_whole());
    } else {
      refuse_charts(subject, *item);
      check_explore(subject, *item, check.is_whole());
    }
  }
}

}  // namespace rubicon::interpreter::plan_check
