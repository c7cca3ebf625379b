#include "src/motion/guides/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "src/motion/robot/turns.hpp"

namespace rubicon::guides {

namespace {

/// A whole turn has so many nodes at least: with fewer, two ways round would be the same.
constexpr double kLeastOfTurn = 3;

/// More pitches than any search looks through: what a range without end is cut to.
constexpr double kMostPitches = 1e9;

std::int32_t whole(double pitches) {
  return static_cast<std::int32_t>(std::clamp(pitches, -kMostPitches, kMostPitches));
}

}  // namespace

Lattice::Lattice(const Space& space, const Point& start, const Point& goal)
    : space_(space), start_(start), target_(goal) {
  const std::vector<int>& parameters = space.leg().parameters();
  const auto coordinate_of = [&](int parameter) {
    return std::find(parameters.begin(), parameters.end(), parameter) - parameters.begin();
  };
  const int heading = space.leg().heading();
  if (heading >= 0) heading_ = static_cast<int>(coordinate_of(heading));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::vector<int>& over = space.spec().over;
    const auto place = space.leg().place();
    const bool spanned =
        heading >= 0
            ? std::find(place.begin(), place.end(), parameters[i]) != place.end()
            : over.empty() || std::find(over.begin(), over.end(), parameters[i]) != over.end();
    if (spanned && axes_.size() < kMostSpanned) add_axis(i);
  }
  find_directions();
}

void Lattice::add_axis(std::size_t i) {
  Axis axis;
  axis.coordinate = i;
  axis.pitch = space_.spec().step / space_.weight(i);
  const double lower = space_.lower(i);
  const double upper = space_.upper(i);
  if (space_.parameter(i).cyclic) {
    const double count = std::max(std::floor(360 / axis.pitch + 0.5), kLeastOfTurn);
    axis.turn = whole(count);
    axis.pitch = 360 / static_cast<double>(axis.turn);
    axis.most = axis.turn - 1;
  } else {
    axis.least = whole(std::ceil((lower - target_[i]) / axis.pitch));
    axis.most = whole(std::floor((upper - target_[i]) / axis.pitch));
  }
  axis.weighted = axis.pitch * space_.weight(i);
  axes_.push_back(axis);
}

/// The legs to neighbours; of a vehicle also what it faces at the end of each.
void Lattice::find_directions() {
  std::vector<std::int32_t> by(axes_.size(), -1);
  for (bool more = true; more;) {
    const auto moving = std::count_if(by.begin(), by.end(), [](std::int32_t b) { return b != 0; });
    const bool straight = space_.spec().neighbours == Neighbours::straight;
    if (moving == 1 || (moving > 1 && !straight)) directions_.push_back(by);
    more = false;
    for (std::int32_t& each : by) {
      more = each < 1;
      if (more) {
        ++each;
        break;
      }
      each = -1;
    }
  }
  if (heading_ < 0) return;
  const std::vector<double> from = space_.configuration(target_);
  const auto heading = static_cast<std::size_t>(space_.leg().heading());
  for (const std::vector<std::int32_t>& direction : directions_) {
    Point ahead = target_;
    for (std::size_t a = 0; a < axes_.size(); ++a) {
      ahead[axes_[a].coordinate] += direction[a] * axes_[a].pitch;
    }
    const std::vector<double> to = space_.configuration(ahead);
    // It turns, if it must, and drives; then it would turn back.
    const auto place = static_cast<std::size_t>(space_.leg().parameters()[axes_[0].coordinate]);
    const auto across = static_cast<std::size_t>(space_.leg().parameters()[axes_[1].coordinate]);
    double facing = from[heading];
    for (const std::vector<double>& corner : space_.leg().corners(from, to)) {
      facing = corner[heading];
      if (corner[place] != from[place] || corner[across] != from[across]) break;
    }
    headings_.push_back(
        robot::reduced(space_.parameter(static_cast<std::size_t>(heading_)), facing));
  }
}

Point Lattice::point(const Node& node) const {
  Point result = start_;
  for (std::size_t a = 0; a < axes_.size(); ++a) {
    const Axis& axis = axes_[a];
    result[axis.coordinate] = robot::reduced(
        space_.parameter(axis.coordinate), target_[axis.coordinate] + node.pitches[a] * axis.pitch);
  }
  if (heading_ >= 0) {
    result[static_cast<std::size_t>(heading_)] = headings_[static_cast<std::size_t>(node.facing)];
  }
  return result;
}

/// Whether there is a node so many pitches further along an axis: `node` then is that one.
bool Lattice::moved(Node& node, std::size_t a, std::int32_t by) const {
  const Axis& axis = axes_[a];
  std::int32_t& pitches = node.pitches[a];
  pitches += by;
  if (axis.turn > 0) {
    pitches = ((pitches % axis.turn) + axis.turn) % axis.turn;
    return true;
  }
  return pitches >= axis.least && pitches <= axis.most;
}

