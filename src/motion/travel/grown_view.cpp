#include "src/motion/travel/grown_view.hpp"

#include <utility>

#include "src/motion/travel/grow.hpp"
#include "src/motion/travel/ring.hpp"

namespace rubicon::travel {

GrownView::GrownView(const Heights& heights, double radius) : heights_(heights) {
  if (radius > 0) footprint_ = disc(radius);
}

Obstacle* GrownView::add(const std::string& name, const std::vector<geometry::Shape>& shapes,
                         const math::Pose& X_WB) {
  Obstacle obstacle;
  obstacle.name = name;
  for (const geometry::Shape& shape : shapes) {
    for (std::vector<Vec2>& outline : plan_view(shape, X_WB, heights_)) {
      if (footprint_.empty()) {
        obstacle.parts.push_back(std::move(outline));
        continue;
      }
      for (const Piece& piece : grown_pieces(outline, footprint_, 0)) {
        obstacle.parts.push_back(in_metres(piece.ring));
      }
    }
  }
  if (obstacle.parts.empty()) return nullptr;
  return &obstacles_.emplace_back(std::move(obstacle));
}

}  // namespace rubicon::travel
