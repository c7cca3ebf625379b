#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "src/motion/geometry/motion.hpp"
#include "src/motion/robot/kinematics.hpp"

namespace rubicon::robot {

/// One step of a robot: its control parameters run linearly from q0 to q1. Shared by the motions of
/// all its bodies.
struct StepPath {
  const RobotModel* model = nullptr;  ///< must outlive the motions
  Mounting mounting;
  std::vector<double> q0, q1;
  std::vector<Pose> X0, X1;  ///< of all bodies and last of the tool, at q0 and q1
};

/// Bound of the acceleration d2x/ds2 of a point of a body, by its distance from the body's origin:
/// origin + turning * r.
struct AccelerationBound {
  double origin = 0;   ///< m
  double turning = 0;  ///< m per m of distance
};

/// Rigorous bound over s in [0, 1] for the frame at the end of `elements`, by interval arithmetic:
/// the origin's path is carried through the chain from its end to its base with two derivatives;
/// for the rest |R''| <= (sum of the rates)^2 + sum of the accelerations of all angles, in radians.
AccelerationBound acceleration_bound(std::span<const FrameElement* const> elements,
                                     std::span<const double> q0, std::span<const double> q1,
                                     std::span<const double> starts);

/// Motion of a body or of the tool frame (body = -1) that is no screw.
class ChainMotion : public geometry::GeneralMotion {
 public:
  /// `known`: a bound that was found more cheaply; else it is found by `acceleration_bound`.
  ChainMotion(std::shared_ptr<const StepPath> path, int body,
              const std::optional<AccelerationBound>& known = {});

  Pose pose(double s) const override;
  double chord_deviation(double s0, double s1, double reach) const override;

 private:
  std::shared_ptr<const StepPath> path_;  // shared: one step, several bodies
  int body_;
  AccelerationBound acceleration_;
};

}  // namespace rubicon::robot
