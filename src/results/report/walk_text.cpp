#include "src/results/report/walk_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "src/results/report/columns.hpp"

namespace rubicon::report {

namespace {

using WalkJson = nlohmann::ordered_json;

/// Steps of a walk that are printed, and names of nodes that were not seen.
constexpr std::size_t kMostSteps = 200;
constexpr std::size_t kMostUnseen = 10;
/// Characters on a line of nodes.
constexpr std::size_t kLineLength = 100;

std::size_t place_in(std::int32_t i) { return static_cast<std::size_t>(i); }

const std::string& node_name(const WalkResult& result, lanes::NodeIndex node) {
  return result.network.node(node).name;
}

std::string nodes_told(const WalkResult& result, std::size_t explorer) {
  const ExplorerWalk& walk = result.walks[explorer];
  std::string text;
  std::string line = "  " + node_name(result, result.spec.explorers[explorer].from);
  for (std::size_t i = 0; i < walk.steps.size() && i < kMostSteps; ++i) {
    const std::string& name = node_name(result, walk.steps[i].to);
    if (line.size() + name.size() + 1 > kLineLength) {
      text += line + "\n";
      line = "   ";
    }
    line += " " + name;
  }
  if (walk.steps.size() > kMostSteps) {
    line += fmt::format(" and {} more", walk.steps.size() - kMostSteps);
  }
  return text + line + "\n";
}

}  // namespace

WalkResult explore(const interpreter::ExploreSpec& spec,
                   const interpreter::NetworkSpec& description, const lanes::LaneNetwork& network) {
  WalkResult result{spec, description, network, lanes::travelways_of(network), {}};
  for (const interpreter::ExploreSpec::Explorer& explorer : spec.explorers) {
    ExplorerWalk walk;
    walk.steps = lanes::covering_walk(spec.rule, result.travelways.graph, explorer.from);
    lanes::Nanoseconds now = 0;
    std::vector<char> is_used(result.travelways.lane.size(), 0);
    std::vector<char> is_seen(place_in(network.node_count()), 0);
    is_seen[place_in(explorer.from)] = 1;
    for (const lanes::WalkStep& step : walk.steps) {
      const lanes::LaneIndex lane = result.travelways.lane[place_in(step.edge)];
      now += std::min(network.time(lane, explorer.speed), lanes::kEndOfTime - now);
      walk.arrivals.push_back(now);
      walk.length += network.length(lane);
      is_used[place_in(step.edge)] = 1;
      is_seen[place_in(step.to)] = 1;
    }
    walk.ways = static_cast<int>(std::count(is_used.begin(), is_used.end(), 1));
    for (std::int32_t i = 0; i < network.node_count(); ++i) {
      if (is_seen[place_in(i)] == 0) walk.unseen.push_back(i);
    }
    result.walks.push_back(std::move(walk));
  }
  return result;
}

std::string walk_table(const WalkResult& result) {
  std::string text = fmt::format(
      "network {}: {} nodes, {} ways between them; explored without a map by the rule of {}\n",
      result.description.name, result.network.node_count(), result.travelways.lane.size(),
      result.spec.rule == lanes::Exploration::kTarry ? "Tarry" : "Fraenkel");
  if (result.walks.empty()) return text;
  std::vector<TableRow> rows = {{"robot", "from", "ways", "steps", "m", "s", "nodes not seen"}};
  for (std::size_t i = 0; i < result.walks.size(); ++i) {
    const ExplorerWalk& walk = result.walks[i];
    std::string unseen;
    for (std::size_t k = 0; k < walk.unseen.size() && k < kMostUnseen; ++k) {
      unseen += (k == 0 ? "" : ", ") + node_name(result, walk.unseen[k]);
    }
    if (walk.unseen.size() > kMostUnseen) {
      unseen += fmt::format(" and {} more", walk.unseen.size() - kMostUnseen);
    }
    const lanes::Nanoseconds end = walk.arrivals.empty() ? 0 : walk.arrivals.back();
    rows.push_back({result.spec.explorers[i].name, node_name(result, result.spec.explorers[i].from),
                    std::to_string(walk.ways), std::to_string(walk.steps.size()),
                    fmt::format("{:.2f}", walk.length),
                    fmt::format("{:.2f}", static_cast<double>(end) / charts::kSecond),
                    unseen.empty() ? "none" : unseen});
  }
  text += "\n" + columns(rows, {2, 3, 4, 5});
  for (std::size_t i = 0; i < result.walks.size(); ++i) {
    text += fmt::format("\n{}\n", result.spec.explorers[i].name) + nodes_told(result, i);
  }
  return text;
}

std::string walk_csv(const WalkResult& result) {
  std::string text = "robot,step,from,to,way,arrival_s\n";
  for (std::size_t i = 0; i < result.walks.size(); ++i) {
    const ExplorerWalk& walk = result.walks[i];
    for (std::size_t k = 0; k < walk.steps.size(); ++k) {
      text += fmt::format("{},{},{},{},{},{}\n", csv_field(result.spec.explorers[i].name), k + 1,
                          csv_field(node_name(result, walk.steps[k].from)),
                          csv_field(node_name(result, walk.steps[k].to)), walk.steps[k].edge,
                          charts::seconds_told(walk.arrivals[k]));
    }
  }
  return text;
}

std::string walk_json(const WalkResult& result) {
  WalkJson json;
  json["format"] = "rubicon-walk";
  json["version"] = 1;
  json["network"] = result.description.name;
  json["rule"] = lanes::name_of(result.spec.rule);
  json["nodes"] = WalkJson::array();
  for (std::int32_t i = 0; i < result.network.node_count(); ++i) {
    json["nodes"].push_back(node_name(result, i));
  }
  json["lanes"] = WalkJson::array();
  for (std::int32_t i = 0; i < result.network.lane_count(); ++i) {
    const lanes::Lane& lane = result.network.lane(i);
    json["lanes"].push_back({{"from", lane.from},
                             {"to", lane.to},
                             {"length", result.network.length(i)},
                             {"speed", result.network.class_of(i).speed}});
  }
  json["ways"] = result.travelways.lane;  // the first lane of each
  json["robots"] = WalkJson::array();
  for (std::size_t i = 0; i < result.walks.size(); ++i) {
    const ExplorerWalk& walk = result.walks[i];
    const auto& explorer = result.spec.explorers[i];
    WalkJson each = {{"name", explorer.name}, {"from", explorer.from}};
    if (std::isfinite(explorer.speed)) each["speed"] = explorer.speed;
    each["length"] = walk.length;
    each["ways"] = walk.ways;
    each["unseen"] = walk.unseen;
    each["steps"] = WalkJson::array();
    for (std::size_t k = 0; k < walk.steps.size(); ++k) {
      each["steps"].push_back({{"way", walk.steps[k].edge},
                               {"to", walk.steps[k].to},
                               {"arrival_ns", walk.arrivals[k]}});
    }
    json["robots"].push_back(std::move(each));
  }
  return json.dump(1, ' ', false, WalkJson::error_handler_t::replace) + "\n";
}

}  // namespace rubicon::report
