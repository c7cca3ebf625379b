#pragma once

#include <optional>
#include <span>
#include <vector>

#include "src/fleets/lanes/lane_network.hpp"

namespace rubicon::traffic {

using lanes::LaneIndex;
using lanes::LaneNetwork;
using lanes::Nanoseconds;
using lanes::NodeIndex;

/// When a node belongs to another vehicle: from `from` until before `until`.
struct Hold {
  Nanoseconds from = 0;
  Nanoseconds until = lanes::kEndOfTime;
};

/// A node on a timed way. It is the vehicle's from `enter`, when it leaves the node before, until
/// it has arrived at the node after.
struct TimedNode {
  NodeIndex node = lanes::kNone;
  LaneIndex lane = lanes::kNone;  ///< that leads here; of the first kNone
  Nanoseconds enter = 0;
  Nanoseconds arrive = 0;
};

struct TimedWayQuery {
  const LaneNetwork* network = nullptr;
  NodeIndex from = lanes::kNone;
  Nanoseconds start = 0;  ///< when the vehicle is there
  double speed = 1;       ///< m/s, of the vehicle at most
  double width = 0;       ///< m
  /// By node: what others hold, ascending, without overlaps.
  std::span<const std::vector<Hold>> holds;
  /// By lane: when it may not be driven because others are too near to it; empty: lanes are far
  /// enough from all but their own nodes. Ascending, without overlaps.
  std::span<const std::vector<Hold>> lane_holds = {};
  /// With a goal the search ends there, led by `least`, by node: how long it takes to the goal at
  /// least.
  NodeIndex goal = lanes::kNone;
  std::span<const Nanoseconds> least = {};
};

/// Earliest arrivals between what others hold, by safe intervals (M. Phillips and M. Likhachev,
/// "SIPP: Safe Interval Path Planning for Dynamic Environments", 2011). A vehicle waits at nodes
/// only. Of ways that arrive at the same time the one that was found first counts: lanes in the
/// order of the network.
class TimedWays {
 public:
  explicit TimedWays(const TimedWayQuery& query);

  /// The earliest way to a node where the vehicle may then stay for good; nothing where there is
  /// none.
  std::optional<std::vector<TimedNode>> to(NodeIndex goal) const;
  /// The nodes where it may stay for good, the earliest first, the one it stands at among them.
  std::vector<NodeIndex> resting_places() const;
  /// From how many pairs of node and interval the search went on.
  std::int64_t expanded() const { return static_cast<std::int64_t>(labels_.size()); }

 private:
  struct Label {
    NodeIndex node = lanes::kNone;
    Nanoseconds end = 0;  ///< of the safe interval
    Nanoseconds enter = 0;
    Nanoseconds arrive = 0;
    LaneIndex lane = lanes::kNone;
    int before = -1;
  };
  /// The label with which the vehicle stays for good; -1: none.
  int last_of(NodeIndex node) const;

  std::vector<Label> labels_;  ///< settled, by arrival
  std::vector<int> last_;      ///< by node
};

}  // namespace rubicon::traffic
