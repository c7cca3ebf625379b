#include "src/fleets/traffic/make_way.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <queue>
#include <utility>

namespace rubicon::traffic {

namespace {

/// So many arrangements of vehicles are looked at to bring one past the others.
constexpr int kMostArrangements = 20'000;

/// What a move costs, what each lane that is left to the goal counts for (more than a move: the
/// first way found is good enough), each lane to what another wants, and a place from which another
/// does not get on any more.
constexpr int kMove = 10;
constexpr int kLeft = 15;
constexpr int kLeftOfOthers = 1;
constexpr int kLost = 20;

/// How good a place is for who makes way.
enum Grade : std::uint8_t { kBackAndOn, kOn, kDeadEnd };

std::size_t slot(int index) { return static_cast<std::size_t>(index); }

/// How many lanes it is from each node to a node, or the other way, for a vehicle; -1: no way.
std::vector<int> lanes_between(const LaneNetwork& network, NodeIndex node, double width,
                               bool from_it) {
  std::vector<std::vector<NodeIndex>> next(slot(network.node_count()));
  for (LaneIndex i = 0; i < network.lane_count(); ++i) {
    if (network.class_of(i).width < width) continue;
    const lanes::Lane& lane = network.lane(i);
    next[slot(from_it ? lane.from : lane.to)].push_back(from_it ? lane.to : lane.from);
  }
  std::vector<int> count(next.size(), -1);
  std::vector<NodeIndex> open = {node};
  count[slot(node)] = 0;
  for (std::size_t i = 0; i < open.size(); ++i) {
    for (const NodeIndex each : next[slot(open[i])]) {
      if (count[slot(each)] >= 0) continue;
      count[slot(each)] = count[slot(open[i])] + 1;
      open.push_back(each);
    }
  }
  return count;
}

class Search {
 public:
  explicit Search(const MakeWayQuery& query) : query_(query) {
    for (const Mover& mover : query.movers) {
      left_.push_back(mover.wants == lanes::kNone ? std::vector<int>(query.taken.size(), 0)
                                                  : lanes_to(mover.wants, mover.width));
      grades_.push_back(left_.size() == 1 ? grades_of_first() : grades_of(mover));
    }
  }

  std::optional<std::vector<Move>> find() {
    const Mover& first = query_.movers.front();
    if (left_[0][slot(first.at)] < 0) return std::nullopt;
    for (const Grade worst : {kBackAndOn, kOn, kDeadEnd}) {
      if (worst != kBackAndOn && !has_[worst]) continue;
      if (auto moves = find(worst)) return moves;
    }
    return std::nullopt;
  }

 private:
  using Places = std::vector<NodeIndex>;
  struct Arrangement {
    Places places;
    int cost = 0;
    int before = -1;
    Move move;
  };

  std::vector<int> lanes_to(NodeIndex node, double width) const {
    return lanes_between(*query_.network, node, width, false);
  }

  std::vector<int> lanes_from(NodeIndex node, double width) const {
    return lanes_between(*query_.network, node, width, true);
  }

  /// Whether lanes lead from each node to each other: then no place is worse than another.
  bool leads_everywhere(double width) {
    const auto [known, is_new] = leads_everywhere_.emplace(width, true);
    if (!is_new) return known->second;
    const auto is_none = [](int lanes) { return lanes < 0; };
    for (const std::vector<int>& lanes : {lanes_from(0, width), lanes_to(0, width)}) {
      if (std::any_of(lanes.begin(), lanes.end(), is_none)) known->second = false;
    }
    return known->second;
  }

  /// The first goes its way, wherever it stands for a while.
  std::vector<Grade> grades_of_first() const {
    return std::vector<Grade>(query_.taken.size(), kBackAndOn);
  }

