#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <tuple>

#include "src/motion/guides/least_distance.hpp"
#include "src/motion/guides/planners.hpp"
#include "src/motion/guides/roadmap.hpp"

namespace rubicon::guides {

namespace {

/// Start and goal are joined to so many times as many configurations as those are to each other:
/// machines begin and end close to things, where most legs are refused.
constexpr std::size_t kMoreAtEnds = 4;

/// The same for a vehicle that steers: ways are looked for only where the straight line leaves room
/// for one that counts.
std::vector<int> nearest_by_ways(const Space& space, const std::vector<Point>& points,
                                 const Point& to, std::size_t count, int except) {
  std::vector<std::pair<double, int>> straight;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    if (i == except) continue;
    straight.emplace_back(least_distance(space, points[static_cast<std::size_t>(i)], to), i);
  }
  std::sort(straight.begin(), straight.end());
  std::set<std::pair<double, int>> best;
  for (const auto& [least, i] : straight) {
    if (best.size() >= count && (count == 0 || least > best.rbegin()->first)) break;
    best.emplace(space.distance(points[static_cast<std::size_t>(i)], to), i);
    if (best.size() > count) best.erase(std::prev(best.end()));
  }
  std::vector<int> numbers;
  for (const auto& [distance, i] : best) numbers.push_back(i);
  return numbers;
}

/// The `count` points nearest to one, of equals the first; without number `except`.
std::vector<int> nearest_to(const Space& space, const std::vector<Point>& points, const Point& to,
                            std::size_t count, int except) {
  if (space.leg().steers()) return nearest_by_ways(space, points, to, count, except);
  std::vector<std::pair<double, int>> all;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    if (i != except) all.emplace_back(space.distance(points[static_cast<std::size_t>(i)], to), i);
  }
  count = std::min(count, all.size());
  std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count), all.end());
  std::vector<int> numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(all[i].second);
  return numbers;
}

/// Looks for the shortest way over the roadmap, taking for free what was not tested; tests what
/// that way needs; and looks again without what was in the way (Lazy PRM: Bohlin, Kavraki, ICRA
/// 2000).
class RoadmapSearch {
 public:
  RoadmapSearch(Space& space, const Point& start, const Point& goal, RoadmapMemory& memory)
      : space_(space),
        start_(start),
        goal_(goal),
        memory_(memory),
        roadmap_(*memory.roadmap),
        start_number_(static_cast<int>(roadmap_.points.size())),
        goal_number_(start_number_ + 1) {
    const std::size_t count = kMoreAtEnds * static_cast<std::size_t>(space.spec().nearest);
    from_start_ = nearest_to(space, roadmap_.points, start, count, -1);
    from_start_.push_back(goal_number_);
    at_goal_.resize(roadmap_.points.size(), false);
    for (const int i : nearest_to(space, roadmap_.points, goal, count, -1)) {
      at_goal_[static_cast<std::size_t>(i)] = true;
    }
  }

  std::vector<Point> run() {
    std::vector<int> way = untested_way();
    while (!way.empty() && !is_free(way)) {
      if (space_.spent()) return {};
      way = untested_way();
    }
    std::vector<Point> points;
    for (const int i : way) points.push_back(point(i));
    return points;
  }

 private:
  const Point& point(int i) const {
    if (i == start_number_) return start_;
    return i == goal_number_ ? goal_ : roadmap_.points[static_cast<std::size_t>(i)];
  }

  template <typename Visit>
  void for_each_next(int i, const Visit& visit) const {
    if (i == start_number_) {
      for (const int next : from_start_) visit(next);
      return;
    }
    for (const int next : roadmap_.next_to[static_cast<std::size_t>(i)]) visit(next);
    if (at_goal_[static_cast<std::size_t>(i)]) visit(goal_number_);
  }

  /// Legs from the start and to the goal are those of this search alone.
  std::set<std::pair<int, int>>& blocked_with(int from, int to) {
    return from >= start_number_ || to >= start_number_ ? blocked_ : memory_.blocked_legs;
  }

  bool may_pass(int from, int to) {
    if (memory_.blocked_points.count(to) != 0) return false;
    return blocked_with(from, to).count({from, to}) == 0;
  }

  /// Ways of a vehicle that steers take long to find: each is looked for once.
  double length_of(int from, int to) {
    if (!space_.leg().steers()) return space_.distance(point(from), point(to));
    const auto [place, is_new] = lengths_.try_emplace({from, to}, 0);
    if (is_new) place->second = space_.distance(point(from), point(to));
    return place->second;
  }

