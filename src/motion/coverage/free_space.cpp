#include "src/motion/coverage/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "src/motion/coverage/cells.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::coverage {
namespace {

using math::at;

constexpr double kNoWay = std::numeric_limits<double>::infinity();
/// Up to so many corners what they see is kept: at most 16 MB.
constexpr std::size_t kMostKept = 4000;

bool is_convex(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (cross(corner_before(ring, i), ring[i], next_corner(ring, i)) < 0) return false;
  }
  return true;
}

/// Andrew's monotone chain, counter-clockwise.
Ring convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Ring hull(2 * points.size());
  std::size_t count = 0;
  const auto add = [&](const Point& p, std::size_t least) {
    while (count >= least && cross(hull[count - 2], hull[count - 1], p) <= 0) --count;
    hull[count++] = p;
  };
  for (const Point& p : points) add(p, 2);
  const std::size_t lower = count + 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  hull.resize(count - 1);
  return hull;
}

bool is_box_ring(const Ring& ring) { return ring.size() == 4 && is_orthogonal(ring); }

Obstacle obstacle_of(const Ring& part, std::int64_t clearance, int hole) {
  Obstacle obstacle;
  obstacle.hole = hole;
  obstacle.body = box_of(part);
  obstacle.is_box = is_box_ring(part);
  if (obstacle.is_box || clearance == 0) {
    obstacle.grown = part;
    if (obstacle.is_box) {
      const Box& box = obstacle.body;
      obstacle.grown = Box{{box.low.x - clearance, box.low.y - clearance},
                           {box.high.x + clearance, box.high.y + clearance}}
                           .ring();
    }
  } else {
    // The corners of an octagon round the circle: c and c (sqrt(2) - 1).
    const std::int64_t far = clearance + 1;
    const auto near = static_cast<std::int64_t>(static_cast<double>(far) * 0.4142135624) + 1;
    std::vector<Point> points;
    for (const Point& p : part) {
      for (const std::int64_t x : {-1, 1}) {
        for (const std::int64_t y : {-1, 1}) {
          points.push_back({p.x + x * far, p.y + y * near});
          points.push_back({p.x + x * near, p.y + y * far});
        }
      }
    }
    obstacle.grown = convex_hull(std::move(points));
  }
  obstacle.grown_box = box_of(obstacle.grown);
  return obstacle;
}

std::vector<Obstacle> obstacles_of(const Floor& floor, double clearance_m) {
  const std::int64_t clearance = in_units(clearance_m);
  std::vector<Obstacle> result;
  for (std::size_t i = 0; i < floor.holes.size(); ++i) {
    const Ring& ring = floor.holes[i].ring;
    if (is_convex(ring)) {
      result.push_back(obstacle_of(ring, clearance, static_cast<int>(i)));
      continue;
    }
    // Parts overlap by a little, so that no way runs along their seams.
    const std::vector<Ring> rings{ring};
    for (const Cell& cell : cells_by_sweep(rings, true).cells) {
      const Ring part = cell.ring();
      if (part.size() < 3 || coverage::twice_area(part) <= 0) continue;
      result.push_back(
          obstacle_of(part, std::max<std::int64_t>(clearance, 2), static_cast<int>(i)));
    }
  }
  return result;
}

/// Where a line at `level` along x has the inside of a convex ring, rounded outwards.
std::optional<Stretch> inside_convex(const Ring& ring, std::int64_t level) {
  std::optional<Stretch> result;
  const auto include = [&](std::int64_t low, std::int64_t high) {
    if (!result) result = Stretch{low, high};
    result->low = std::min(result->low, low);
    result->high = std::max(result->high, high);
  };
  bool below = false;
  bool above = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = next_corner(ring, i);
    below = below || a.y < level;
    above = above || a.y > level;
    if (a.y == level) include(a.x, a.x);
    if ((a.y < level && b.y > level) || (b.y < level && a.y > level)) {
      const Side side = a.y < b.y ? Side{a, b} : Side{b, a};
      include(side.x_below(level), side.x_above(level));
    }
  }
  return below && above ? result : std::nullopt;
}

std::vector<Stretch> less_stretches(std::int64_t low, std::int64_t high,
                                    std::vector<Stretch> taken) {
  std::sort(taken.begin(), taken.end(),
            [](const Stretch& a, const Stretch& b) { return a.low < b.low; });
  std::vector<Stretch> result;
  for (const Stretch& stretch : taken) {
    if (stretch.low > low) result.push_back({low, std::min(stretch.low, high)});
    low = std::max(low, stretch.high);
    if (low >= high) return result;
  }
  if (low < high) result.push_back({low, high});
  return result;
}

