#include "src/fleets/traffic/traffic.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "src/fleets/lanes/shortest_way.hpp"

namespace rubicon::traffic {

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

/// Who stands for good on the best way of an empty network, in the order of the way; nothing where
/// no way leads.
std::optional<std::vector<Wait>> Traffic::standing_before(int vehicle, NodeIndex goal) const {
  lanes::WayOptions options;
  options.vehicle_speed = vehicles_[at(vehicle)].speed;
  options.vehicle_width = vehicles_[at(vehicle)].width;
  const auto way = lanes::shortest_way(*network_, end_of(vehicle), goal, options);
  if (!way) return std::nullopt;
  std::vector<Wait> all;
  for (const NodeIndex node : way->nodes) {
    const std::vector<Turn>& turns = turns_[at(node)];
    if (turns.empty() || turns.back().vehicle == vehicle) continue;
    if (leave_of(turns.back()) < lanes::kEndOfTime) continue;
    all.push_back({turns.back().vehicle, node});
  }
  return all;
}

PlanResult Traffic::blocked(int vehicle, NodeIndex goal) const {
  PlanResult result;
  const auto standing = standing_before(vehicle, goal);
  result.outcome = standing ? PlanResult::Outcome::waits : PlanResult::Outcome::no_way;
  if (standing && !standing->empty()) result.wait = standing->front();
  return result;
}

/// The vehicle first, then those who may be moved; all that others hold is taken.
std::vector<int> Traffic::movers_for(int vehicle, const std::vector<bool>& movable) const {
  std::vector<int> who = {vehicle};
  for (int other = 0; other < vehicles(); ++other) {
    if (other != vehicle && movable[at(other)] && states_[at(other)].stays.size() == 1) {
      who.push_back(other);
    }
  }
  return who;
}

/// `left_out`: a vehicle as if it were not there; -1: none.
MakeWayQuery Traffic::way_made_by(const std::vector<int>& who, const Ahead& ahead,
                                  int left_out) const {
  MakeWayQuery query;
  query.network = network_.get();
  for (const int each : who) {
    query.movers.push_back({node_of(each), vehicles_[at(each)].width, wants(each), {}});
    if (!ahead.empty()) query.movers.back().ahead = ahead[at(each)];
  }
  query.taken.resize(turns_.size(), false);
  for (std::size_t node = 0; node < turns_.size(); ++node) {
    for (const Turn& turn : turns_[node]) {
      const bool may_leave =
          turn.vehicle == left_out || std::find(who.begin(), who.end(), turn.vehicle) != who.end();
      if (!may_leave) query.taken[node] = true;
    }
  }
  return query;
}

bool Traffic::untangle(int vehicle, const std::vector<bool>& movable, const Ahead& ahead,
                       Nanoseconds now) {
  if (wants(vehicle) == lanes::kNone || states_[at(vehicle)].stays.size() > 1) return false;
  const std::vector<int> who = movers_for(vehicle, movable);
  const auto moves = make_way(way_made_by(who, ahead, -1));
  if (!moves) return false;
  // One after the other: so all have their turns at the nodes in the order of the moves.
  for (const Move& move : *moves) {
    const int mover = who[at(move.mover)];
    State& state = states_[at(mover)];
    turns_[at(move.to)].push_back(
        {mover, state.first + static_cast<std::int64_t>(state.stays.size())});
    state.stays.push_back({move.to, move.lane, 0, 0});
  }
  states_[at(vehicle)].wants = lanes::kNone;
  foresee(now);
  ++changes_;
  return true;
}

std::optional<Wait> Traffic::who_bars(int vehicle, const std::vector<bool>& movable) const {
  const NodeIndex goal = wants(vehicle);
  if (goal == lanes::kNone || states_[at(vehicle)].stays.size() > 1) return std::nullopt;
  const auto standing = standing_before(vehicle, goal);
  if (!standing || standing->empty()) return std::nullopt;
  for (std::size_t i = 0; standing->size() > 1 && i < standing->size(); ++i) {
    const Wait& each = (*standing)[i];
    std::vector<bool> others = movable;
    others[at(each.vehicle)] = false;
    if (make_way(way_made_by(movers_for(vehicle, others), {}, each.vehicle))) return each;
  }
  return standing->front();
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
