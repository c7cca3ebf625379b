#include "tests/unit/travel/rational_bugs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "tests/unit/travel/rational.hpp"

namespace rubicon::travel {
namespace {

struct Point {
  Rational x, y;
};

Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
Point along(const Point& a, const Point& b, const Rational& t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}
Rational cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
Rational dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
bool same(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }
Point corner(const LatticePoint& p) { return {p.x, p.y}; }
double distance(const Point& a, const Point& b) {
  const double x = (b.x - a.x).value() / kPitchesPerMetre;
  const double y = (b.y - a.y).value() / kPitchesPerMetre;
  return std::sqrt(x * x + y * y);
}
const Rational kZero(0);
const Rational kOne(1);

struct Before {
  bool operator()(const Point& a, const Point& b) const {
    if (a.x < b.x) return true;
    return a.x == b.x && a.y < b.y;
  }
};

bool strictly_inside(const Ring& ring, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = corner(ring[i]);
    const Point b = corner(ring[(i + 1) % ring.size()]);
    const int turn = cross(b - a, p - a).sign();
    if (turn == 0 && dot(a - p, b - p).sign() <= 0) return false;
    const bool a_above = p.y < a.y;
    const bool b_above = p.y < b.y;
    if (a_above != b_above && (turn > 0) == b_above) inside = !inside;
  }
  return inside;
}

/// An edge of the outline, walked with the obstacle on the right.
struct Wall {
  int from = 0, to = 0, next = -1, previous = -1;
};

class World {
 public:
  explicit World(const std::vector<Ring>& rings) {
    std::set<std::pair<int, int>> stretches;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      for (std::size_t k = 0; k < rings[i].size(); ++k) add_edge(rings, i, k, stretches);
    }
    for (const auto& [from, to] : stretches) {
      if (!stretches.contains({to, from})) walls.push_back({to, from});
    }
    for (std::size_t i = 0; i < walls.size(); ++i) link(static_cast<int>(i));
  }

  std::vector<Point> points;
  std::vector<Wall> walls;

  const Point& from(int wall) const { return points[static_cast<std::size_t>(at(wall).from)]; }
  const Point& to(int wall) const { return points[static_cast<std::size_t>(at(wall).to)]; }
  const Wall& at(int wall) const { return walls[static_cast<std::size_t>(wall)]; }
  Point heading(int wall) const { return to(wall) - from(wall); }

  /// At the start of a wall: whether a direction leads into free space; `closed`: or along an edge.
  bool opens(int wall, const Point& way, bool closed) const {
    const Point in = heading(at(wall).previous);
    const Point out = heading(wall);
    const int least = closed ? 0 : 1;
    const bool left_of_in = cross(in, way).sign() >= least;
    const bool left_of_out = cross(out, way).sign() >= least;
    return cross(in, out).sign() > 0 ? left_of_in && left_of_out : left_of_in || left_of_out;
  }

 private:
  int point_number(const Point& p) {
    const auto [found, is_new] = numbers_.try_emplace(p, static_cast<int>(points.size()));
    if (is_new) points.push_back(p);
    return found->second;
  }

