#include "src/motion/coverage/frame.hpp"

#include <cmath>

#include "src/motion/math/angles.hpp"

namespace rubicon::coverage {
namespace {

std::int64_t rounded(double value) {
  return static_cast<std::int64_t>(value < 0 ? value - 0.5 : value + 0.5);
}

}  // namespace

Frame Frame::of_quarter(int quarter) {
  Frame frame;
  frame.cosine_ = quarter == 0 ? 1 : 0;
  frame.sine_ = quarter == 0 ? 0 : 1;
  return frame;
}

Frame Frame::along(const Point& direction) {
  const double length = distance({0, 0}, direction);
  Frame frame;
  frame.cosine_ = static_cast<double>(direction.x) / length;
  frame.sine_ = static_cast<double>(direction.y) / length;
  return frame;
}

double Frame::direction_deg() const {
  const double angle = math::atan2_deg(sine_, cosine_);
  if (angle < 0) return angle + 180;
  return angle >= 180 ? angle - 180 : angle;
}

Point Frame::turned(const Point& p) const {
  const auto x = static_cast<double>(p.x);
  const auto y = static_cast<double>(p.y);
  return {rounded(cosine_ * x + sine_ * y), rounded(cosine_ * y - sine_ * x)};
}

Place Frame::back(const Point& p) const {
  const Place place = metres(p);
  return {cosine_ * place.x - sine_ * place.y, sine_ * place.x + cosine_ * place.y};
}

Floor Frame::turned(const Floor& floor) const {
  Floor result = floor;
  for (Point& p : result.outline) p = turned(p);
  for (Hole& hole : result.holes) {
    const Box box = box_of(hole.ring);
    for (Point& p : hole.ring) p = turned(p);
    if (hole.round && !is_exact()) {
      // The square around a round column is parallel to the lines in every frame.
      const Point centre =
          turned(Point{(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2});
      const std::int64_t half = (box.width() + 1) / 2 + 1;
      hole.ring =
          Box{{centre.x - half, centre.y - half}, {centre.x + half, centre.y + half}}.ring();
    }
  }
  for (BeamLine& beam : result.beams) beam = {turned(beam.from), turned(beam.to), beam.number};
  return result;
}

}  // namespace rubicon::coverage
