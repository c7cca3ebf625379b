#pragma once

#include <optional>
#include <vector>

#include "src/motion/travel/outline.hpp"

namespace rubicon::travel {

/// A part of a way that is seen, as shares of the way: it is free in its middle.
struct SeenPart {
  double middle = 0;
  double end = 0;
};

/// What can be seen from a point, up to some metres, past standing obstacles. Sight along an edge
/// and past a corner is free, through a point where obstacles meet it is not. Places nearer than
/// 0.1 um count as the same: the eye stands where motion has brought it, rounded.
class View {
 public:
  View(const Outline& outline, const Vec2& eye, double radius);

  bool sees(const Vec2& p) const;
  /// How far from a, as a share of the way to b, everything is seen; a itself is taken to be.
  double seen_up_to(const Vec2& a, const Vec2& b) const;
  /// The last part of the way from a to b that is seen and free, if any.
  std::optional<SeenPart> last_seen(const Vec2& a, const Vec2& b) const;

 private:
  struct Wall {
    Vec2 from{0, 0};
    Vec2 to{0, 0};
    Vec2 heading{0, 0};
  };
  /// A point where obstacles touch: the directions in and out of each of its corners.
  struct Pinch {
    Vec2 point{0, 0};
    Vec2 in{0, 0};
    Vec2 out{0, 0};
    bool turns_left = false;
  };

  bool blocks(const Wall& wall, const Vec2& p, const Vec2& along, double length) const;
  bool passes_pinches(const Vec2& along, double length) const;
  bool in_the_open(const Vec2& p) const;
  /// Where on the way from a to b sight may begin or end; with 0 and 1.
  std::vector<double> breaks(const Vec2& a, const Vec2& b) const;

  const Outline& outline_;
  Vec2 eye_;
  double radius_;
  std::vector<Wall> walls_;  ///< within the radius
  std::vector<Pinch> pinches_;
};

}  // namespace rubicon::travel