  void add_edge(const std::vector<Ring>& rings, std::size_t ring, std::size_t edge,
                std::set<std::pair<int, int>>& stretches) {
    const Point a = corner(rings[ring][edge]);
    const Point b = corner(rings[ring][(edge + 1) % rings[ring].size()]);
    const Point ab = b - a;
    std::vector<Rational> cuts{kZero, kOne};
    const auto cut = [&cuts](const Rational& t) {
      if (kZero < t && t < kOne) cuts.push_back(t);
    };
    for (std::size_t i = 0; i < rings.size(); ++i) {
      if (i == ring) continue;
      for (std::size_t k = 0; k < rings[i].size(); ++k) {
        const Point c = corner(rings[i][k]);
        const Point d = corner(rings[i][(k + 1) % rings[i].size()]);
        const Rational across = cross(ab, d - c);
        if (across.sign() == 0) {
          if (cross(ab, c - a).sign() != 0) continue;
          cut(dot(c - a, ab) / dot(ab, ab));
          cut(dot(d - a, ab) / dot(ab, ab));
          continue;
        }
        const Rational u = cross(c - a, ab) / across;
        if (u < kZero || kOne < u) continue;
        cut(cross(c - a, d - c) / across);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (cuts[i] == cuts[i + 1]) continue;
      const Point p = along(a, b, cuts[i]);
      const Point q = along(a, b, cuts[i + 1]);
      const Point middle = along(p, q, kOne / Rational(2));
      const bool covered = std::any_of(rings.begin(), rings.end(), [&middle](const Ring& other) {
        return strictly_inside(other, middle);
      });
      if (!covered) stretches.insert({point_number(p), point_number(q)});
    }
  }

  void link(int wall) {
    const Point back = from(wall) - to(wall);
    const auto half = [&back](const Point& way) { return cross(back, way).sign(); };
    int best = -1;
    for (std::size_t i = 0; i < walls.size(); ++i) {
      if (walls[i].from != at(wall).to) continue;
      if (best >= 0) {
        const Point way = heading(static_cast<int>(i));
        const Point best_way = heading(best);
        const bool sooner = half(way) != half(best_way) ? half(way) < half(best_way)
                                                        : cross(way, best_way).sign() < 0;
        if (!sooner) continue;
      }
      best = static_cast<int>(i);
    }
    walls[static_cast<std::size_t>(wall)].next = best;
    walls[static_cast<std::size_t>(best)].previous = wall;
  }

  std::map<Point, int, Before> numbers_;
};

/// A place on an outline; `t`: the share of the wall that is behind.
struct Place {
  int wall = 0;
  Rational t;
  Point point;
};

struct Stroke {
  Place hit;
  Rational share;  ///< of the way to the destination
};

/// Where the way from a point to the destination is first blocked, beyond the share `begin`.
std::optional<Stroke> first_stroke(const World& world, const Point& start, const Point& goal,
                                   const Rational& begin) {
  const Point way = goal - start;
  const Point back = start - goal;
  std::optional<Stroke> first;
  const auto offer = [&](const Stroke& stroke) {
    if (stroke.share < begin || !(stroke.share < kOne)) return;
    if (!first || stroke.share < first->share) first = stroke;
  };
  for (int i = 0; i < static_cast<int>(world.walls.size()); ++i) {
    const Rational at_from = cross(way, world.from(i) - start);
    const Rational at_to = cross(way, world.to(i) - start);
    if (at_from.sign() < 0 && at_to.sign() > 0) {
      const Rational t = at_from / (at_from - at_to);
      const Point p = along(world.from(i), world.to(i), t);
      offer({{i, t, p}, dot(p - start, way) / dot(way, way)});
    } else if (at_from.sign() == 0) {
      const Rational share = dot(world.from(i) - start, way) / dot(way, way);
      if (!(begin < share) || world.opens(i, way, true) || !world.opens(i, back, true)) continue;
      offer({{i, kZero, world.from(i)}, share});
    }
  }
  return first;
}

class Bug {
 public:
  Bug(const std::vector<Ring>& rings, const LatticePoint& start, const LatticePoint& destination)
      : world_(rings), start_(corner(start)), goal_(corner(destination)) {}

  OracleResult bug2() {
    Rational share = kZero;
    const Point way = goal_ - start_;
    Point here = start_;
    while (true) {
      const auto stroke = first_stroke(world_, start_, goal_, share);
      if (!stroke) return end(true, here, goal_);
      length_ += distance(here, stroke->hit.point);
      Place place = stroke->hit;
      while (true) {
        // On the rest of this wall: the destination, the line, the hit; whichever comes first.
        const Rational at_from = cross(way, world_.from(place.wall) - start_);
        const Rational at_to = cross(way, world_.to(place.wall) - start_);
        std::optional<Rational> leave;
        if (at_from.sign() * at_to.sign() < 0) {
          const Rational t = at_from / (at_from - at_to);
          const Point p = along(world_.from(place.wall), world_.to(place.wall), t);
          const Rational at = dot(p - start_, way) / dot(way, way);
          if (place.t < t && stroke->share < at && !(kOne < at) &&
              cross(world_.heading(place.wall), goal_ - p).sign() > 0) {
            leave = t;
          }
        }
        const std::optional<Rational> goal = goal_on(place);
        if (goal) return end(true, place.point, goal_);
        const bool back = place.wall == stroke->hit.wall && place.t < stroke->hit.t;
        if (leave && (!back || !(stroke->hit.t < *leave))) {
          here = along(world_.from(place.wall), world_.to(place.wall), *leave);
          length_ += distance(place.point, here);
          share = dot(here - start_, way) / dot(way, way);
          break;
        }
        if (back) return end(false, place.point, stroke->hit.point);
        next(place);
        if (same(place.point, goal_)) return end(true, goal_, goal_);
        const Rational at = dot(place.point - start_, way) / dot(way, way);
        // Where walls meet in the point of the hit, the line may be open on another side of it.
        if (cross(way, place.point - start_).sign() == 0 && !(at < stroke->share) && !(kOne < at) &&
            world_.opens(place.wall, goal_ - place.point, false)) {
          here = place.point;
          share = at;
          break;
        }
        if (place.wall == stroke->hit.wall && stroke->hit.t == kZero) {
          return end(false, goal_, goal_);
        }
      }
    }
  }

