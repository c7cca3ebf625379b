#include "src/fleets/traffic/traffic.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <stdexcept>
#include <string>
#include <utility>

#include "src/fleets/lanes/shortest_way.hpp"

namespace rubicon::traffic {

namespace {

/// So many arrangements of vehicles are looked at to bring one past the others.
constexpr int kMostArrangements = 20'000;

/// What a move costs, what each lane that is left to the goal counts for (more than a move: the
/// first way found is good enough), and each lane to what another wants.
constexpr int kMove = 10;
constexpr int kLeft = 15;
constexpr int kLeftOfOthers = 1;

}  // namespace

Traffic::Traffic(std::shared_ptr<const LaneNetwork> network, std::vector<Vehicle> vehicles)
    : network_(std::move(network)), vehicles_(std::move(vehicles)) {
  turns_.resize(at(network_->node_count()));
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    const Vehicle& vehicle = vehicles_[i];
    if (vehicle.start < 0 || vehicle.start >= network_->node_count()) {
      throw std::invalid_argument("vehicle " + std::to_string(i) + " begins at no node");
    }
    if (!(vehicle.speed > 0)) {
      throw std::invalid_argument("vehicle " + std::to_string(i) + " has no speed");
    }
    std::vector<Turn>& turns = turns_[at(vehicle.start)];
    if (!turns.empty()) {
      throw std::invalid_argument("two vehicles begin at " + network_->node(vehicle.start).name);
    }
    turns.push_back({static_cast<int>(i), 0});
    State state;
    state.stays.push_back({vehicle.start, lanes::kNone, 0, 0});
    states_.push_back(std::move(state));
  }
}

NodeIndex Traffic::next_of(int vehicle) const {
  const std::vector<Stay>& stays = states_[at(vehicle)].stays;
  return stays.size() > 1 ? stays[1].node : lanes::kNone;
}

NodeIndex Traffic::next_stop(int vehicle) const {
  const std::vector<Stay>& stays = states_[at(vehicle)].stays;
  if (stays.size() < 2) return lanes::kNone;
  const NodeIndex end = stays.back().node;
  return end == stays.front().node ? stays[stays.size() - 2].node : end;
}

const Traffic::Stay& Traffic::stay_of(const Turn& turn) const {
  const State& state = states_[at(turn.vehicle)];
  return state.stays[static_cast<std::size_t>(turn.number - state.first)];
}

/// When the node of the turn is free again: with the arrival at the node after.
Nanoseconds Traffic::leave_of(const Turn& turn) const {
  const State& state = states_[at(turn.vehicle)];
  const auto next = static_cast<std::size_t>(turn.number - state.first) + 1;
  return next < state.stays.size() ? state.stays[next].arrive : lanes::kEndOfTime;
}

/// Works out again when each stay begins: after the stay before it, and when all that are before it
/// at its node have gone. Each is looked at once, when what it waits for is known.
void Traffic::foresee(Nanoseconds now) {
  struct Place {
    int vehicle = -1;
    std::size_t stay = 0;
  };
  // By vehicle and stay: who waits for it to be known, and for how many it waits itself.
  std::vector<std::vector<int>> missing(states_.size());
  std::vector<std::vector<std::vector<Place>>> followers(states_.size());
  std::vector<Place> known;
  for (std::size_t v = 0; v < states_.size(); ++v) {
    missing[v].assign(states_[v].stays.size(), 1);
    followers[v].resize(states_[v].stays.size());
    missing[v][0] = 0;
    known.push_back({static_cast<int>(v), 0});
  }
  for (const std::vector<Turn>& turns : turns_) {
    for (std::size_t i = 1; i < turns.size(); ++i) {
      const Turn& before = turns[i - 1];
      const auto next =
          static_cast<std::size_t>(before.number - states_[at(before.vehicle)].first) + 1;
      const auto stay =
          static_cast<std::size_t>(turns[i].number - states_[at(turns[i].vehicle)].first);
      if (next >= states_[at(before.vehicle)].stays.size()) continue;
      // Of those one is the vehicle itself that comes back: it has left by then.
      followers[at(before.vehicle)][next].push_back({turns[i].vehicle, stay});
      ++missing[at(turns[i].vehicle)][stay];
    }
  }
  std::vector<std::vector<Nanoseconds>> free_from(states_.size());
  for (std::size_t v = 0; v < states_.size(); ++v) free_from[v].assign(states_[v].stays.size(), 0);
  const auto lower = [&](const Place& place) {
    if (--missing[at(place.vehicle)][place.stay] == 0) known.push_back(place);
  };
  for (std::size_t done = 0; done < known.size(); ++done) {
    const Place place = known[done];
    State& state = states_[at(place.vehicle)];
    Stay& stay = state.stays[place.stay];
    if (place.stay > 0) {
      const bool entered = place.stay == 1 && state.drives;
      const Nanoseconds takes = network_->time(stay.lane, vehicles_[at(place.vehicle)].speed);
      if (!entered) {
        stay.enter = std::max(
            {now, state.stays[place.stay - 1].arrive, free_from[at(place.vehicle)][place.stay]});
      }
      stay.arrive = std::max(now, stay.enter + takes);
    }
    for (const Place& follower : followers[at(place.vehicle)][place.stay]) {
      Nanoseconds& from = free_from[at(follower.vehicle)][follower.stay];
      from = std::max(from, stay.arrive);
      lower(follower);
    }
    if (place.stay + 1 < state.stays.size()) lower({place.vehicle, place.stay + 1});
  }
}

