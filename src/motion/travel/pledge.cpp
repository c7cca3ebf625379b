#include "src/motion/travel/methods.hpp"

namespace rubicon::travel {
namespace {

/// Degrees; turns are sums of rounded angles, and a counter that came back to 0 is 0. Corners on
/// the lattice turn by far more, or exactly not.
constexpr double kNoTurn = 1e-9;

Aim compass_of(const Walker& walker) {
  const Vec2& compass = walker.settings().compass;
  if (compass.x() != 0 || compass.y() != 0) return {snap(compass.normalized() * 1024), true};
  return {{walker.destination().x - walker.start().x, walker.destination().y - walker.start().y},
          true};
}

}  // namespace

TravelResult travel_pledge(Walker walker) {
  const Aim north = compass_of(walker);
  const ExactPoint destination(walker.destination());
  ExactPoint from(walker.start());
  while (true) {
    walker.set_mode(Mode::kTowards);
    Leg leg(from, north);
    // Where the destination is straight ahead the way ends there.
    if (side(leg.from(), leg.through(), destination) == 0 && leg.distance_of(destination.p) >= 0) {
      leg = Leg(from, walker.aim());
    }
    switch (walker.go(leg)) {
      case Walker::Outcome::kArrived:
        return walker.finish(Verdict::kReached, EventKind::kReached);
      case Walker::Outcome::kEndless:
        return walker.finish(Verdict::kReached, EventKind::kEscaped);
      case Walker::Outcome::kLimit:
        return walker.finish(Verdict::kLimit, EventKind::kLimit);
      case Walker::Outcome::kPushed:
        from = walker.exact_position();
        continue;
      case Walker::Outcome::kHit:
        walker.note(EventKind::kHit);
    }
    walker.set_mode(Mode::kSearching);
    const double zero = walker.turned() - angle_between(leg.direction(), walker.edge().heading);
    while (true) {
      const Stop stop = walker.follow({});
      if (stop.destination) return walker.finish(Verdict::kReached, EventKind::kReached);
      if (stop.limit) return walker.finish(Verdict::kLimit, EventKind::kLimit);
      if (walker.turned() - zero <= kNoTurn) break;
    }
    walker.note(EventKind::kClear);
    from = walker.exact_position();
  }
}

}  // namespace rubicon::travel
