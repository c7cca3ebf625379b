#include "src/fleets/lanes/lane_network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace rubicon::lanes {
namespace {

// Lanes that leave the same node stand together, in the order of the description.
struct Leaving {
  std::vector<std::int32_t> first;
  std::vector<LaneIndex> lanes;
};

Leaving group_by_start(const std::vector<Lane>& lanes, std::size_t nodes) {
  Leaving result{std::vector<std::int32_t>(nodes + 1, 0), std::vector<LaneIndex>(lanes.size())};
  for (const Lane& lane : lanes) ++result.first[static_cast<std::size_t>(lane.from) + 1];
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  std::vector<std::int32_t> next(result.first.begin(), result.first.end() - 1);
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    result.lanes[static_cast<std::size_t>(next[static_cast<std::size_t>(lanes[i].from)]++)] =
        static_cast<LaneIndex>(i);
  }
  return result;
}

std::vector<NodeIndex> order_by_name(const std::vector<Node>& nodes) {
  std::vector<NodeIndex> result(nodes.size());
  std::iota(result.begin(), result.end(), 0);
  std::sort(result.begin(), result.end(), [&nodes](NodeIndex a, NodeIndex b) {
    const int order =
        nodes[static_cast<std::size_t>(a)].name.compare(nodes[static_cast<std::size_t>(b)].name);
    return order != 0 ? order < 0 : a < b;
  });
  return result;
}

double straight_between(const Node& a, const Node& b) {
  const double x = b.x - a.x;
  const double y = b.y - a.y;
  return std::sqrt(x * x + y * y);
}

// Collects faults, and stops counting where there are enough.
class FaultFinder {
 public:
  FaultFinder(const NetworkDescription& description, std::size_t most)
      : description_(description), most_(most) {}

  std::vector<NetworkFault> find() {
    check_classes();
    check_nodes();
    bool ends_known = true;
    for (std::size_t i = 0; i < lanes().size(); ++i) ends_known &= check_lane(i);
    if (ends_known) check_twice();
    return std::move(faults_);
  }

  // After find(): sorting a million names takes longer than all the rest.
  std::vector<NodeIndex> take_name_order() { return std::move(by_name_); }

 private:
  const std::vector<Node>& nodes() const { return description_.nodes; }
  const std::vector<Lane>& lanes() const { return description_.lanes; }
  bool is_node(NodeIndex i) const { return i >= 0 && static_cast<std::size_t>(i) < nodes().size(); }
  const std::string& name_of_node(NodeIndex i) const {
    return nodes()[static_cast<std::size_t>(i)].name;
  }

  void add(std::string message, NodeIndex node, LaneIndex lane) {
    if (faults_.size() < most_) faults_.push_back({std::move(message), node, lane});
  }

  // Lanes by their nodes where these are known, else by their place.
  std::string name_of_lane(std::size_t i) const {
    const Lane& lane = lanes()[i];
    if (!is_node(lane.from) || !is_node(lane.to)) return fmt::format("lane number {}", i + 1);
    return fmt::format("lane {} to {}", name_of_node(lane.from), name_of_node(lane.to));
  }

  void check_classes() {
    const std::vector<LaneClass>& classes = description_.classes;
    for (std::size_t i = 0; i < classes.size(); ++i) {
      const LaneClass& one = classes[i];
      const auto positive = [&](const char* what, double value) {
        if (value > 0 && std::isfinite(value)) return;
        add(fmt::format("class {}: expected a {} above 0, found {}", one.name, what, value), kNone,
            kNone);
      };
      positive("speed", one.speed);
      positive("width", one.width);
      if (!(one.cost >= 0) || !std::isfinite(one.cost)) {
        add(fmt::format("class {}: expected a cost of 0 or more, found {}", one.name, one.cost),
            kNone, kNone);
      }
      for (std::size_t k = 0; k < i; ++k) {
        if (classes[k].name != one.name) continue;
        add(fmt::format("class {} is there twice", one.name), kNone, kNone);
        break;
      }
    }
  }

