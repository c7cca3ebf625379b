#include "src/fleets/traffic/one_shot.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "src/fleets/lanes/shortest_way.hpp"

namespace rubicon::traffic {

namespace {

using Ways = std::vector<std::vector<TimedNode>>;

std::size_t index_of(std::int32_t index) { return static_cast<std::size_t>(index); }

/// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, 2014).
class Bits {
 public:
  explicit Bits(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t count) {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return static_cast<std::size_t>((z ^ (z >> 31)) % count);
  }

 private:
  std::uint64_t state_;
};

/// What is held of one node or lane, and by whom; what belongs to several is told as one.
class Holding {
 public:
  void add(int trip, Hold hold) {
    all_.push_back({trip, hold});
    merge();
  }
  void remove(int trip) {
    std::erase_if(all_, [trip](const Owned& each) { return each.trip == trip; });
    merge();
  }
  const std::vector<Hold>& merged() const { return merged_; }
  template <typename Visit>
  void each(Visit visit) const {
    for (const Owned& owned : all_) visit(owned.trip, owned.hold);
  }

 private:
  struct Owned {
    int trip = 0;
    Hold hold;
  };
  void merge() {
    std::stable_sort(all_.begin(), all_.end(),
                     [](const Owned& a, const Owned& b) { return a.hold.from < b.hold.from; });
    merged_.clear();
    for (const Owned& each : all_) {
      if (!merged_.empty() && each.hold.from <= merged_.back().until) {
        merged_.back().until = std::max(merged_.back().until, each.hold.until);
      } else {
        merged_.push_back(each.hold);
      }
    }
  }
  std::vector<Owned> all_;
  std::vector<Hold> merged_;
};

lanes::NetworkDescription reversed(const LaneNetwork& network) {
  lanes::NetworkDescription description;
  description.classes = network.classes();
  for (NodeIndex node = 0; node < network.node_count(); ++node) {
    description.nodes.push_back(network.node(node));
  }
  for (LaneIndex i = 0; i < network.lane_count(); ++i) {
    const lanes::Lane& lane = network.lane(i);
    description.lanes.push_back(
        {lane.to, lane.from, lane.lane_class, network.length(i), lanes::kNone});
  }
  return description;
}

/// What a way holds: its nodes from when the one before is left until the one after is reached, its
/// lanes while they are driven.
template <typename Visit>
void each_node_hold(const std::vector<TimedNode>& way, Visit visit) {
  for (std::size_t k = 0; k < way.size(); ++k) {
    const Nanoseconds from = k == 0 ? 0 : way[k].enter;
    const Nanoseconds until = k + 1 < way.size() ? way[k + 1].arrive : lanes::kEndOfTime;
    visit(k, Hold{from, until});
  }
}

class OneShotPlanner {
 public:
  OneShotPlanner(const LaneNetwork& network, const Nearness& near, const std::vector<Trip>& trips,
                 const OneShotOptions& options)
      : network_(network), near_(near), trips_(trips), options_(options), random_(options.seed) {
    check();
    const LaneNetwork back(reversed(network));
    for (const Trip& trip : trips_) {
      lanes::WayOptions alone;
      alone.vehicle_speed = trip.speed;
      least_.push_back(lanes::ways_from(back, trip.to, alone).weight);
    }
    node_holds_.resize(index_of(network.node_count()));
    lane_holds_.resize(index_of(network.lane_count()));
    told_nodes_.resize(node_holds_.size());
    told_lanes_.resize(lane_holds_.size());
  }

  OneShot run() {
    OneShot result;
    for (std::size_t i = 0; i < trips_.size(); ++i) {
      if (least_[i][index_of(trips_[i].from)] >= lanes::kNoWay) return result;
      result.least += least_[i][index_of(trips_[i].from)];
    }
    result.solved = find_first();
    result.expansions = expansions_;
    if (!result.solved) return result;
    result.first_cost = cost_;
    improve();
    result.ways = ways_;
    result.cost = cost_;
    result.expansions = expansions_;
    return result;
  }

 private:
  void check() {
    std::set<NodeIndex> starts, goals;
    for (std::size_t i = 0; i < trips_.size(); ++i) {
      const Trip& trip = trips_[i];
      const std::string who = "trip " + std::to_string(i);
      for (const NodeIndex node : {trip.from, trip.to}) {
        if (node < 0 || node >= network_.node_count()) {
          throw std::invalid_argument(who + " has an unknown node");
        }
      }
      if (!(trip.speed > 0)) throw std::invalid_argument(who + " has no speed");
      if (!starts.insert(trip.from).second || !goals.insert(trip.to).second) {
        throw std::invalid_argument(who + " begins or ends where another does");
      }
    }
  }

  Nanoseconds delay_of(int trip) const {
    const Trip& each = trips_[index_of(trip)];
    return ways_[index_of(trip)].back().arrive - least_[index_of(trip)][index_of(each.from)];
  }

