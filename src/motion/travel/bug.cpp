#include <algorithm>
#include <limits>
#include <optional>

#include "src/motion/travel/methods.hpp"

namespace rubicon::travel {
namespace {

/// m; a point is nearer than another one only by more than this, so that of equally near ones the
/// first counts whatever the rounding.
constexpr double kNearer = 1e-9;

/// The point of an outline nearest to the destination, with the way to it round the outline.
struct Nearest {
  double distance = 0;  ///< m, from the destination
  double round = 0;     ///< m, from the hit on, in the sense of walking
  int edge = 0;
  double along = 0;
};

class Bug1 {
 public:
  explicit Bug1(Walker& walker) : walker_(walker) {}

  TravelResult run() {
    ExactPoint from(walker_.start());
    while (true) {
      walker_.set_mode(Mode::kTowards);
      switch (walker_.go(Leg(from, walker_.aim()))) {
        case Walker::Outcome::kArrived:
          return walker_.finish(Verdict::kReached, EventKind::kReached);
        case Walker::Outcome::kHit:
          break;
        default:
          return walker_.finish(Verdict::kLimit, EventKind::kLimit);
      }
      walker_.note(EventKind::kHit);
      walker_.set_mode(Mode::kSearching);
      const Stop stop = go_round();
      if (stop.destination) return walker_.finish(Verdict::kReached, EventKind::kReached);
      if (stop.limit) return walker_.finish(Verdict::kLimit, EventKind::kLimit);
      walker_.note(EventKind::kNearest);
      if (!leaves()) return walker_.finish(Verdict::kUnreachable, EventKind::kBack);
      from = nearest_.along == 0
                 ? walker_.exact_position()
                 : foot(walker_.edge().line_a, walker_.edge().line_b, walker_.destination());
    }
  }

 private:
  const Composite& composite() const {
    return walker_.outline().composites()[static_cast<std::size_t>(walker_.composite())];
  }
  const Edge& edge(int index) const { return composite().edges[static_cast<std::size_t>(index)]; }

  /// Once round the outline, then the shorter way to its nearest point.
  Stop go_round() {
    const Mark hit = walker_.here();
    nearest_ = {walker_.distance_to_destination(), 0, walker_.edge_index(), walker_.along()};
    Watches watches;
    watches.mark = &hit;
    double round = 0;
    Stop stop;
    while (!stop.mark) {
      const int on = walker_.edge_index();
      const double begin = walker_.along();
      stop = walker_.follow(watches);
      if (stop.destination || stop.limit) return stop;
      const double end = stop.node ? edge(on).length : walker_.along();
      look_at(on, begin, end, round);
      round += end - begin;
    }
    if (nearest_.round == 0) return stop;
    if (nearest_.round > round - nearest_.round) {
      walker_.follow_back(nearest_.edge, nearest_.along);
      return stop;
    }
    const Vec2 from = composite().nodes[static_cast<std::size_t>(edge(nearest_.edge).from)].p;
    const Vec2 heading = edge(nearest_.edge).heading;
    const Mark there{from + nearest_.along * heading, heading};
    watches.mark = &there;
    do {
      stop = walker_.follow(watches);
    } while (!stop.mark && !stop.limit);
    return stop;
  }

  /// Looks at a stretch of an edge that begins `round` metres from the hit.
  void look_at(int index, double begin, double end, double round) {
    const Edge& on = edge(index);
    const Vec2 from = composite().nodes[static_cast<std::size_t>(on.from)].p;
    const Vec2 goal = metres(walker_.destination());
    const double along = std::clamp(on.heading.dot(goal - from), begin, end);
    const double distance = (from + along * on.heading - goal).norm();
    const bool at_end = along == on.length;
    const bool is_nearer = distance < nearest_.distance - kNearer;
    if (!is_nearer && !(at_end && opens_pinch(on.next, distance))) return;
    nearest_ = {distance, round + along - begin, at_end ? on.next : index, at_end ? 0 : along};
  }

  /// Whether the node where an edge starts is as near as the nearest point, and lets the robot go
  /// on where that does not: obstacles meet there, and it came to another side of it first.
  bool opens_pinch(int edge, double distance) const {
    const Composite& at = composite();
    if (!at.pinch[static_cast<std::size_t>(this->edge(edge).from)]) return false;
    return distance < nearest_.distance + kNearer && !leaves() &&
           corner_before(at, edge).opens_to(walker_.aim());
  }

  bool leaves() const {
    const Edge& on = edge(nearest_.edge);
    if (nearest_.along > 0) return side(on.line_a, on.line_b, walker_.aim()) > 0;
    return corner_before(composite(), nearest_.edge).opens_to(walker_.aim());
  }

