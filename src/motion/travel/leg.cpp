#include "src/motion/travel/leg.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubicon::travel {
namespace {

/// m; places on one leg that are nearer to each other are the same: a hundredth of the pitch of
/// corners and far above the rounding of distances. Which side a point is on never hangs on it.
constexpr double kSamePlace = 1e-8;

std::size_t number(int index) { return static_cast<std::size_t>(index); }

/// Whether the line of a leg from `begin` on comes near a box; on the safe side.
bool passes(const Leg& leg, double begin, const Box& box) {
  constexpr double kMargin = 1e-6;
  const Vec2 low = metres({box.low_x, box.low_y});
  const Vec2 high = metres({box.high_x, box.high_y});
  double first = begin - kMargin;
  double last = leg.length() + kMargin;
  for (int axis = 0; axis < 2; ++axis) {
    const double from = leg.from().p[axis];
    const double step = leg.direction()[axis];
    if (std::fabs(step) < 1e-12) {
      // Over the longest leg such a step adds less than the margin.
      if (from < low[axis] - kMargin || from > high[axis] + kMargin) return false;
      continue;
    }
    const double a = (low[axis] - kMargin - from) / step;
    const double b = (high[axis] + kMargin - from) / step;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last;
}

class HitFinder {
 public:
  HitFinder(const Leg& leg, double begin, bool departing)
      : leg_(leg), begin_(begin), departing_(departing) {}

  void look_at(const Composite& composite, int index) {
    sides_.clear();
    bool left = false;
    bool right = false;
    for (const ExactPoint& node : composite.nodes) {
      sides_.push_back(side(leg_.from(), leg_.through(), node));
      left = left || sides_.back() >= 0;
      right = right || sides_.back() <= 0;
    }
    if (!left || !right) return;
    for (std::size_t i = 0; i < composite.edges.size(); ++i) {
      const Edge& edge = composite.edges[i];
      if (sides_[number(edge.from)] < 0 && sides_[number(edge.to)] > 0) {
        look_at_edge(composite, index, static_cast<int>(i));
      } else if (sides_[number(edge.from)] == 0) {
        look_at_node(composite, index, static_cast<int>(i));
      }
    }
  }

  bool found() const { return found_; }
  const Hit& best() const { return best_; }

 private:
  /// The edge goes from the right of the leg to the left: the leg enters there.
  void look_at_edge(const Composite& composite, int index, int edge_index) {
    const Edge& edge = composite.edges[number(edge_index)];
    const Vec2 from = composite.nodes[number(edge.from)].p;
    const Vec2 to = composite.nodes[number(edge.to)].p;
    const Vec2& d = leg_.direction();
    const Vec2 a = from - leg_.from().p;
    const Vec2 b = to - leg_.from().p;
    const double below = -(d.x() * a.y() - d.y() * a.x());
    const double above = d.x() * b.y() - d.y() * b.x();
    double share = below / (below + above);
    if (!(share > 0)) share = 0;
    share = std::min(share, 1.0);
    const Vec2 point = from + share * (to - from);
    offer({index, edge_index, share * edge.length, leg_.distance_of(point), point});
  }

  void look_at_node(const Composite& composite, int index, int out) {
    const Edge& edge = composite.edges[number(out)];
    const ExactPoint& node = composite.nodes[number(edge.from)];
    const double distance = leg_.distance_of(node.p);
    if (distance < begin_ - kSamePlace || distance > leg_.length() - kSamePlace) return;
    const bool at_start = distance <= begin_ + kSamePlace;
    if (departing_ && at_start) return;
    const Corner corner = corner_before(composite, out);
    if (corner.admits(leg_.aim())) return;
    if (at_start) {
      // Whoever starts at a node may go wherever one of its corners lets it.
      for (std::size_t i = 0; i < composite.edges.size(); ++i) {
        if (composite.edges[i].from == edge.from &&
            corner_before(composite, static_cast<int>(i)).admits(leg_.aim())) {
          return;
        }
      }
    } else if (!corner.admits(leg_.aim(), true)) {
      return;  // the leg arrives between other edges
    }
    offer({index, out, 0, distance, node.p});
  }

  void offer(const Hit& hit) {
    if (hit.distance < begin_ - kSamePlace || hit.distance > leg_.length() - kSamePlace) return;
    if (found_ && hit.distance >= best_.distance) return;
    best_ = hit;
    found_ = true;
  }

  const Leg& leg_;
  double begin_;
  bool departing_;
  std::vector<int> sides_;
  Hit best_;
  bool found_ = false;
};

}  // namespace

Leg::Leg(const ExactPoint& from, const Aim& aim) : from_(from), aim_(aim) {
  if (aim.is_direction) {
    through_.x = from.x + times(aim.to.x, from.w);
    through_.y = from.y + times(aim.to.y, from.w);
    through_.w = from.w;
    through_.p = from.p + metres(aim.to);
    direction_ = metres(aim.to).normalized();
    length_ = std::numeric_limits<double>::infinity();
  } else {
    through_ = ExactPoint(aim.to);
    const Vec2 way = through_.p - from.p;
    length_ = way.norm();
    if (length_ > 0) direction_ = way / length_;
  }
}

std::optional<Hit> first_hit(const Outline& outline, const Leg& leg, double begin, bool departing) {
  HitFinder finder(leg, begin, departing);
  for (std::size_t i = 0; i < outline.composites().size(); ++i) {
    const Composite& composite = outline.composites()[i];
    if (composite.pieces.empty() || !passes(leg, begin, composite.box)) continue;
    finder.look_at(composite, static_cast<int>(i));
  }
  if (!finder.found()) return std::nullopt;
  return finder.best();
}

}  // namespace rubicon::travel