std::vector<TimedNode> Traffic::way_of(int vehicle, Nanoseconds now) {
  foresee(now);
  std::vector<TimedNode> way;
  for (const Stay& stay : states_[at(vehicle)].stays) {
    way.push_back({stay.node, stay.lane, stay.enter, stay.arrive});
  }
  return way;
}

/// All ways of a vehicle at the end of its way, between what others hold.
TimedWays Traffic::ways_from(int vehicle, Nanoseconds now) {
  foresee(now);
  std::vector<std::vector<Hold>> holds(turns_.size());
  for (std::size_t node = 0; node < turns_.size(); ++node) {
    for (const Turn& turn : turns_[node]) {
      if (turn.vehicle == vehicle) continue;
      const Stay& stay = stay_of(turn);
      const bool is_here = turn.number == states_[at(turn.vehicle)].first;
      holds[node].push_back({is_here ? 0 : stay.enter, leave_of(turn)});
    }
  }
  const State& state = states_[at(vehicle)];
  TimedWayQuery query;
  query.network = network_.get();
  query.from = state.stays.back().node;
  query.start = std::max(now, state.stays.back().arrive);
  query.speed = vehicles_[at(vehicle)].speed;
  query.width = vehicles_[at(vehicle)].width;
  query.holds = holds;
  return TimedWays(query);
}

/// Gives the vehicle a way, which begins where its own ends.
void Traffic::take(int vehicle, const std::vector<TimedNode>& way) {
  State& state = states_[at(vehicle)];
  for (std::size_t i = 1; i < way.size(); ++i) {
    const TimedNode& each = way[i];
    const Turn turn{vehicle, state.first + static_cast<std::int64_t>(state.stays.size())};
    std::vector<Turn>& turns = turns_[at(each.node)];
    const auto later = std::find_if(turns.begin(), turns.end(), [&](const Turn& other) {
      const bool is_here = other.number == states_[at(other.vehicle)].first;
      return !is_here && stay_of(other).enter > each.enter;
    });
    turns.insert(later, turn);
    state.stays.push_back({each.node, each.lane, each.enter, each.arrive});
  }
  state.wants = lanes::kNone;
  ++changes_;
}

/// Who stands in the way: the first on the best way of an empty network.
PlanResult Traffic::blocked(int vehicle, NodeIndex goal) const {
  PlanResult result;
  lanes::WayOptions options;
  options.vehicle_speed = vehicles_[at(vehicle)].speed;
  options.vehicle_width = vehicles_[at(vehicle)].width;
  const auto way = lanes::shortest_way(*network_, end_of(vehicle), goal, options);
  result.outcome = way ? PlanResult::Outcome::waits : PlanResult::Outcome::no_way;
  if (!way) return result;
  for (const NodeIndex node : way->nodes) {
    const std::vector<Turn>& turns = turns_[at(node)];
    if (turns.empty() || turns.back().vehicle == vehicle) continue;
    if (leave_of(turns.back()) < lanes::kEndOfTime) continue;
    result.wait = {turns.back().vehicle, node};
    break;
  }
  return result;
}

/// How many lanes it is from each node to the goal for a vehicle; -1: no way.
std::vector<int> Traffic::lanes_to(NodeIndex goal, double width) const {
  std::vector<std::vector<NodeIndex>> before(turns_.size());
  for (LaneIndex lane = 0; lane < network_->lane_count(); ++lane) {
    if (network_->class_of(lane).width < width) continue;
    before[at(network_->lane(lane).to)].push_back(network_->lane(lane).from);
  }
  std::vector<int> left(turns_.size(), -1);
  std::vector<NodeIndex> open = {goal};
  left[at(goal)] = 0;
  for (std::size_t i = 0; i < open.size(); ++i) {
    for (const NodeIndex node : before[at(open[i])]) {
      if (left[at(node)] >= 0) continue;
      left[at(node)] = left[at(open[i])] + 1;
      open.push_back(node);
    }
  }
  return left;
}

