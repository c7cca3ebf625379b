#include "src/motion/travel/grow.hpp"

#include <algorithm>
#include <stdexcept>

#include "src/motion/math/angles.hpp"

namespace rubicon::travel {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Counter-clockwise, the lowest corner first, of these the leftmost. Corners that turn right, or
/// not at all, are dropped: what remains is the convex hull of a polygon that is convex but for
/// rounding.
std::vector<Vec2> from_lowest(std::vector<Vec2> corners) {
  double twice_area = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    twice_area += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  if (twice_area < 0) std::reverse(corners.begin(), corners.end());
  const auto lower = [](const Vec2& a, const Vec2& b) {
    return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
  };
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), lower),
              corners.end());
  return corners;
}

/// Whether the triangle about corner i may be cut off.
bool is_ear(const Ring& ring, std::size_t i) {
  const LatticePoint& a = ring[i == 0 ? ring.size() - 1 : i - 1];
  const LatticePoint& b = ring[i];
  const LatticePoint& c = next_corner(ring, i);
  if (side(a, b, c) <= 0) return false;
  return std::none_of(ring.begin(), ring.end(), [&](const LatticePoint& corner) {
    return corner != a && corner != b && corner != c && side(a, b, corner) >= 0 &&
           side(b, c, corner) >= 0 && side(c, a, corner) >= 0;
  });
}

}  // namespace

std::vector<Vec2> disc(double radius, int sides) {
  if (!(radius > 0) || sides < 3) throw std::invalid_argument("a disc without radius or sides");
  const double half = 180.0 / sides;
  const double reach = radius / math::cos_deg(half);
  std::vector<Vec2> corners;
  for (int i = 0; i < sides; ++i) {
    const auto [sine, cosine] = math::sine_cosine_deg(half * (2 * i + 1));
    corners.emplace_back(reach * cosine, reach * sine);
  }
  return corners;
}

std::vector<Vec2> grow(std::span<const Vec2> obstacle, std::span<const Vec2> footprint) {
  std::vector<Vec2> mirrored;
  for (const Vec2& corner : footprint) mirrored.emplace_back(-corner);
  const std::vector<Vec2> a = from_lowest({obstacle.begin(), obstacle.end()});
  const std::vector<Vec2> b = from_lowest(std::move(mirrored));
  // Edges of both in the order of their directions, from the lowest corner on.
  std::vector<Vec2> sum;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() || j < b.size()) {
    sum.emplace_back(a[i % a.size()] + b[j % b.size()]);
    const Vec2 along_a = a[(i + 1) % a.size()] - a[i % a.size()];
    const Vec2 along_b = b[(j + 1) % b.size()] - b[j % b.size()];
    const double turned = cross(along_a, along_b);
    if (j == b.size() || (i < a.size() && turned > 0)) {
      ++i;
    } else if (i == a.size() || turned < 0) {
      ++j;
    } else {
      ++i;
      ++j;
    }
  }
  return sum;
}

std::vector<Ring> convex_parts(Ring ring) {
  if (is_convex(ring)) return {std::move(ring)};
  std::vector<Ring> parts;
  while (ring.size() > 3) {
    std::size_t ear = 0;
    while (ear < ring.size() && !is_ear(ring, ear)) ++ear;
    if (ear == ring.size()) {
      // Only corners on lines of their neighbours are left besides ears: one of these goes.
      ear = 0;
      while (ear < ring.size() && side(ring[ear == 0 ? ring.size() - 1 : ear - 1], ring[ear],
                                       next_corner(ring, ear)) != 0) {
        ++ear;
      }
      if (ear == ring.size()) throw std::invalid_argument("a polygon that has no ears");
    } else {
      parts.push_back(
          {ring[ear == 0 ? ring.size() - 1 : ear - 1], ring[ear], next_corner(ring, ear)});
    }
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  if (side(ring[0], ring[1], ring[2]) > 0) parts.push_back(std::move(ring));
  return parts;
}

std::vector<Piece> grown_pieces(std::span<const Vec2> corners, std::span<const Vec2> footprint,
                                int obstacle) {
  std::vector<Piece> pieces;
  for (const Ring& part : convex_parts(ring_of(corners))) {
    pieces.push_back({ring_of(grow(in_metres(part), footprint)), obstacle});
  }
  return pieces;
}

}  // namespace rubicon::travel
