#include "src/exchange/ifc/chords.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "src/motion/math/angles.hpp"

namespace rubicon::ifc {

using math::Vec3;

namespace {

Vec3 point_of(const Arc& arc, double angle_deg) {
  const math::SineCosine at = math::sine_cosine_deg(angle_deg);
  return arc.centre + at.cosine * arc.x + at.sine * arc.y;
}

/// A corner between straight sides, as an arc.
void add_corner(const RoundCorner& before, const RoundCorner& corner, const RoundCorner& after,
                double metres_per_unit, std::vector<Vec3>& out) {
  const Vec3& b = corner.at;
  const Vec3 u = (before.at - b).normalized();
  const Vec3 v = (after.at - b).normalized();
  const double cosine = u.dot(v);
  const double tangent = std::sqrt((1 - cosine) / (1 + cosine));  // of half the angle between
  const double length = corner.radius / tangent;
  // Half of a side is left to a round corner at its other end.
  const auto room = [&](const RoundCorner& other) {
    return (other.at - b).norm() * (other.radius > 0 ? 0.5 : 1) * (1 + 1e-9);
  };
  const bool fits = length > 0 && length <= std::min(room(before), room(after));
  if (!fits) {
    out.push_back(b);
    return;
  }
  const Vec3 start = b + length * u;
  const Vec3 across = u.cross(v);  // along z
  const Vec3 inward = Vec3(across.cross(u)).normalized();
  Arc arc;
  arc.centre = start + corner.radius * inward;
  arc.x = start - arc.centre;
  arc.y = -corner.radius * u;
  arc.from_deg = 0;
  arc.turn_deg = 180 - 2 * math::atan2_deg(tangent, 1);
  out.push_back(start);
  add_chords(arc, metres_per_unit, out);
}

}  // namespace

double chord_turn_deg(double radius) {
  // Sagitta = r (1 - cos(turn / 2)), which is just below r turn^2 / 8.
  const double turn = math::degrees(std::sqrt(8 * kChordSagitta / radius));
  if (!(turn < kChordTurnDeg)) return kChordTurnDeg;
  return std::max(turn, kSmallestChordTurnDeg);
}

Vec3 arc_start(const Arc& arc) { return point_of(arc, arc.from_deg); }

void add_chords(const Arc& arc, double metres_per_unit, std::vector<Vec3>& out) {
  const double radius = std::max(arc.x.norm(), arc.y.norm()) * metres_per_unit;
  const double most = chord_turn_deg(radius);
  int chords = std::max(1, static_cast<int>(std::ceil(std::fabs(arc.turn_deg) / most - 1e-9)));
  if (std::fabs(arc.turn_deg) == 360) chords = (chords + 3) / 4 * 4;
  for (int i = 1; i <= chords; ++i) {
    out.push_back(point_of(arc, arc.from_deg + arc.turn_deg * i / chords));
  }
}

std::vector<Vec3> rounded(const std::vector<RoundCorner>& corners, double metres_per_unit) {
  std::vector<Vec3> out;
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const RoundCorner& corner = corners[i];
    if (corner.radius > 0) {
      add_corner(corners[(i + count - 1) % count], corner, corners[(i + 1) % count],
                 metres_per_unit, out);
    } else {
      out.push_back(corner.at);
    }
  }
  // Neighbouring arcs may meet in one point.
  std::vector<Vec3> result;
  for (const Vec3& p : out) {
    if (result.empty() || (p - result.back()).norm() * metres_per_unit > 1e-7) result.push_back(p);
  }
  while (result.size() > 1 && (result.front() - result.back()).norm() * metres_per_unit <= 1e-7) {
    result.pop_back();
  }
  return result;
}

std::vector<Vec3> rounded_line(const std::vector<Vec3>& line, double radius,
                               double metres_per_unit) {
  if (line.size() < 3) return line;
  std::vector<RoundCorner> corners;
  for (const Vec3& p : line) corners.push_back({p, radius});
  corners.front().radius = 0;
  corners.back().radius = 0;
  std::vector<Vec3> points = rounded(corners, metres_per_unit);
  if (points.back() != line.back()) points.push_back(line.back());
  return points;
}

}  // namespace rubicon::ifc
