#pragma once

#include <string>
#include <vector>

#include "src/motion/travel/plan_view.hpp"
#include "src/motion/travel/travel.hpp"

namespace rubicon::travel {

/// What a machine meets in the plan view: shapes at its heights, grown by the disc that holds it
/// however it is turned.
class GrownView {
 public:
  /// `radius` (m) 0: a point.
  GrownView(const Heights& heights, double radius);

  /// Adds shapes that stand at X_WB, as one obstacle; nothing where they are above or below. Null:
  /// nothing was added.
  Obstacle* add(const std::string& name, const std::vector<geometry::Shape>& shapes,
                const math::Pose& X_WB);
  std::vector<Obstacle>& obstacles() { return obstacles_; }

 private:
  std::vector<std::vector<Vec2>> grown(const std::vector<Vec2>& outline) const;

  Heights heights_;
  std::vector<Vec2> footprint_;
  std::vector<Obstacle> obstacles_;
};

/// Whether a way through places meets an obstacle that stands, or touches it (within 10 um).
bool meets(const Obstacle& obstacle, const std::vector<Vec2>& way);

}  // namespace rubicon::travel
