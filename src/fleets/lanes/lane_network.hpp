#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubicon::lanes {

/// Time and durations in whole nanoseconds, so that sums are exact and ties are real.
using Nanoseconds = std::int64_t;
inline constexpr Nanoseconds kSecond = 1'000'000'000;
/// 285 years: what takes longer counts as never.
inline constexpr Nanoseconds kEndOfTime = 9'000'000'000 * kSecond;

/// Seconds as nanoseconds, rounded to the nearest; at least 1 ns, so that nothing takes no time,
/// and at most kEndOfTime. Of what is not a number: kEndOfTime.
Nanoseconds nanoseconds_of(double seconds);

/// Nodes and lanes are known by their place in the description.
using NodeIndex = std::int32_t;
using LaneIndex = std::int32_t;
inline constexpr std::int32_t kNone = -1;

/// A place where lanes begin, end and cross.
struct Node {
  std::string name;
  double x = 0;  ///< m, plan view of the site
  double y = 0;
  double heading_deg = 0;  ///< of a vehicle that stands here
  /// Something to know the place by: here a robot checks the lane ahead (the Blackmon paper,
  /// "Background": at all decision points).
  bool landmark = true;
};

/// What lanes of one kind have in common: highway, freeway, alley.
struct LaneClass {
  std::string name;
  double speed = 1;  ///< m/s, average
  double width = 4;  ///< m; no wider vehicle drives here
  double cost = 1;   ///< of a metre, in any currency
};

/// One direction from one node to another.
struct Lane {
  NodeIndex from = kNone;
  NodeIndex to = kNone;
  std::int32_t lane_class = 0;
  std::optional<double> length = std::nullopt;  ///< m; else the straight distance
  LaneIndex beside = kNone;                     ///< the other lane of the same travelway
};

struct NetworkDescription {
  std::vector<LaneClass> classes;
  std::vector<Node> nodes;
  std::vector<Lane> lanes;
};

/// What is wrong with a description, and where.
struct NetworkFault {
  std::string message;  ///< in words for users, by names
  NodeIndex node = kNone;
  LaneIndex lane = kNone;
};

/// All faults of a description, at most `most` of them: classes, nodes, lanes, each in their order.
std::vector<NetworkFault> faults_of(const NetworkDescription& description, std::size_t most = 100);

/// Lanes between nodes, checked. Memory and the time to build it grow with nodes and lanes (n log n
/// for the names).
class LaneNetwork {
 public:
  /// Throws std::invalid_argument with the first fault. A lane that is beside another has that one
  /// beside it, said once or twice.
  explicit LaneNetwork(NetworkDescription description);

  std::int32_t node_count() const { return static_cast<std::int32_t>(nodes_.size()); }
  std::int32_t lane_count() const { return static_cast<std::int32_t>(lanes_.size()); }
  const Node& node(NodeIndex index) const { return nodes_[static_cast<std::size_t>(index)]; }
  const Lane& lane(LaneIndex index) const { return lanes_[static_cast<std::size_t>(index)]; }
  const LaneClass& class_of(LaneIndex index) const {
    return classes_[static_cast<std::size_t>(lane(index).lane_class)];
  }
  const std::vector<LaneClass>& classes() const { return classes_; }

  /// m.
  double length(LaneIndex index) const { return lengths_[static_cast<std::size_t>(index)]; }
  /// How long a vehicle of this top speed (m/s) takes for the lane.
  Nanoseconds time(LaneIndex index,
                   double vehicle_speed = std::numeric_limits<double>::infinity()) const;
  /// The same for so many metres of it.
  Nanoseconds time_of_part(LaneIndex index, double metres, double vehicle_speed) const;

  /// The lanes that leave a node, in the order of the description.
  std::span<const LaneIndex> leaving(NodeIndex node) const;
  /// The lane from one node to another; kNone where there is none.
  LaneIndex find_lane(NodeIndex from, NodeIndex to) const;
  /// The node of this name; kNone where there is none.
  NodeIndex find_node(std::string_view name) const;
  /// "B8 to B8B10".
  std::string name_of(LaneIndex index) const;
  /// m, in a straight line.
  double distance(NodeIndex from, NodeIndex to) const;

  /// What a search may expect of the best of all lanes.
  struct Bounds {
    double speed = 0;    ///< m/s, the highest
    double cost = 0;     ///< of a metre, the least
    double length = 0;   ///< m, of the shortest lane
    double stretch = 1;  ///< the least length by straight distance: below 1 a lane is a short cut
  };
  const Bounds& bounds() const { return bounds_; }

 private:
  std::vector<LaneClass> classes_;
  std::vector<Node> nodes_;
  std::vector<Lane> lanes_;
  std::vector<double> lengths_;
  std::vector<std::int32_t> first_leaving_;  // by node, and one more
  std::vector<LaneIndex> leaving_;
  std::vector<NodeIndex> by_name_;
  Bounds bounds_;
};

}  // namespace rubicon::lanes
