#include <algorithm>
#include <cmath>
#include <utility>

#include "src/motion/guides/planners.hpp"
#include "src/motion/guides/repaired_lattice.hpp"

namespace rubicon::guides {

namespace {

/// Keys that are nearer to each other than this share are taken for equal: what the starts moved by
/// is added up with rounding, and a vertex on the way may come out just above the start.
constexpr double kSameKey = 1e-9;

}  // namespace

/// One search: the lattice as it lies about the start of now.
class RepairedLattice::Repair {
 public:
  Repair(RepairedLattice& kept, Space& space, const Point& start)
      : kept_(kept), space_(space), lattice_(space, start, kept.goal_), start_(start) {
    kept_.expansions_ = 0;
    move_start();
    for (const Lattice::Node& node : lattice_.about_start()) about_start_.push_back(number(node));
    std::sort(about_start_.begin(), about_start_.end());
  }

  std::vector<Point> run() {
    if (fresh_) update(kGoal);
    test_blocked_again();
    update(kStart);
    while (compute()) {
      const std::vector<std::size_t> way = cheapest_way();
      if (way.empty()) return {};
      if (is_free(way)) return points_of(way);
      if (space_.spent()) return {};
    }
    return {};
  }

 private:
  Vertex& vertex(std::size_t v) { return kept_.vertices_[v]; }
  const Vertex& vertex(std::size_t v) const { return kept_.vertices_[v]; }

  const Point& point(std::size_t v) const { return vertex(v).point; }

  std::size_t number(const Lattice::Node& node) {
    const auto [place, is_new] = kept_.numbers_.emplace(node, kept_.vertices_.size());
    if (is_new) {
      Vertex& added = kept_.vertices_.emplace_back();
      added.node = node;
      added.point = lattice_.point(node);
    }
    return place->second;
  }

  /// Where the robot stands now is another start; what is known of the rest stays.
  void move_start() {
    fresh_ = kept_.start_.empty();
    if (!fresh_) {
      kept_.moved_ += space_.distance(kept_.start_, start_);
      leave_queue(kStart);
      vertex(kStart) = Vertex{};
      std::erase_if(kept_.blocked_, [](const Leg& leg) { return leg.first == kStart; });
    }
    kept_.start_ = start_;
    vertex(kStart).point = start_;
    vertex(kGoal).point = kept_.goal_;
  }

  /// Tests what was not tested yet of a way: first where it leads through, since that is soon done.
  /// What is refused is remembered.
  bool is_free(const std::vector<std::size_t>& way) {
    bool free = true;
    for (const std::size_t v : way) {
      if (v <= kStart || standing_.count(v) != 0) continue;
      if (space_.spent()) return false;
      if (space_.stands(point(v))) {
        standing_.insert(v);
        continue;
      }
      kept_.blocked_vertices_.insert(v);
      for (const std::size_t before : leading_to(v)) update(before);
      update(v);
      free = false;
    }
    for (std::size_t i = 0; i + 1 < way.size() && free; ++i) {
      const Leg leg{way[i], way[i + 1]};
      if (free_.count(leg) != 0) continue;
      if (space_.spent()) return false;
      if (space_.leg_is_free(point(leg.first), point(leg.second))) {
        free_.insert(leg);
        continue;
      }
      kept_.blocked_.insert(leg);
      update(leg.first);
      free = false;
    }
    return free;
  }

  void test_blocked_again() {
    const std::vector<std::size_t> vertices(kept_.blocked_vertices_.begin(),
                                            kept_.blocked_vertices_.end());
    for (const std::size_t v : vertices) {
      if (space_.spent()) return;
      if (!space_.stands(point(v))) continue;
      standing_.insert(v);
      kept_.blocked_vertices_.erase(v);
      update(v);
      for (const std::size_t before : leading_to(v)) update(before);
    }
    const std::vector<Leg> blocked(kept_.blocked_.begin(), kept_.blocked_.end());
    for (const Leg& leg : blocked) {
      if (space_.spent()) return;
      if (!space_.leg_is_free(point(leg.first), point(leg.second))) continue;
      free_.insert(leg);
      kept_.blocked_.erase(leg);
      update(leg.first);
    }
  }

  double cost(std::size_t from, std::size_t to) const {
    if (kept_.blocked_vertices_.count(from) != 0 || kept_.blocked_vertices_.count(to) != 0 ||
        kept_.blocked_.count({from, to}) != 0) {
      return kInfinite;
    }
    return space_.distance(point(from), point(to));
  }

  std::vector<std::size_t> next_to(std::size_t v) {
    std::vector<std::size_t> next;
    if (v == kStart) {
      next = about_start_;
      next.push_back(kGoal);
      return next;
    }
    const Lattice::Node node = vertex(v).node;
    for (const Lattice::Node& each : lattice_.next_to(node)) next.push_back(number(each));
    if (lattice_.is_at_goal(node)) next.push_back(kGoal);
    return next;
  }

  std::vector<std::size_t> leading_to(std::size_t v) {
    std::vector<std::size_t> before;
    const std::vector<Lattice::Node> nodes =
        v == kGoal ? lattice_.at_goal() : lattice_.leading_to(vertex(v).node);
    for (const Lattice::Node& each : nodes) before.push_back(number(each));
    if (v == kGoal || std::binary_search(about_start_.begin(), about_start_.end(), v)) {
      before.push_back(kStart);
    }
    return before;
  }