bool Traffic::untangle(int vehicle, const std::vector<bool>& movable, Nanoseconds now) {
  const NodeIndex goal = states_[at(vehicle)].wants;
  if (goal == lanes::kNone || states_[at(vehicle)].stays.size() > 1) return false;
  // The vehicle first, then those who may be moved; all that others hold is taken.
  std::vector<int> who = {vehicle};
  for (int other = 0; other < vehicles(); ++other) {
    if (other != vehicle && movable[at(other)] && states_[at(other)].stays.size() == 1) {
      who.push_back(other);
    }
  }
  std::vector<bool> taken(turns_.size(), false);
  for (std::size_t node = 0; node < turns_.size(); ++node) {
    for (const Turn& turn : turns_[node]) {
      const bool may_leave = std::find(who.begin(), who.end(), turn.vehicle) != who.end();
      if (!may_leave) taken[node] = true;
    }
  }
  std::vector<std::vector<int>> left;
  for (const int each : who) {
    const NodeIndex wanted = states_[at(each)].wants;
    left.push_back(wanted == lanes::kNone ? std::vector<int>(turns_.size(), 0)
                                          : lanes_to(wanted, vehicles_[at(each)].width));
  }
  using Places = std::vector<NodeIndex>;
  struct Arrangement {
    Places places;
    int cost = 0;
    int before = -1;
    int moved = -1;  // index into `who`
    LaneIndex lane = lanes::kNone;
  };
  const auto rank = [&](const Arrangement& each) {
    int sum = each.cost;
    for (std::size_t i = 0; i < who.size(); ++i) {
      const int lanes_left = left[i][at(each.places[i])];
      sum += std::max(lanes_left, 0) * (i == 0 ? kLeft : kLeftOfOthers);
    }
    return sum;
  };
  std::vector<Arrangement> all;
  std::map<Places, int> best;         // the least cost at which each was reached
  using Entry = std::pair<int, int>;  // rank, index
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto reach = [&](Arrangement arrangement) {
    const auto [place, is_new] = best.emplace(arrangement.places, arrangement.cost);
    if (!is_new && place->second <= arrangement.cost) return;
    place->second = arrangement.cost;
    open.emplace(rank(arrangement), static_cast<int>(all.size()));
    all.push_back(std::move(arrangement));
  };
  Arrangement first;
  for (const int each : who) first.places.push_back(node_of(each));
  if (left[0][at(first.places[0])] < 0) return false;
  reach(std::move(first));
  int found = -1;
  for (int looked = 0; looked < kMostArrangements && !open.empty() && found < 0; ++looked) {
    const int index = open.top().second;
    open.pop();
    const Arrangement here = all[static_cast<std::size_t>(index)];
    if (best.at(here.places) < here.cost) continue;
    if (here.places[0] == goal) {
      found = index;
      break;
    }
    for (std::size_t i = 0; i < who.size(); ++i) {
      for (const LaneIndex lane : network_->leaving(here.places[i])) {
        const NodeIndex to = network_->lane(lane).to;
        if (taken[at(to)] || network_->class_of(lane).width < vehicles_[at(who[i])].width) continue;
        if (std::find(here.places.begin(), here.places.end(), to) != here.places.end()) continue;
        Arrangement next = here;
        next.places[i] = to;
        next.cost += kMove;
        next.before = index;
        next.moved = static_cast<int>(i);
        next.lane = lane;
        reach(std::move(next));
      }
    }
  }
  if (found < 0) return false;
  std::vector<const Arrangement*> moves;
  for (int i = found; all[static_cast<std::size_t>(i)].before >= 0;
       i = all[static_cast<std::size_t>(i)].before) {
    moves.push_back(&all[static_cast<std::size_t>(i)]);
  }
  std::reverse(moves.begin(), moves.end());
  // One after the other: so all have their turns at the nodes in the order of the moves.
  for (const Arrangement* const move : moves) {
    const int mover = who[at(move->moved)];
    State& state = states_[at(mover)];
    const NodeIndex to = move->places[at(move->moved)];
    turns_[at(to)].push_back({mover, state.first + static_cast<std::int64_t>(state.stays.size())});
    state.stays.push_back({to, move->lane, 0, 0});
  }
  states_[at(vehicle)].wants = lanes::kNone;
  foresee(now);
  ++changes_;
  return true;
}

PlanResult Traffic::plan(int vehicle, NodeIndex goal, Nanoseconds now) {
  PlanResult result;
  if (next_of(vehicle) != lanes::kNone || node_of(vehicle) == goal) return result;
  if (auto way = ways_from(vehicle, now).to(goal)) {
    take(vehicle, *way);
    return result;
  }
  result = blocked(vehicle, goal);
  if (result.outcome == PlanResult::Outcome::waits) states_[at(vehicle)].wants = goal;
  return result;
}

std::optional<Wait> Traffic::enter_next(int vehicle, Nanoseconds now) {
  State& state = states_[at(vehicle)];
  if (state.drives || state.stays.size() < 2) return std::nullopt;
  Stay& next = state.stays[1];
  const Turn& first = turns_[at(next.node)].front();
  if (first.vehicle != vehicle || first.number != state.first + 1) {
    return Wait{first.vehicle, next.node};
  }
  state.drives = true;
  next.enter = now;
  return std::nullopt;
}

void Traffic::arrived(int vehicle, Nanoseconds now) {
  State& state = states_[at(vehicle)];
  if (!state.drives) return;
  std::vector<Turn>& turns = turns_[at(state.stays[0].node)];
  turns.erase(turns.begin());
  state.stays.erase(state.stays.begin());
  ++state.first;
  state.drives = false;
  state.stays[0].arrive = now;
  ++changes_;
}

}  // namespace rubicon::traffic