Box box_of_all(const Ring& outline, const std::vector<Obstacle>& obstacles) {
  Box box = box_of(outline);
  for (const Obstacle& obstacle : obstacles) {
    const Box& other = obstacle.grown_box;
    box.low = {std::min(box.low.x, other.low.x), std::min(box.low.y, other.low.y)};
    box.high = {std::max(box.high.x, other.high.x), std::max(box.high.y, other.high.y)};
  }
  return box;
}

}  // namespace

FreeSpace::FreeSpace(const Floor& floor, double clearance)
    : outline_(floor.outline),
      obstacles_(obstacles_of(floor, clearance)),
      edge_buckets_(box_of_all(outline_, obstacles_), outline_.size()),
      obstacle_buckets_(box_of_all(outline_, obstacles_), obstacles_.size() * 2),
      node_buckets_(box_of_all(outline_, obstacles_), outline_.size() + obstacles_.size() * 4) {
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    edge_buckets_.add(static_cast<int>(i), outline_[i], next_corner(outline_, i));
    longest_ += distance(outline_[i], next_corner(outline_, i));
  }
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    obstacle_buckets_.add(static_cast<int>(i), obstacles_[i].grown_box);
    for (std::size_t k = 0; k < obstacles_[i].grown.size(); ++k) {
      longest_ += distance(obstacles_[i].grown[k], next_corner(obstacles_[i].grown, k));
    }
  }
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    const bool is_reflex =
        cross(corner_before(outline_, i), outline_[i], next_corner(outline_, i)) < 0;
    if (is_reflex && is_clear(outline_[i])) nodes_.push_back(outline_[i]);
  }
  for (const Obstacle& obstacle : obstacles_) {
    for (const Point& p : obstacle.grown) {
      if (allows(p)) nodes_.push_back(p);
    }
  }
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    node_buckets_.add(static_cast<int>(i), nodes_[i], nodes_[i]);
  }
  if (nodes_.size() <= kMostKept) seen_.assign(nodes_.size() * nodes_.size(), 0);
}

bool FreeSpace::is_clear(const Point& p) const {
  return !obstacle_buckets_.any_near(
      p, p, [&](int item) { return enters_convex(obstacles_[at(item)].grown, p, p); });
}

bool FreeSpace::allows(const Point& p) const { return is_clear(p) && place_in(outline_, p) >= 0; }

bool FreeSpace::leaves_floor(const Point& a, const Point& b) const {
  // Whether the direction from p, on corner i, to q starts outside the floor.
  const auto leaves_corner = [&](std::size_t i, const Point& p, const Point& q) {
    const Point& before = corner_before(outline_, i);
    const Point& next = next_corner(outline_, i);
    const bool left_of_in = cross(before, p, q) >= 0;
    const bool left_of_out = cross(p, next, q) >= 0;
    return cross(before, p, next) >= 0 ? !(left_of_in && left_of_out)
                                       : !(left_of_in || left_of_out);
  };
  return edge_buckets_.any_near(a, b, [&](int item) {
    const std::size_t i = at(item);
    const Point& c = outline_[i];
    const Point& d = next_corner(outline_, i);
    if (!box_of(a, b).meets(box_of(c, d))) return false;
    const std::int64_t at_c = cross(a, b, c);
    const std::int64_t at_d = cross(a, b, d);
    if ((at_c > 0 && at_d > 0) || (at_c < 0 && at_d < 0)) return false;
    if (at_c == 0 && dot(c, a, b) <= 0) {
      // The way passes corner c or ends there.
      if (c != a && leaves_corner(i, c, a)) return true;
      if (c != b && leaves_corner(i, c, b)) return true;
    }
    // Corner d is looked at with the next edge.
    if (at_c == 0 || at_d == 0) return false;
    const std::int64_t at_a = cross(c, d, a);
    const std::int64_t at_b = cross(c, d, b);
    return (at_a < 0 && at_b >= 0) || (at_b < 0 && at_a >= 0);
  });
}

bool FreeSpace::sees(const Point& a, const Point& b) const {
  if (a == b) return true;
  const bool is_hidden = obstacle_buckets_.any_near(a, b, [&](int item) {
    const Obstacle& obstacle = obstacles_[at(item)];
    return obstacle.grown_box.meets(box_of(a, b)) && enters_convex(obstacle.grown, a, b);
  });
  return !is_hidden && !leaves_floor(a, b);
}