  std::pair<double, double> key_of(std::size_t v) const {
    const double least = std::min(vertex(v).g, vertex(v).rhs);
    const double from_start = v == kStart ? 0 : space_.distance(start_, point(v));
    return {least + from_start + kept_.moved_, least};
  }

  void leave_queue(std::size_t v) {
    Vertex& each = vertex(v);
    if (each.queued) kept_.queue_.erase({each.key.first, each.key.second, v});
    each.queued = false;
  }

  void enter_queue(std::size_t v) {
    Vertex& each = vertex(v);
    each.key = key_of(v);
    each.queued = true;
    kept_.queue_.emplace(each.key.first, each.key.second, v);
  }

  /// Of all that is next to it.
  void update(std::size_t v) {
    if (v != kGoal) {
      double least = kInfinite;
      for (const std::size_t next : next_to(v)) {
        if (vertex(next).g < kInfinite) least = std::min(least, cost(v, next) + vertex(next).g);
      }
      vertex(v).rhs = least;
    }
    queue(v);
  }

  void queue(std::size_t v) {
    leave_queue(v);
    if (vertex(v).g != vertex(v).rhs) enter_queue(v);
  }

  /// The costs of a vertex fell: those before it may, too.
  void lower(std::size_t v) {
    vertex(v).g = vertex(v).rhs;
    for (const std::size_t before : leading_to(v)) {
      if (before == kGoal) continue;
      const double by_this = cost(before, v) + vertex(v).g;
      if (!(by_this < vertex(before).rhs)) continue;
      vertex(before).rhs = by_this;
      queue(before);
    }
  }

  /// They rose: those before it that went on by it look for another way.
  void raise(std::size_t v) {
    const double was = vertex(v).g;
    vertex(v).g = kInfinite;
    queue(v);
    for (const std::size_t before : leading_to(v)) {
      if (before != kGoal && vertex(before).rhs == cost(before, v) + was) update(before);
    }
  }

  /// Until what the start costs is known; false at the limit of nodes, or if there is no way.
  bool compute() {
    while (!kept_.queue_.empty()) {
      const auto [first, second, v] = *kept_.queue_.begin();
      const std::pair<double, double> top{first, second};
      const double needed = key_of(kStart).first;
      const bool beyond = first > needed + kSameKey * (1 + std::fabs(needed));
      if (beyond && vertex(kStart).rhs == vertex(kStart).g) break;
      if (static_cast<double>(kept_.expansions_) >= space_.spec().nodes) return false;
      const std::pair<double, double> now = key_of(v);
      leave_queue(v);
      if (top < now) {
        enter_queue(v);
        continue;
      }
      ++kept_.expansions_;
      if (vertex(v).g > vertex(v).rhs) {
        lower(v);
      } else {
        raise(v);
      }
    }
    return vertex(kStart).g < kInfinite;
  }

  /// Always on to where the rest costs least; of equals to the first.
  std::vector<std::size_t> cheapest_way() {
    std::vector<std::size_t> way{kStart};
    while (way.back() != kGoal) {
      if (way.size() > kept_.vertices_.size()) return {};
      double least = kInfinite;
      std::size_t best = kGoal;
      for (const std::size_t next : next_to(way.back())) {
        const double whole = cost(way.back(), next) + vertex(next).g;
        if (!(whole < least)) continue;
        least = whole;
        best = next;
      }
      if (!(least < kInfinite)) return {};
      way.push_back(best);
    }
    return way;
  }

  std::vector<Point> points_of(const std::vector<std::size_t>& way) const {
    std::vector<Point> points;
    for (const std::size_t v : way) {
      if (points.empty() || space_.distance(points.back(), point(v)) > 0) {
        points.push_back(point(v));
      }
    }
    if (points.size() == 1) points.push_back(kept_.goal_);
    return points;
  }

  RepairedLattice& kept_;
  Space& space_;
  Lattice lattice_;
  const Point& start_;
  bool fresh_ = true;
  std::vector<std::size_t> about_start_;
  std::set<Leg> free_;              ///< now
  std::set<std::size_t> standing_;  ///< the same of vertices
};

std::vector<Point> RepairedLattice::search(Space& space, const Point& start) {
  return Repair(*this, space, start).run();
}

bool RepairedLattice::lies_about(const Space& space, const Point& start) const {
  return start_.empty() ||
         Lattice(space, start_, goal_).point({}) == Lattice(space, start, goal_).point({});
}

Search repair_lattice(Space& space, const Point& start, const Point& goal,
                      std::shared_ptr<const RepairedLattice>& memory) {
  const bool same_goal = memory && memory->goal() == goal && memory->lies_about(space, start);
  RepairedLattice lattice = same_goal ? *memory : RepairedLattice(goal);
  Search search;
  search.way = joined_legs(space, lattice.search(space, start));
  search.cost = lattice.cost();
  search.nodes = lattice.expansions();
  search.out_of_nodes = !space.spent();
  memory = std::make_shared<const RepairedLattice>(std::move(lattice));
  return search;
}

}  // namespace rubicon::guides
