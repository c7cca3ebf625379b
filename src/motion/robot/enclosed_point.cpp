#include "src/motion/robot/enclosed_point.hpp"

#include <cmath>

#include "src/motion/robot/frame_chain.hpp"

namespace rubicon::robot {

namespace {

/// Turns p about the axis of the element by an angle with this sine and cosine.
void turn(FrameElement::Kind kind, const Enclosure& s, const Enclosure& c, EnclosedPoint& p) {
  const auto k = static_cast<std::size_t>(rotation_axis_index(kind));
  const std::size_t i = (k + 1) % 3;
  const std::size_t j = (k + 2) % 3;
  const Enclosure turned_i = c * p[i] - s * p[j];
  const Enclosure turned_j = s * p[i] + c * p[j];
  p[i] = turned_i;
  p[j] = turned_j;
}

}  // namespace

std::array<Enclosure, 3> enclosed_arguments(const FrameElement& element, std::span<const double> q0,
                                            std::span<const double> q1,
                                            std::span<const double> starts, double s0, double s1) {
  std::array<Enclosure, 3> arguments;
  arguments[0] = element.a.enclose(q0, q1, starts, s0, s1);
  if (element.kind == FrameElement::Kind::trans) {
    arguments[1] = element.b.enclose(q0, q1, starts, s0, s1);
    arguments[2] = element.c.enclose(q0, q1, starts, s0, s1);
  }
  return arguments;
}

void transform(const FrameElement& element, const std::array<Enclosure, 3>& arguments,
               EnclosedPoint& p) {
  if (element.kind == FrameElement::Kind::trans) {
    for (std::size_t i = 0; i < 3; ++i) p[i] = p[i] + arguments[i];
    return;
  }
  const auto [s, c] = sine_cosine(arguments[0]);
  turn(element.kind, s, c, p);
}

void transform_back(const FrameElement& element, const std::array<Enclosure, 3>& arguments,
                    EnclosedPoint& p) {
  if (element.kind == FrameElement::Kind::trans) {
    for (std::size_t i = 0; i < 3; ++i) p[i] = p[i] - arguments[i];
    return;
  }
  const auto [s, c] = sine_cosine(arguments[0]);
  turn(element.kind, -s, c, p);
}

double acceleration_of(const EnclosedPoint& p) {
  double squared = 0;
  for (const Enclosure& component : p) {
    const double most = magnitude(component.second);
    squared += most * most;
  }
  return std::sqrt(squared) * kBoundRounding;
}

}  // namespace rubicon::robot
