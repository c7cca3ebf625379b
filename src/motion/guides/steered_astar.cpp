#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <queue>
#include <set>
#include <utility>

#include "src/motion/guides/planners.hpp"
#include "src/motion/guides/queued_leg.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/math/turns.hpp"

namespace rubicon::guides {

namespace {

using math::at;

/// A piece is longer than the diagonal of a cell by this share, so that it leaves it.
constexpr double kBeyondCell = 1.02;

/// A* over pieces of ways that a vehicle steers. Its estimate is the way of Reeds and Shepp with
/// nothing in the way, which is never more than what is left.
class ArcSearch {
 public:
  ArcSearch(Space& space, const Point& start, const Point& goal)
      : space_(space), goal_(goal), radius_(space.spec().turn_radius) {
    const std::vector<int>& parameters = space.leg().parameters();
    const auto coordinate = [&](int parameter) {
      return static_cast<std::size_t>(std::find(parameters.begin(), parameters.end(), parameter) -
                                      parameters.begin());
    };
    x_ = coordinate(space.leg().place()[0]);
    y_ = coordinate(space.leg().place()[1]);
    heading_ = coordinate(space.leg().heading());
    pitch_ = space.spec().step / std::max(space.weight(x_), space.weight(y_));
    piece_ = std::sqrt(2.0) * pitch_ * kBeyondCell;
    turn_deg_ = std::min(math::degrees(piece_ / radius_), 90.0);
    piece_ = math::radians(turn_deg_) * radius_;
    cells_of_turn_ = std::max(std::ceil(360 / (turn_deg_ / 2)), 4.0);
    reached_.push_back({start, 0, -1});
  }

  Search run() {
    add_goal(0);
    cells_.insert(cell_of(reached_[0].point));
    add_pieces(0);
    Search search;
    while (!queue_.empty() && !full() && !space_.spent()) {
      Candidate next = queue_.top();
      queue_.pop();
      if (!next.at_goal && cells_.count(cell_of(next.point)) != 0) continue;
      if (!space_.leg_is_free(reached_[at(next.from)].point, next.point)) continue;
      const int here = static_cast<int>(reached_.size());
      if (!next.at_goal) cells_.insert(cell_of(next.point));
      reached_.push_back({std::move(next.point), next.cost, next.from});
      if (next.at_goal) {
        search.way = way();
        search.cost = reached_.back().cost;
        break;
      }
      add_goal(here);
      add_pieces(here);
    }
    tell_reached(reached_, space_, search);
    return search;
  }

 private:
  struct Reached {
    Point point;
    double cost = 0;
    int from = -1;
  };
  struct Candidate : QueuedLeg {
    Point point;
  };
  using Cell = std::array<std::int64_t, 3>;

  bool full() const { return static_cast<double>(reached_.size()) >= space_.spec().nodes; }

  Cell cell_of(const Point& point) const {
    const double turns = math::normalised_deg(point[heading_]) * cells_of_turn_ / 360;
    auto turn = static_cast<std::int64_t>(std::floor(turns + 0.5));
    const auto all = static_cast<std::int64_t>(cells_of_turn_);
    turn = ((turn % all) + all) % all;
    return {static_cast<std::int64_t>(std::floor((point[x_] - goal_[x_]) / pitch_ + 0.5)),
            static_cast<std::int64_t>(std::floor((point[y_] - goal_[y_]) / pitch_ + 0.5)), turn};
  }

  void add_goal(int from) {
    Candidate candidate;
    candidate.from = from;
    candidate.at_goal = true;
    candidate.point = goal_;
    candidate.cost = candidate.whole =
        reached_[at(from)].cost + space_.distance(reached_[at(from)].point, goal_);
    candidate.number = ++added_;
    queue_.push(std::move(candidate));
  }

  void add_pieces(int from) {
    for (const double direction : {1.0, -1.0}) {
      for (const double turn : {0.0, 1.0, -1.0}) {
        Candidate candidate;
        candidate.from = from;
        candidate.point = driven(reached_[at(from)].point, direction, turn);
        if (cells_.count(cell_of(candidate.point)) != 0) continue;
        candidate.cost =
            reached_[at(from)].cost + space_.distance(reached_[at(from)].point, candidate.point);
        candidate.whole = candidate.cost + space_.distance(candidate.point, goal_);
        candidate.number = ++added_;
        queue_.push(std::move(candidate));
      }
    }
  }

  /// Where a piece leads: the leg there is that piece, since no way is shorter.
  Point driven(const Point& from, double direction, double turn) const {
    PlanePart part;
    part.driven = direction * piece_;
    part.turned_deg = turn * direction * turn_deg_;
    return space_.point(space_.leg().driven_by(space_.configuration(from), part));
  }

  std::vector<Point> way() const {
    std::vector<Point> points;
    for (int i = static_cast<int>(reached_.size()) - 1; i >= 0; i = reached_[at(i)].from) {
      points.push_back(reached_[at(i)].point);
    }
    std::reverse(points.begin(), points.end());
    return points;
  }

  Space& space_;
  const Point& goal_;
  double radius_;
  std::size_t x_ = 0, y_ = 0, heading_ = 0;  ///< coordinates of points
  double pitch_ = 0;                         ///< m
  double piece_ = 0;                         ///< m
  double turn_deg_ = 0;                      ///< that an arc of a piece turns by
  double cells_of_turn_ = 0;
  std::vector<Reached> reached_;  ///< the start first
  std::set<Cell> cells_;          ///< those that were reached
  std::priority_queue<Candidate> queue_;
  std::size_t added_ = 0;
};

}  // namespace

Search search_arcs(Space& space, const Point& start, const Point& goal) {
  return ArcSearch(space, start, goal).run();
}

}  // namespace rubicon::guides