std::vector<Stretch> FreeSpace::stretches_along_x(std::int64_t y, std::int64_t low,
                                                  std::int64_t high) const {
  std::vector<Stretch> taken;
  obstacle_buckets_.any_near({low, y}, {high, y}, [&](int item) {
    const Obstacle& obstacle = obstacles_[at(item)];
    if (y <= obstacle.grown_box.low.y || y >= obstacle.grown_box.high.y) return false;
    if (const auto inside = inside_convex(obstacle.grown, y)) taken.push_back(*inside);
    return false;
  });
  return less_stretches(low, high, std::move(taken));
}

std::vector<Stretch> FreeSpace::stretches_along_y(std::int64_t x, std::int64_t low,
                                                  std::int64_t high) const {
  std::vector<Stretch> taken;
  obstacle_buckets_.any_near({x, low}, {x, high}, [&](int item) {
    const Obstacle& obstacle = obstacles_[at(item)];
    if (x <= obstacle.grown_box.low.x || x >= obstacle.grown_box.high.x) return false;
    Ring turned;
    for (const Point& p : obstacle.grown) turned.push_back({p.y, p.x});
    if (const auto inside = inside_convex(turned, x)) taken.push_back(*inside);
    return false;
  });
  return less_stretches(low, high, std::move(taken));
}

bool FreeSpace::nodes_see(int a, int b) const {
  if (seen_.empty()) return sees(nodes_[at(a)], nodes_[at(b)]);
  signed char& kept = seen_[at(std::min(a, b)) * nodes_.size() + at(std::max(a, b))];
  if (kept == 0) kept = sees(nodes_[at(a)], nodes_[at(b)]) ? 1 : -1;
  return kept > 0;
}

double FreeSpace::search(const Point& a, const Point& b, double bound,
                         std::vector<Point>& way) const {
  struct Candidate {
    int node;
    double to_b;
    double cost;
    int before;
    bool done;
    bool is_sure;  ///< the stretch that leads here was found free
    bool hidden_from_a;
  };
  const auto spare = static_cast<std::int64_t>((bound - distance(a, b)) / 2) + 1;
  Box box = box_of(a, b);
  box = {{box.low.x - spare, box.low.y - spare}, {box.high.x + spare, box.high.y + spare}};
  std::vector<Candidate> candidates;
  node_buckets_.any_in(box, [&](int item) {
    const Point& p = nodes_[at(item)];
    const double to_b = distance(p, b);
    if (distance(a, p) + to_b <= bound)
      candidates.push_back({item, to_b, kNoWay, -1, false, false, false});
    return false;
  });
  // Whether a stretch is free is asked only when it would be taken: most never are.
  for (Candidate& candidate : candidates) {
    candidate.cost = distance(a, nodes_[at(candidate.node)]);
  }
  std::vector<int> done;
  const auto is_free = [&](int from, const Candidate& to) {
    return from < 0 ? sees(a, nodes_[at(to.node)]) : nodes_see(candidates[at(from)].node, to.node);
  };
  const auto cost_from = [&](int from, const Candidate& to) {
    const Point& p = nodes_[at(to.node)];
    return from < 0
               ? distance(a, p)
               : candidates[at(from)].cost + distance(nodes_[at(candidates[at(from)].node)], p);
  };
  double best = kNoWay;
  int last = -1;
  while (true) {
    int next = -1;
    double least = best;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const Candidate& candidate = candidates[i];
      if (candidate.done || candidate.cost + candidate.to_b >= least) continue;
      least = candidate.cost + candidate.to_b;
      next = static_cast<int>(i);
    }
    if (next < 0) break;
    Candidate& from = candidates[at(next)];
    if (!from.is_sure && !is_free(from.before, from)) {
      // The cheapest of the other stretches that lead here and are free.
      std::vector<std::pair<double, int>> others;
      for (const int other : done) {
        if (other != from.before) others.emplace_back(cost_from(other, from), other);
      }
      if (from.before >= 0 && !from.hidden_from_a) others.emplace_back(cost_from(-1, from), -1);
      from.hidden_from_a = from.hidden_from_a || from.before < 0;
      std::sort(others.begin(), others.end());
      from.cost = kNoWay;
      from.is_sure = true;
      for (const auto& [cost, other] : others) {
        if (!is_free(other, from)) continue;
        from.cost = cost;
        from.before = other;
        break;
      }
      continue;
    }
    from.done = true;
    done.push_back(next);
    if (sees(nodes_[at(from.node)], b)) {
      best = from.cost + from.to_b;
      last = next;
      continue;
    }
    for (Candidate& to : candidates) {
      if (to.done) continue;
      const double cost = cost_from(next, to);
      if (cost >= to.cost || cost + to.to_b >= best) continue;
      if (to.is_sure && !is_free(next, to)) continue;
      to.cost = cost;
      to.before = next;
    }
  }
  if (last < 0) return kNoWay;
  way = {b};
  for (int i = last; i >= 0; i = candidates[at(i)].before) {
    way.push_back(nodes_[at(candidates[at(i)].node)]);
  }
  way.push_back(a);
  std::reverse(way.begin(), way.end());
  way.erase(std::unique(way.begin(), way.end()), way.end());
  return best;
}

