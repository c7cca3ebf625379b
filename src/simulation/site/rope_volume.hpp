#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "src/motion/robot/rope_path.hpp"
#include "src/simulation/site/site_robot.hpp"

namespace rubicon::site {

/// The prepared bodies of a machine's ropes, of the capsules used last: while a machine slews or
/// travels its ropes keep their length. For one thread at a time.
class RopeBodies {
 public:
  collision::BodyPtr body_of(const geometry::Capsule& capsule);

 private:
  struct Entry {
    geometry::Capsule capsule;
    collision::BodyPtr body;
  };
  std::vector<Entry> entries_;
  std::size_t oldest_ = 0;
};

/// A part of what a rope sweeps over a step.
struct RopeVolume {
  collision::BodyPtr body;
  geometry::Motion motion;
  double s0 = 0, s1 = 1;  ///< of the step
};

/// The volumes that hold what the rope (index of its body) sweeps while q runs from q0 to q1, by
/// robot::rope_pieces, at most so many; `motions` are those of all bodies over the whole step.
std::vector<RopeVolume> rope_volumes(const SiteRobot& robot, int rope, std::span<const double> q0,
                                     std::span<const double> q1,
                                     const std::vector<geometry::Motion>& motions,
                                     int most_pieces = robot::kMostRopePieces);

/// The rope of a robot that stands at q. World frame.
RopeVolume standing_rope(const SiteRobot& robot, int rope, std::span<const double> q);

/// The configuration at s of a step.
std::vector<double> configuration_at(std::span<const double> q0, std::span<const double> q1,
                                     double s);

}  // namespace rubicon::site
