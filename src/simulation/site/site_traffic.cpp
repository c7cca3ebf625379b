#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "src/fleets/lanes/shortest_way.hpp"
#include "src/motion/math/index.hpp"
#include "src/simulation/site/site_world.hpp"

namespace rubicon::site {

using guides::LaneAnswer;
using math::at;

namespace {

/// m: so near a vehicle is at its node. Legs end much nearer.
constexpr double kAtNode = 1e-6;

Eigen::Vector2d place_of(const traffic::LaneNetwork& network, lanes::NodeIndex node) {
  return {network.node(node).x, network.node(node).y};
}

/// The nearest node to a place; of equals the first.
lanes::NodeIndex nearest_node(const traffic::LaneNetwork& network, const Eigen::Vector2d& place) {
  lanes::NodeIndex nearest = 0;
  double least = (place_of(network, 0) - place).squaredNorm();
  for (lanes::NodeIndex node = 1; node < network.node_count(); ++node) {
    const double distance = (place_of(network, node) - place).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    nearest = node;
  }
  return nearest;
}

}  // namespace

void SiteWorld::add_network(std::string name, traffic::Traffic traffic, std::vector<int> robots) {
  networks_.push_back({std::move(name), std::move(traffic), std::move(robots)});
}

/// Who is before a vehicle at a node, and stands there or goes first there.
interpreter::HitPair SiteWorld::in_the_way(const Network& network, const traffic::Wait& wait) {
  const bool stands = network.traffic.node_of(wait.vehicle) == wait.node;
  interpreter::HitPair pair{stands ? "is at" : "goes first at",
                            network.name + "." + network.traffic.network().node(wait.node).name,
                            network.robots[at(wait.vehicle)]};
  pair.turn = true;
  return pair;
}

LaneAnswer SiteWorld::next_node(int robot, const guides::LaneQuestion& question,
                                std::optional<interpreter::HitPair>& before) {
  LaneAnswer answer;
  answer.reason = "it drives on no network";
  for (Network& network : networks_) {
    const auto found = std::find(network.robots.begin(), network.robots.end(), robot);
    if (found == network.robots.end()) continue;
    const int vehicle = static_cast<int>(found - network.robots.begin());
    traffic::Traffic& traffic = network.traffic;
    const traffic::LaneNetwork& map = traffic.network();
    const auto waits = [&](const traffic::Wait& wait) {
      interpreter::HitPair pair = in_the_way(network, wait);
      answer.kind = LaneAnswer::Kind::waits;
      answer.reason = fmt::format("{} {} {}", entry(pair.machine).robot.name, pair.moved, pair.met);
      answer.tells_way = false;
      answer.way.clear();
      before = std::move(pair);
    };
    answer.tells_way = !question.reached;
    const lanes::NodeIndex goal = nearest_node(map, question.goal);
    // It may have a way beyond its goal, out of the way of others: they will ask it to go on.
    const bool stops_at_goal = traffic.wants(vehicle) != goal;
    const auto drive_to = [&](lanes::NodeIndex node) {
      answer.kind = LaneAnswer::Kind::node;
      answer.place = place_of(map, node);
      const std::vector<traffic::TimedNode> way = traffic.way_of(vehicle, now_);
      answer.left = -1;
      for (std::size_t i = traffic.node_of(vehicle) == node ? 0 : 1; i < way.size(); ++i) {
        ++answer.left;
        if (answer.tells_way) answer.way.push_back(place_of(map, way[i].node));
        if (stops_at_goal && way[i].node == goal) break;
      }
    };
    if (question.reached) traffic.arrived(vehicle, now_);
    if (traffic.drives(vehicle)) {
      drive_to(traffic.next_of(vehicle));
      return answer;
    }
    if (stops_at_goal && traffic.node_of(vehicle) == goal) {
      answer.kind = LaneAnswer::Kind::goal;
      return answer;
    }
    if (traffic.next_of(vehicle) == lanes::kNone && traffic.node_of(vehicle) != goal) {
      const traffic::PlanResult result = traffic.plan(vehicle, goal, now_);
      if (result.outcome == traffic::PlanResult::Outcome::no_way) {
        answer.kind = LaneAnswer::Kind::no_way;
        answer.tells_way = false;
        answer.reason =
            fmt::format("no lanes of {} that are wide enough lead from {} to {}", network.name,
                        map.node(traffic.node_of(vehicle)).name, map.node(goal).name);
        return answer;
      }
      if (result.outcome == traffic::PlanResult::Outcome::waits) {
        waits(result.wait);
        return answer;
      }
      answer.tells_way = true;
    }
    if (traffic.next_of(vehicle) == lanes::kNone) {
      answer.kind = LaneAnswer::Kind::goal;
      return answer;
    }
    if ((question.place - place_of(map, traffic.node_of(vehicle))).norm() > kAtNode) {
      drive_to(traffic.node_of(vehicle));  // from beside the lanes
      return answer;
    }
    if (const auto wait = traffic.enter_next(vehicle, now_)) {
      waits(*wait);
      return answer;
    }
    drive_to(traffic.next_of(vehicle));
    return answer;
  }
  return answer;
}

std::optional<double> SiteWorld::lane_distance(int robot, const Eigen::Vector2d& place) const {
  for (const Network& network : networks_) {
    const auto found = std::find(network.robots.begin(), network.robots.end(), robot);
    if (found == network.robots.end()) continue;
    const int vehicle = static_cast<int>(found - network.robots.begin());
    const traffic::Traffic& traffic = network.traffic;
    const lanes::NodeIndex goal = nearest_node(traffic.network(), place);
    lanes::WayOptions options;
    options.criterion = lanes::Criterion::kDistance;
    options.vehicle_width = traffic.vehicle(vehicle).width;
    const auto way =
        lanes::shortest_way(traffic.network(), traffic.node_of(vehicle), goal, options);
    if (!way) return std::numeric_limits<double>::infinity();
    return way->length + (place - place_of(traffic.network(), goal)).norm();
  }
  return std::nullopt;
}

/// By vehicle: who is idle, or waits itself.
std::vector<bool> SiteWorld::movable_in(const Network& network, const std::vector<bool>& idle) {
  std::vector<bool> movable;
  for (std::size_t i = 0; i < network.robots.size(); ++i) {
    movable.push_back(idle[at(network.robots[i])] || network.traffic.waits(static_cast<int>(i)));
  }
  return movable;
}

std::optional<interpreter::HitPair> SiteWorld::who_bars(int robot,
                                                        const std::vector<bool>& idle) const {
  for (const Network& network : networks_) {
    const auto found = std::find(network.robots.begin(), network.robots.end(), robot);
    if (found == network.robots.end()) continue;
    const int vehicle = static_cast<int>(found - network.robots.begin());
    const auto wait = network.traffic.who_bars(vehicle, movable_in(network, idle));
    if (wait) return in_the_way(network, *wait);
  }
  return std::nullopt;
}

bool SiteWorld::untangle(
    int robot, const std::vector<bool>& idle,
    const std::function<std::vector<Eigen::Vector2d>(int robot)>& places_ahead) {
  for (Network& network : networks_) {
    const auto found = std::find(network.robots.begin(), network.robots.end(), robot);
    if (found == network.robots.end()) continue;
    const int vehicle = static_cast<int>(found - network.robots.begin());
    if (!network.traffic.waits(vehicle)) return false;
    const std::vector<bool> movable = movable_in(network, idle);
    const std::pair state(network.traffic.changes(), movable);
    const auto known = network.tangled.find(vehicle);
    if (known != network.tangled.end() && known->second == state) return false;
    traffic::Traffic::Ahead ahead(network.robots.size());
    for (std::size_t i = 0; i < network.robots.size(); ++i) {
      if (!movable[i]) continue;
      for (const Eigen::Vector2d& place : places_ahead(network.robots[i])) {
        ahead[i].push_back(nearest_node(network.traffic.network(), place));
      }
    }
    if (network.traffic.untangle(vehicle, movable, ahead, now_)) return true;
    network.tangled[vehicle] = state;
  }
  return false;
}

std::vector<int> SiteWorld::robots_beside(int robot) const {
  for (const Network& network : networks_) {
    if (std::find(network.robots.begin(), network.robots.end(), robot) == network.robots.end()) {
      continue;
    }
    std::vector<int> others = network.robots;
    std::erase(others, robot);
    return others;
  }
  return {};
}

std::optional<lanes::Node> SiteWorld::next_stop(int robot) const {
  for (const Network& network : networks_) {
    const auto found = std::find(network.robots.begin(), network.robots.end(), robot);
    if (found == network.robots.end()) continue;
    const int vehicle = static_cast<int>(found - network.robots.begin());
    const lanes::NodeIndex stop = network.traffic.next_stop(vehicle);
    if (stop == lanes::kNone) continue;
    return network.traffic.network().node(stop);
  }
  return std::nullopt;
}

std::uint64_t SiteWorld::traffic_changes() const {
  std::uint64_t changes = 0;
  for (const Network& network : networks_) changes += network.traffic.changes();
  return changes;
}

std::vector<traffic::Traffic> SiteWorld::traffic() const {
  std::vector<traffic::Traffic> all;
  for (const Network& network : networks_) all.push_back(network.traffic);
  return all;
}

void SiteWorld::set_traffic(std::vector<traffic::Traffic> traffic) {
  for (std::size_t i = 0; i < networks_.size(); ++i) networks_[i].traffic = std::move(traffic[i]);
}

}  // namespace rubicon::site
