#include "tests/unit/traffic/roadmaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "tests/unit/lanes/lane_fixtures.hpp"

namespace rubicon::traffic {

namespace {

using lanes::kSecond;
using lanes::TestRandom;

std::size_t as_index(int value) { return static_cast<std::size_t>(value); }

}  // namespace

LaneNetwork roadmap(const RoadmapQuery& query) {
  TestRandom random(query.seed);
  lanes::NetworkDescription description;
  description.classes.push_back({"road", 100, 4, 1});
  constexpr int kParts = 1'000'000;
  for (int tries = 0; static_cast<int>(description.nodes.size()) < query.nodes; ++tries) {
    if (tries > 1000 * query.nodes) throw std::invalid_argument("test: the yard is too small");
    const double x = query.side * random.whole(0, kParts) / kParts;
    const double y = query.side * random.whole(0, kParts) / kParts;
    const auto near = [&](const lanes::Node& other) {
      return std::hypot(other.x - x, other.y - y) < query.spacing;
    };
    if (std::any_of(description.nodes.begin(), description.nodes.end(), near)) continue;
    description.nodes.push_back({"n" + std::to_string(description.nodes.size()), x, y, 0, true});
  }
  struct Pair {
    double length = 0;
    int a = 0, b = 0;
    bool is_joined = false;
  };
  std::vector<Pair> pairs;
  for (int a = 0; a < query.nodes; ++a) {
    for (int b = a + 1; b < query.nodes; ++b) {
      const lanes::Node& from = description.nodes[as_index(a)];
      const lanes::Node& to = description.nodes[as_index(b)];
      pairs.push_back({std::hypot(from.x - to.x, from.y - to.y), a, b, false});
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.length, a.a, a.b) < std::tie(b.length, b.a, b.b);
  });
  std::vector<std::vector<std::size_t>> nearest(as_index(query.nodes));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    nearest[as_index(pairs[i].a)].push_back(i);
    nearest[as_index(pairs[i].b)].push_back(i);
  }
  std::vector<int> joined(as_index(query.nodes), 0);
  int left = query.edges;
  const auto join = [&](Pair& pair) {
    pair.is_joined = true;
    ++joined[as_index(pair.a)];
    ++joined[as_index(pair.b)];
    --left;
    description.lanes.push_back({pair.a, pair.b, 0, std::nullopt, lanes::kNone});
    description.lanes.push_back({pair.b, pair.a, 0, std::nullopt, lanes::kNone});
  };
  // Kruskal: the tree of the shortest lines first.
  std::vector<int> part(as_index(query.nodes));
  std::iota(part.begin(), part.end(), 0);
  const auto root = [&](int node) {
    while (part[as_index(node)] != node) node = part[as_index(node)];
    return node;
  };
  for (Pair& pair : pairs) {
    const int a = root(pair.a);
    const int b = root(pair.b);
    if (a == b) continue;
    part[as_index(a)] = b;
    join(pair);
  }
  // Then whoever has the fewest neighbours gets the nearest that it has not.
  while (left > 0) {
    const auto fewest = std::min_element(joined.begin(), joined.end()) - joined.begin();
    const auto& candidates = nearest[static_cast<std::size_t>(fewest)];
    const auto next = std::find_if(candidates.begin(), candidates.end(),
                                   [&](std::size_t i) { return !pairs[i].is_joined; });
    join(pairs[*next]);
  }
  return LaneNetwork(std::move(description));
}

std::vector<Trip> random_trips(const LaneNetwork& network, int count, std::uint64_t seed) {
  TestRandom random(seed);
  const auto shuffled = [&] {
    std::vector<NodeIndex> all;
    for (NodeIndex node = 0; node < network.node_count(); ++node) {
      all.insert(all.begin() + random.whole(0, node), node);
    }
    return all;
  };
  const std::vector<NodeIndex> starts = shuffled();
  const std::vector<NodeIndex> goals = shuffled();
  const double speeds[] = {1.2, 2, 3};
  std::vector<Trip> trips;
  for (int i = 0; i < count; ++i) {
    trips.push_back({starts[as_index(i)], goals[as_index(i)], speeds[i % 3]});
  }
  return trips;
}

