#include "src/results/verify/input/mechanism.hpp"

#include <gtest/gtest.h>

#include "tests/unit/verify/random.hpp"

namespace rubicon::verify {
namespace {

SceneRobot robot_of(const std::vector<std::pair<int, std::string>>& frames,
                    const std::vector<std::string>& names, const std::string& tool) {
  SceneRobot robot;
  for (const auto& [parent, text] : frames) {
    SceneBody body;
    body.name = "body " + std::to_string(robot.bodies.size());
    body.parent = parent;
    body.frame = parse_frame(text, names);
    robot.bodies.push_back(body);
  }
  for (const std::string& name : names) {
    SceneParameter parameter;
    parameter.name = name;
    robot.parameters.push_back(parameter);
    robot.starts.push_back(0);
  }
  robot.tool_body = static_cast<int>(robot.bodies.size()) - 1;
  robot.tool_frame = parse_frame(tool, names);
  return robot;
}

SceneRobot crane() {
  return robot_of({{-1, "trans(0, 0, 0)"},
                   {0, "rotz(theta)"},
                   {1, "trans(x, 0, 30)"},
                   {2, "trans(0, 0, z - 30) * rotz(psi)"}},
                  {"theta", "x", "z", "psi"}, "trans(0, 0, -1)");
}

/// Joints about several axes, one frame that is not linear in its parameter, and two branches.
SceneRobot excavator() {
  return robot_of({{-1, "trans(x, 0, 1) * rotz(theta)"},
                   {0, "trans(1, 0, 2 * sin(phi)) * roty(phi)"},
                   {1, "trans(4, 0, 0) * roty(psi) * trans(x * 0.1, 0, 0)"},
                   {0, "trans(-2, 0, 0) * rotx(theta * 2)"}},
                  {"x", "theta", "phi", "psi"}, "trans(1, 0, 0) * rotz(psi)");
}

TEST(Mechanism, PutsTheHookOfACraneWhereItBelongs) {
  const SceneRobot robot = crane();
  const Mechanism mechanism(robot);
  const std::vector<double> q = {90, 12, 5, 30};
  const Pose X_WT = mechanism.pose(mechanism.tool(), q);
  EXPECT_TRUE(X_WT.translation().isApprox(Vec3(0, 12, 4), 1e-12));
  EXPECT_TRUE(X_WT.linear().isApprox(math::rotation_z_deg(120).linear(), 1e-12));
  EXPECT_TRUE(mechanism.state(q, q).changes.empty());
  EXPECT_TRUE(mechanism.state(q, q).X_WB.back().isApprox(X_WT, 1e-12));
}

TEST(Mechanism, KnowsWhatTwoFramesStandOn) {
  const SceneRobot robot = excavator();
  const Mechanism mechanism(robot);
  EXPECT_EQ(mechanism.common_frame(2, 3), 0);
  EXPECT_EQ(mechanism.common_frame(2, 1), 1);
  EXPECT_EQ(mechanism.common_frame(mechanism.tool(), 3), 3);
  EXPECT_EQ(mechanism.common_frame(3, 3), 3);
}

/// No point of a ball that is fixed to a frame gets farther from where it is at the middle than
/// the reach says, in the world or as another frame sees it.
void expect_reach_holds(const SceneRobot& robot, std::uint64_t seed) {
  const Mechanism mechanism(robot);
  Random random(seed);
  for (int round = 0; round < 300; ++round) {
    std::vector<double> from, to;
    const double size = random.whole(0, 1) == 0 ? 30 : 0.5;
    for (std::size_t i = 0; i < robot.parameters.size(); ++i) {
      from.push_back(random.real(-60, 60));
      to.push_back(random.whole(0, 2) == 0 ? from.back() : from.back() + random.real(-size, size));
    }
    const MechanismState state = mechanism.state(from, to);
    const int frame = random.whole(0, mechanism.tool());
    const int other = random.whole(-1, mechanism.tool());
    const int base = other < 0 ? -1 : mechanism.common_frame(frame, other);
    const double radius = random.real(0, 2);
    const Pose& X_WF = state.X_WB[static_cast<std::size_t>(frame)];
    const Vec3 centre_F = random.point(3);
    const Reach reach = mechanism.reach(state, frame, base, X_WF * centre_F, radius);
    const Pose X_WS = base < 0 ? Pose::Identity() : state.X_WB[static_cast<std::size_t>(base)];
    for (int sample = 0; sample < 30; ++sample) {
      std::vector<double> q;
      const double s = sample < 2 ? sample : random.real(0, 1);
      for (std::size_t i = 0; i < from.size(); ++i) q.push_back(from[i] + s * (to[i] - from[i]));
      const Vec3 p_F = centre_F + random.direction() * radius;
      const Vec3 n = random.direction();
      // As the base sees it, put back to where the base is at the middle.
      const Pose X_WS_now = base < 0 ? Pose::Identity() : mechanism.pose(base, q);
      const Vec3 now = X_WS * (X_WS_now.inverse() * (mechanism.pose(frame, q) * p_F));
      EXPECT_LE(n.dot(now - X_WF * p_F), reach.along(n) + 1e-9);
      EXPECT_LE((now - X_WF * p_F).norm(), reach.most() + 1e-9);
    }
  }
}

TEST(Mechanism, ReachHoldsForACrane) { expect_reach_holds(crane(), 2); }
TEST(Mechanism, ReachHoldsForAnExcavator) { expect_reach_holds(excavator(), 3); }

TEST(Mechanism, ReachCountsNothingAcrossAStraightMove) {
  const SceneRobot robot = crane();
  const Mechanism mechanism(robot);
  const std::vector<double> from = {0, 10, 5, 0};
  const std::vector<double> to = {0, 10, 5.5, 0};
  const Reach reach =
      mechanism.reach(mechanism.state(from, to), mechanism.tool(), -1, {10, 0, 4}, 3);
  EXPECT_EQ(reach.along(Vec3::UnitX()), 0);
  EXPECT_NEAR(reach.along(Vec3::UnitZ()), 0.25, 1e-12);
}

TEST(Mechanism, ReachShrinksWithTheInterval) {
  const SceneRobot robot = excavator();
  const Mechanism mechanism(robot);
  const std::vector<double> from = {1, 20, 30, 40};
  std::vector<double> to = from;
  for (double& value : to) value += 1e-4;
  const MechanismState state = mechanism.state(from, to);
  const Vec3 centre = state.X_WB.back().translation();
  EXPECT_LT(mechanism.reach(state, mechanism.tool(), -1, centre, 1).most(), 2e-3);
}

}  // namespace
}  // namespace rubicon::verify
