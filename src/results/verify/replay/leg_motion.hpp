#pragma once

#include <map>
#include <utility>
#include <vector>

#include "src/results/verify/geometry/pair_sweep.hpp"
#include "src/results/verify/replay/robot_track.hpp"

namespace rubicon::verify {

/// The frames of a robot during one leg, kept for every interval that was asked for. The mechanism
/// and the leg must outlive it.
class LegFrames {
 public:
  LegFrames(const Mechanism& mechanism, const Leg& leg) : mechanism_(mechanism), leg_(leg) {}

  const Mechanism& mechanism() const { return mechanism_; }
  const Leg& leg() const { return leg_; }
  /// While s, the share of the leg that is over, runs from s0 to s1.
  const MechanismState& state(double s0, double s1) const;

 private:
  const Mechanism& mechanism_;
  const Leg& leg_;
  mutable std::map<std::pair<double, double>, MechanismState> states_;
};

/// A solid that is fixed to a frame of a robot, and its name; or a rope, between two frames.
struct RobotPart {
  const Solid* solid = nullptr;  ///< of a rope as it is at the start
  int frame = 0;                 ///< of a rope the one that it goes to
  Pose X_FS = Pose::Identity();
  std::string name;
  const SceneRope* rope = nullptr;
  double turn_deg = 0;  ///< of a load that people turn meanwhile about the vertical
  bool is_buffer = false;
};

/// A pose turned about the vertical through a point (world).
Pose turned_about_vertical(const Pose& X_W, const Vec3& point_W, double angle_deg);

/// A robot's part while a leg runs from the share s0 to s1, seen from the frame `base` (-1: the
/// world).
class LegPart : public PartMotion {
 public:
  LegPart(const LegFrames& frames, const RobotPart& part, int base = -1, double s0 = 0,
          double s1 = 1)
      : frames_(frames), part_(part), base_(base), s0_(s0), s1_(s1) {}

  PartState state(double u0, double u1) const override;

 private:
  PartState rope_state(const MechanismState& frames) const;
  PartState turned_state(const MechanismState& frames, double u0, double u1) const;

  const LegFrames& frames_;
  const RobotPart& part_;
  int base_;
  double s0_;
  double s1_;
};

}  // namespace rubicon::verify
