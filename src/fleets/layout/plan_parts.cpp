#include "src/fleets/layout/plan_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace rubicon::layout {

namespace {

/// To the millimetre, without what a reader does not need.
std::string metres(double value) {
  std::string text = fmt::format("{:.3f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace

PlanParts plan_parts(const Layout& layout, const PlanNames& names) {
  PlanParts parts;
  const std::vector<lanes::Node>& nodes = layout.network.nodes;
  const auto gates = names.gates.size();
  const auto name_of = [&](lanes::NodeIndex index) {
    const auto i = static_cast<std::size_t>(index);
    if (i < gates) return names.gates[i];
    std::string name = nodes[i].name;
    while (std::find(names.gates.begin(), names.gates.end(), name) != names.gates.end())
      name += '_';
    return name;
  };
  for (std::size_t i = gates; i < nodes.size(); ++i) {
    const lanes::Node& node = nodes[i];
    parts.network +=
        fmt::format("node {} at trans({}, {}, {})", name_of(static_cast<lanes::NodeIndex>(i)),
                    metres(node.x), metres(node.y), metres(names.floor));
    if (node.heading_deg != 0) parts.network += fmt::format(" * rotz({})", node.heading_deg);
    parts.network += ";\n";
  }
  std::set<std::pair<lanes::NodeIndex, lanes::NodeIndex>> all;
  for (const lanes::Lane& lane : layout.network.lanes) all.insert({lane.from, lane.to});
  for (const lanes::Lane& lane : layout.network.lanes) {
    const bool both = all.count({lane.to, lane.from}) > 0;
    if (both && lane.from > lane.to) continue;
    parts.network += fmt::format("lane {} to {} {}{};\n", name_of(lane.from), name_of(lane.to),
                                 lane.lane_class == 0 ? names.aisle_class : names.cross_class,
                                 both ? " both" : "");
  }
  for (const Module& module : layout.modules) {
    parts.plan += fmt::format("site box({}, {}, {}, {}, {}, {});\n", metres(module.box.x0),
                              metres(module.box.y0), metres(names.floor), metres(module.box.x1),
                              metres(module.box.y1), metres(names.floor + names.height));
  }
  if (!names.with_tasks || names.fleets.empty()) return parts;
  const std::size_t trips = std::min(kMostTrips, layout.modules.size());
  for (std::size_t i = 0; i < trips; ++i) {
    const Module& module = layout.modules[i * layout.modules.size() / trips];
    parts.plan += fmt::format(
        "task fetch_{0} {{ by {1}; go at {2}.{3}; }}\n"
        "task stow_{0} {{ by same as fetch_{0}; go at {2}.{4}; after fetch_{0}; }}\n",
        i + 1, names.fleets[i % names.fleets.size()], names.network, names.gates[i % gates],
        name_of(module.stop));
  }
  return parts;
}

}  // namespace rubicon::layout
