#include <algorithm>
#include <map>
#include <queue>
#include <utility>

#include "src/motion/guides/lattice.hpp"
#include "src/motion/guides/planners.hpp"
#include "src/motion/guides/queued_leg.hpp"

namespace rubicon::guides {

namespace {

/// A* (Hart, Nilsson, Raphael 1968) that tests a leg only when nothing cheaper is left: the queue
/// holds legs, not nodes, so that a refused one takes nothing away from the others (lazy A*: Cohen,
/// Phillips, Likhachev, RSS 2014).
class LatticeSearch {
 public:
  LatticeSearch(Space& space, const Point& start, const Point& goal)
      : space_(space), goal_(goal), lattice_(space, start, goal) {
    reached_.push_back({start, {}, 0, -1});
  }

  Search run() {
    // The straight leg is no leg of the lattice: nothing tells how near to obstacles it passes.
    if (!(space_.spec().safety > 0)) add_goal(0);
    for (const Lattice::Node& node : lattice_.about_start()) add(0, node);
    Search search;
    while (!queue_.empty() && !full() && !space_.spent()) {
      const Candidate next = queue_.top();
      queue_.pop();
      if (!take(next)) continue;
      if (next.at_goal) {
        search.way = way();
        search.cost = reached_.back().cost;
        break;
      }
      const int here = static_cast<int>(reached_.size()) - 1;
      if (lattice_.is_at_goal(next.node)) add_goal(here);
      for (const Lattice::Node& node : lattice_.next_to(next.node)) add(here, node);
    }
    tell_reached(reached_, space_, search);
    return search;
  }

 private:
  struct Reached {
    Point point;
    Lattice::Node node;
    double cost = 0;
    int from = -1;
  };

  struct Candidate : QueuedLeg {
    bool tested = false;
    Lattice::Node node;
  };

  bool full() const { return static_cast<double>(reached_.size()) >= space_.spec().nodes; }
  const Point& point(int reached) const {
    return reached_[static_cast<std::size_t>(reached)].point;
  }
  double cost(int reached) const { return reached_[static_cast<std::size_t>(reached)].cost; }

  void add(int from, const Lattice::Node& node) {
    if (numbers_.count(node) != 0) return;
    Candidate candidate;
    candidate.from = from;
    candidate.node = node;
    candidate.cost = cost(from) + space_.distance(point(from), lattice_.point(node));
    candidate.whole = candidate.cost + lattice_.left(node);
    candidate.number = ++added_;
    queue_.push(candidate);
  }

  void add_goal(int from) {
    Candidate candidate;
    candidate.from = from;
    candidate.at_goal = true;
    candidate.cost = candidate.whole = cost(from) + space_.distance(point(from), goal_);
    candidate.number = ++added_;
    queue_.push(candidate);
  }

  /// Whether a leg leads to where none has led before, and is free: then its end is the last of
  /// `reached_`.
  bool take(Candidate candidate) {
    if (!candidate.at_goal && numbers_.count(candidate.node) != 0) return false;
    Point end = candidate.at_goal ? goal_ : lattice_.point(candidate.node);
    if (!candidate.tested && !space_.leg_is_free(point(candidate.from), end)) return false;
    if (!candidate.tested && !candidate.at_goal && space_.spec().safety > 0) {
      const double length = candidate.cost - cost(candidate.from);
      const double more = length * space_.spec().safety * blocked_share(candidate.node);
      if (more > 0) {
        candidate.cost += more;
        candidate.whole += more;
        candidate.tested = true;
        queue_.push(candidate);
        return false;
      }
    }
    if (!candidate.at_goal) numbers_.emplace(candidate.node, reached_.size());
    reached_.push_back({std::move(end), candidate.node, candidate.cost, candidate.from});
    return true;
  }

  /// Of the nodes beside one the share at which the robot may not stand.
  double blocked_share(const Lattice::Node& node) {
    const std::vector<Lattice::Node> all = lattice_.beside(node);
    const auto blocked = std::count_if(all.begin(), all.end(), [&](const Lattice::Node& each) {
      const auto known = stands_.find(each);
      if (known != stands_.end()) return !known->second;
      const bool stands = space_.stands(lattice_.point(each));
      stands_.emplace(each, stands);
      return !stands;
    });
    return all.empty() ? 0 : static_cast<double>(blocked) / static_cast<double>(all.size());
  }

  /// From the start to the last that was reached, in as few legs as are free.
  std::vector<Point> way() {
    std::vector<Point> points;
    for (int at = static_cast<int>(reached_.size()) - 1; at >= 0;
         at = reached_[static_cast<std::size_t>(at)].from) {
      const bool again = !points.empty() && space_.distance(points.back(), point(at)) == 0;
      if (!again) points.push_back(point(at));
    }
    std::reverse(points.begin(), points.end());
    if (points.size() == 1) points.push_back(goal_);
    return joined_legs(space_, points);
  }

  Space& space_;
  const Point& goal_;
  Lattice lattice_;
  std::vector<Reached> reached_;  ///< the start first
  std::map<Lattice::Node, std::size_t> numbers_;
  std::map<Lattice::Node, bool> stands_;
  std::priority_queue<Candidate> queue_;
  std::size_t added_ = 0;
};

}  // namespace

Search search_lattice(Space& space, const Point& start, const Point& goal) {
  return LatticeSearch(space, start, goal).run();
}

}  // namespace rubicon::guides