std::vector<Lattice::Node> Lattice::facing_all_ways(std::vector<Node> nodes) const {
  if (heading_ < 0) return nodes;
  std::vector<Node> result;
  for (Node& node : nodes) {
    for (node.facing = 0; node.facing < static_cast<std::int32_t>(headings_.size());
         ++node.facing) {
      result.push_back(node);
    }
  }
  return result;
}

std::vector<Lattice::Node> Lattice::about_start() const {
  std::vector<Node> nodes{Node{}};
  for (std::size_t a = 0; a < axes_.size(); ++a) {
    const Axis& axis = axes_[a];
    const double off = robot::way_between(space_.parameter(axis.coordinate),
                                          target_[axis.coordinate], start_[axis.coordinate]);
    const std::int32_t below = whole(std::floor(off / axis.pitch));
    std::vector<Node> wider;
    for (const Node& node : nodes) {
      for (std::int32_t k = -1; k <= 2; ++k) {
        Node next = node;
        next.pitches[a] = 0;
        if (!moved(next, a, below + k)) continue;
        if (std::fabs(off / axis.pitch - (below + k)) >= 2) continue;
        wider.push_back(next);
      }
    }
    nodes = std::move(wider);
  }
  // Of a coarse turn the same node may be met from both sides.
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return facing_all_ways(std::move(nodes));
}

std::vector<Lattice::Node> Lattice::next_to(const Node& node) const {
  std::vector<Node> nodes;
  for (std::size_t d = 0; d < directions_.size(); ++d) {
    Node next = node;
    bool there = true;
    for (std::size_t a = 0; a < axes_.size() && there; ++a) {
      there = directions_[d][a] == 0 || moved(next, a, directions_[d][a]);
    }
    if (!there) continue;
    if (heading_ >= 0) next.facing = static_cast<std::int32_t>(d);
    nodes.push_back(next);
  }
  return nodes;
}

std::vector<Lattice::Node> Lattice::leading_to(const Node& node) const {
  std::vector<Node> nodes;
  for (std::size_t d = 0; d < directions_.size(); ++d) {
    if (heading_ >= 0 && static_cast<std::int32_t>(d) != node.facing) continue;
    Node before = node;
    bool there = true;
    for (std::size_t a = 0; a < axes_.size() && there; ++a) {
      there = directions_[d][a] == 0 || moved(before, a, -directions_[d][a]);
    }
    if (there) nodes.push_back(before);
  }
  return facing_all_ways(std::move(nodes));
}

std::vector<Lattice::Node> Lattice::beside(const Node& node) const {
  std::vector<Node> nodes;
  for (std::size_t a = 0; a < axes_.size(); ++a) {
    for (const std::int32_t by : {-1, 1}) {
      Node next = node;
      if (moved(next, a, by)) nodes.push_back(next);
    }
  }
  return nodes;
}

double Lattice::left(const Node& node) const {
  struct Way {
    std::int32_t pitches;
    double weighted;
  };
  std::vector<Way> ways;
  for (std::size_t a = 0; a < axes_.size(); ++a) {
    std::int32_t pitches = node.pitches[a] < 0 ? -node.pitches[a] : node.pitches[a];
    if (axes_[a].turn > 0) pitches = std::min(pitches, axes_[a].turn - pitches);
    ways.push_back({pitches, axes_[a].weighted});
  }
  Heuristic heuristic = space_.spec().heuristic;
  if (heuristic == Heuristic::fitting) {
    const bool straight = space_.spec().neighbours == Neighbours::straight;
    heuristic = straight ? Heuristic::manhattan : Heuristic::octile;
  }
  double sum = 0;
  if (heuristic == Heuristic::manhattan) {
    for (const Way& way : ways) sum += way.pitches * way.weighted;
    return sum;
  }
  if (heuristic == Heuristic::euclid) {
    for (const Way& way : ways) {
      const double off = way.pitches * way.weighted;
      sum += off * off;
    }
    return std::sqrt(sum);
  }
  // Legs that move the more parameters are the shorter for what they do: first all that have a way
  // to go, until the shortest of the ways is done, and so on.
  std::stable_sort(ways.begin(), ways.end(),
                   [](const Way& a, const Way& b) { return a.pitches > b.pitches; });
  double square = 0;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    square += ways[i].weighted * ways[i].weighted;
    const std::int32_t next = i + 1 < ways.size() ? ways[i + 1].pitches : 0;
    sum += (ways[i].pitches - next) * std::sqrt(square);
  }
  return sum;
}

}  // namespace rubicon::guides
