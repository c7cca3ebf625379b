#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "src/motion/guides/planners.hpp"
#include "src/motion/guides/tree.hpp"
#include "src/motion/guides/way_metrics.hpp"

namespace rubicon::guides {

namespace {

/// A shortcut must save this share of the time that it replaces: rounding is no progress.
constexpr double kWorthwhile = 1e-9;

/// Dynamic domains (Yershova, Jaillet, Simeon, LaValle, ICRA 2005; Jaillet and others, IROS 2005):
/// that of a node which could not be left is this share of the diagonal of the space, and grows or
/// shrinks by that share each time it is tried again.
constexpr double kDomainShare = 0.2;
constexpr double kDomainChange = 0.05;
/// A sample that lies in no domain is taken after so many draws.
constexpr int kMostDraws = 100;

/// A leg goes no farther than this share of the diagonal of the space, and is taken only if this
/// share of it is free: short pieces of legs that end at an obstacle cost more looks than they
/// help.
constexpr double kLongestLeg = 0.25;
constexpr double kLeastShare = 0.3;
/// The smaller tree grows, but for one draw of so many.
constexpr int kBalanced = 10;

class Connector {
 public:
  Connector(Space& space, const Point& start, const Point& goal)
      : space_(space),
        random_(static_cast<std::uint64_t>(space.spec().seed)),
        from_start_{Tree(space, start)},
        from_goal_{Tree(space, goal)} {
    double square = 0;
    for (std::size_t i = 0; i < space.size(); ++i) {
      const double range = (space.upper(i) - space.lower(i)) * space.weight(i);
      square += range * range;
    }
    first_domain_ = std::sqrt(square) * kDomainShare;
    longest_leg_ = std::sqrt(square) * kLongestLeg;
  }

  Search run() {
    Search search;
    search.way = find();
    search.nodes = from_start_.tree.size() + from_goal_.tree.size();
    search.out_of_nodes = full();
    if (space_.spec().tells_tree) {
      from_start_.tree.tell(search.tree);
      from_goal_.tree.tell(search.tree);
    }
    return search;
  }

 private:
  bool full() const {
    return static_cast<double>(from_start_.tree.size() + from_goal_.tree.size()) >=
           space_.spec().nodes;
  }

  std::vector<Point> find() {
    if (space_.leg_is_free(from_start_.tree.point(0), from_goal_.tree.point(0))) {
      return {from_start_.tree.point(0), from_goal_.tree.point(0)};
    }
    for (int n = 1; !full() && !space_.spent(); ++n) {
      const bool is_smaller = from_start_.tree.size() <= from_goal_.tree.size();
      const bool forward = is_smaller == (n % kBalanced != 0);
      Side& grown = forward ? from_start_ : from_goal_;
      Side& other = forward ? from_goal_ : from_start_;
      const auto [sample, nearest] = draw(grown);
      const int node = extend(grown.tree, nearest, sample, forward).node;
      note(grown, nearest, node >= 0);
      if (node < 0) continue;
      const Point reached = grown.tree.point(node);
      const int met = connect(other.tree, reached, !forward);
      if (met >= 0) return forward ? joined(node, met) : joined(met, node);
    }
    return {};
  }

  /// A tree, and of each node within which distance it is drawn for.
  struct Side {
    Tree tree;
    std::vector<double> domains = {};
  };

  /// A sample and the node nearest to it, in whose domain it lies.
  std::pair<Point, int> draw(Side& side) {
    side.domains.resize(side.tree.size(), std::numeric_limits<double>::infinity());
    Point sample;
    for (int n = 1;; ++n) {
      space_.sample(random_, sample);
      const Tree::Near nearest = side.tree.nearest(sample);
      const double domain = side.domains[static_cast<std::size_t>(nearest.node)];
      if (n == kMostDraws || nearest.distance <= domain) return {std::move(sample), nearest.node};
    }
  }

  /// A node that could not be left has obstacles near it: samples far behind them are no use.
  void note(Side& side, int node, bool left) {
    double& domain = side.domains[static_cast<std::size_t>(node)];
    if (left) {
      domain *= 1 + kDomainChange;
    } else if (std::isinf(domain)) {
      domain = first_domain_;
    } else {
      domain = std::max(domain * (1 - kDomainChange), space_.spec().step);
    }
  }

  struct Extended {
    int node = -1;       ///< -1: none
    bool stuck = false;  ///< what lies behind it is not free
  };

  /// Goes from a node towards the target, the longest leg at most, as far as that is free. Where
  /// that cannot be seen at once, by the longest leg of those that are 1, 1/2, 1/4 ... of the way.
  /// Legs of the tree from the goal are driven towards it.
  Extended extend(Tree& tree, int from, Point target, bool forward) {
    const Point start = tree.point(from);
    double length = space_.distance(start, target);
    if (!(length > 0)) return {};
    if (length > longest_leg_) {
      target = space_.towards(start, target, longest_leg_);
      length = longest_leg_;
    }
    const double least = std::max(kLeastShare, space_.spec().step / length);
    if (const auto share = space_.free_share(start, target, least)) {
      if (*share <= 0) return {};
      return {tree.add(space_.towards(start, target, *share * length), from), *share < 1};
    }
    while (!space_.spent()) {
      Point next = space_.towards(start, target, length);
      const bool free = forward ? space_.leg_is_free(start, next) : space_.leg_is_free(next, start);
      if (free) return {tree.add(std::move(next), from)};
      if (length <= space_.spec().step) break;
      length = std::max(length / 2, space_.spec().step);
    }
    return {};
  }

  /// Goes on from the nearest node until it is at the target or stuck; the node there, or -1.
  int connect(Tree& tree, const Point& target, bool forward) {
    Extended reached{tree.nearest(target).node, false};
    while (!full() && !reached.stuck) {
      reached = extend(tree, reached.node, target, forward);
      if (reached.node < 0) return -1;
      if (space_.distance(tree.point(reached.node), target) == 0) return reached.node;
    }
    return -1;
  }

  std::vector<Point> joined(int of_start, int of_goal) const {
    std::vector<Point> way = from_start_.tree.way_to(of_start);
    std::vector<Point> rest = from_goal_.tree.way_to(of_goal);
    way.insert(way.end(), rest.rbegin() + 1, rest.rend());
    return way;
  }

  Space& space_;
  Random random_;
  Side from_start_;
  Side from_goal_;
  double first_domain_ = 0;
  double longest_leg_ = 0;
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
