#pragma once

#include <vector>

#include "src/motion/math/pose.hpp"

namespace rubicon::ifc {

/// An arc is replaced by chords that turn by at most this much, as the library does with circles.
inline constexpr double kChordTurnDeg = 10;
/// They lie at most this far (metres) inside of the arc ...
inline constexpr double kChordSagitta = 1e-3;
/// ... unless that took more chords than one for each degree: above 26 m of radius.
inline constexpr double kSmallestChordTurnDeg = 1;

/// How much a chord of an arc turns at most. `radius` in metres.
double chord_turn_deg(double radius);

/// An arc of a circle or ellipse: centre + cos a * x + sin a * y, from angle `from_deg` on over
/// `turn_deg`, which may be negative.
struct Arc {
  math::Vec3 centre = math::Vec3::Zero();
  math::Vec3 x = math::Vec3::UnitX();
  math::Vec3 y = math::Vec3::UnitY();
  double from_deg = 0;
  double turn_deg = 360;
};

/// Adds the ends of the chords of an arc, all but the first. A whole circle gets a multiple of four
/// of them, so that it is as wide as it says.
void add_chords(const Arc& arc, double metres_per_unit, std::vector<math::Vec3>& out);

/// The first point of an arc.
math::Vec3 arc_start(const Arc& arc);

/// A corner of an outline that may be rounded.
struct RoundCorner {
  math::Vec3 at = math::Vec3::Zero();
  double radius = 0;  ///< 0 and below: sharp
};

/// The outline, z 0, with its round corners as chords. A corner whose sides are too short for its
/// radius stays sharp.
std::vector<math::Vec3> rounded(const std::vector<RoundCorner>& corners, double metres_per_unit);

/// An open line in space, all its corners rounded with one radius as above.
std::vector<math::Vec3> rounded_line(const std::vector<math::Vec3>& line, double radius,
                                     double metres_per_unit);

}  // namespace rubicon::ifc
