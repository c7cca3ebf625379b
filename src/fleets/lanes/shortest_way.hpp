#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "src/fleets/lanes/lane_network.hpp"

namespace rubicon::lanes {

/// What a way is to have least of (the Blackmon paper, "Introduction").
enum class Criterion { kTime, kDistance, kCost };
/// As in files: "time", "distance", "cost".
std::string_view name_of(Criterion criterion);

struct WayOptions {
  Criterion criterion = Criterion::kTime;
  double vehicle_speed = std::numeric_limits<double>::infinity();  ///< m/s, of the vehicle at most
  double vehicle_width = 0;                                        ///< m
  /// Lanes that nobody may enter: ascending.
  std::span<const LaneIndex> closed;
};

/// A way from node to node. `nodes` has one more than `lanes`; both ends may be the same node.
struct Way {
  std::vector<NodeIndex> nodes;
  std::vector<LaneIndex> lanes;
  Nanoseconds time = 0;
  double length = 0;  ///< m
  double cost = 0;
};

/// The best way, or none where no way leads there within 285 years. A* (Hart, Nilsson, Raphael
/// 1968); what is yet to come is taken to be the straight distance by the best that any lane of the
/// network offers, which never promises too much. Lanes are weighed in whole nanoseconds,
/// nanometres or billionths of the currency.
/// Of ways equally good, seen from the goal backwards, the one by the lane that the description
/// has first. Throws std::invalid_argument for unknown nodes, a speed that is not above 0, a width
/// that is not a number, and closed lanes that are unknown or not ascending.
std::optional<Way> shortest_way(const LaneNetwork& network, NodeIndex from, NodeIndex to,
                                const WayOptions& options = {});

/// From how many nodes a search went on: for tests and benchmarks.
struct SearchCounts {
  std::int64_t expanded = 0;
};
std::optional<Way> shortest_way(const LaneNetwork& network, NodeIndex from, NodeIndex to,
                                const WayOptions& options, SearchCounts& counts);

/// The best ways from one node to all (Dijkstra 1959), by the same rules.
struct WaysFrom {
  NodeIndex from = kNone;
  /// By node: nanoseconds, nanometres or billionths of the currency; kNoWay where no way leads.
  std::vector<std::int64_t> weight;
  /// By node: the last lane of its way; kNone for `from` and where no way leads.
  std::vector<LaneIndex> last;
};
inline constexpr std::int64_t kNoWay = kEndOfTime;
WaysFrom ways_from(const LaneNetwork& network, NodeIndex from, const WayOptions& options = {});
/// One of these ways; the options have to be those that it was found by.
std::optional<Way> way_to(const LaneNetwork& network, const WaysFrom& ways, NodeIndex to,
                          const WayOptions& options = {});

}  // namespace rubicon::lanes