  Walker& walker_;
  Nearest nearest_;
};

/// The line from start to destination crosses an edge properly, or changes from free to covered at
/// a node.
int crossings_of(const Composite& composite, int loop, const Leg& line) {
  int count = 0;
  for (std::size_t i = 0; i < composite.edges.size(); ++i) {
    const Edge& edge = composite.edges[i];
    if (edge.loop != loop) continue;
    const ExactPoint& from = composite.nodes[static_cast<std::size_t>(edge.from)];
    const ExactPoint& to = composite.nodes[static_cast<std::size_t>(edge.to)];
    const int at_from = side(line.from(), line.through(), from);
    const int at_to = side(line.from(), line.through(), to);
    Vec2 point = from.p;
    if (at_from * at_to < 0) {
      const Vec2& d = line.direction();
      const auto off = [&](const Vec2& p) {
        const Vec2 way = p - line.from().p;
        return std::max(d.x() * way.y() - d.y() * way.x(), d.y() * way.x() - d.x() * way.y());
      };
      point += off(from.p) / (off(from.p) + off(to.p)) * (to.p - from.p);
    } else if (at_from != 0) {
      continue;
    } else {
      const Corner corner = corner_before(composite, static_cast<int>(i));
      if (corner.admits(line.aim()) == corner.admits(line.aim(), true)) continue;
    }
    const double distance = line.distance_of(point);
    if (distance > -kNearer && distance < line.length() + kNearer) ++count;
  }
  return count;
}

double distance_to_loop(const Composite& composite, int loop, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Edge& edge : composite.edges) {
    if (edge.loop != loop) continue;
    const Vec2 from = composite.nodes[static_cast<std::size_t>(edge.from)].p;
    const double along = std::clamp(edge.heading.dot(p - from), 0.0, edge.length);
    least = std::min(least, (from + along * edge.heading - p).norm());
  }
  return least;
}

}  // namespace

TravelResult travel_bug1(Walker walker) { return Bug1(walker).run(); }

TravelResult travel_bug2(Walker walker) {
  const Leg line(ExactPoint(walker.start()), walker.aim());
  std::optional<Leg> leg = line;
  while (true) {
    walker.set_mode(Mode::kTowards);
    const Walker::Outcome outcome = walker.go(*leg);
    if (outcome == Walker::Outcome::kArrived) {
      return walker.finish(Verdict::kReached, EventKind::kReached);
    }
    if (outcome == Walker::Outcome::kLimit) {
      return walker.finish(Verdict::kLimit, EventKind::kLimit);
    }
    if (outcome == Walker::Outcome::kPushed) {
      leg = Leg(walker.exact_position(), walker.aim());
      continue;
    }
    walker.note(EventKind::kHit);
    walker.set_mode(Mode::kSearching);
    const Mark hit = walker.here();
    const LineWatch watch{line, walker.distance_to_destination()};
    Watches watches;
    watches.line = &watch;
    watches.mark = &hit;
    while (true) {
      const Stop stop = walker.follow(watches);
      if (stop.destination) return walker.finish(Verdict::kReached, EventKind::kReached);
      if (stop.limit) return walker.finish(Verdict::kLimit, EventKind::kLimit);
      if (stop.line) break;
      if (stop.mark) return walker.finish(Verdict::kUnreachable, EventKind::kBack);
    }
    walker.note(EventKind::kLeave);
    leg = line;
  }
}

Bound bug1_bound(const Outline& outline, const LatticePoint& start,
                 const LatticePoint& destination) {
  Bound bound;
  const Leg line(ExactPoint(start), {destination, false});
  bound.distance = line.length();
  for (const Composite& composite : outline.composites()) {
    for (std::size_t i = 0; i < composite.loops.size(); ++i) {
      const int loop = static_cast<int>(i);
      bound.crossings += crossings_of(composite, loop, line);
      if (distance_to_loop(composite, loop, metres(destination)) > bound.distance) continue;
      bound.perimeters += composite.loops[i].length;
    }
  }
  bound.length = bound.distance + 1.5 * bound.perimeters;
  return bound;
}

Bound bug2_bound(const Outline& outline, const LatticePoint& start,
                 const LatticePoint& destination) {
  Bound bound;
  const Leg line(ExactPoint(start), {destination, false});
  bound.distance = line.length();
  bound.length = bound.distance;
  for (const Composite& composite : outline.composites()) {
    for (std::size_t i = 0; i < composite.loops.size(); ++i) {
      const int crossings = crossings_of(composite, static_cast<int>(i), line);
      if (crossings == 0) continue;
      bound.crossings += crossings;
      bound.perimeters += composite.loops[i].length;
      // Each time the line enters the outline there is at most one round: half of the crossings,
      // and one more where the destination or the start is enclosed.
      const int rounds = (crossings + 1) / 2;
      bound.length += rounds * composite.loops[i].length;
    }
  }
  return bound;
}

}  // namespace rubicon::travel
