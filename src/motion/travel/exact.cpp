#include "src/motion/travel/exact.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rubicon::travel {
namespace {

Int128 cross(Int128 ax, Int128 ay, Int128 bx, Int128 by) { return times(ax, by) - times(ay, bx); }

double metres_of(Int128 numerator, Int128 denominator) {
  // Whole part and rest apart: the quotient of two rounded numbers would lose bits far out.
  const Int128 whole = numerator / denominator;
  const Int128 rest = numerator - times(whole, denominator);
  return (static_cast<double>(whole) +
          static_cast<double>(rest) / static_cast<double>(denominator)) /
         kPitchesPerMetre;
}

ExactPoint point(Int128 x, Int128 y, Int128 w) {
  ExactPoint result;
  result.x = w < 0 ? -x : x;
  result.y = w < 0 ? -y : y;
  result.w = w < 0 ? -w : w;
  result.p = {metres_of(result.x, result.w), metres_of(result.y, result.w)};
  return result;
}

/// The sign of a determinant of metres computed in doubles, or 0 where rounding could hide it.
int certain_sign(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u = b - a;
  const Vec2 v = c - a;
  const double left = u.x() * v.y();
  const double right = u.y() * v.x();
  const double reach = std::max({std::fabs(a.x()), std::fabs(a.y()), std::fabs(b.x()),
                                 std::fabs(b.y()), std::fabs(c.x()), std::fabs(c.y())});
  // Points are rounded by 2^-52 of the reach; a factor of 8 covers all that follows from it.
  constexpr double kRounding = 8 * 2.220446049250313e-16;
  const double error =
      kRounding *
      (reach * (std::fabs(u.x()) + std::fabs(u.y()) + std::fabs(v.x()) + std::fabs(v.y())) +
       std::fabs(left) + std::fabs(right));
  const double value = left - right;
  return value > error ? 1 : value < -error ? -1 : 0;
}

int side_exactly(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  const Wide ax(a.x), ay(a.y), aw(a.w);
  const Wide bx(b.x), by(b.y), bw(b.w);
  const Wide cx(c.x), cy(c.y), cw(c.w);
  return (ax * (by * cw - cy * bw) - ay * (bx * cw - cx * bw) + aw * (bx * cy - cx * by)).sign();
}

/// The side of the middle between c and d; the determinant is linear in the middle.
int side_of_middle(const LatticePoint& a, const LatticePoint& b, const ExactPoint& c,
                   const ExactPoint& d) {
  const int certain = certain_sign(metres(a), metres(b), (c.p + d.p) / 2);
  if (certain != 0) return certain;
  const Wide nx = Wide(a.y) - Wide(b.y);
  const Wide ny = Wide(b.x) - Wide(a.x);
  const Wide n0 = Wide(cross(a.x, a.y, b.x, b.y));
  const Wide at_c = nx * Wide(c.x) + ny * Wide(c.y) + n0 * Wide(c.w);
  const Wide at_d = nx * Wide(d.x) + ny * Wide(d.y) + n0 * Wide(d.w);
  return (at_c * Wide(d.w) + at_d * Wide(c.w)).sign();
}

/// The sign of (c + d) / 2 - limit, of coordinates c/cw and d/dw in pitches; `middle` is about
/// (c + d) / 2 in metres.
int compare_middle(double middle, Int128 c, Int128 cw, Int128 d, Int128 dw, std::int64_t limit) {
  const double bound = static_cast<double>(limit) / kPitchesPerMetre;
  const double error = 1e-15 * (std::fabs(middle) + std::fabs(bound)) + 1e-9;
  if (middle > bound + error) return 1;
  if (middle < bound - error) return -1;
  const Wide both = Wide(cw) * Wide(dw) * Wide(2);
  return (Wide(c) * Wide(dw) + Wide(d) * Wide(cw) - Wide(limit) * both).sign();
}

int compare_coordinate(double near_a, double near_b, Int128 a, Int128 aw, Int128 b, Int128 bw) {
  const double difference = near_a - near_b;
  const double error = 1e-15 * (std::fabs(near_a) + std::fabs(near_b));
  if (difference > error) return 1;
  if (difference < -error) return -1;
  if (aw == 1 && bw == 1) return sign_of(a - b);
  return (Wide(a) * Wide(bw) - Wide(b) * Wide(aw)).sign();
}

}  // namespace

