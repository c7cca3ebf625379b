#pragma once

#include <array>
#include <span>
#include <vector>

#include "src/motion/robot/kinematics.hpp"

namespace rubicon::robot {

/// What holds a rope over a part [s0, s1] of a step: a capsule fixed to one of the two bodies that
/// the rope joins. At each moment the rope lies in the capsule where that body is then.
struct RopePiece {
  int body = 0;           ///< index of the body
  Vec3 a = Vec3::Zero();  ///< m, frame of the body: the point that the rope is fixed to
  Vec3 b = Vec3::Zero();  ///< m, frame of the body: as far as the rope goes
  double radius = 0;      ///< m, with the growth that makes up for what is not straight
  double s0 = 0, s1 = 1;
};

/// m: a step in which a rope's volume would be larger than what it sweeps by more than this is cut
/// into parts. Smaller values cost time, larger ones false refusals beside ropes whose
/// ends move across each other.
inline constexpr double kRopeExcess = 0.02;
inline constexpr int kMostRopePieces = 16;

class RopeView;

/// How one rope of a robot moves.
class RopePath {
 public:
  /// Of the rope with this index of its body; `model` must outlive it.
  RopePath(const RobotModel& model, const Mounting& mounting, int rope);
  ~RopePath();
  RopePath(RopePath&&) noexcept;
  RopePath& operator=(RopePath&&) noexcept;

  /// The rope while q runs from q0 to q1: what the pieces sweep holds all that the rope sweeps. It
  /// is the same where the rope keeps its direction as seen from one of its ends (hoisting,
  /// slewing, driving, the hook below a luffing boom). Else it is larger by at most kRopeExcess, or
  /// by 1/16 of the way of one end as seen from the other if that is more. A bound of the path's
  /// curvature by interval arithmetic is part of the radius.
  std::vector<RopePiece> pieces(std::span<const double> q0, std::span<const double> q1,
                                int most_pieces = kMostRopePieces) const;

 private:
  std::vector<RopeView> views_;  ///< from above, from below
};

/// Both ends of the rope, in the world, at q.
std::array<Vec3, 2> rope_ends(const RobotModel& model, const Mounting& mounting, int rope,
                              std::span<const double> q);

}  // namespace rubicon::robot
