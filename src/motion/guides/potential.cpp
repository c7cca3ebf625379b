#include "src/motion/guides/potential.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/motion/guides/planners.hpp"

namespace rubicon::guides {

namespace {

/// m: bodies that come nearer to each other touch. Below any step that anybody makes.
constexpr double kTouching = 2e-3;

/// m: nearer than that counts as that near, so that the field stays finite.
constexpr double kNearest = 1e-3;

/// m: so far is looked for what a minimum is named by.
constexpr double kFarthest = 1000;

/// More pairs that touch than a robot has.
constexpr int kMostTouching = 1000;

}  // namespace

PotentialField::PotentialField(Space& space, const Point& start, Point goal)
    : space_(space), goal_(std::move(goal)) {
  leave_out_touching(start);
  leave_out_touching(goal_);
}

void PotentialField::leave_out_touching(const Point& point) {
  for (int i = 0; i < kMostTouching; ++i) {
    const Nearness near = space_.nearest(point, kTouching, left_out_);
    if (near.distance > kTouching) return;
    left_out_.emplace_back(near.moved, near.met);
  }
}

double PotentialField::value(const Point& point) {
  if (!space_.stands(point)) return kBlocked;
  const GuideSpec& spec = space_.spec();
  const double d = space_.distance(point, goal_);
  double strength = spec.attraction;
  if (spec.repulsion > 0) {
    const double r = space_.nearest(point, spec.influence, left_out_).distance;
    if (r < spec.influence) {
      const double push = 1 / std::max(r, kNearest) - 1 / spec.influence;
      strength += spec.repulsion * push * push;
    }
  }
  return d * d / 2 * strength;
}

Nearness PotentialField::nearest(const Point& point) {
  return space_.nearest(point, kFarthest, left_out_);
}

double FieldOnLattice::value(const Lattice::Node& node) {
  const auto known = values_.find(node);
  if (known != values_.end()) return known->second;
  const double value = field_.value(lattice_.point(node));
  values_.emplace(node, value);
  return value;
}

/// Of equals the first in the order of nodes.
std::optional<Lattice::Node> FieldOnLattice::lowest(const Point& from, double value_here,
                                                    const std::vector<Lattice::Node>& nodes) {
  std::vector<std::pair<double, Lattice::Node>> lower;
  for (const Lattice::Node& node : nodes) {
    if (space_.spent()) return std::nullopt;
    const double there = value(node);
    if (there < value_here) lower.emplace_back(there, node);
  }
  std::sort(lower.begin(), lower.end());
  for (const auto& [there, node] : lower) {
    if (space_.spent()) return std::nullopt;
    if (space_.leg_is_free(from, lattice_.point(node))) return node;
  }
  return std::nullopt;
}

std::optional<Lattice::Node> FieldOnLattice::below(const Lattice::Node& node) {
  return lowest(lattice_.point(node), value(node), lattice_.next_to(node));
}

/// A way down from where the robot stands.
class Descent {
 public:
  Descent(Space& space, const Point& start, const Point& goal)
      : space_(space), goal_(goal), on_lattice_(space, start, goal), way_{start} {}

  Search run() {
    Search search;
    const double at_start = on_lattice_.field_.value(way_.front());
    const std::vector<Lattice::Node> about = on_lattice_.lattice_.about_start();
    const bool spanned_there =
        std::any_of(about.begin(), about.end(), [&](const Lattice::Node& each) {
          return on_lattice_.lattice_.is_at_goal(each) &&
                 space_.distance(on_lattice_.lattice_.point(each), way_.front()) == 0;
        });
    std::optional<Lattice::Node> node;
    if (!spanned_there || !reach_goal()) node = on_lattice_.lowest(way_.front(), at_start, about);
    while (!there_ && node && static_cast<double>(way_.size()) < space_.spec().nodes &&
           !space_.spent()) {
      way_.push_back(on_lattice_.lattice_.point(*node));
      if (on_lattice_.lattice_.is_at_goal(*node) && reach_goal()) break;
      node = on_lattice_.below(*node);
    }
    search.nodes = way_.size();
    if (there_) {
      search.way = joined_legs(space_, way_);
    } else if (!node && !space_.spent()) {
      search.cause = minimum_text();
    }
    search.out_of_nodes = !space_.spent();
    return search;
  }

 private:
  /// What the lattice does not span changes last.
  bool reach_goal() {
    there_ = space_.distance(way_.back(), goal_) == 0 || space_.leg_is_free(way_.back(), goal_);
    if (there_ && way_.back() != goal_) way_.push_back(goal_);
    return there_;
  }

  std::string minimum_text() {
    std::string place;
    for (std::size_t i = 0; i < space_.size(); ++i) {
      place += fmt::format("{}{} {:.6g}", i == 0 ? "" : ", ", space_.parameter(i).display_name,
                           way_.back()[i]);
    }
    const Nearness near = on_lattice_.field_.nearest(way_.back());
    const std::string pair =
        std::isfinite(near.distance)
            ? fmt::format("{} is {:.2f} m from {}", near.moved, near.distance, near.met)
            : "nothing is near";
    return fmt::format("the field has a minimum at {}, where {}", place, pair);
  }

  Space& space_;
  const Point& goal_;
  FieldOnLattice on_lattice_;
  std::vector<Point> way_;
  bool there_ = false;
};

Search descend(Space& space, const Point& start, const Point& goal) {
  return Descent(space, start, goal).run();
}

}  // namespace rubicon::guides
