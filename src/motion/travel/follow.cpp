#include <algorithm>
#include <cmath>
#include <limits>

#include "src/motion/travel/walker.hpp"

namespace rubicon::travel {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();
/// m; places on one edge that are nearer to each other are the same place.
constexpr double kSameSpot = 1e-8;
/// m; how near to a mark or trail, which are known in metres, an edge passes to be on it.
constexpr double kOnIt = 1e-7;

std::size_t of(int index) { return static_cast<std::size_t>(index); }

/// Whether a point of the watched line counts: it is nearer, or `here_too` no farther.
bool counts(const LineWatch& watch, const Vec2& point, bool here_too = false) {
  const double distance = watch.line.distance_of(point);
  const double most = here_too ? watch.nearer_than + kSameSpot : watch.nearer_than - kSameSpot;
  return distance > -kSameSpot && distance < watch.line.length() + kSameSpot &&
         watch.line.length() - distance < most;
}

/// Whether a walk in a direction from a point on is at the mark, and how far on.
double distance_to_mark(const Mark& mark, const Vec2& from, const Vec2& heading) {
  if (heading.dot(mark.heading) < 1 - 1e-12) return kNowhere;
  const Vec2 way = mark.point - from;
  if (std::fabs(heading.x() * way.y() - heading.y() * way.x()) > kOnIt) return kNowhere;
  return heading.dot(way);
}

/// How far from the start of an edge it first meets a part of a trail, from `begin` on.
double distance_to_part(const TrailPart& part, const Vec2& from, const Vec2& heading, double begin,
                        double length) {
  const auto off = [&](const Vec2& p) {
    return heading.x() * (p - from).y() - heading.y() * (p - from).x();
  };
  const double off_a = off(part.from);
  const double off_b = off(part.to);
  if (std::min(off_a, off_b) > kOnIt || std::max(off_a, off_b) < -kOnIt) return kNowhere;
  const double a = heading.dot(part.from - from);
  const double b = heading.dot(part.to - from);
  double met;
  if (std::fabs(off_a) <= kOnIt && std::fabs(off_b) <= kOnIt) {
    // Along the edge: where it comes onto the part; who is on it already has been told.
    met = std::min(a, b);
  } else {
    met = a + (b - a) * std::clamp(off_a / (off_a - off_b), 0.0, 1.0);
  }
  return met >= begin && met < length ? met : kNowhere;
}

/// The first part of a trail that a walk along an edge meets from `begin` on, not behind it.
struct TrailMeeting {
  double distance = kNowhere;
  std::size_t part = 0;
};
TrailMeeting meet_trail(const std::vector<TrailPart>& trail, std::uint64_t version,
                        const Vec2& from, const Vec2& heading, double begin, double length) {
  TrailMeeting first;
  if (trail.size() <= 2) return first;
  const Vec2 start = trail.front().from;
  for (std::size_t i = 0; i + 2 < trail.size(); ++i) {
    // In an outline that has not changed since only walking the same edge again counts: where
    // obstacles touch in a point the walk passes it several times.
    const Vec2 along = trail[i].to - trail[i].from;
    if (trail[i].version == version && along.dot(heading) < (1 - 1e-12) * along.norm()) continue;
    const double distance = distance_to_part(trail[i], from, heading, begin, length);
    if (distance >= first.distance) continue;
    if ((from + distance * heading - start).norm() <= kOnIt) continue;
    first = {distance, i};
  }
  return first;
}

}  // namespace

Stop Walker::follow(const Watches& watches) {
  Stop stop;
  while (true) {
    if (at_limit()) {
      stop.limit = true;
      return stop;
    }
    if (budget() <= kNoWayLeft) {
      begin_slice();
      if (world_.any_moved()) {
        stop.slice = true;
        stop.squeezed = squeezed_;
        if (squeezed_) note(EventKind::kSqueezed);
        return stop;
      }
    }
    const Composite& composite = outline().composites()[of(footing_->composite)];
    const Edge& here = edge();
    const ExactPoint& from = composite.nodes[of(here.from)];
    const ExactPoint& to = composite.nodes[of(here.to)];
    const double begin = footing_->along + kSameSpot;
    const auto ahead = [&](double distance) {
      return distance > begin && distance < here.length - kSameSpot ? distance : kNowhere;
    };

    double destination = kNowhere;
    if (side(here.line_a, here.line_b, destination_) == 0) {
      destination = ahead(here.heading.dot(metres(destination_) - from.p));
    }
    double line = kNowhere;
    if (watches.line != nullptr && side(here.line_a, here.line_b, watches.line->line.aim()) > 0) {
      const Leg& leg = watches.line->line;
      if (side(leg.from(), leg.through(), from) * side(leg.from(), leg.through(), to) < 0) {
        const auto off = [&leg](const Vec2& p) {
          const Vec2 way = p - leg.from().p;
          return std::fabs(leg.direction().x() * way.y() - leg.direction().y() * way.x());
        };
        const double share = off(from.p) / (off(from.p) + off(to.p));
        if (counts(*watches.line, from.p + share * (to.p - from.p))) {
          line = ahead(share * here.length);
        }
      }
    }
    double mark = kNowhere;
    if (watches.mark != nullptr)
      mark = ahead(distance_to_mark(*watches.mark, from.p, here.heading));
    TrailMeeting trail;
    if (watches.trail) {
      trail = meet_trail(trail_, composite.version, from.p, here.heading, begin,
                         here.length - kSameSpot);
    }

    const double event = std::min({destination, line, mark, trail.distance, here.length});
    const double reach = footing_->along + budget();
    if (reach < event) {
      advance_to(from.p + reach * here.heading);
      stand_on(footing_->composite, footing_->edge, reach);
      time_ = slice_end_;
      continue;
    }
    if (event < here.length) {
      advance_to(event == destination ? metres(destination_) : from.p + event * here.heading);
      stand_on(footing_->composite, footing_->edge, event);
      const auto now = [event](double distance) { return distance <= event + kSameSpot; };
      stop.destination = now(destination);
      stop.line = now(line);
      stop.mark = now(mark);
      stop.trail = now(trail.distance);
      stop.trail_part = trail.part;
      stop.lap = stop.trail && trail_[trail.part].version == composite.version;
      return stop;
    }
    advance_to(to.p);
    arrive_at_next_edge();
    look_at_node(watches, stop);
    return stop;
  }
}

void Walker::look_at_node(const Watches& watches, Stop& stop) const {
  const Composite& composite = outline().composites()[of(footing_->composite)];
  const ExactPoint& node = composite.nodes[of(edge().from)];
  stop.node = true;
  stop.destination = compare(node, ExactPoint(destination_)) == 0;
  if (watches.line != nullptr) {
    const Leg& leg = watches.line->line;
    // Where obstacles meet in the very point that closed the line, it may be open on another side.
    const bool pinch = composite.pinch[of(edge().from)];
    stop.line = side(leg.from(), leg.through(), node) == 0 &&
                counts(*watches.line, node.p, pinch) &&
                corner_before(composite, footing_->edge).opens_to(leg.aim());
  }
  if (watches.mark != nullptr) {
    stop.mark = std::fabs(distance_to_mark(*watches.mark, node.p, edge().heading)) <= kSameSpot;
  }
  if (watches.trail) {
    const TrailMeeting met =
        meet_trail(trail_, composite.version, node.p, edge().heading, -kSameSpot, kSameSpot);
    stop.trail = met.distance < kNowhere;
    stop.trail_part = met.part;
    stop.lap = stop.trail && trail_[met.part].version == composite.version;
  }
}

}  // namespace rubicon::travel