std::vector<TimedPlace> track_of(const LaneNetwork& network, const std::vector<TimedNode>& way) {
  std::vector<TimedPlace> track;
  const auto add = [&](Nanoseconds time, NodeIndex node) {
    track.push_back({static_cast<double>(time) * 1e-9, network.node(node).x, network.node(node).y});
  };
  for (std::size_t k = 0; k < way.size(); ++k) {
    if (k > 0) add(way[k].enter, way[k - 1].node);
    add(way[k].arrive, way[k].node);
  }
  return track;
}

double least_distance(const std::vector<TimedPlace>& a, const std::vector<TimedPlace>& b) {
  std::vector<double> times;
  for (const TimedPlace& each : a) times.push_back(each.t);
  for (const TimedPlace& each : b) times.push_back(each.t);
  std::sort(times.begin(), times.end());
  const auto place = [](const std::vector<TimedPlace>& track, double t) {
    const auto next =
        std::upper_bound(track.begin(), track.end(), t,
                         [](double time, const TimedPlace& each) { return time < each.t; });
    if (next == track.begin()) return *next;
    const TimedPlace& from = *(next - 1);
    if (next == track.end()) return from;
    const double part = (t - from.t) / (next->t - from.t);
    return TimedPlace{t, from.x + part * (next->x - from.x), from.y + part * (next->y - from.y)};
  };
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < times.size(); ++i) {
    const TimedPlace a0 = place(a, times[i]);
    const TimedPlace b0 = place(b, times[i]);
    least = std::min(least, std::hypot(a0.x - b0.x, a0.y - b0.y));
    if (i + 1 == times.size()) break;
    // Both go straight until then: the difference does too.
    const TimedPlace a1 = place(a, times[i + 1]);
    const TimedPlace b1 = place(b, times[i + 1]);
    const double dx = a0.x - b0.x, dy = a0.y - b0.y;
    const double ex = a1.x - b1.x - dx, ey = a1.y - b1.y - dy;
    const double square = ex * ex + ey * ey;
    if (square == 0) continue;
    const double t = std::clamp(-(dx * ex + dy * ey) / square, 0.0, 1.0);
    least = std::min(least, std::hypot(dx + t * ex, dy + t * ey));
  }
  return least;
}

std::vector<std::vector<TimedNode>> driven_late(const LaneNetwork& network,
                                                const std::vector<Trip>& trips,
                                                const std::vector<Precedence>& order,
                                                const std::vector<std::vector<TimedNode>>& ways,
                                                int most_late, std::uint64_t seed) {
  TestRandom random(seed);
  std::vector<std::vector<TimedNode>> driven;
  for (const auto& way : ways) driven.push_back({{way.front().node, lanes::kNone, 0, 0}});
  std::vector<std::vector<std::vector<Precedence>>> before(ways.size());
  for (std::size_t i = 0; i < ways.size(); ++i) before[i].resize(ways[i].size());
  for (const Precedence& each : order) {
    before[as_index(each.later)][as_index(each.departs)].push_back(each);
  }
  for (bool went = true; went;) {
    went = false;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      std::vector<TimedNode>& own = driven[i];
      const std::size_t k = own.size();
      if (k == ways[i].size()) continue;
      Nanoseconds start = own.back().arrive;
      bool is_free = true;
      for (const Precedence& each : before[i][k]) {
        const auto& first = driven[as_index(each.first)];
        is_free = is_free && as_index(each.arrives) < first.size();
        if (is_free) start = std::max(start, first[as_index(each.arrives)].arrive);
      }
      if (!is_free) continue;
      const LaneIndex lane = ways[i][k].lane;
      const Nanoseconds takes =
          network.time(lane, trips[i].speed) + random.whole(0, most_late * 1000) * (kSecond / 1000);
      own.push_back({ways[i][k].node, lane, start, start + takes});
      went = true;
    }
  }
  return driven;
}

}  // namespace rubicon::traffic