  void check_nodes() {
    for (std::size_t i = 0; i < nodes().size(); ++i) {
      const Node& node = nodes()[i];
      if (node.name.empty()) {
        add(fmt::format("node number {} has no name", i + 1), static_cast<NodeIndex>(i), kNone);
      }
      if (!std::isfinite(node.x) || !std::isfinite(node.y) || !std::isfinite(node.heading_deg)) {
        add(fmt::format("node {}: its place is not a number", node.name), static_cast<NodeIndex>(i),
            kNone);
      }
    }
    by_name_ = order_by_name(nodes());
    for (std::size_t i = 1; i < by_name_.size(); ++i) {
      const std::string& name = name_of_node(by_name_[i]);
      if (!name.empty() && name == name_of_node(by_name_[i - 1])) {
        add(fmt::format("node {} is there twice", name), by_name_[i], kNone);
      }
    }
  }

  // Whether both ends are nodes.
  bool check_lane(std::size_t i) {
    const Lane& lane = lanes()[i];
    const auto index = static_cast<LaneIndex>(i);
    const bool ends_known = is_node(lane.from) && is_node(lane.to);
    if (!ends_known) {
      add(fmt::format("{}: its {} is an unknown node; there are {} nodes", name_of_lane(i),
                      is_node(lane.from) ? "end" : "start", nodes().size()),
          kNone, index);
    } else if (lane.from == lane.to) {
      add(fmt::format("{} ends where it starts", name_of_lane(i)), lane.from, index);
    }
    if (lane.lane_class < 0 ||
        static_cast<std::size_t>(lane.lane_class) >= description_.classes.size()) {
      add(fmt::format("{} is of an unknown class", name_of_lane(i)), kNone, index);
    }
    if (lane.length) {
      if (!(*lane.length > 0) || !std::isfinite(*lane.length)) {
        add(fmt::format("{}: expected a length above 0 m, found {}", name_of_lane(i), *lane.length),
            kNone, index);
      }
    } else if (ends_known && lane.from != lane.to) {
      const double straight = straight_between(nodes()[static_cast<std::size_t>(lane.from)],
                                               nodes()[static_cast<std::size_t>(lane.to)]);
      if (straight == 0) {
        add(fmt::format("{}: both nodes are at the same place; give the lane a length",
                        name_of_lane(i)),
            lane.to, index);
      } else if (std::isinf(straight)) {
        add(fmt::format("{}: its nodes are too far apart; give the lane a length", name_of_lane(i)),
            lane.to, index);
      }
    }
    check_beside(i);
    return ends_known;
  }

  void check_beside(std::size_t i) {
    const LaneIndex other = lanes()[i].beside;
    const auto index = static_cast<LaneIndex>(i);
    if (other == kNone) return;
    if (other < 0 || static_cast<std::size_t>(other) >= lanes().size()) {
      add(fmt::format("{} is beside an unknown lane", name_of_lane(i)), kNone, index);
      return;
    }
    if (other == index) {
      add(fmt::format("{} is beside itself", name_of_lane(i)), kNone, index);
      return;
    }
    if (partner_.empty()) partner_.assign(lanes().size(), kNone);
    const auto claim = [&](LaneIndex one, LaneIndex with) {
      LaneIndex& partner = partner_[static_cast<std::size_t>(one)];
      if (partner != kNone && partner != with) {
        add(fmt::format("{} is beside two lanes: {} and {}",
                        name_of_lane(static_cast<std::size_t>(one)),
                        name_of_lane(static_cast<std::size_t>(partner)),
                        name_of_lane(static_cast<std::size_t>(with))),
            kNone, index);
      }
      partner = with;
    };
    claim(index, other);
    claim(other, index);
  }

  void check_twice() {
    const Leaving leaving = group_by_start(lanes(), nodes().size());
    std::vector<LaneIndex> here;
    for (std::size_t node = 0; node < nodes().size(); ++node) {
      here.assign(leaving.lanes.begin() + leaving.first[node],
                  leaving.lanes.begin() + leaving.first[node + 1]);
      std::stable_sort(here.begin(), here.end(), [&](LaneIndex a, LaneIndex b) {
        return lanes()[static_cast<std::size_t>(a)].to < lanes()[static_cast<std::size_t>(b)].to;
      });
      for (std::size_t k = 1; k < here.size(); ++k) {
        const auto now = static_cast<std::size_t>(here[k]);
        if (lanes()[now].to != lanes()[static_cast<std::size_t>(here[k - 1])].to) continue;
        add(fmt::format("{} is listed twice", name_of_lane(now)), kNone, here[k]);
      }
    }
  }

