#include "src/motion/robot/tool_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/turns.hpp"
#include "tests/unit/robot/robots.hpp"

namespace rubicon::robot {
namespace {

using Q = std::vector<double>;

/// Six axes on a base that slides: shoulder, elbow and a wrist of three axes that meet.
RobotModel arm() {
  RobotModel model;
  const auto part = [&](const char* body, const char* name, double least, double most,
                        FrameFormula frame, FrameElement::Kind kind, double sign) {
    add_body(model, body, static_cast<int>(model.bodies.size()) - 1);
    const int p = add_parameter(model, name, least, most, 3);
    const Formula angle = sign < 0 ? -of(p) : of(p);
    frame.push_back({kind, angle, number(0), number(0)});
    model.bodies.back().frame = std::move(frame);
    return p;
  };
  using Kind = FrameElement::Kind;
  add_body(model, "base", -1);
  const int x = add_parameter(model, "x", -10, 10, 0.1);
  model.bodies.back().frame = {trans(of(x), number(0), number(0))};
  part("turret", "theta", -180, 180, {trans(0, 0, 0.6)}, Kind::rotz, 1);
  part("upper", "phi", -20, 160, {trans(0.1, 0, 0.45)}, Kind::roty, -1);
  part("fore", "phi", -160, 160, {trans(1.1, 0, 0)}, Kind::roty, -1);
  part("wrist", "psi", -180, 180, {trans(0.9, 0, 0)}, Kind::rotx, 1);
  part("hand", "phi", -120, 120, {}, Kind::roty, -1);
  part("drill", "psi", -180, 180, {trans(0.2, 0, 0)}, Kind::rotx, 1);
  model.tool_body = static_cast<int>(model.bodies.size()) - 1;
  model.tool_frame = {trans(0.4, 0, 0), roty(number(90))};
  return model;
}

constexpr int kBase = 0;
const Q kStart = {0, 10, 110, -90, 20, 60, 0};

/// Where the tool leads `line` to.
struct Walk {
  ToolLine::Step::Kind end = ToolLine::Step::Kind::made;
  std::vector<Q> places;
};

Walk walk(const RobotModel& model, const ToolLine& line, Q q, const Q& target, int most = 3000) {
  const Mounting mounting = mounting_of(model);
  Walk result;
  result.places.push_back(q);
  Q steps(q.size());
  Q next(q.size());
  for (int n = 0; n < most; ++n) {
    const ToolLine::Step step = line.next_step(q, target, {}, steps);
    result.end = step.kind;
    if (step.kind != ToolLine::Step::Kind::made) return result;
    for (std::size_t i = 0; i < q.size(); ++i) {
      EXPECT_LE(std::fabs(steps[i]), model.parameters[i].step * (1 + 1e-6)) << i;
    }
    apply_rules(model, mounting, q, steps, next);
    q = next;
    result.places.push_back(q);
  }
  return result;
}

/// The most that the tool is beside the straight way at 40 moments of each step: m, degrees of its
/// z axis from the great circle that it should run along.
std::pair<double, double> most_beside(const RobotModel& model, const std::vector<Q>& places) {
  const Mounting mounting = mounting_of(model);
  const Pose first = tool_pose(model, mounting, places.front());
  const Pose last = tool_pose(model, mounting, places.back());
  const Vec3 along = last.translation() - first.translation();
  const double turn = math::rotation_angle_deg(first.linear().transpose() * last.linear());
  std::pair<double, double> most = {0, 0};
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    for (int m = 0; m <= 40; ++m) {
      const Pose now =
          tool_pose(model, mounting, configuration_at(places[k], places[k + 1], m / 40.0));
      const Vec3 gone = now.translation() - first.translation();
      const double share = along.norm() > 0 ? gone.dot(along) / along.squaredNorm() : 0;
      most.first = std::max(most.first, (gone - share * along).norm());
      const double since = math::rotation_angle_deg(first.linear().transpose() * now.linear());
      most.second = std::max(most.second, std::fabs(since - share * turn));
    }
  }
  return most;
}

/// A configuration that the straight way to can be gone: the tool moved and turned a little.
Q moved_and_turned(const RobotModel& model, const Q& q, const Vec3& by, const Vec3& turn) {
  const Mounting mounting = mounting_of(model);
  Pose X = tool_pose(model, mounting, q);
  X.translation() += by;
  X.linear() = (rotation_by(turn) * X.linear()).eval();
  GoalClauses clauses;
  clauses.locked = {kBase};
  const GoalSolution found = solve_goal(model, mounting, q, X, {1e-7, 1e-7}, clauses);
  return found.reachable ? found.q : Q{};
}

TEST(ToolLine, KeepsTheToolBesideItsStraightWayAsNearAsSaid) {
  const RobotModel model = arm();
  std::mt19937 random(7);
  const auto draw = [&](double most) {
    return most * (2.0 * static_cast<double>(random()) / 4294967295.0 - 1);
  };
  int gone = 0;
  for (int n = 0; n < 30; ++n) {
    const Q target = moved_and_turned(model, kStart, {draw(0.4), draw(0.4), draw(0.3)},
                                      {draw(0.4), draw(0.4), draw(0.4)});
    if (target.empty()) continue;
    const LineDeviation allowed{n % 2 == 0 ? 1e-3 : 1e-4, n % 2 == 0 ? 0.1 : 0.02};
    const ToolLine line(model, mounting_of(model), allowed, {});
    const Walk way = walk(model, line, kStart, target);
    const auto [off, turned] = most_beside(model, way.places);
    EXPECT_LE(off, allowed.position) << n;
    EXPECT_LE(turned, 2 * allowed.orientation_deg) << n;
    if (way.end == ToolLine::Step::Kind::there) ++gone;
  }
  EXPECT_GE(gone, 20);
}

TEST(ToolLine, WhatIsMoreThanThePoseNeedsEndsAtItsValue) {
  const RobotModel model = arm();
  Q target = moved_and_turned(model, kStart, {0.3, 0.1, 0.1}, {0, 0.1, 0.2});
  ASSERT_FALSE(target.empty());
  // The same pose with the base 0.2 m on.
  GoalClauses clauses;
  clauses.locked = {kBase};
  target[kBase] = 0.2;
  const Pose X = tool_pose(model, mounting_of(model),
                           moved_and_turned(model, kStart, {0.3, 0.1, 0.1}, {0, 0.1, 0.2}));
  const GoalSolution found = solve_goal(model, mounting_of(model), target, X, {}, clauses);
  ASSERT_TRUE(found.reachable);
  const ToolLine line(model, mounting_of(model), {}, {});
  const Walk way = walk(model, line, kStart, found.q);
  EXPECT_EQ(way.end, ToolLine::Step::Kind::there);
  for (std::size_t i = 0; i < found.q.size(); ++i)
    EXPECT_NEAR(way.places.back()[i], found.q[i], 1e-6);
}

TEST(ToolLine, AFreeTurnIsLeftAsItComes) {
  const RobotModel model = arm();
  const Mounting mounting = mounting_of(model);
  Q target = moved_and_turned(model, kStart, {0, 0, 0.2}, Vec3::Zero());
  ASSERT_FALSE(target.empty());
  target.back() += 90;  // about the tool's own axis
  GoalClauses clauses;
  clauses.free = FreeTurn::z;
  clauses.locked = {kBase};
  const ToolLine line(model, mounting, {}, clauses);
  const Walk way = walk(model, line, kStart, target);
  EXPECT_EQ(way.end, ToolLine::Step::Kind::there);
  const Pose X = tool_pose(model, mounting, way.places.back());
  const Pose X_target = tool_pose(model, mounting, target);
  EXPECT_LE((X.translation() - X_target.translation()).norm(), 1e-7);
  EXPECT_GE(X.linear().col(2).dot(X_target.linear().col(2)), 1 - 1e-12);
  EXPECT_GT(math::rotation_angle_deg(X.linear().transpose() * X_target.linear()), 45);
  for (const Q& q : way.places) EXPECT_EQ(q[kBase], kStart[kBase]);
}

TEST(ToolLine, SaysWhichLimitBarsIt) {
  RobotModel model = gantry();
  model.parameters[0].upper = 3;
  const ToolLine line(model, mounting_of(model), {}, {});
  const Walk way = walk(model, line, {0, 0}, {6, 2});
  EXPECT_EQ(way.end, ToolLine::Step::Kind::limit);
  EXPECT_NEAR(way.places.back()[0], 3, 1e-2);
}

TEST(ToolLine, OutOfReachThereIsNoWay) {
  const RobotModel model = planar_arm();
  Q straight(model.parameters.size(), 0.0);
  Q folded = straight;
  folded.back() = 60;
  const ToolLine line(model, mounting_of(model), {}, {});
  // Stretched out it cannot turn its tip on the straight way without moving it.
  Q steps(straight.size());
  EXPECT_NE(line.next_step(straight, folded, {}, steps).kind, ToolLine::Step::Kind::there);
  EXPECT_TRUE(line.is_there(folded, folded, {}));
}

TEST(GoalClauses, LockedParametersAreNotMovedToTheGoal) {
  const RobotModel model = arm();
  const Mounting mounting = mounting_of(model);
  Pose X = tool_pose(model, mounting, kStart);
  X.translation().x() += 0.3;
  for (const int locked : {kBase, 1}) {
    GoalClauses clauses;
    clauses.locked = {locked};
    const GoalSolution found = solve_goal(model, mounting, kStart, X, {}, clauses);
    ASSERT_TRUE(found.reachable) << locked;
    EXPECT_EQ(found.q[static_cast<std::size_t>(locked)], kStart[static_cast<std::size_t>(locked)]);
  }
}

TEST(GoalClauses, NearChoosesAmongSolutions) {
  const RobotModel model = arm();
  const Mounting mounting = mounting_of(model);
  const Pose X = tool_pose(model, mounting, kStart);
  GoalClauses clauses;
  clauses.locked = {kBase};
  clauses.near = {{4, -150}, {5, -60}};  // the wrist the other way round
  const GoalSolution found = solve_goal(model, mounting, kStart, X, {}, clauses);
  ASSERT_TRUE(found.reachable);
  EXPECT_LT(found.q[5], 0);
}

}  // namespace
}  // namespace rubicon::robot