LatticePoint snap(const Vec2& p) {
  if (!(std::fabs(p.x()) < kReach && std::fabs(p.y()) < kReach)) {
    throw std::invalid_argument(
        "a point of the plan view is further than 524288 m from the origin");
  }
  return {std::llround(p.x() * kPitchesPerMetre), std::llround(p.y() * kPitchesPerMetre)};
}

Vec2 metres(const LatticePoint& p) {
  return {static_cast<double>(p.x) / kPitchesPerMetre, static_cast<double>(p.y) / kPitchesPerMetre};
}

ExactPoint::ExactPoint(const LatticePoint& corner) : x(corner.x), y(corner.y), p(metres(corner)) {}

ExactPoint nearby(const Vec2& p) {
  const LatticePoint whole = snap(p);
  constexpr std::int64_t kParts = std::int64_t{1} << 22;
  const Vec2 rest =
      (p * kPitchesPerMetre - Vec2(static_cast<double>(whole.x), static_cast<double>(whole.y))) *
      static_cast<double>(kParts);
  return point(times(whole.x, kParts) + std::llround(rest.x()),
               times(whole.y, kParts) + std::llround(rest.y()), kParts);
}

Int128 area(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return cross(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
}

int side(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return sign_of(area(a, b, c));
}

int side(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  const int certain = certain_sign(a.p, b.p, c.p);
  if (certain != 0) return certain;
  if (a.w == 1 && b.w == 1 && c.w == 1) {
    return sign_of(cross(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y));
  }
  return side_exactly(a, b, c);
}

int turn(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
         const LatticePoint& d) {
  return sign_of(cross(b.x - a.x, b.y - a.y, d.x - c.x, d.y - c.y));
}

int side(const LatticePoint& a, const LatticePoint& b, const Aim& aim) {
  return aim.is_direction ? turn(a, b, LatticePoint{0, 0}, aim.to) : side(a, b, aim.to);
}

int compare(const ExactPoint& a, const ExactPoint& b) {
  const int by_x = compare_coordinate(a.p.x(), b.p.x(), a.x, a.w, b.x, b.w);
  return by_x != 0 ? by_x : compare_y(a, b);
}

int compare_y(const ExactPoint& a, const ExactPoint& b) {
  return compare_coordinate(a.p.y(), b.p.y(), a.y, a.w, b.y, b.w);
}

ExactPoint crossing(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                    const LatticePoint& d) {
  const Int128 w = cross(b.x - a.x, b.y - a.y, d.x - c.x, d.y - c.y);
  const Int128 t = cross(c.x - a.x, c.y - a.y, d.x - c.x, d.y - c.y);
  return point(times(a.x, w) + times(b.x - a.x, t), times(a.y, w) + times(b.y - a.y, t), w);
}

ExactPoint foot(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  const Int128 dx = b.x - a.x;
  const Int128 dy = b.y - a.y;
  const Int128 w = times(dx, dx) + times(dy, dy);
  const Int128 t = times(dx, c.x - a.x) + times(dy, c.y - a.y);
  return point(times(a.x, w) + times(dx, t), times(a.y, w) + times(dy, t), w);
}

int place_of_middle(const ExactPoint& a, const ExactPoint& b,
                    const std::vector<LatticePoint>& ring) {
  bool inside = false;
  const Vec2 middle = (a.p + b.p) / 2;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LatticePoint& p = ring[i];
    const LatticePoint& q = ring[i + 1 < ring.size() ? i + 1 : 0];
    const int above_p = compare_middle(middle.y(), a.y, a.w, b.y, b.w, p.y);
    const int above_q = compare_middle(middle.y(), a.y, a.w, b.y, b.w, q.y);
    if (above_p * above_q > 0) continue;
    const int beyond_p = compare_middle(middle.x(), a.x, a.w, b.x, b.w, p.x);
    const int beyond_q = compare_middle(middle.x(), a.x, a.w, b.x, b.w, q.x);
    const int at = side_of_middle(p, q, a, b);
    if (at == 0 && beyond_p * beyond_q <= 0) return 0;
    // Half-open in y: a corner that the ray to the east meets counts once.
    if ((above_p < 0) == (above_q < 0)) continue;
    if ((at > 0) == (above_q < 0)) inside = !inside;
  }
  return inside ? 1 : -1;
}

}  // namespace rubicon::travel
