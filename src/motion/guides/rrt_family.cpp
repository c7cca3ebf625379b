#include <cmath>
#include <optional>
#include <utility>

#include "src/motion/guides/planners.hpp"
#include "src/motion/guides/tree.hpp"

namespace rubicon::guides {

namespace {

/// A random direction that is perpendicular to a given one has at least this length before it is
/// made a unit: a shorter one is drawn again.
constexpr double kShortDirection = 1e-3;

/// One search of the family: they differ in where samples come from and in how far they go.
class Growth {
 public:
  Growth(Space& space, const Point& start, const Point& goal)
      : space_(space),
        spec_(space.spec()),
        random_(static_cast<std::uint64_t>(spec_.seed)),
        goal_(goal),
        tree_(space, start) {}

  Search run() {
    std::optional<int> end;
    if (space_.distance(tree_.point(0), goal_) <= spec_.step && reach_goal(0)) end = last();
    while (!end && !space_.spent() && !full()) end = round();
    Search search;
    search.nodes = tree_.size();
    search.out_of_nodes = full();
    if (spec_.tells_tree) tree_.tell(search.tree);
    if (end) search.way = smoothed(tree_.way_to(*end));
    return search;
  }

 private:
  bool full() const { return static_cast<double>(tree_.size()) >= spec_.nodes; }
  int last() const { return static_cast<int>(tree_.size()) - 1; }

  /// A sample and what the tree makes of it; the node at the goal, if it is there.
  std::optional<int> round() {
    const bool to_goal = spec_.goal_bias > 0 && random_.uniform() < spec_.goal_bias;
    switch (spec_.kind) {
      case GuideKind::rrt_limcon:
        return extend_one_parameter(to_goal ? goal_ : space_.sample(random_));
      case GuideKind::rrt_plus:
        return to_goal ? extend_to_goal() : extend_greedily(sample_plus());
      case GuideKind::rrt_nonuniform:
        return extend_once(to_goal ? goal_
                                   : space_.sample_about(goal_, spec_.concentration, random_));
      default:
        return extend_once(to_goal ? goal_ : space_.sample(random_));
    }
  }

  Point sample_plus() {
    if (static_cast<double>(tree_.size()) <= spec_.uniform_nodes) return space_.sample(random_);
    return space_.sample_about(goal_, spec_.concentration, random_);
  }

  /// A leg of at most a step from a node towards the target; whether it is free.
  bool grow(int from, const Point& target) {
    Point next = space_.towards(tree_.point(from), target, spec_.step);
    if (space_.distance(tree_.point(from), next) == 0) return false;
    if (!space_.leg_is_free(tree_.point(from), next)) return false;
    tree_.add(std::move(next), from);
    return true;
  }

  /// Whether the goal is within a step of a node, and its leg free: then it is the last node.
  bool reach_goal(int from) {
    const double distance = space_.distance(tree_.point(from), goal_);
    if (distance > spec_.step) return false;
    if (distance > 0 && !space_.leg_is_free(tree_.point(from), goal_)) return false;
    tree_.add(goal_, from);
    return true;
  }

  std::optional<int> extend_once(const Point& target) {
    if (!grow(tree_.nearest(target).node, target)) return std::nullopt;
    if (reach_goal(last())) return last();
    return std::nullopt;
  }

  std::optional<int> extend_to_goal() {
    int from = tree_.nearest(goal_).node;
    while (!full() && !space_.spent()) {
      if (reach_goal(from)) return last();
      if (!grow(from, goal_)) {
        note_refusal(from, goal_);
        return std::nullopt;
      }
      rejected_ = 0;
      from = last();
    }
    return std::nullopt;
  }

  std::optional<int> extend_greedily(const Point& target) {
    int from = tree_.nearest(target).node;
    for (int i = 0; i < static_cast<int>(spec_.greed) && !full() && !space_.spent(); ++i) {
      if (!grow(from, target)) {
        note_refusal(from, target);
        return std::nullopt;
      }
      rejected_ = 0;
      from = last();
      if (reach_goal(from)) return last();
      if (space_.distance(tree_.point(from), target) == 0) break;
    }
    return std::nullopt;
  }

