#pragma once

#include <span>
#include <string>
#include <vector>

#include "src/motion/guides/reeds_shepp.hpp"
#include "src/motion/robot/kinematics.hpp"

namespace rubicon::guides {

/// The leg of a robot from one configuration to another, as `follow` makes it.
///
/// Plain parameters, which change by their own steps alone, run in a straight line and arrive
/// together: one step is as long as the `step` of the first that it would exceed. A vehicle, whose
/// one local parameter drives it along its heading, turns to face the place, drives there, and then
/// turns to its heading, while its other parameters run. Values in file units (m, degrees), one per
/// parameter of the robot, which must outlive it.
///
/// A vehicle that steers turns nowhere narrower than its radius: it drives the shortest way of
/// Reeds and Shepp, forwards and backwards, on chords of its arcs that are steps; then its other
/// parameters run. Where its rules let it turn while it drives, so that a step that turns by a
/// leads along the chord of an arc of a, it does both at once; else it turns half, drives, and
/// turns half. `next_step` makes one chord: give it the `stops` of the leg, one after the other.
class Leg {
 public:
  /// Locked parameters stay; what needs them to drive, stands.
  Leg(const robot::RobotModel& model, const robot::Mounting& mounting,
      const robot::GoalClauses& clauses = {}, double turn_radius = 0);

  /// Why robots with these rules make no legs; empty: this one does.
  const std::string& refusal() const { return refusal_; }

  /// Parameters that a leg brings to their values: what a waypoint is made of. Those that are
  /// derived follow.
  const std::vector<int>& parameters() const { return parameters_; }
  /// Parameters that its steps step where none is locked, ascending.
  const std::vector<int>& stepped() const { return stepped_; }
  /// Of a vehicle: the angle that it drives along, else -1; and the two that driving changes.
  int heading() const { return heading_; }
  /// Of a vehicle: the parameter that drives it, else -1.
  int drive() const { return drive_; }
  std::span<const int, 2> place() const { return place_; }

  /// The steps, per parameter, of the next motion step from `q` to `target`; false: it is there.
  bool next_step(std::span<const double> q, std::span<const double> target,
                 std::span<double> steps) const;

  /// Where a leg from `q` changes its direction, and its end: between them it runs straight. Cyclic
  /// angles run on, derived parameters are computed.
  std::vector<std::vector<double>> corners(std::span<const double> q,
                                           std::span<const double> target) const;

  /// Of a vehicle that steers: the ends of the chords of a leg and of its straight parts, then of
  /// its other parameters; of any other leg its end alone.
  std::vector<std::vector<double>> stops(std::span<const double> q,
                                         std::span<const double> target) const;
  bool steers() const { return turn_radius_ > 0 && drive_ >= 0; }
  /// m that a vehicle that steers drives.
  double driven(std::span<const double> q, std::span<const double> target) const;
  /// Of a vehicle that steers: where a part of a way leads.
  std::vector<double> driven_by(std::span<const double> q, const PlanePart& part) const;
  /// Of a vehicle that steers: where it is after a share of its way; others as far on theirs.
  std::vector<double> partway(std::span<const double> q, std::span<const double> target,
                              double share) const;

  /// The heading of a vehicle that drives along a direction of the plan (world), from q.
  double heading_along(std::span<const double> q, const Eigen::Vector2d& direction_W) const;

  bool is_there(std::span<const double> q, std::span<const double> target) const;

 private:
  struct Facing {
    bool there = true;
    double turn = 0;      ///< degrees to turn
    double distance = 0;  ///< m to drive
  };

  void find_vehicle();
  std::vector<int> parameters_driven_by(int drive) const;
  bool turns_with_heading() const;
  bool turns_alone(int parameter) const;
  bool drives_chords() const;
  ReedsSheppWay steered(std::span<const double> q, std::span<const double> target) const;
  PlanePose plane_pose(std::span<const double> q) const;
  std::vector<std::vector<double>> steered_corners(std::span<const double> q,
                                                   std::span<const double> target,
                                                   bool stops_only) const;
  bool next_chord(std::span<const double> q, std::span<const double> target,
                  std::span<double> steps) const;
  void turn_or_drive(double turn, bool must_turn, double distance, std::span<double> steps) const;
  /// How the driven parameters change per metre.
  void direction(std::span<const double> q, double& along_x, double& along_y) const;
  Facing facing(std::span<const double> q, std::span<const double> target) const;
  /// m by which it may pass beside its target.
  double most_beside() const;
  double missing(int parameter, std::span<const double> q, std::span<const double> target) const;
  const robot::Parameter& parameter(int index) const {
    return model_.parameters[static_cast<std::size_t>(index)];
  }

  const robot::RobotModel& model_;
  robot::Mounting mounting_;
  std::string refusal_;
  std::vector<int> parameters_;
  std::vector<int> stepped_;
  std::vector<int> plain_;   ///< of these the ones that run in a straight line
  int drive_ = -1;           ///< of a vehicle: the local parameter
  int heading_ = -1;         ///< of a vehicle: the angle that it drives along
  int place_[2] = {-1, -1};  ///< of a vehicle: what driving changes
  double turn_radius_ = 0;   ///< m; 0: it turns on the spot
  double drift_deg_ = 0;     ///< of a vehicle: the direction that it drives in at heading 0
  bool chords_ = false;      ///< it turns while it drives, along chords
};

}  // namespace rubicon::guides
