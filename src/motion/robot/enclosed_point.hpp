#pragma once

#include <array>
#include <span>

#include "src/motion/robot/enclosure.hpp"
#include "src/motion/robot/robot_model.hpp"

namespace rubicon::robot {

/// Part by which a bound is enlarged for the rounding of its own last few operations.
inline constexpr double kBoundRounding = 1 + 1e-14;

/// Coordinates of a point (m) over an interval of s, with two derivatives.
using EnclosedPoint = std::array<Enclosure, 3>;

/// What an element of a frame says over [s0, s1] while q runs linearly from q0 to q1.
std::array<Enclosure, 3> enclosed_arguments(const FrameElement& element, std::span<const double> q0,
                                            std::span<const double> q1,
                                            std::span<const double> starts, double s0, double s1);

/// p <- element * p.
void transform(const FrameElement& element, const std::array<Enclosure, 3>& arguments,
               EnclosedPoint& p);

/// p <- the inverse of element * p.
void transform_back(const FrameElement& element, const std::array<Enclosure, 3>& arguments,
                    EnclosedPoint& p);

/// Upper bound of |d2p/ds2| (m), enlarged for the rounding of its own last few operations.
double acceleration_of(const EnclosedPoint& p);

}  // namespace rubicon::robot
