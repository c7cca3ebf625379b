#include <algorithm>
#include <optional>
#include <stdexcept>

#include "src/motion/travel/methods.hpp"
#include "src/motion/travel/vision.hpp"

namespace rubicon::travel {
namespace {

/// m; the robot is at its intermediate target when it is nearer than this.
constexpr double kThere = 1e-7;

/// A place on an outline.
struct Spot {
  int composite = 0;
  int edge = 0;
  double along = 0;
};

/// VisBug-21 (Lumelsky, Sensing, Intelligence, Motion, 2006, chapter 3; Lumelsky and Skewis 1990).
/// Its intermediate target T_i runs along the way of Bug2 as far as the robot sees.
class VisBug {
 public:
  explicit VisBug(Walker& walker)
      : walker_(walker), line_(ExactPoint(walker.start()), walker.aim()) {}

  TravelResult run() {
    if (!(walker_.settings().vision > 0)) {
      throw std::invalid_argument("visbug21 needs a vision of more than 0 m");
    }
    walker_.set_mode(Mode::kTowards);
    place_target_on_line(0);
    while (true) {
      compute_target();
      if (unreachable_) return walker_.finish(Verdict::kUnreachable, EventKind::kBack);
      if (walker_.at_limit()) return walker_.finish(Verdict::kLimit, EventKind::kLimit);
      if (at_target()) {
        if (sees_destination_) return walker_.finish(Verdict::kReached, EventKind::kReached);
        on_outline_ ? step_along_outline() : step_along_line();
      } else {
        step_to_target();
      }
    }
  }

 private:
  const Outline& outline() const { return walker_.outline(); }
  const Composite& composite() const {
    return outline().composites()[static_cast<std::size_t>(spot_.composite)];
  }
  const Edge& edge() const { return composite().edges[static_cast<std::size_t>(spot_.edge)]; }
  const ExactPoint& node(int index) const {
    return composite().nodes[static_cast<std::size_t>(index)];
  }
  bool at_target() const { return (walker_.position() - target_).norm() <= kThere; }

  void place_target_on_line(double at) {
    on_outline_ = false;
    on_line_ = true;
    at_line_ = at;
    target_ = at >= line_.length() ? line_.through().p : line_.at(at);
  }

  void place_target_on_outline(const Spot& spot) {
    on_outline_ = true;
    on_line_ = false;
    spot_ = spot;
    if (spot_.along >= edge().length - kThere) spot_ = {spot.composite, edge().next, 0};
    target_ = node(edge().from).p + spot_.along * edge().heading;
  }

  /// S1: towards the target, which is in sight.
  void step_to_target() {
    const Vec2 way = target_ - walker_.position();
    const double stride = walker_.settings().stride;
    const bool arrives = way.norm() <= stride;
    walker_.set_mode(on_outline_ ? Mode::kSearching : Mode::kTowards);
    walker_.go_to(arrives ? target_ : Vec2(walker_.position() + stride * way.normalized()));
  }

  /// S2: along the outline, where sight shows no more of it.
  void step_along_outline() {
    walker_.set_mode(Mode::kSearching);
    const double along = std::min(spot_.along + walker_.settings().stride, edge().length);
    walker_.go_to(node(edge().from).p + along * edge().heading);
  }

  /// As bug2, where sight shows no more of a line that is free.
  void step_along_line() {
    walker_.set_mode(Mode::kTowards);
    const std::optional<Hit> hit = hit_ahead();
    const double end = hit ? hit->distance : line_.length();
    place_target_on_line(std::min(at_line_ + walker_.settings().stride, end));
    walker_.go_to(target_);
  }

  /// Where the line meets the next obstacle, exactly, wherever sight has moved the target since.
  std::optional<Hit> hit_ahead() const { return first_hit(outline(), line_, free_from_, leaves_); }

  void compute_target() {
    const View view(outline(), walker_.position(), walker_.settings().vision);
    if (view.sees(line_.through().p)) {
      sees_destination_ = true;
      place_target_on_line(line_.length());
      return;
    }
    sees_destination_ = false;
    // Each pass moves the target along the way of Bug2, or ends.
    while (!unreachable_ && !walker_.at_limit()) {
      if (!on_outline_) go_on_along_line(view);
      if (on_outline_ && go_on_along_outline(view)) continue;
      if (unreachable_ || !jump_to_line(view)) return;
    }
  }

  /// Step 2.
  void go_on_along_line(const View& view) {
    const std::optional<Hit> hit = hit_ahead();
    const double end = hit ? hit->distance : line_.length();
    const double seen = end <= at_line_ + kThere
                            ? end
                            : at_line_ + (end - at_line_) * view.seen_up_to(target_, line_.at(end));
    if (hit && seen >= end - kThere) {
      place_target_on_outline({hit->composite, hit->edge, hit->along});
      hit_ = spot_;
      hit_distance_ = line_.length() - end;
      crossing_ = end;
      note(EventKind::kHit);
    } else {
      place_target_on_line(seen);
    }
  }

