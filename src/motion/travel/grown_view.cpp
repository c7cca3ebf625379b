#include "src/motion/travel/grown_view.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "src/motion/travel/grow.hpp"
#include "src/motion/travel/ring.hpp"

namespace rubicon::travel {

namespace {

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

GrownView::GrownView(const Heights& heights, double radius) : heights_(heights) {
  if (radius > 0) footprint_ = disc(radius);
}

std::vector<std::vector<Vec2>> GrownView::grown(const std::vector<Vec2>& outline) const {
  if (footprint_.empty()) return {outline};
  std::vector<std::vector<Vec2>> rings;
  for (const Piece& piece : grown_pieces(outline, footprint_, 0)) {
    rings.push_back(in_metres(piece.ring));
  }
  return rings;
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
