#include "src/results/gltf/motion_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/motion/math/angles.hpp"

namespace rubicon::gltf {
namespace {

using verify::Leg;
using verify::SceneRobot;

/// One cyclic angle; the frame has its sine, a product, and the angle itself.
SceneRobot turner() {
  SceneRobot robot;
  const std::vector<std::string> names = {"theta", "x"};
  for (const std::string& name : names) {
    verify::SceneParameter& parameter = robot.parameters.emplace_back();
    parameter.name = name;
    parameter.rotation = parameter.cyclic = name == "theta";
    robot.starts.push_back(0);
  }
  robot.bodies.resize(1);
  robot.bodies[0].frame =
      verify::parse_frame("trans(5 * sin(theta), x * x, 1) * rotz(2 * theta)", names);
  return robot;
}

verify::RobotTrack track(
    const std::vector<std::pair<std::vector<double>, std::vector<double>>>& steps) {
  verify::RobotTrack track;
  verify::Ticks now = 0;
  for (const auto& [from, to] : steps) {
    Leg& leg = track.legs.emplace_back();
    leg.from = now;
    now += 2 * verify::kSecond;
    leg.to = now;
    leg.q0 = from;
    leg.q1 = to;
  }
  return track;
}

Vec3 at(const KeyCurve& curve, double time) {
  std::size_t i = 1;
  while (i + 1 < curve.size() && curve[i].time < time) ++i;
  const double share = (time - curve[i - 1].time) / (curve[i].time - curve[i - 1].time);
  return curve[i - 1].value + share * (curve[i].value - curve[i - 1].value);
}

TEST(MotionCurves, FollowWhatIsNoStraightLine) {
  const auto frames = motion_curves(
      turner(), track({{{0, 0}, {170, 3}}, {{170, 3}, {190, 3}}, {{-170, 3}, {-100, -1}}}));
  ASSERT_EQ(frames.size(), 2U);
  ASSERT_EQ(frames[0].size(), 2U);
  const KeyCurve& moves = frames[0][0].keys;
  const KeyCurve& turns = frames[0][1].keys;
  EXPECT_LT(moves.size(), 1000U);
  for (double time = 0; time <= 6; time += 0.013) {
    const double theta = time < 2   ? 85 * time
                         : time < 4 ? 170 + 10 * (time - 2)
                                    : 190 + 35 * (time - 4);
    const double x = time < 2 ? 1.5 * time : time < 4 ? 3 : 3 - 2 * (time - 4);
    const Vec3 expected(5 * std::sin(math::radians(theta)), x * x, 1);
    EXPECT_LT((at(moves, time) - expected).cwiseAbs().maxCoeff(), kCurveSlack) << time;
    EXPECT_NEAR(at(turns, time).x(), 2 * theta, kTurnSlack) << time;  // over half a turn and on
  }
}

TEST(MotionCurves, HaveNoKeysWhereNothingMoves) {
  const auto frames = motion_curves(turner(), track({{{0, 0}, {0, 0}}}));
  EXPECT_TRUE(frames[0][0].keys.empty());
  EXPECT_TRUE(frames[0][1].keys.empty());
  EXPECT_EQ(frames[0][0].start, Vec3(0, 0, 1));
  verify::RobotTrack standing;
  standing.legs.push_back({0, verify::kSecond, {0, 0}, {}, -1, -1, 0});
  EXPECT_TRUE(motion_curves(turner(), standing)[0][0].keys.empty());
}

TEST(MotionCurves, RefuseFramesBeyondAllBounds) {
  const std::vector<std::string> names = {"theta", "x"};
  SceneRobot robot = turner();
  for (const char* frame : {"trans(1 / x, 0, 0)", "rotz(1000000000000 * x)",
                            "trans(1000000000000 * x, 0, 0) * rotx(x / 0)"}) {
    robot.bodies[0].frame = verify::parse_frame(frame, names);
    EXPECT_THROW(motion_curves(robot, track({{{0, 0}, {0, 1}}})), verify::UnreadableInput) << frame;
  }
}

TEST(MotionCurves, RefuseTurnsThatMakeMoreKeysThanAFilmHas) {
  SceneRobot robot = turner();
  robot.bodies[0].frame = verify::parse_frame("rotz(10000000 * x)", {"theta", "x"});
  std::vector<std::pair<std::vector<double>, std::vector<double>>> steps = {{{0, 0}, {0, 9}}};
  const std::size_t few = film_keys(motion_curves(robot, track(steps)));
  EXPECT_EQ(few, 1'000'001U);  // quarters
  for (int i = 0; i < 4; ++i) steps.push_back({steps.back().second, steps.back().first});
  EXPECT_THROW(motion_curves(robot, track(steps)), verify::UnreadableInput);
}

TEST(MotionCurves, StandStillBetweenSteps) {
  auto steps = track({{{0, 0}, {0, 1}}, {{0, 1}, {0, 2}}});
  steps.legs[1].from += 100 * verify::kSecond;
  steps.legs[1].to += 100 * verify::kSecond;
  const KeyCurve keys = motion_curves(turner(), steps)[0][0].keys;
  EXPECT_NEAR(at(keys, 2.5).y(), 1, kCurveSlack);
  EXPECT_NEAR(at(keys, 101.9).y(), 1, kCurveSlack);
  EXPECT_NEAR(keys.back().value.y(), 4, kCurveSlack);
}

}  // namespace
}  // namespace rubicon::gltf