  void hold_node(int trip, NodeIndex node, Hold hold) {
    node_holds_[index_of(node)].add(trip, hold);
    told_nodes_[index_of(node)] = node_holds_[index_of(node)].merged();
    touched_[index_of(trip)].first.push_back(node);
  }
  void hold_lane(int trip, LaneIndex lane, Hold hold) {
    lane_holds_[index_of(lane)].add(trip, hold);
    told_lanes_[index_of(lane)] = lane_holds_[index_of(lane)].merged();
    touched_[index_of(trip)].second.push_back(lane);
  }

  void place(int trip, std::vector<TimedNode> way) {
    each_node_hold(way, [&](std::size_t k, Hold hold) {
      hold_node(trip, way[k].node, hold);
      for (const LaneIndex lane : near_.lanes_by_node[index_of(way[k].node)]) {
        hold_lane(trip, lane, hold);
      }
      for (const NodeIndex node : near_.nodes_by_node[index_of(way[k].node)]) {
        hold_node(trip, node, hold);
      }
      if (k == 0) return;
      const Hold driven{way[k].enter, way[k].arrive};
      for (const NodeIndex node : near_.nodes_by_lane[index_of(way[k].lane)]) {
        hold_node(trip, node, driven);
      }
      for (const LaneIndex lane : near_.lanes_by_lane[index_of(way[k].lane)]) {
        hold_lane(trip, lane, driven);
      }
    });
    cost_ += way.back().arrive;
    ways_[index_of(trip)] = std::move(way);
  }

  std::vector<TimedNode> take_away(int trip) {
    for (const NodeIndex node : touched_[index_of(trip)].first) {
      node_holds_[index_of(node)].remove(trip);
      told_nodes_[index_of(node)] = node_holds_[index_of(node)].merged();
    }
    for (const LaneIndex lane : touched_[index_of(trip)].second) {
      lane_holds_[index_of(lane)].remove(trip);
      told_lanes_[index_of(lane)] = lane_holds_[index_of(lane)].merged();
    }
    touched_[index_of(trip)] = {};
    cost_ -= ways_[index_of(trip)].back().arrive;
    return std::exchange(ways_[index_of(trip)], {});
  }

  bool find_way(int trip) {
    const Trip& each = trips_[index_of(trip)];
    TimedWayQuery query;
    query.network = &network_;
    query.from = each.from;
    query.speed = each.speed;
    query.holds = told_nodes_;
    query.lane_holds = told_lanes_;
    query.goal = each.to;
    query.least = least_[index_of(trip)];
    // Somebody passes here before it could leave.
    const std::vector<Hold>& own = told_nodes_[index_of(each.from)];
    if (!own.empty() && own.front().from == 0) return false;
    const TimedWays ways(query);
    expansions_ += ways.expanded();
    auto way = ways.to(each.to);
    if (!way) return false;
    place(trip, std::move(*way));
    return true;
  }

  void clear() {
    for (std::size_t i = 0; i < trips_.size(); ++i) {
      if (i < ways_.size() && !ways_[i].empty()) take_away(static_cast<int>(i));
    }
    ways_.assign(trips_.size(), {});
    touched_.assign(trips_.size(), {});
  }

  bool find_first() {
    std::vector<int> order(trips_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
      return least_[index_of(a)][index_of(trips_[index_of(a)].from)] >
             least_[index_of(b)][index_of(trips_[index_of(b)].from)];
    });
    while (true) {
      clear();
      const auto failed =
          std::find_if(order.begin(), order.end(), [&](int trip) { return !find_way(trip); });
      if (failed == order.end()) return true;
      if (expansions_ >= options_.expansions) return false;
      // What was seen to fail goes first; by chance a few others change places, so that no order
      // comes again and again.
      std::rotate(order.begin(), failed, failed + 1);
      if (order.size() > 2) {
        const std::size_t a = 1 + random_.below(order.size() - 1);
        const std::size_t b = 1 + random_.below(order.size() - 1);
        std::swap(order[a], order[b]);
      }
      ++expansions_;
    }
  }

  /// Who holds what the best way of a trip alone would need, and the trip itself.
  std::vector<int> neighbours_of(int trip, std::size_t most) {
    std::vector<int> group = {trip};
    const auto take = [&](int other, const Hold&) {
      if (group.size() >= most) return;
      if (std::find(group.begin(), group.end(), other) == group.end()) group.push_back(other);
    };
    // Along its best way alone: down the times that are left.
    const std::vector<Nanoseconds>& least = least_[index_of(trip)];
    NodeIndex node = trips_[index_of(trip)].from;
    while (node != trips_[index_of(trip)].to && group.size() < most) {
      NodeIndex next = lanes::kNone;
      LaneIndex by = lanes::kNone;
      for (const LaneIndex lane : network_.leaving(node)) {
        const NodeIndex to = network_.lane(lane).to;
        const Nanoseconds left = least[index_of(to)];
        if (left >= least[index_of(node)]) continue;
        const Nanoseconds takes = network_.time(lane, trips_[index_of(trip)].speed);
        if (left + takes != least[index_of(node)]) continue;
        next = to;
        by = lane;
        break;
      }
      if (next == lanes::kNone) break;
      lane_holds_[index_of(by)].each(take);
      node_holds_[index_of(next)].each(take);
      node = next;
    }
    while (group.size() < most) {
      take(static_cast<int>(random_.below(trips_.size())), {});
      if (group.size() >= trips_.size()) break;
    }
    return group;
  }