  OracleResult bug1() {
    Point here = start_;
    while (true) {
      const auto stroke = first_stroke(world_, here, goal_, kZero);
      if (!stroke) return end(true, here, goal_);
      length_ += distance(here, stroke->hit.point);
      Place place = stroke->hit;
      Place nearest = place;
      Rational least = dot(goal_ - place.point, goal_ - place.point);
      double round = 0;
      double round_to_nearest = 0;
      for (bool back = false; !back;) {
        if (goal_on(place)) return end(true, place.point, goal_);
        const Place before = place;
        Rational last = kOne;
        if (place.wall == stroke->hit.wall && place.t < stroke->hit.t) {
          back = true;
          last = stroke->hit.t;
        }
        const Point heading = world_.heading(place.wall);
        const Point a = world_.from(place.wall);
        Rational t = dot(goal_ - a, heading) / dot(heading, heading);
        if (t < place.t) t = place.t;
        if (last < t) t = last;
        const Point p = along(a, world_.to(place.wall), t);
        const Rational square = dot(goal_ - p, goal_ - p);
        Place there{place.wall, t, p};
        if (t == kOne) there = {world_.at(place.wall).next, kZero, p};
        const bool other_side = same(p, nearest.point) && !leaves(nearest) && leaves(there);
        if (square < least || other_side) {
          least = square;
          nearest = there;
          round_to_nearest = round + distance(before.point, p);
        }
        if (back) {
          length_ += distance(place.point, stroke->hit.point);
          round += distance(place.point, stroke->hit.point);
          break;
        }
        next(place);
        round += distance(before.point, place.point);
        if (same(place.point, goal_)) return end(true, goal_, goal_);
        back = place.wall == stroke->hit.wall && stroke->hit.t == kZero;
      }
      length_ += std::min(round_to_nearest, round - round_to_nearest);
      if (!leaves(nearest)) return end(false, goal_, goal_);
      here = nearest.point;
    }
  }

 private:
  bool leaves(const Place& place) const {
    return kZero < place.t ? cross(world_.heading(place.wall), goal_ - place.point).sign() > 0
                           : world_.opens(place.wall, goal_ - place.point, false);
  }

  std::optional<Rational> goal_on(const Place& place) const {
    const Point heading = world_.heading(place.wall);
    const Point way = goal_ - world_.from(place.wall);
    if (cross(heading, way).sign() != 0) return std::nullopt;
    const Rational t = dot(way, heading) / dot(heading, heading);
    if (!(place.t < t) || !(t < kOne)) return std::nullopt;
    return t;
  }

  void next(Place& place) {
    const Point end = world_.to(place.wall);
    length_ += distance(place.point, end);
    place = {world_.at(place.wall).next, kZero, end};
  }

  OracleResult end(bool reached, const Point& from, const Point& to) {
    return {reached, length_ + distance(from, to)};
  }

  World world_;
  Point start_;
  Point goal_;
  double length_ = 0;
};

/// Whether the straight way between two points stays out of all interiors: between two points where
/// it meets borders all of it is in or out.
bool free_between(const std::vector<Ring>& rings, const Point& p, const Point& q) {
  std::vector<Rational> cuts{kZero, kOne};
  const Point pq = q - p;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = corner(ring[i]);
      const Point b = corner(ring[(i + 1) % ring.size()]);
      const Rational across = cross(pq, b - a);
      if (across.sign() == 0) continue;
      const Rational t = cross(a - p, b - a) / across;
      if (kZero < t && t < kOne) cuts.push_back(t);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Point middle = along(p, q, (cuts[i] + cuts[i + 1]) / Rational(2));
    for (const Ring& ring : rings) {
      if (strictly_inside(ring, middle)) return false;
    }
  }
  return true;
}

}  // namespace

double rational_shortest(const std::vector<Ring>& rings, const LatticePoint& start,
                         const LatticePoint& destination) {
  std::vector<Point> points{corner(start), corner(destination)};
  for (const Ring& ring : rings) {
    for (const LatticePoint& each : ring) points.push_back(corner(each));
  }
  const std::size_t size = points.size();
  constexpr double kNone = 1e300;
  std::vector<double> cost(size * size, kNone);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = i; j < size; ++j) {
      if (!free_between(rings, points[i], points[j])) continue;
      cost[i * size + j] = cost[j * size + i] = distance(points[i], points[j]);
    }
  }
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) {
        cost[i * size + j] = std::min(cost[i * size + j], cost[i * size + k] + cost[k * size + j]);
      }
    }
  }
  return cost[1] < kNone / 2 ? cost[1] : -1;
}

OracleResult rational_bug1(const std::vector<Ring>& rings, const LatticePoint& start,
                           const LatticePoint& destination) {
  return Bug(rings, start, destination).bug1();
}

OracleResult rational_bug2(const std::vector<Ring>& rings, const LatticePoint& start,
                           const LatticePoint& destination) {
  return Bug(rings, start, destination).bug2();
}

std::vector<double> rational_loops(const std::vector<Ring>& rings) {
  const World world(rings);
  std::vector<double> lengths;
  std::vector<bool> seen(world.walls.size(), false);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i]) continue;
    double length = 0;
    for (int wall = static_cast<int>(i); !seen[static_cast<std::size_t>(wall)];
         wall = world.at(wall).next) {
      seen[static_cast<std::size_t>(wall)] = true;
      length += distance(world.from(wall), world.to(wall));
    }
    lengths.push_back(length);
  }
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

}  // namespace rubicon::travel
