#include <cmath>
#include <vector>

#include "src/motion/travel/methods.hpp"

namespace rubicon::travel {
namespace {

/// Degrees; angles are sums of rounded ones. Whether the destination is exactly ahead or behind is
/// asked of the corners.
constexpr double kNoAngle = 1e-9;

/// Simple, Tangent and ACE (Lee and Adams): towards the destination, searching, tracking.
class Tangent {
 public:
  Tangent(Walker& walker, Method method) : walker_(walker), method_(method) {}

  TravelResult run() {
    Leg leg(ExactPoint(walker_.start()), walker_.aim());
    while (true) {
      walker_.set_mode(Mode::kTowards);
      switch (walker_.go(leg)) {
        case Walker::Outcome::kArrived:
          return walker_.finish(Verdict::kReached, EventKind::kReached);
        case Walker::Outcome::kHit:
          walker_.note(EventKind::kHit);
          break;
        case Walker::Outcome::kPushed:
          leg = Leg(walker_.exact_position(), walker_.aim());
          continue;
        default:
          return walker_.finish(Verdict::kLimit, EventKind::kLimit);
      }
      begin_search(leg.direction());
      switch (follow(leg)) {
        case Exit::kClear:
          leg = Leg(walker_.exact_position(), walker_.aim());
          break;
        case Exit::kLine:
          break;
        case Exit::kDestination:
          return walker_.finish(Verdict::kReached, EventKind::kReached);
        case Exit::kUnreachable:
          return walker_.finish(Verdict::kUnreachable, EventKind::kBack);
        case Exit::kLimit:
          return walker_.finish(Verdict::kLimit, EventKind::kLimit);
      }
    }
  }

 private:
  /// How following an outline ends; kLine: on the line of the leg, which is that of the tracking.
  enum class Exit { kClear, kLine, kDestination, kUnreachable, kLimit };

  /// A place where the robot was stopped, and what stopped it.
  struct Stopped {
    Vec2 point;
    std::uint64_t version;
  };

  /// Theta (H): the heading minus the bearing of the destination, unwrapped, begun anew at a hit.
  double theta() const {
    double value = theta_at_hit_ + walker_.turned() - turned_at_hit_ -
                   (walker_.bearing_turned() - bearing_at_hit_);
    // Rounding must not decide on which side of the heading the destination is.
    const double half_turns = std::round(value / 180);
    if (std::fabs(value - 180 * half_turns) < 1e-6) {
      const int at = side(walker_.edge().line_a, walker_.edge().line_b, walker_.destination());
      const bool even = std::fmod(half_turns, 2) == 0;
      value = 180 * half_turns + (at == 0 ? 0 : (at < 0) == even ? 2e-9 : -2e-9);
    }
    return value;
  }
  /// The turn of the robot since the line to the destination was begun (R): G - Theta_ref.
  double turned_from_line() const { return line_turn_ + walker_.turned() - turned_at_hit_; }

  void begin_search(const Vec2& arriving) {
    walker_.set_mode(Mode::kSearching);
    turned_at_hit_ = walker_.turned();
    bearing_at_hit_ = walker_.bearing_turned();
    const Vec2 bearing = metres(walker_.destination()) - walker_.position();
    theta_at_hit_ = angle_between(bearing, walker_.edge().heading);
    if (theta_at_hit_ < -180 + kNoAngle) theta_at_hit_ = 180;
    line_turn_ += angle_between(arriving, walker_.edge().heading);
  }

  /// The robot turns towards the destination.
  void end_search(bool begin_new_line) {
    line_turn_ = begin_new_line ? 0 : turned_from_line() - theta();
    walker_.end_trail();
  }

  /// Whether the outline is a trap. Turned by half a turn since the line was begun, at a hit, or by
  /// a whole one at a corner, it goes round in circles; but where the direction to the destination
  /// is clear that makes no trap: the line from there would start in free space, and a round trip
  /// without meeting it again would prove nothing.
  bool trapped(bool at_hit) const {
    if (method_ == Method::kSimple) return false;
    const double angle = theta();
    if (angle > 180 + kNoAngle) return true;
    const double most = at_hit ? 180 : 360;
    return angle > kNoAngle && std::fabs(turned_from_line()) > most + kNoAngle;
  }

