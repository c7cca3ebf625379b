#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "src/motion/geometry/motion.hpp"
#include "src/motion/robot/kinematics.hpp"

namespace rubicon::robot {

/// Where bodies of a robot are on a step, at the places of it that were asked for last: the bodies
/// of a chain are asked for at the same places, and each stands on the one before. Not for several
/// threads at once.
class PosesOnStep {
 public:
  static constexpr std::size_t kMostBodies = 64;  ///< of a robot, to be remembered

  /// The same, bit by bit, as `body_pose` at the configuration of the place s.
  const Pose& pose(const RobotModel& model, const Mounting& mounting, std::span<const double> q0,
                   std::span<const double> q1, double s, int body);
  /// The configuration there.
  std::span<const double> configuration() const { return {q_.data() + place_ * count_, count_}; }

 private:
  static constexpr std::size_t kPlaces = 8;

  void go_to(const RobotModel& model, std::span<const double> q0, std::span<const double> q1,
             double s);

  std::array<double, kPlaces> s_{};
  std::array<std::uint64_t, kPlaces> known_{};  ///< a bit for each body
  std::size_t used_ = 0;                        ///< of the places
  std::size_t next_ = 0;                        ///< the place that is forgotten next
  std::size_t place_ = 0;                       ///< the one asked for last
  std::size_t count_ = 0;                       ///< of parameters
  std::vector<double> q_;
  std::vector<Pose> X_;
};

/// One step of a robot: its control parameters run linearly from q0 to q1. Shared by the motions of
/// all its bodies.
struct StepPath {
  const RobotModel* model = nullptr;  ///< must outlive the motions
  Mounting mounting;
  std::vector<double> q0, q1;
  std::vector<Pose> X0, X1;  ///< of all bodies and last of the tool, at q0 and q1
  mutable PosesOnStep between = {};
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