  void improve() {
    std::vector<int> late;
    while (expansions_ < options_.expansions) {
      late.clear();
      for (std::size_t i = 0; i < trips_.size(); ++i) {
        if (delay_of(static_cast<int>(i)) > 0) late.push_back(static_cast<int>(i));
      }
      if (late.empty()) return;
      const std::size_t chosen = random_.below(late.size());
      const std::size_t size = std::min(trips_.size(), 2 + random_.below(7));
      std::vector<int> group = neighbours_of(late[chosen], size);
      for (std::size_t i = group.size(); i > 1; --i) {
        const std::size_t other = random_.below(i);
        std::swap(group[i - 1], group[other]);
      }
      const Nanoseconds before = cost_;
      std::vector<std::vector<TimedNode>> old;
      for (const int trip : group) old.push_back(take_away(trip));
      bool is_whole = true;
      std::size_t placed = 0;
      for (; placed < group.size() && is_whole; ++placed) {
        is_whole = find_way(group[placed]) && cost_ <= before;
      }
      ++expansions_;
      if (is_whole) continue;
      for (const int trip : group) {
        if (!ways_[index_of(trip)].empty()) take_away(trip);
      }
      for (std::size_t i = 0; i < group.size(); ++i) place(group[i], std::move(old[i]));
    }
  }

  const LaneNetwork& network_;
  const Nearness& near_;
  const std::vector<Trip>& trips_;
  OneShotOptions options_;
  Bits random_;
  std::vector<std::vector<Nanoseconds>> least_;  ///< by trip and node: to its goal
  std::vector<Holding> node_holds_;
  std::vector<Holding> lane_holds_;
  std::vector<std::vector<Hold>> told_nodes_;  ///< as searches ask for them
  std::vector<std::vector<Hold>> told_lanes_;
  std::vector<std::pair<std::vector<NodeIndex>, std::vector<LaneIndex>>> touched_;
  Ways ways_;
  Nanoseconds cost_ = 0;
  std::int64_t expansions_ = 0;
};

}  // namespace

OneShot plan_all(const LaneNetwork& network, const Nearness& near, const std::vector<Trip>& trips,
                 const OneShotOptions& options) {
  return OneShotPlanner(network, near, trips, options).run();
}

std::vector<Precedence> order_of(const Nearness& near,
                                 const std::vector<std::vector<TimedNode>>& ways) {
  /// A node or a lane that a trip holds: from when it leaves a node of its way until it arrives at
  /// one.
  struct Use {
    int trip = 0;
    int departs = 0;  ///< the node that it is on its way to when it begins; 0: from the beginning
    int arrives = 0;  ///< the node at which it ends; past the last: never
    Hold hold;
  };
  std::vector<std::vector<Use>> at_node(near.lanes_by_node.size());
  std::vector<std::vector<Use>> on_lane(near.lanes_by_lane.size());
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const int trip = static_cast<int>(i);
    each_node_hold(ways[i], [&](std::size_t k, Hold hold) {
      const int place = static_cast<int>(k);
      at_node[index_of(ways[i][k].node)].push_back({trip, place, place + 1, hold});
      if (k == 0) return;
      on_lane[index_of(ways[i][k].lane)].push_back(
          {trip, place, place, {ways[i][k].enter, ways[i][k].arrive}});
    });
  }
  std::set<std::tuple<int, int, int, int>> found;
  const auto compare = [&](const std::vector<Use>& some, const std::vector<Use>& others) {
    for (const Use& a : some) {
      for (const Use& b : others) {
        if (a.trip == b.trip) continue;
        const bool a_first = a.hold.until <= b.hold.from;
        const Use& first = a_first ? a : b;
        const Use& later = a_first ? b : a;
        found.insert({first.trip, first.arrives, later.trip, later.departs});
      }
    }
  };
  for (std::size_t node = 0; node < at_node.size(); ++node) {
    compare(at_node[node], at_node[node]);
    for (const NodeIndex other : near.nodes_by_node[node]) {
      compare(at_node[node], at_node[index_of(other)]);
    }
    for (const LaneIndex lane : near.lanes_by_node[node]) {
      compare(at_node[node], on_lane[index_of(lane)]);
    }
  }
  for (std::size_t lane = 0; lane < on_lane.size(); ++lane) {
    for (const LaneIndex other : near.lanes_by_lane[lane]) {
      compare(on_lane[lane], on_lane[index_of(other)]);
    }
  }
  std::vector<Precedence> order;
  for (const auto& [first, arrives, later, departs] : found) {
    order.push_back({first, arrives, later, departs});
  }
  return order;
}

}  // namespace rubicon::traffic