  bool clear(const Stop& stop) const {
    if (method_ != Method::kSimple) return theta() <= kNoAngle;
    return (stop.node || stop.slice) && open_here();
  }

  /// Whether the direction to the destination leads into free space.
  bool open_here() const {
    const Edge& edge = walker_.edge();
    if (walker_.along() > 0) return side(edge.line_a, edge.line_b, walker_.aim()) > 0;
    const Composite& composite =
        walker_.outline().composites()[static_cast<std::size_t>(walker_.composite())];
    return corner_before(composite, walker_.edge_index()).opens_to(walker_.aim());
  }

  /// Whether it has been stopped here before, by an outline that has not changed since: then it
  /// goes in circles, and from here on keeps to the line that it has come on, as bug2 does, which
  /// ends.
  bool stopped_again() {
    if (walker_.contact_moves()) return false;
    const std::uint64_t version = walker_.here_version();
    for (const Stopped& before : stopped_) {
      if (before.version == version && (before.point - walker_.position()).norm() < 1e-7)
        return true;
    }
    stopped_.push_back({walker_.position(), version});
    return false;
  }

  Exit follow(Leg& leg) {
    if (method_ != Method::kSimple) keeps_to_line_ = stopped_again() || keeps_to_line_;
    if (keeps_to_line_ || trapped(true)) {
      walker_.note(EventKind::kTrack);
      return track(leg);
    }
    while (true) {
      const Stop stop = walker_.follow({});
      if (stop.destination) return Exit::kDestination;
      if (stop.limit) return Exit::kLimit;
      if (trapped(false)) {
        walker_.note(EventKind::kTrack);
        leg = Leg(walker_.exact_position(), walker_.aim());
        return track(leg);
      }
      if (clear(stop)) {
        walker_.note(EventKind::kClear);
        end_search(false);
        return Exit::kClear;
      }
    }
  }

  Exit leave_track(EventKind why) {
    walker_.note(why);
    end_search(true);
    if (why == EventKind::kLeave) return Exit::kLine;
    keeps_to_line_ = false;
    return Exit::kClear;
  }

  /// Follows from the tracking point, which is here, with the line of a leg through it.
  Exit track(const Leg& leg) {
    walker_.set_mode(Mode::kTracking);
    const bool ace = method_ == Method::kAce;
    const LineWatch line{leg, walker_.distance_to_destination()};
    const Mark mark = walker_.here();
    walker_.begin_trail();
    Watches watches;
    watches.line = &line;
    watches.mark = &mark;
    watches.trail = ace;
    while (true) {
      if (ace && walker_.contact_moves()) return leave_track(EventKind::kTrackedMoves);
      const Stop stop = walker_.follow(watches);
      if (stop.destination) return Exit::kDestination;
      if (stop.limit) return Exit::kLimit;
      if (ace && walker_.contact_moves()) continue;
      if (stop.line) return leave_track(EventKind::kLeave);
      if (stop.mark) {
        if (!open_here()) return Exit::kUnreachable;
        // What closed the line when tracking began has moved away since.
        return leave_track(EventKind::kLeave);
      }
      if (!stop.trail) continue;
      if (clockwise_since(stop.trail_part)) return leave_track(EventKind::kRevisit);
      // Once round a room whose walls have not changed: it was closed after tracking began.
      if (stop.lap) return Exit::kUnreachable;
    }
  }

  /// Whether the loop from here along the trail, from one of its parts on, back to here is
  /// clockwise.
  bool clockwise_since(std::size_t part) const {
    const auto& trail = walker_.trail();
    const Vec2 here = walker_.position();
    double twice_area = 0;
    for (std::size_t i = part; i < trail.size(); ++i) {
      const Vec2 a = i == part ? Vec2(0, 0) : Vec2(trail[i].from - here);
      const Vec2 b = trail[i].to - here;
      twice_area += a.x() * b.y() - a.y() * b.x();
    }
    return twice_area < 0;
  }

  Walker& walker_;
  Method method_;
  double theta_at_hit_ = 0;
  double turned_at_hit_ = 0;
  double bearing_at_hit_ = 0;
  double line_turn_ = 0;
  bool keeps_to_line_ = false;
  std::vector<Stopped> stopped_;
};

}  // namespace

TravelResult travel_tangent(Walker walker, Method method) { return Tangent(walker, method).run(); }

}  // namespace rubicon::travel
