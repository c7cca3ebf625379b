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
/// m; a smaller disc is a point.
constexpr double kLeastDisc = 1e-3;

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

/// The disc by which an outline is grown, empty for a point.
std::vector<Vec2> GrownView::footprint_for(const std::vector<Vec2>& outline) const {
  double radius = radius_;
  for (const Vec2& place : free_) {
    const double distance = distance_to(outline, place);
    if (distance > kSpare) radius = std::min(radius, kOfDistance * distance - kSpare);
  }
  if (radius >= radius_) return footprint_;
  return radius < kLeastDisc ? std::vector<Vec2>() : disc(radius);
}

Obstacle* GrownView::add(const std::string& name, const std::vector<geometry::Shape>& shapes,
                         const math::Pose& X_WB) {
  Obstacle obstacle;
  obstacle.name = name;
  for (const geometry::Shape& shape : shapes) {
    for (std::vector<Vec2>& outline : plan_view(shape, X_WB, heights_)) {
      const std::vector<Vec2> footprint = footprint_for(outline);
      if (footprint.empty()) {
        obstacle.parts.push_back(std::move(outline));
        continue;
      }
      for (const Piece& piece : grown_pieces(outline, footprint, 0)) {
        obstacle.parts.push_back(in_metres(piece.ring));
      }
    }
  }
  if (obstacle.parts.empty()) return nullptr;
  return &obstacles_.emplace_back(std::move(obstacle));
}

}  // namespace rubicon::travel
