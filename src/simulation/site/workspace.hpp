#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "src/simulation/site/site_robot.hpp"

namespace rubicon::site {

/// How the dynamic workspaces of machines are found, and who goes first where they would overlap.
struct WorkspaceRules {
  std::vector<int> order;    ///< robots that keep theirs apart, those that go first in front
  double reaction = 1;       ///< s until a machine brakes
  double braking = 2;        ///< m/s2
  double turn_braking = 30;  ///< deg/s2
  double foreseen = 0;       ///< s for which the ways of those that go first are foreseen; 0: not
  bool watch = false;        ///< where they overlap it is counted, and nobody stops

  int rank_of(int robot) const;  ///< -1: its workspace is not kept apart
};

/// A convex polygon in the plan view, counter-clockwise.
using PlanPolygon = std::vector<Eigen::Vector2d>;
/// A part of the site in the plan view, as convex polygons, with the box around it.
struct PlanRegion {
  std::vector<PlanPolygon> polygons;
  std::vector<Eigen::AlignedBox2d> boxes;  ///< round each
  Eigen::AlignedBox2d bounds;

  void add(std::vector<Eigen::Vector2d> points);
  /// Whether they have more than their edges in common.
  bool overlaps(const PlanRegion& other) const;
};

/// The corners of the boxes round the shapes of each body of a machine, in the body's frame.
using BodyCorners = std::vector<std::vector<math::Vec3>>;
BodyCorners corners_of(const robot::RobotModel& model);

/// A step, and where the machine stands next.
struct WorkspaceStep {
  std::span<const double> q_from, q_to, q_goal;  ///< q_goal empty: not known
  double seconds = 0;
};

/// What the machine sweeps in the plan view in this step and then until it stands, if it has to
/// stop as soon as the step is over: it goes on as in the step for the time of reaction, and brakes
/// then; but no farther than to where it stands next anyway. `more_steps`: so many like it before
/// that.
PlanRegion workspace_of(const SiteRobot& robot, const BodyCorners& corners,
                        const WorkspaceStep& step, const WorkspaceRules& rules, int more_steps = 0);

/// What the machine sweeps in the plan view from one configuration straight to another, no more.
PlanRegion swept_region(const SiteRobot& robot, const BodyCorners& corners,
                        std::span<const double> q_from, std::span<const double> q_to);

/// What the machine covers where it stands.
PlanRegion footprint_of(const SiteRobot& robot, const BodyCorners& corners,
                        std::span<const double> q);

}  // namespace rubicon::site