  /// After too many refusals in a row: a step across the direction that was refused, to either
  /// side (Langari 2015, 3.3.3).
  void note_refusal(int from, const Point& target) {
    if (static_cast<double>(++rejected_) <= spec_.rejections || space_.size() < 2) return;
    std::vector<double> across = perpendicular(tree_.point(from), target);
    for (int side = 0; side < 2 && !full() && !space_.spent(); ++side) {
      if (side == 1) {
        for (double& each : across) each = -each;
      }
      if (grow(from, space_.moved(tree_.point(from), across))) rejected_ = 0;
    }
  }

  std::vector<double> perpendicular(const Point& from, const Point& target) {
    const std::size_t n = space_.size();
    std::vector<double> along(n);
    double square = 0;
    for (std::size_t i = 0; i < n; ++i) {
      along[i] = space_.offset(from, target, i);
      square += along[i] * along[i];
    }
    std::vector<double> across(n);
    while (true) {
      double dot = 0;
      for (std::size_t i = 0; i < n; ++i) {
        across[i] = random_.between(-1, 1);
        dot += across[i] * along[i];
      }
      double length = 0;
      for (std::size_t i = 0; i < n; ++i) {
        if (square > 0) across[i] -= dot / square * along[i];
        length += across[i] * across[i];
      }
      length = std::sqrt(length);
      if (length < kShortDirection) continue;
      for (double& each : across) each *= spec_.step / length;
      return across;
    }
  }

  /// Steps of the parameter that is farthest from the target, as long as they lead past neither it
  /// nor away from the goal (our reading of AlBahnassi's RRTBiasedLimCon, PLANNERS 5.4).
  std::optional<int> extend_one_parameter(const Point& target) {
    int from = tree_.nearest(target).node;
    std::size_t moved = 0;
    double farthest = 0;
    for (std::size_t i = 0; i < space_.size(); ++i) {
      const double off = space_.offset(tree_.point(from), target, i);
      if (std::fabs(off) <= std::fabs(farthest)) continue;
      farthest = off;
      moved = i;
    }
    double left = std::fabs(farthest);
    double to_goal = space_.distance(tree_.point(from), goal_);
    for (bool first = true; left > 0 && !full() && !space_.spent(); first = false) {
      std::vector<double> offsets(space_.size(), 0.0);
      const double length = left < spec_.step ? left : spec_.step;
      offsets[moved] = farthest > 0 ? length : -length;
      Point next = space_.moved(tree_.point(from), offsets);
      const double after = space_.distance(next, goal_);
      if (!first && after > to_goal) break;
      if (!space_.leg_is_free(tree_.point(from), next)) break;
      from = tree_.add(std::move(next), from);
      left -= length;
      to_goal = after;
      if (to_goal <= spec_.step && reach_goal(from)) return last();
    }
    return std::nullopt;
  }

  /// From each point to the farthest one at most C steps away that a free leg leads to. The thesis
  /// (3.3.4) does without the test; of 50 ways seven then had legs in contact (PLANNERS 5.4).
  std::vector<Point> smoothed(std::vector<Point> way) {
    if (spec_.smooth <= 1) return way;
    std::vector<Point> result{way.front()};
    std::size_t i = 0;
    while (i + 1 < way.size()) {
      std::size_t next = i + 1;
      for (std::size_t k = i + 2; k < way.size(); ++k) {
        const double distance = space_.distance(way[i], way[k]);
        if (distance > spec_.step && distance < spec_.smooth * spec_.step &&
            space_.leg_is_free(way[i], way[k])) {
          next = k;
        }
      }
      result.push_back(way[next]);
      i = next;
    }
    return result;
  }

  Space& space_;
  const GuideSpec& spec_;
  Random random_;
  const Point& goal_;
  Tree tree_;
  int rejected_ = 0;  ///< in a row
};

}  // namespace

Search grow_to_goal(Space& space, const Point& start, const Point& goal) {
  return Growth(space, start, goal).run();
}

}  // namespace rubicon::guides
