#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "src/motion/robot/rope_path.hpp"
#include "src/simulation/site/site_robot.hpp"

namespace rubicon::site {

/// The prepared bodies of a machine's ropes: of the capsules used last, and of each rope as it
/// hung last. While a machine slews or travels its ropes do not change. It never changes an answer.
/// For one thread at a time.
class RopeBodies {
 public:
  /// A rope as it hangs while its two bodies do not move against each other.
  struct Hanging {
    std::vector<double> values;  ///< of the parameters that move them
    robot::RopePiece piece;
    collision::BodyPtr body;
  };

  /// Makes a rope known (index of its body): how it moves, and the parameters that move its bodies
  /// against each other.
  void add(int rope, robot::RopePath path, std::vector<int> parameters);
  const robot::RopePath& path(int rope) const;

  collision::BodyPtr body_of(const geometry::Capsule& capsule);

  /// The rope, if no step from q0 to q1 moves its bodies against each other and it hung like that
  /// last; else null.
  const Hanging* unchanged(int rope, std::span<const double> q0, std::span<const double> q1) const;
  /// Remembers it as it hangs at q, if it hangs still from q0 to q1.
  void remember(int rope, std::span<const double> q0, std::span<const double> q1,
                const robot::RopePiece& piece, collision::BodyPtr body);

 private:
  struct Entry {
    geometry::Capsule capsule;
    collision::BodyPtr body;
  };
  struct Known {
    robot::RopePath path;
    std::vector<int> parameters;
    Hanging last;
  };
  std::vector<Entry> entries_;
  std::size_t oldest_ = 0;
  std::map<int, Known> ropes_;
};

/// A part of what a rope sweeps over a step.
struct RopeVolume {
  collision::BodyPtr body;
  geometry::Motion motion;
  double s0 = 0, s1 = 1;  ///< of the step
};

/// The volumes that hold what the rope (index of its body) sweeps while q runs from q0 to q1, by
/// robot::RopePath, at most so many; `motions` are those of all bodies over the whole step.
std::vector<RopeVolume> rope_volumes(const SiteRobot& robot, int rope, std::span<const double> q0,
                                     std::span<const double> q1,
                                     const std::vector<geometry::Motion>& motions,
                                     int most_pieces = robot::kMostRopePieces);

/// The rope of a robot that stands at q. World frame.
RopeVolume standing_rope(const SiteRobot& robot, int rope, std::span<const double> q);
}  // namespace rubicon::site
