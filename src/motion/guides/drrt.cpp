#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "src/motion/guides/least_distance.hpp"
#include "src/motion/guides/planners.hpp"

namespace rubicon::guides {

namespace {

/// Nodes that the start is joined to at most, the nearest first, before the tree grows.
constexpr std::size_t kMostJoined = 10;

/// Dynamic RRT (Ferguson, Kalra, Stentz, ICRA 2006): the tree grows from the goal, so that it stays
/// as it is while the robot goes on. What of it is no longer free is found where a way needs it.
class DynamicTree {
 public:
  DynamicTree(Space& space, const Point& start, const Point& goal, GoalTree tree)
      : space_(space),
        spec_(space.spec()),
        random_(static_cast<std::uint64_t>(spec_.seed)),
        start_(start),
        tree_(std::move(tree)) {
    if (!tree_.points.empty() && tree_.points.front() == goal) return;
    tree_ = {{goal}, {-1}};
  }

  Search run() {
    Search search;
    search.way = find();
    search.nodes = tree_.points.size();
    search.out_of_nodes = search.way.empty() && !space_.spent();
    return search;
  }

  GoalTree take() { return std::move(tree_); }

 private:
  bool full() const { return static_cast<double>(tree_.points.size()) >= spec_.nodes; }
  const Point& point(int node) const { return tree_.points[static_cast<std::size_t>(node)]; }
  int parent(int node) const { return tree_.parents[static_cast<std::size_t>(node)]; }

  std::vector<Point> find() {
    for (int joined = join(); joined >= 0; joined = join()) {
      if (is_free_to_goal(joined)) return way_from(joined);
    }
    while (!full() && !space_.spent()) {
      const int added = grow();
      if (added < 0 || space_.distance(start_, point(added)) > spec_.step) continue;
      if (!space_.leg_is_free(start_, point(added))) continue;
      if (is_free_to_goal(added)) return way_from(added);
    }
    return {};
  }

  /// A node within a step of the start that a free leg leads to; -1: there is none.
  int join() {
    std::vector<std::pair<double, int>> near;
    for (int i = 0; i < static_cast<int>(tree_.points.size()); ++i) {
      if (space_.leg().steers() && least_distance(space_, start_, point(i)) > spec_.step) continue;
      const double distance = space_.distance(start_, point(i));
      if (distance <= spec_.step) near.emplace_back(distance, i);
    }
    const std::size_t count = std::min(kMostJoined, near.size());
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
    for (std::size_t i = 0; i < count && !space_.spent(); ++i) {
      if (space_.leg_is_free(start_, point(near[i].second))) return near[i].second;
    }
    return -1;
  }

  /// Tests the legs from a node to the goal that were not tested yet; the tree is cut at the first
  /// that is not free, seen from the goal.
  bool is_free_to_goal(int node) {
    std::vector<int> nodes;
    for (; node > 0; node = parent(node)) nodes.push_back(node);
    for (auto each = nodes.rbegin(); each != nodes.rend(); ++each) {
      if (tested_.count(point(*each)) != 0) continue;
      if (space_.spent()) return false;
      if (!space_.leg_is_free(point(*each), point(parent(*each)))) {
        tree_.trim(*each);
        return false;
      }
      tested_.insert(point(*each));
    }
    return true;
  }

  /// A leg of at most a step that leads on to the node nearest to a sample; its number, or -1.
  int grow() {
    const bool to_start = spec_.goal_bias > 0 && random_.uniform() < spec_.goal_bias;
    const Point target = to_start ? start_ : space_.sample(random_);
    const int from = nearest(target);
    Point next = space_.towards(point(from), target, spec_.step);
    if (space_.distance(point(from), next) == 0) return -1;
    if (!space_.leg_is_free(next, point(from))) return -1;
    tested_.insert(next);
    tree_.points.push_back(std::move(next));
    tree_.parents.push_back(from);
    return static_cast<int>(tree_.points.size()) - 1;
  }

  int nearest(const Point& to) const {
    const bool steers = space_.leg().steers();
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < static_cast<int>(tree_.points.size()); ++i) {
      if (steers && least_distance(space_, point(i), to) >= least) continue;
      const double distance = space_.distance(point(i), to);
      if (distance >= least) continue;
      least = distance;
      best = i;
    }
    return best;
  }

  std::vector<Point> way_from(int node) const {
    std::vector<Point> way{start_};
    for (; node >= 0; node = parent(node)) {
      if (space_.distance(way.back(), point(node)) > 0) way.push_back(point(node));
    }
    if (way.size() == 1) way.push_back(point(0));
    return way;
  }

  Space& space_;
  const GuideSpec& spec_;
  Random random_;
  const Point& start_;
  GoalTree tree_;
  std::set<Point> tested_;  ///< nodes whose legs to their parents are free now
};

}  // namespace

void GoalTree::trim(int node) {
  std::vector<int> numbers(points.size(), -1);
  int kept = 0;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool leads_there = parents[at] >= 0 && numbers[static_cast<std::size_t>(parents[at])] < 0;
    if (i == node || leads_there) continue;
    numbers[at] = kept++;
    const auto to = static_cast<std::size_t>(numbers[at]);
    if (to != at) points[to] = std::move(points[at]);
    parents[to] = parents[at] < 0 ? -1 : numbers[static_cast<std::size_t>(parents[at])];
  }
  points.resize(static_cast<std::size_t>(kept));
  parents.resize(static_cast<std::size_t>(kept));
}

Search search_tree(Space& space, const Point& start, const Point& goal,
                   std::shared_ptr<const GoalTree>& memory) {
  DynamicTree tree(space, start, goal, memory ? *memory : GoalTree{});
  Search search = tree.run();
  memory = std::make_shared<const GoalTree>(tree.take());
  return search;
}

}  // namespace rubicon::guides