  const NetworkDescription& description_;
  std::size_t most_;
  std::vector<NetworkFault> faults_;
  std::vector<LaneIndex> partner_;  // by lane: the one beside it
  std::vector<NodeIndex> by_name_;
};

}  // namespace

Nanoseconds nanoseconds_of(double seconds) {
  constexpr double kMost = 9e9;  // s, kEndOfTime
  if (!(seconds < kMost)) return kEndOfTime;
  return std::max<Nanoseconds>(1, static_cast<Nanoseconds>(std::floor(seconds * 1e9 + 0.5)));
}

std::vector<NetworkFault> faults_of(const NetworkDescription& description, std::size_t most) {
  return FaultFinder(description, most).find();
}

LaneNetwork::LaneNetwork(NetworkDescription description) {
  FaultFinder finder(description, 1);
  const std::vector<NetworkFault> faults = finder.find();
  if (!faults.empty()) throw std::invalid_argument(faults.front().message);
  by_name_ = finder.take_name_order();
  classes_ = std::move(description.classes);
  nodes_ = std::move(description.nodes);
  lanes_ = std::move(description.lanes);

  Leaving leaving = group_by_start(lanes_, nodes_.size());
  first_leaving_ = std::move(leaving.first);
  leaving_ = std::move(leaving.lanes);

  bounds_.cost = bounds_.length = bounds_.stretch = std::numeric_limits<double>::infinity();
  lengths_.resize(lanes_.size());
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    const Lane& lane = lanes_[i];
    if (lane.beside != kNone) {
      lanes_[static_cast<std::size_t>(lane.beside)].beside = static_cast<LaneIndex>(i);
    }
    const double straight = distance(lane.from, lane.to);
    lengths_[i] = lane.length.value_or(straight);
    const LaneClass& its_class = classes_[static_cast<std::size_t>(lane.lane_class)];
    bounds_.speed = std::max(bounds_.speed, its_class.speed);
    bounds_.cost = std::min(bounds_.cost, its_class.cost);
    bounds_.length = std::min(bounds_.length, lengths_[i]);
    if (straight > 0) bounds_.stretch = std::min(bounds_.stretch, lengths_[i] / straight);
  }
}

Nanoseconds LaneNetwork::time(LaneIndex index, double vehicle_speed) const {
  return time_of_part(index, length(index), vehicle_speed);
}

Nanoseconds LaneNetwork::time_of_part(LaneIndex index, double metres, double vehicle_speed) const {
  return nanoseconds_of(metres / std::min(class_of(index).speed, vehicle_speed));
}

std::span<const LaneIndex> LaneNetwork::leaving(NodeIndex node) const {
  const auto i = static_cast<std::size_t>(node);
  return std::span(leaving_).subspan(
      static_cast<std::size_t>(first_leaving_[i]),
      static_cast<std::size_t>(first_leaving_[i + 1] - first_leaving_[i]));
}

LaneIndex LaneNetwork::find_lane(NodeIndex from, NodeIndex to) const {
  for (const LaneIndex i : leaving(from)) {
    if (lane(i).to == to) return i;
  }
  return kNone;
}

NodeIndex LaneNetwork::find_node(std::string_view name) const {
  const auto found = std::lower_bound(
      by_name_.begin(), by_name_.end(), name,
      [this](NodeIndex i, std::string_view wanted) { return node(i).name < wanted; });
  return found != by_name_.end() && node(*found).name == name ? *found : kNone;
}

std::string LaneNetwork::name_of(LaneIndex index) const {
  return fmt::format("{} to {}", node(lane(index).from).name, node(lane(index).to).name);
}

double LaneNetwork::distance(NodeIndex from, NodeIndex to) const {
  return straight_between(node(from), node(to));
}

}  // namespace rubicon::lanes