namespace {

double length_of(const std::vector<Point>& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += distance(way[i - 1], way[i]);
  return length;
}

}  // namespace

std::vector<Point> FreeSpace::way_within(const Point& a, const Point& b, double limit) const {
  const double straight = distance(a, b);
  if (straight > limit) return {};
  if (sees(a, b)) return {a, b};
  double bound = std::min(1.25 * straight + static_cast<double>(kUnitsPerMetre), limit);
  while (true) {
    std::vector<Point> way;
    const double length = search(a, b, bound, way);
    if (length <= bound) return way;
    if (bound >= limit) return {};
    if (length < kNoWay) {
      bound = std::min(length, limit);  // whatever is shorter lies in this ellipse
    } else if (bound > straight + longest_) {
      return {};
    } else {
      bound = std::min(2 * bound, limit);
    }
  }
}

std::vector<Point> FreeSpace::shortest_way(const Point& a, const Point& b) const {
  return way_within(a, b, kNoWay);
}

double FreeSpace::shortest_length(const Point& a, const Point& b) const {
  return shortest_length_within(a, b, kNoWay);
}

double FreeSpace::shortest_length_within(const Point& a, const Point& b, double limit) const {
  const std::vector<Point> way = way_within(a, b, limit);
  return way.empty() ? kNoWay : length_of(way);
}

/// The corners that can be reached from a place, those nearest to another place first.
class FreeSpace::Flood {
 public:
  Flood(const FreeSpace& space, const Point& from, const Point& to)
      : space_(space), from_(from), to_(to), reached_(space.nodes_.size(), false) {}

  /// Goes on by a corner; false: all were looked at.
  bool step() {
    if (!std::exchange(begun_, true)) {
      look_from(-1);
      return true;
    }
    if (open_.empty()) return false;
    std::pop_heap(open_.begin(), open_.end(), std::greater<>());
    const int node = open_.back().second;
    open_.pop_back();
    look_from(node);
    return true;
  }
  bool found() const { return found_; }

 private:
  void look_from(int node) {
    const Point& p = node < 0 ? from_ : space_.nodes_[at(node)];
    found_ = found_ || space_.sees(p, to_);
    for (std::size_t i = 0; i < reached_.size() && !found_; ++i) {
      const int other = static_cast<int>(i);
      if (reached_[i] || other == node) continue;
      const Point& q = space_.nodes_[i];
      if (!(node < 0 ? space_.sees(p, q) : space_.nodes_see(node, other))) continue;
      reached_[i] = true;
      open_.emplace_back(distance(q, to_), other);
      std::push_heap(open_.begin(), open_.end(), std::greater<>());
    }
  }

  const FreeSpace& space_;
  const Point from_, to_;
  std::vector<bool> reached_;
  std::vector<std::pair<double, int>> open_;  ///< a heap
  bool begun_ = false;
  bool found_ = false;
};

bool FreeSpace::reaches(const Point& a, const Point& b) const {
  // Most are near each other. Else one of the two may lie in a small part of the space: a search
  // from there comes to its end soon.
  const double near = 2 * distance(a, b) + 4 * static_cast<double>(kUnitsPerMetre);
  if (!way_within(a, b, near).empty()) return true;
  Flood there(*this, a, b);
  Flood back(*this, b, a);
  while (there.step() && !there.found() && back.step() && !back.found()) {
  }
  return there.found() || back.found();
}

}  // namespace rubicon::coverage