  /// Of each node where the mover may get.
  std::vector<Grade> grades_of(const Mover& mover) {
    std::vector<Grade> grades(query_.taken.size(), kBackAndOn);
    if (leads_everywhere(mover.width)) return grades;
    const std::vector<int> reached = lanes_from(mover.at, mover.width);
    const std::vector<int> back = lanes_to(mover.at, mover.width);
    std::vector<NodeIndex> ahead = mover.ahead;
    if (mover.wants != lanes::kNone) ahead.push_back(mover.wants);
    std::sort(ahead.begin(), ahead.end());
    ahead.erase(std::unique(ahead.begin(), ahead.end()), ahead.end());
    // Who can come back can get on from there.
    const auto is_one_way = [&](std::size_t node) { return reached[node] >= 0 && back[node] < 0; };
    bool any = false;
    for (std::size_t node = 0; node < grades.size(); ++node) {
      if (!is_one_way(node)) continue;
      grades[node] = kOn;
      any = true;
    }
    for (std::size_t i = 0; any && i < ahead.size(); ++i) {
      if (reached[slot(ahead[i])] < 0) continue;  // it does not get there as it is
      const std::vector<int> on = lanes_to(ahead[i], mover.width);
      for (std::size_t node = 0; node < grades.size(); ++node) {
        if (is_one_way(node) && on[node] < 0) grades[node] = kDeadEnd;
      }
    }
    for (const Grade grade : grades) has_[grade] = true;
    return grades;
  }

  int rank(const Arrangement& arrangement) const {
    int sum = arrangement.cost;
    for (std::size_t i = 0; i < arrangement.places.size(); ++i) {
      const std::size_t place = slot(arrangement.places[i]);
      sum += std::max(left_[i][place], 0) * (i == 0 ? kLeft : kLeftOfOthers);
      if (grades_[i][place] == kDeadEnd) sum += kLost;
    }
    return sum;
  }

  /// With no place that is worse.
  std::optional<std::vector<Move>> find(Grade worst) const {
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
    for (const Mover& mover : query_.movers) first.places.push_back(mover.at);
    reach(std::move(first));
    const LaneNetwork& network = *query_.network;
    for (int looked = 0; looked < kMostArrangements && !open.empty(); ++looked) {
      const int index = open.top().second;
      open.pop();
      const Arrangement here = all[slot(index)];
      if (best.at(here.places) < here.cost) continue;
      if (here.places[0] == query_.movers[0].wants) return moves_to(all, index);
      for (std::size_t i = 0; i < here.places.size(); ++i) {
        for (const LaneIndex lane : network.leaving(here.places[i])) {
          const NodeIndex to = network.lane(lane).to;
          if (query_.taken[slot(to)] || grades_[i][slot(to)] > worst) continue;
          if (i == 0 && left_[0][slot(to)] < 0) continue;
          if (network.class_of(lane).width < query_.movers[i].width) continue;
          if (std::find(here.places.begin(), here.places.end(), to) != here.places.end()) continue;
          Arrangement next = here;
          next.places[i] = to;
          next.cost += kMove;
          next.before = index;
          next.move = {static_cast<int>(i), lane, to};
          reach(std::move(next));
        }
      }
    }
    return std::nullopt;
  }

  static std::vector<Move> moves_to(const std::vector<Arrangement>& all, int found) {
    std::vector<Move> moves;
    for (int i = found; all[slot(i)].before >= 0; i = all[slot(i)].before) {
      moves.push_back(all[slot(i)].move);
    }
    std::reverse(moves.begin(), moves.end());
    return moves;
  }

  const MakeWayQuery& query_;
  std::vector<std::vector<int>> left_;       ///< by mover and node: lanes to what it wants
  std::vector<std::vector<Grade>> grades_;   ///< by mover and node
  std::map<double, bool> leads_everywhere_;  ///< by width
  bool has_[3] = {};                         ///< whether there are places of this grade
};

}  // namespace

std::optional<std::vector<Move>> make_way(const MakeWayQuery& query) {
  return Search(query).find();
}

}  // namespace rubicon::traffic