  /// Step 3; whether the target has come to the line and goes on along it.
  bool go_on_along_outline(const View& view) {
    while (true) {
      const Vec2 from = node(edge().from).p;
      const Vec2 to = node(edge().to).p;
      const double seen =
          spot_.along +
          (edge().length - spot_.along) * view.seen_up_to(from + spot_.along * edge().heading, to);
      if (look_for_line(seen)) return true;
      if (passes_hit(seen)) {
        unreachable_ = true;
        return false;
      }
      if (seen < edge().length - kThere) {
        if (seen > spot_.along) place_target_on_outline({spot_.composite, spot_.edge, seen});
        return false;
      }
      place_target_on_outline({spot_.composite, edge().next, 0});
      if (look_for_line_at_node()) return true;
      if (spot_.edge == hit_.edge && spot_.composite == hit_.composite && hit_.along == 0) {
        unreachable_ = true;
        return false;
      }
    }
  }

  bool passes_hit(double seen) const {
    return spot_.composite == hit_.composite && spot_.edge == hit_.edge &&
           hit_.along > spot_.along + kThere && hit_.along <= seen + kThere;
  }

  /// Whether a point of the line that the target comes to is one to leave at; notes X. At a pinch
  /// one that is no farther than the hit counts, too.
  bool counts(double at, bool opens, bool pinch = false) {
    const double to_go = line_.length() - at;
    const double most = pinch && opens ? hit_distance_ + 1e-8 : hit_distance_ - 1e-8;
    if (!(at > -kThere && to_go > -kThere && to_go < most)) return false;
    crossing_ = at;
    if (!opens) return false;
    free_from_ = at;
    leaves_ = true;
    place_target_on_line(at);
    note(EventKind::kLeave);
    return true;
  }

  bool look_for_line(double seen) {
    const ExactPoint& from = node(edge().from);
    const ExactPoint& to = node(edge().to);
    if (side(line_.from(), line_.through(), from) * side(line_.from(), line_.through(), to) >= 0) {
      return false;
    }
    const auto off = [this](const Vec2& p) {
      const Vec2 way = p - line_.from().p;
      return std::max(line_.direction().x() * way.y() - line_.direction().y() * way.x(),
                      line_.direction().y() * way.x() - line_.direction().x() * way.y());
    };
    const double share = off(from.p) / (off(from.p) + off(to.p));
    const double along = share * edge().length;
    if (along <= spot_.along + kThere || along > seen + kThere) return false;
    return counts(line_.distance_of(from.p + share * (to.p - from.p)),
                  side(edge().line_a, edge().line_b, walker_.aim()) > 0);
  }

  bool look_for_line_at_node() {
    const ExactPoint& at = node(edge().from);
    if (side(line_.from(), line_.through(), at) != 0) return false;
    return counts(line_.distance_of(at.p),
                  corner_before(composite(), spot_.edge).opens_to(walker_.aim()),
                  composite().pinch[static_cast<std::size_t>(edge().from)]);
  }

  /// Step 4: whether the robot, left of the line, sees a point of it further on.
  bool jump_to_line(const View& view) {
    const Vec2 way = walker_.position() - line_.from().p;
    const double left = line_.direction().x() * way.y() - line_.direction().y() * way.x();
    if (left < -kThere) return false;
    const double begin = on_line_ ? at_line_ : crossing_;
    const std::optional<SeenPart> seen = view.last_seen(line_.at(begin), line_.through().p);
    if (!seen) return false;
    // Sight ends at an obstacle, rounded. Where the line enters it is known exactly.
    const double to_go = line_.length() - begin;
    const double free_from = begin + seen->middle * to_go;
    double at = begin + seen->end * to_go;
    const std::optional<Hit> hit = first_hit(outline(), line_, free_from, true);
    if (hit) at = std::min(at, hit->distance);
    if (at <= begin + 1e-6) return false;
    free_from_ = free_from;
    leaves_ = true;
    place_target_on_line(at);
    note(EventKind::kTarget);
    return true;
  }

  void note(EventKind kind) {
    walker_.note_at(kind, target_, on_outline_ ? edge().owner.piece : -1);
  }

  Walker& walker_;
  Leg line_;
  // The target:
  Vec2 target_{0, 0};
  bool on_outline_ = false;
  bool on_line_ = true;
  Spot spot_;             ///< where it is on an outline
  double at_line_ = 0;    ///< m from the start, where it is on the line
  double free_from_ = 0;  ///< m from the start, where the line was last known to be free
  bool leaves_ = false;   ///< and it leaves an outline there that is known to let it
  Spot hit_;              ///< H, and how far from the destination it is
  double hit_distance_ = 0;
  double crossing_ = 0;  ///< X, m from the start
  bool sees_destination_ = false;
  bool unreachable_ = false;
};

}  // namespace

TravelResult travel_visbug21(Walker walker) { return VisBug(walker).run(); }

}  // namespace rubicon::travel
