#include "src/results/flow/lane_flow.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "src/motion/math/index.hpp"

namespace rubicon::flow {

namespace {

using math::at;

/// Where a vehicle is in the plan view: the parameters x and y of the body that drives.
class Place {
 public:
  explicit Place(const robot::RobotModel& model) {
    for (std::size_t i = 0; i < model.parameters.size() && y_ < 0; ++i) {
      if (model.parameters[i].name != "x") continue;
      for (std::size_t k = 0; k < model.parameters.size(); ++k) {
        if (model.parameters[k].name != "y") continue;
        if (model.parameters[k].body != model.parameters[i].body) continue;
        x_ = static_cast<int>(i);
        y_ = static_cast<int>(k);
      }
    }
  }
  bool is_known() const { return y_ >= 0; }
  std::pair<double, double> of(const std::vector<double>& q) const {
    return {q[at(x_)], q[at(y_)]};
  }

 private:
  int x_ = -1, y_ = -1;
};

double distance_between(std::pair<double, double> a, std::pair<double, double> b) {
  const double x = a.first - b.first;
  const double y = a.second - b.second;
  return std::sqrt(x * x + y * y);
}

/// Where a robot is at a moment; its values there.
const std::vector<double>* values_at(const replay::RobotTrack& track, Ticks time) {
  const auto found = std::partition_point(track.legs.begin(), track.legs.end(),
                                          [&](const replay::Leg& leg) { return leg.to <= time; });
  if (found != track.legs.end()) return &found->q0;
  if (track.legs.empty()) return nullptr;
  return track.legs.back().moves() ? &track.legs.back().q1 : &track.legs.back().q0;
}

/// From when to when, and where.
struct Standing {
  Ticks from = 0;
  Ticks to = 0;
  std::size_t node = 0;
};

std::vector<QueueLength> lengths_of(const std::vector<Standing>& all) {
  std::map<Ticks, int> changes = {{0, 0}};
  for (const Standing& each : all) {
    ++changes[each.from];
    --changes[each.to];
  }
  std::vector<QueueLength> lengths;
  int count = 0;
  for (const auto& [time, change] : changes) {
    count += change;
    if (lengths.empty() || lengths.back().count != count) lengths.push_back({time, count});
  }
  return lengths;
}

class LaneReader {
 public:
  explicit LaneReader(const replay::Replay& replay) : replay_(replay) {}

  LaneFlow run() {
    for (const trace::HeaderFleet& fleet : replay_.header.fleets) {
      const auto network = std::find_if(
          replay_.header.networks.begin(), replay_.header.networks.end(),
          [&](const trace::HeaderNetwork& each) { return each.name == fleet.network; });
      if (network == replay_.header.networks.end() || network->nodes.empty()) continue;
      for (const std::string& robot : fleet.robots) add_vehicle(fleet.name, robot, *network);
    }
    for (const trace::HeaderNetwork& network : replay_.header.networks) {
      const auto found = standing_.find(network.name);
      if (found != standing_.end()) add_network(network, found->second);
    }
    std::stable_sort(flow_.nodes.begin(), flow_.nodes.end(),
                     [](const NodeWaits& a, const NodeWaits& b) { return a.waited > b.waited; });
    return std::move(flow_);
  }

 private:
  void add_vehicle(const std::string& fleet, const std::string& name,
                   const trace::HeaderNetwork& network) {
    const auto machine =
        std::find_if(replay_.machines.begin(), replay_.machines.end(),
                     [&](const replay::Machine& each) { return each.name == name; });
    if (machine == replay_.machines.end()) return;
    const Place place(machine->model);
    const auto robot = static_cast<int>(machine - replay_.machines.begin());
    const replay::RobotTrack& track = replay_.tracks[at(robot)];
    std::vector<Standing>& standing = standing_[network.name];
    VehicleFlow vehicle;
    vehicle.fleet = fleet;
    vehicle.name = name;
    for (const replay::Leg& leg : track.legs) {
      if (!leg.moves()) continue;
      vehicle.moving += leg.to - leg.from;
      if (place.is_known())
        vehicle.distance += distance_between(place.of(leg.q0), place.of(leg.q1));
    }
    for (const replay::TaskRun& run : replay_.runs) {
      if (run.robot != robot || !run.happened) continue;
      ++vehicle.tasks;
      vehicle.held += run.end - run.start;
      for (const replay::MachineWait& wait : run.waits) {
        ++vehicle.waits;
        vehicle.waited += wait.to - wait.from;
        const std::vector<double>* const q = values_at(track, wait.from);
        if (q == nullptr || !place.is_known()) continue;
        standing.push_back({wait.from, wait.to, nearest(network, place.of(*q))});
      }
    }
    flow_.vehicles.push_back(std::move(vehicle));
  }

  static std::size_t nearest(const trace::HeaderNetwork& network, std::pair<double, double> place) {
    std::size_t best = 0;
    std::optional<double> least;
    for (std::size_t i = 0; i < network.nodes.size(); ++i) {
      const auto& origin = network.nodes[i].X_WN.translation();
      const double distance = distance_between({origin.x(), origin.y()}, place);
      if (least && distance >= *least) continue;
      least = distance;
      best = i;
    }
    return best;
  }

  void add_network(const trace::HeaderNetwork& network, const std::vector<Standing>& standing) {
    flow_.queues.push_back({network.name, lengths_of(standing)});
    std::map<std::size_t, std::vector<Standing>> by_node;
    for (const Standing& each : standing) by_node[each.node].push_back(each);
    for (const auto& [node, all] : by_node) {
      NodeWaits waits;
      waits.network = network.name;
      waits.node = network.nodes[node].name;
      waits.waits = static_cast<int>(all.size());
      for (const Standing& each : all) {
        waits.waited += each.to - each.from;
        waits.longest = std::max(waits.longest, each.to - each.from);
      }
      for (const QueueLength& length : lengths_of(all)) {
        waits.most = std::max(waits.most, length.count);
      }
      flow_.nodes.push_back(std::move(waits));
    }
  }

  const replay::Replay& replay_;
  std::map<std::string, std::vector<Standing>> standing_;
  LaneFlow flow_;
};

}  // namespace

LaneFlow lane_flow(const replay::Replay& replay) { return LaneReader(replay).run(); }

}  // namespace rubicon::flow
