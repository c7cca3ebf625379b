#include <algorithm>
#include <utility>

#include "src/motion/guides/planners.hpp"
#include "src/motion/guides/tree.hpp"
#include "src/motion/guides/way_metrics.hpp"

namespace rubicon::guides {

namespace {

/// A shortcut must save this share of the time that it replaces: rounding is no progress.
constexpr double kWorthwhile = 1e-9;

class Connector {
 public:
  Connector(Space& space, const Point& start, const Point& goal)
      : space_(space),
        random_(static_cast<std::uint64_t>(space.spec().seed)),
        from_start_(space, start),
        from_goal_(space, goal) {}

  Search run() {
    Search search;
    search.way = find();
    search.nodes = from_start_.size() + from_goal_.size();
    search.out_of_nodes = full();
    if (space_.spec().tells_tree) {
      from_start_.tell(search.tree);
      from_goal_.tell(search.tree);
    }
    return search;
  }

 private:
  bool full() const {
    return static_cast<double>(from_start_.size() + from_goal_.size()) >= space_.spec().nodes;
  }

  std::vector<Point> find() {
    if (space_.leg_is_free(from_start_.point(0), from_goal_.point(0))) {
      return {from_start_.point(0), from_goal_.point(0)};
    }
    for (bool forward = true; !full() && !space_.spent(); forward = !forward) {
      Tree& grown = forward ? from_start_ : from_goal_;
      Tree& other = forward ? from_goal_ : from_start_;
      const Point sample = space_.sample(random_);
      const int node = extend(grown, grown.nearest(sample), sample, forward);
      if (node < 0) continue;
      const Point reached = grown.point(node);
      const int met = connect(other, reached, !forward);
      if (met >= 0) return forward ? joined(node, met) : joined(met, node);
    }
    return {};
  }

  /// Legs of the tree from the goal are driven towards it.
  bool is_free(const Point& from, const Point& to, bool forward) {
    return forward ? space_.leg_is_free(from, to) : space_.leg_is_free(to, from);
  }

  /// The longest leg of those that are 1, 1/2, 1/4 ... of the way to the target and free; -1: none.
  int extend(Tree& tree, int from, const Point& target, bool forward) {
    const Point start = tree.point(from);
    double length = space_.distance(start, target);
    while (length > 0 && !space_.spent()) {
      Point next = space_.towards(start, target, length);
      if (is_free(start, next, forward)) return tree.add(std::move(next), from);
      if (length <= space_.spec().step) return -1;
      length = std::max(length / 2, space_.spec().step);
    }
    return -1;
  }

  /// Goes on from the nearest node until it is at the target or stuck; the node there, or -1.
  int connect(Tree& tree, const Point& target, bool forward) {
    int node = tree.nearest(target);
    while (!full()) {
      node = extend(tree, node, target, forward);
      if (node < 0) return -1;
      if (space_.distance(tree.point(node), target) == 0) return node;
    }
    return -1;
  }

  std::vector<Point> joined(int of_start, int of_goal) const {
    std::vector<Point> way = from_start_.way_to(of_start);
    std::vector<Point> rest = from_goal_.way_to(of_goal);
    way.insert(way.end(), rest.rbegin() + 1, rest.rend());
    return way;
  }

  Space& space_;
  Random random_;
  Tree from_start_;
  Tree from_goal_;
};

/// Makes a way shorter by legs between random places of it that are free and take less time.
class Shortener {
 public:
  Shortener(Space& space, const robot::RobotModel& model, bool loaded)
      : space_(space),
        model_(model),
        loaded_(loaded),
        random_(~static_cast<std::uint64_t>(space.spec().seed)) {}

  void shorten(std::vector<Point>& way) {
    for (std::size_t k = 1; k + 1 < way.size();) {
      if (!try_shortcut(way, k - 1, way[k - 1], k + 1, way[k + 1])) ++k;
    }
    for (int i = 0; i < static_cast<int>(space_.spec().improve) && way.size() > 2; ++i) {
      if (space_.spent()) return;
      std::size_t a = random_.index(way.size() - 1);
      std::size_t b = random_.index(way.size() - 1);
      if (a == b) continue;
      if (a > b) std::swap(a, b);
      const Point from = between(way[a], way[a + 1]);
      const Point to = between(way[b], way[b + 1]);
      try_shortcut(way, a, from, b + 1, to);
    }
  }

 private:
  Point between(const Point& a, const Point& b) {
    return space_.towards(a, b, space_.distance(a, b) * random_.uniform());
  }

  double time(const Point& a, const Point& b) const {
    return leg_time(model_, space_.leg(), space_.configuration(a), space_.configuration(b),
                    loaded_);
  }

  /// Replaces what lies between points `first` and `last` of the way by `from` and `to` (or one of
  /// them, where they are these points themselves).
  bool try_shortcut(std::vector<Point>& way, std::size_t first, const Point& from, std::size_t last,
                    const Point& to) {
    std::vector<Point> part{way[first]};
    if (from != way[first]) part.push_back(from);
    if (to != part.back()) part.push_back(to);
    if (way[last] != part.back()) part.push_back(way[last]);
    double now = 0;
    for (std::size_t k = first; k < last; ++k) now += time(way[k], way[k + 1]);
    double then = 0;
    for (std::size_t k = 0; k + 1 < part.size(); ++k) then += time(part[k], part[k + 1]);
    if (then > now * (1 - kWorthwhile) && (then > now || part.size() > last - first)) return false;
    // Parts of legs that were free are tested too: they are driven as legs of their own.
    for (std::size_t k = 0; k + 1 < part.size(); ++k) {
      if (!space_.leg_is_free(part[k], part[k + 1])) return false;
    }
    const auto begin = way.begin();
    way.erase(begin + static_cast<std::ptrdiff_t>(first),
              begin + static_cast<std::ptrdiff_t>(last) + 1);
    way.insert(way.begin() + static_cast<std::ptrdiff_t>(first), part.begin(), part.end());
    return true;
  }

  Space& space_;
  const robot::RobotModel& model_;
  bool loaded_;
  Random random_;
};

}  // namespace

Search connect_trees(Space& space, const Point& start, const Point& goal,
                     const robot::RobotModel& model, bool loaded) {
  Search search = Connector(space, start, goal).run();
  if (!search.way.empty()) shorten(space, search.way, model, loaded);
  return search;
}

void shorten(Space& space, std::vector<Point>& way, const robot::RobotModel& model, bool loaded) {
  Shortener(space, model, loaded).shorten(way);
}

}  // namespace rubicon::guides
