#pragma once

#include <vector>

#include "src/motion/travel/outline.hpp"
#include "src/motion/travel/travel.hpp"

namespace rubicon::travel {

/// All obstacles with the outline at the present time.
class MovingOutline {
 public:
  /// Throws std::invalid_argument for polygons that are not simple and for timetables whose times
  /// do not ascend, that turn by 180 degrees or more at once, or that repeat from another place.
  explicit MovingOutline(std::vector<Obstacle> obstacles);

  const Outline& outline() const { return outline_; }
  const std::vector<Obstacle>& obstacles() const { return obstacles_; }

  /// The first time, not before `time`, from which on an obstacle moves; infinite: none will.
  double next_motion(double time) const;
  /// s; in so much time no obstacle moves by more than half of its thickness. Infinite: none moves.
  double longest_slice() const;
  /// Puts all obstacles where they are at `time`.
  void move_to(double time);
  /// Whether the last move_to moved an obstacle, or one of any.
  bool moved(int obstacle) const { return moved_[static_cast<std::size_t>(obstacle)]; }
  bool any_moved() const { return any_moved_; }

 private:
  Ring ring_at(std::size_t piece, const Placement& placement) const;

  std::vector<Obstacle> obstacles_;
  std::vector<Ring> own_rings_;  ///< of each piece, in the frame of its obstacle
  std::vector<Placement> placements_;
  std::vector<bool> moved_;
  bool any_moved_ = false;
  Outline outline_;
};

/// Where an obstacle's frame is.
Placement placement_at(const Obstacle& obstacle, double time);

}  // namespace rubicon::travel
