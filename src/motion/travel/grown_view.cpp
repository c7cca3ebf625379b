#include "src/motion/travel/grown_view.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "src/motion/travel/grow.hpp"
#include "src/motion/travel/ring.hpp"

namespace rubicon::travel {

namespace {

/// The share of a disc's radius by which its polygon may not reach beyond it, and m to spare.
constexpr double kOfDistance = 0.99;
constexpr double kSpare = 2e-4;
/// m by which a disc is smaller at first: a place on the outline of a disc is then free. Less than
/// what the caller's disc is larger than its machine by, and more than the rounding of corners.
constexpr double kOnOutline = 5e-5;
constexpr double kOfCorners = 1e-5;
/// m; a smaller disc is a point.
constexpr double kLeastDisc = 1e-3;

/// m; what is nearer touches.
constexpr double kMetWithin = 1e-5;

/// Whether c and d lie on different sides of the line a b.
bool lie_apart(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 along = b - a;
  const auto is_left = [&](const Vec2& p) {
    return along.x() * (p - a).y() - along.y() * (p - a).x() > 0;
  };
  return is_left(c) != is_left(d);
}

/// m from a place to the border of a polygon; 0 inside.
double distance_to(const std::vector<Vec2>& outline, const Vec2& place) {
  double least = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Vec2& a = outline[j];
    const Vec2& b = outline[i];
    const Vec2 along = b - a;
    const double length = along.squaredNorm();
    const double share = length > 0 ? std::clamp((place - a).dot(along) / length, 0.0, 1.0) : 0.0;
    least = std::min(least, (place - a - share * along).norm());
    if ((a.y() > place.y()) == (b.y() > place.y())) continue;
    const double x = a.x() + (place.y() - a.y()) / (b.y() - a.y()) * along.x();
    if (x > place.x()) inside = !inside;
  }
  return inside ? 0 : least;
}

}  // namespace

GrownView::GrownView(const Heights& heights, double radius) : heights_(heights), radius_(radius) {
  if (radius > 0) footprint_ = disc(radius);
}

/// An outline grown by the largest of three discs that leaves the places free: the whole one, one
/// that is hardly smaller, and one that leaves them room.
std::vector<std::vector<Vec2>> GrownView::grown(const std::vector<Vec2>& outline) const {
  if (footprint_.empty()) return {outline};
  const auto grown_by = [&](const std::vector<Vec2>& footprint) {
    std::vector<std::vector<Vec2>> rings;
    for (const Piece& piece : grown_pieces(outline, footprint, 0)) {
      rings.push_back(in_metres(piece.ring));
    }
    return rings;
  };
  double least = radius_;
  std::vector<Vec2> places;
  for (const Vec2& place : free_) {
    const double distance = distance_to(outline, place);
    if (distance <= kSpare) continue;
    places.push_back(place);
    least = std::min(least, kOfDistance * distance - kSpare);
  }
  const auto leaves_free = [&](const std::vector<std::vector<Vec2>>& rings) {
    return std::all_of(rings.begin(), rings.end(), [&](const std::vector<Vec2>& ring) {
      return std::all_of(places.begin(), places.end(),
                         [&](const Vec2& place) { return distance_to(ring, place) > kOfCorners; });
    });
  };
  std::vector<std::vector<Vec2>> rings = grown_by(footprint_);
  if (least >= radius_ || leaves_free(rings)) return rings;
  if (radius_ > kLeastDisc) {
    rings = grown_by(disc(radius_ - kOnOutline));
    if (leaves_free(rings)) return rings;
  }
  if (least < kLeastDisc) return {outline};
  return grown_by(disc(least));
}

Obstacle* GrownView::add(const std::string& name, const std::vector<geometry::Shape>& shapes,
                         const math::Pose& X_WB) {
  Obstacle obstacle;
  obstacle.name = name;
  for (const geometry::Shape& shape : shapes) {
    for (const std::vector<Vec2>& outline : plan_view(shape, X_WB, heights_)) {
      for (std::vector<Vec2>& ring : grown(outline)) obstacle.parts.push_back(std::move(ring));
    }
  }
  if (obstacle.parts.empty()) return nullptr;
  return &obstacles_.emplace_back(std::move(obstacle));
}

bool meets(const Obstacle& obstacle, const std::vector<Vec2>& way) {
  const auto passes = [&](const Vec2& from, const Vec2& to) {
    return std::any_of(obstacle.parts.begin(), obstacle.parts.end(), [&](const auto& outline) {
      if (distance_to(outline, from) <= kMetWithin || distance_to(outline, to) <= kMetWithin) {
        return true;
      }
      for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        if (distance_to({from, to}, outline[i]) <= kMetWithin) return true;
        if (lie_apart(from, to, outline[j], outline[i]) &&
            lie_apart(outline[j], outline[i], from, to)) {
          return true;
        }
      }
      return false;
    });
  };
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    if (passes(way[i], way[i + 1])) return true;
  }
  return false;
}

}  // namespace rubicon::travel