  /// By A*, with the straight distance to the goal; empty: there is none.
  std::vector<int> untested_way() {
    const auto count = static_cast<std::size_t>(goal_number_) + 1;
    std::vector<double> length(count, std::numeric_limits<double>::infinity());
    std::vector<int> before(count, -1);
    std::vector<bool> done(count, false);
    using Entry = std::tuple<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    length[static_cast<std::size_t>(start_number_)] = 0;
    queue.emplace(length_of(start_number_, goal_number_), start_number_);
    while (!queue.empty()) {
      const int here = std::get<1>(queue.top());
      queue.pop();
      if (here == goal_number_) break;
      if (done[static_cast<std::size_t>(here)]) continue;
      done[static_cast<std::size_t>(here)] = true;
      for_each_next(here, [&](int next) {
        const auto index = static_cast<std::size_t>(next);
        if (done[index] || !may_pass(here, next)) return;
        const double there = length[static_cast<std::size_t>(here)] + length_of(here, next);
        if (there >= length[index]) return;
        length[index] = there;
        before[index] = here;
        queue.emplace(there + length_of(next, goal_number_), next);
      });
    }
    if (before[static_cast<std::size_t>(goal_number_)] < 0) return {};
    std::vector<int> way;
    for (int i = goal_number_; i >= 0; i = before[static_cast<std::size_t>(i)]) way.push_back(i);
    return {way.rbegin(), way.rend()};
  }

  /// Tests what was not tested yet of a way: its points first, since that is soon done.
  bool is_free(const std::vector<int>& way) {
    for (const int i : way) {
      if (i >= start_number_ || free_points_.count(i) != 0) continue;
      if (space_.spent()) return false;
      if (!space_.stands(point(i))) {
        memory_.blocked_points.insert(i);
        return false;
      }
      free_points_.insert(i);
    }
    for (std::size_t k = 0; k + 1 < way.size(); ++k) {
      const std::pair<int, int> leg{way[k], way[k + 1]};
      if (free_legs_.count(leg) != 0) continue;
      if (space_.spent()) return false;
      if (!space_.leg_is_free(point(leg.first), point(leg.second))) {
        blocked_with(leg.first, leg.second).insert(leg);
        return false;
      }
      free_legs_.insert(leg);
    }
    return true;
  }

  Space& space_;
  const Point& start_;
  const Point& goal_;
  RoadmapMemory& memory_;
  const Roadmap& roadmap_;
  const int start_number_;
  const int goal_number_;
  std::vector<int> from_start_;
  std::vector<bool> at_goal_;
  std::set<std::pair<int, int>> blocked_;
  std::set<int> free_points_;
  std::set<std::pair<int, int>> free_legs_;
  std::map<std::pair<int, int>, double> lengths_;
};

}  // namespace

Roadmap make_roadmap(const Space& space) {
  Roadmap roadmap;
  Random random(static_cast<std::uint64_t>(space.spec().seed));
  const auto count = static_cast<std::size_t>(space.spec().nodes);
  for (std::size_t i = 0; i < count; ++i) roadmap.points.push_back(space.sample(random));
  roadmap.next_to.resize(count);
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const Point& here = roadmap.points[static_cast<std::size_t>(i)];
    const auto nearest = static_cast<std::size_t>(space.spec().nearest);
    for (const int other : nearest_to(space, roadmap.points, here, nearest, i)) {
      roadmap.next_to[static_cast<std::size_t>(i)].push_back(other);
      roadmap.next_to[static_cast<std::size_t>(other)].push_back(i);
    }
  }
  for (std::vector<int>& each : roadmap.next_to) {
    std::sort(each.begin(), each.end());
    each.erase(std::unique(each.begin(), each.end()), each.end());
  }
  return roadmap;
}

Search search_roadmap(Space& space, const Point& start, const Point& goal, RoadmapMemory& memory) {
  if (!memory.roadmap) memory.roadmap = std::make_shared<const Roadmap>(make_roadmap(space));
  Search search;
  search.nodes = memory.roadmap->points.size();
  const bool remembers = !memory.blocked_points.empty() || !memory.blocked_legs.empty();
  search.way = RoadmapSearch(space, start, goal, memory).run();
  if (search.way.empty() && remembers && !space.spent()) {
    // What was in the way may be gone.
    memory.blocked_points.clear();
    memory.blocked_legs.clear();
    search.way = RoadmapSearch(space, start, goal, memory).run();
  }
  search.out_of_nodes = !space.spent();
  return search;
}

}  // namespace rubicon::guides
