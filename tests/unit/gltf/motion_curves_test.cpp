#include "src/results/gltf/motion_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "src/motion/math/angles.hpp"
#include "src/simulation/trace/formula_reader.hpp"

namespace rubicon::gltf {
namespace {

using replay::Leg;
using replay::Machine;

constexpr replay::Ticks kSecond = 1'000'000'000;

/// One cyclic angle; the frame has its sine, a product, and the angle itself.
Machine turner() {
  Machine robot;
  const std::vector<std::string> names = {"theta", "x"};
  for (const std::string& name : names) {
    robot::Parameter& parameter = robot.model.parameters.emplace_back();
    parameter.name = parameter.display_name = name;
    parameter.rotation = parameter.cyclic = name == "theta";
    robot.mounting.starts.push_back(0);
  }
  robot.model.bodies.resize(1);
  robot.model.bodies[0].frame =
      trace::read_frame("trans(5 * sin(theta), x * x, 1) * rotz(2 * theta)", names);
  return robot;
}

replay::RobotTrack track(
    const std::vector<std::pair<std::vector<double>, std::vector<double>>>& steps) {
  replay::RobotTrack track;
  replay::Ticks now = 0;
  for (const auto& [from, to] : steps) {
    Leg& leg = track.legs.emplace_back();
    leg.from = now;
    now += 2 * kSecond;
    leg.to = now;
    leg.q0 = from;
    leg.q1 = to;
  }
  return track;
}

Vec3 interpolated(const KeyCurve& curve, double time) {
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
    EXPECT_LT((interpolated(moves, time) - expected).cwiseAbs().maxCoeff(), kCurveSlack) << time;
    EXPECT_NEAR(interpolated(turns, time).x(), 2 * theta, kTurnSlack)
        << time;  // over half a turn and on
  }
}

TEST(MotionCurves, HaveNoKeysWhereNothingMoves) {
  const auto frames = motion_curves(turner(), track({{{0, 0}, {0, 0}}}));
  EXPECT_TRUE(frames[0][0].keys.empty());
  EXPECT_TRUE(frames[0][1].keys.empty());
  EXPECT_EQ(frames[0][0].start, Vec3(0, 0, 1));
  replay::RobotTrack standing;
  standing.legs.push_back({0, kSecond, {0, 0}, {}, -1});
  EXPECT_TRUE(motion_curves(turner(), standing)[0][0].keys.empty());
}

TEST(MotionCurves, RefuseFramesBeyondAllBounds) {
  const std::vector<std::string> names = {"theta", "x"};
  Machine robot = turner();
  for (const char* frame : {"trans(1 / x, 0, 0)", "rotz(1000000000000 * x)",
                            "trans(1000000000000 * x, 0, 0) * rotx(x / 0)"}) {
    robot.model.bodies[0].frame = trace::read_frame(frame, names);
    EXPECT_THROW(motion_curves(robot, track({{{0, 0}, {0, 1}}})), std::invalid_argument) << frame;
  }
}

TEST(MotionCurves, RefuseTurnsThatMakeMoreKeysThanAFilmHas) {
  Machine robot = turner();
  robot.model.bodies[0].frame = trace::read_frame("rotz(10000000 * x)", {"theta", "x"});
  std::vector<std::pair<std::vector<double>, std::vector<double>>> steps = {{{0, 0}, {0, 9}}};
  const std::size_t few = film_keys(motion_curves(robot, track(steps)));
  EXPECT_EQ(few, 1'000'001U);  // quarters
  for (int i = 0; i < 4; ++i) steps.push_back({steps.back().second, steps.back().first});
  EXPECT_THROW(motion_curves(robot, track(steps)), std::invalid_argument);
}

TEST(MotionCurves, StandStillBetweenSteps) {
  auto steps = track({{{0, 0}, {0, 1}}, {{0, 1}, {0, 2}}});
  steps.legs[1].from += 100 * kSecond;
  steps.legs[1].to += 100 * kSecond;
  const KeyCurve keys = motion_curves(turner(), steps)[0][0].keys;
  EXPECT_NEAR(interpolated(keys, 2.5).y(), 1, kCurveSlack);
  EXPECT_NEAR(interpolated(keys, 101.9).y(), 1, kCurveSlack);
  EXPECT_NEAR(keys.back().value.y(), 4, kCurveSlack);
}

}  // namespace
}  // namespace rubicon::gltf
