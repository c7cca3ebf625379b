#pragma once

#include <span>
#include <vector>

#include "src/motion/robot/frame_chain.hpp"
#include "src/motion/robot/rope_path.hpp"

namespace rubicon::robot {

/// A rope as seen from one of its ends.
class RopeView {
 public:
  /// One piece and by how much it is larger (m) than what the rope sweeps.
  struct Measured {
    RopePiece piece;
    double excess = 0;
  };

  /// Of the rope with this body; `model` must outlive it.
  RopeView(const RobotModel& model, const Mounting& mounting, const Body& rope, bool from_above);

  /// What holds the rope over [s0, s1] of a step from q0 to q1.
  Measured piece(std::span<const double> q0, std::span<const double> q1, double s0,
                 double s1) const;

 private:
  Vec3 other_end(std::span<const double> q) const;
  double deviation(std::span<const double> q0, std::span<const double> q1, double s0,
                   double s1) const;
  bool moves(std::span<const double> q0, std::span<const double> q1) const;

  const RobotModel* model_;
  Mounting mounting_;
  int body_;
  Vec3 own_;
  Vec3 p_other_;  ///< m, frame of the other body
  double radius_;
  RelativeChain chain_;          ///< from the body of this end to the other
  std::vector<int> parameters_;  ///< on which the pose of the body of this end depends
};

}  // namespace rubicon::robot
