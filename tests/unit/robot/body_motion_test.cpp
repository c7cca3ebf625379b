#include "src/motion/robot/body_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/chain_bound.hpp"
#include "src/motion/robot/frame_chain.hpp"
#include "src/motion/robot/leg_frames.hpp"
#include "tests/unit/robot/robots.hpp"

namespace rubicon::robot {
namespace {

using geometry::GeneralMotion;
using geometry::Motion;
using geometry::ScrewMotion;

const ScrewMotion* screw_of(const Motion& motion) { return std::get_if<ScrewMotion>(&motion.kind); }

const GeneralMotion* general_of(const Motion& motion) {
  const auto* general = std::get_if<std::shared_ptr<const GeneralMotion>>(&motion.kind);
  return general ? general->get() : nullptr;
}

bool only_translates(const Motion& motion) {
  return motion.moves() && screw_of(motion) != nullptr && screw_of(motion)->angle_deg == 0;
}

/// Every motion has to pass through the poses of its frame at the interpolated configuration.
void expect_follows_frames(const RobotModel& model, const Mounting& mounting,
                           const std::vector<double>& q0, const std::vector<double>& q1,
                           const std::vector<Motion>& motions) {
  ASSERT_EQ(motions.size(), model.bodies.size() + 1);
  for (int k = 0; k <= 8; ++k) {
    const double s = k / 8.0;
    std::vector<double> q = q0;
    for (std::size_t i = 0; i < q.size(); ++i) q[i] += s * (q1[i] - q0[i]);
    std::vector<Pose> X;
    body_poses(model, mounting, q, X);
    X.push_back(tool_pose(model, mounting, q));
    for (std::size_t i = 0; i < X.size(); ++i) {
      EXPECT_LT((motions[i].pose(s).matrix() - X[i].matrix()).norm(), 2e-12)
          << "body " << i << " at s = " << s;
    }
  }
}

TEST(StepMotions, RaisingTheHookIsAnExactTranslation) {
  const RobotModel model = crane();
  const Mounting mounting = mounting_of(model);
  const std::vector<double> q0 = {30, 20, 10}, q1 = {30, 20, 11};
  const auto motions = step_motions(model, mounting, q0, q1);
  EXPECT_FALSE(motions[0].moves());
  EXPECT_FALSE(motions[1].moves());
  ASSERT_TRUE(only_translates(motions[2]));
  EXPECT_EQ(screw_of(motions[2])->slide, Vec3(0, 0, 1));
  EXPECT_EQ(screw_of(motions[3])->slide, Vec3(0, 0, 1));
  expect_follows_frames(model, mounting, q0, q1, motions);
}

TEST(StepMotions, TurningTheJibIsARotationAboutTheMast) {
  const RobotModel model = crane();
  const Mounting mounting = mounting_of(model, math::translation(5, 6, 7));
  const std::vector<double> q0 = {175, 20, 10}, q1 = {185, 20, 10};
  const auto motions = step_motions(model, mounting, q0, q1);
  EXPECT_FALSE(motions[0].moves());
  for (std::size_t i = 1; i < motions.size(); ++i) {
    const ScrewMotion* screw = screw_of(motions[i]);
    ASSERT_NE(screw, nullptr);
    EXPECT_EQ(screw->angle_deg, 10);
    EXPECT_EQ(screw->axis, Vec3(0, 0, 1));
    EXPECT_EQ(screw->point, Vec3(5, 6, 7));
    EXPECT_EQ(screw->slide, Vec3(0, 0, 0));
  }
  expect_follows_frames(model, mounting, q0, q1, motions);
}

TEST(StepMotions, DrivingAlongTheHeadingIsATranslation) {
  const RobotModel model = agent();
  const Mounting mounting = mounting_of(model);
  const std::vector<double> q0 = {1, 2, 0, 30};
  std::vector<double> q1(4);
  apply_rules(model, mounting, q0, one_step(model, 0, 0.5), q1);
  const auto motions = step_motions(model, mounting, q0, q1);
  ASSERT_TRUE(only_translates(motions[0]));
  EXPECT_NEAR(screw_of(motions[0])->slide.norm(), 0.5, 1e-15);
  const std::vector<double> q2 = {1, 2, 0, 45};
  const auto turning = step_motions(model, mounting, q0, q2);
  ASSERT_NE(screw_of(turning[0]), nullptr);
  EXPECT_EQ(screw_of(turning[0])->point, Vec3(1, 2, 0));
  expect_follows_frames(model, mounting, q0, q2, turning);
}

TEST(StepMotions, LiftingWhileTurningIsAScrewAndReachingWhileTurningIsGeneral) {
  const RobotModel model = crane();
  const Mounting mounting = mounting_of(model);
  const std::vector<double> q0 = {0, 20, 10}, lifted = {20, 20, 14}, reached = {20, 24, 10};
  const auto screw = step_motions(model, mounting, q0, lifted);
  ASSERT_NE(screw_of(screw[2]), nullptr);
  EXPECT_EQ(screw_of(screw[2])->slide, Vec3(0, 0, 4));
  expect_follows_frames(model, mounting, q0, lifted, screw);
  const auto general = step_motions(model, mounting, q0, reached);
  EXPECT_NE(screw_of(general[1]), nullptr) << "the jib only turns";
  EXPECT_NE(general_of(general[2]), nullptr);
  EXPECT_NE(general_of(general[3]), nullptr);
  expect_follows_frames(model, mounting, q0, reached, general);
}

TEST(StepMotions, TwoTurnsAboutOneLineAreOne) {
  RobotModel model;
  add_body(model, "ring", -1);
  const int a = add_cyclic(model, "theta", 1);
  model.bodies[0].frame = {trans(1, 2, 3), rotz(of(a))};
  add_body(model, "inner", 0);
  const int b = add_cyclic(model, "theta", 1);
  model.bodies[1].frame = {trans(0, 0, 5), rotz(-of(b)), trans(2, 0, 0)};
  const Mounting mounting = mounting_of(model);
  const std::vector<double> q0 = {10, 20}, q1 = {40, 30};
  const auto motions = step_motions(model, mounting, q0, q1);
  ASSERT_NE(screw_of(motions[1]), nullptr);
  EXPECT_EQ(screw_of(motions[1])->angle_deg, 20);
  expect_follows_frames(model, mounting, q0, q1, motions);
}

TEST(StepMotions, ATranslationThatGrowsUnevenlyIsGeneral) {
  RobotModel model;
  add_body(model, "slider", -1);
  const int phi = add_cyclic(model, "phi", 1);
  model.bodies[0].frame = {trans(number(3) * cos_of(of(phi)), number(0), number(2) * of(phi))};
  const Mounting mounting = mounting_of(model);
  const std::vector<double> q0 = {10}, q1 = {40};
  const auto motions = step_motions(model, mounting, q0, q1);
  EXPECT_NE(general_of(motions[0]), nullptr);
  expect_follows_frames(model, mounting, q0, q1, motions);
}

TEST(StepMotions, AreCorrectForTheArmsAndOutliveTheirArguments) {
  const RobotModel model = excavator();
  std::vector<Motion> motions;
  std::vector<double> q0 = {10, -30, 60, 20}, q1 = {15, -28, 57, 24};
  {
    const Mounting mounting =
        mounting_of(model, math::translation(3, 1, 0) * math::rotation_z_deg(33));
    std::vector<double> from = q0, to = q1;
    motions = step_motions(model, mounting, from, to);
  }
  expect_follows_frames(model,
                        mounting_of(model, math::translation(3, 1, 0) * math::rotation_z_deg(33)),
                        q0, q1, motions);
}

TEST(StepMotions, EndExactlyAtTheEndOfAGeneralMotion) {
  const RobotModel model = excavator();
  const Mounting mounting = mounting_of(model);
  const std::vector<double> q0 = {0.1, -30.7, 60.3, 20.9}, q1 = {5.3, -28.1, 57.7, 24.2};
  const auto motions = step_motions(model, mounting, q0, q1);
  EXPECT_EQ(motions.back().pose(1).matrix(), tool_pose(model, mounting, q1).matrix());
  EXPECT_EQ(motions.back().pose(0).matrix(), tool_pose(model, mounting, q0).matrix());
}

/// A chain of one to four bodies with elements of every kind, some uneven; every parameter changes
/// over the step.
struct RandomChain {
  RobotModel model;
  std::vector<double> q0, q1;
};

enum class Elements { any, linear };

RandomChain random_chain(std::mt19937_64& random, Elements elements) {
  std::uniform_real_distribution<double> length(-6, 6);
  std::uniform_real_distribution<double> angle(-180, 180);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  RandomChain chain;
  const int bodies = 1 + pick(4);
  for (int b = 0; b < bodies; ++b) {
    add_body(chain.model, "b" + std::to_string(b), b - 1);
    const int theta = add_cyclic(chain.model, "theta", 1);
    const int x = add_parameter(chain.model, "x", -100, 100, 1);
    chain.q0.push_back(angle(random));
    chain.q1.push_back(chain.q0.back() +
                       (pick(5) == 0 ? 0 : angle(random) / (pick(4) == 0 ? 1.5 : 15)));
    chain.q0.push_back(length(random));
    chain.q1.push_back(chain.q0.back() + (pick(3) == 0 ? 0 : length(random) / 5));
    FrameFormula& frame = chain.model.bodies.back().frame;
    for (int i = 0; i < 3; ++i) {
      const Formula uneven = elements == Elements::linear ? number(180) - of(theta) * number(0.5)
                                                          : number(20) * sin_of(of(theta));
      const Formula turn = pick(3) == 0 ? number(angle(random)) : pick(4) == 0 ? uneven : of(theta);
      switch (pick(5)) {
        case 0:
          frame.push_back(rotx(turn));
          break;
        case 1:
          frame.push_back(roty(-turn));
          break;
        case 2:
          frame.push_back(rotz(turn));
          break;
        case 3:
          frame.push_back(trans(of(x), number(length(random)), number(0)));
          break;
        default:
          frame.push_back(trans(number(length(random)),
                                elements == Elements::linear
                                    ? of(x) * number(-0.7) + of(theta) * number(0.01)
                                    : of(x) * cos_of(of(theta)),
                                number(length(random))));
      }
    }
  }
  chain.model.tool_frame = {trans(length(random), length(random), length(random))};
  return chain;
}

void expect_bounds_every_point(Elements elements) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> unit(0, 1);
  int generals = 0;
  double closest = 0;
  for (int i = 0; i < 1500; ++i) {
    const RandomChain chain = random_chain(random, elements);
    const Mounting mounting =
        mounting_of(chain.model, math::translation(3, 4, 5) * math::rotation_x_deg(20));
    const auto motions = step_motions(chain.model, mounting, chain.q0, chain.q1);
    expect_follows_frames(chain.model, mounting, chain.q0, chain.q1, motions);
    for (const Motion& motion : motions) {
      const GeneralMotion* general = general_of(motion);
      if (!general) continue;
      ++generals;
      const double reach = 4 * unit(random);
      double s0 = unit(random), s1 = unit(random);
      if (s0 > s1) std::swap(s0, s1);
      if (generals % 3 == 0) s0 = 0, s1 = 1;
      const Vec3 point =
          reach * Vec3(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5).normalized();
      const double bound = general->chord_deviation(s0, s1, reach);
      const Vec3 begin = general->pose(s0) * point;
      const Vec3 end = general->pose(s1) * point;
      for (int k = 1; k < 40; ++k) {
        const double part = k / 40.0;
        const Vec3 x = general->pose(s0 + part * (s1 - s0)) * point;
        const double off = (x - (begin + part * (end - begin))).norm();
        EXPECT_LE(off, bound + 1e-12);
        if (bound > 0) closest = std::max(closest, off / bound);
      }
    }
  }
  EXPECT_GT(generals, 1500);
  EXPECT_GT(closest, 0.5) << "the bound is uselessly loose";
}

TEST(ChordDeviation, BoundsEveryPointOfRandomChainsByDenseSampling) {
  expect_bounds_every_point(Elements::any);
}

TEST(ChordDeviation, BoundsEveryPointOfLinearChainsByDenseSampling) {
  expect_bounds_every_point(Elements::linear);
}

/// The bound of linear chains is read off the chain, that of others is found by intervals.
TEST(ChordDeviation, IsNotMuchLooserForLinearChainsThanByIntervals) {
  std::mt19937_64 random(22);
  std::vector<double> ratios;
  for (int i = 0; i < 500; ++i) {
    const RandomChain chain = random_chain(random, Elements::linear);
    const Mounting mounting = mounting_of(chain.model, Pose::Identity());
    ChainBound chain_bound;
    const auto elements = elements_to_tool(chain.model);
    for (const FrameElement* each : elements) {
      chain_bound.append(*each, chain.q0, chain.q1, mounting.starts);
    }
    const auto bound = chain_bound.bound();
    ASSERT_TRUE(bound.has_value());
    const AccelerationBound by_intervals =
        acceleration_bound(elements, chain.q0, chain.q1, mounting.starts);
    EXPECT_LE(bound->turning, by_intervals.turning * (1 + 1e-9) + 1e-12);
    if (by_intervals.origin > 0) ratios.push_back(bound->origin / by_intervals.origin);
  }
  ASSERT_GT(ratios.size(), 300U);
  std::sort(ratios.begin(), ratios.end());
  EXPECT_LT(ratios[ratios.size() / 2], 3);
}

/// X_WF of a lane.
Pose pose_of(const math::LaneFrame& frame, int lane) {
  Pose X = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) X.linear()(row, col) = frame.R[row][col].v[lane];
    X.translation()[row] = frame.t[row].v[lane];
  }
  return X;
}

TEST(LegFrames, StandAndMoveAsTheFramesDo) {
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> unit(0, 1);
  double closest = 0;
  for (int i = 0; i < 500; ++i) {
    const RandomChain chain = random_chain(random, Elements::linear);
    const Mounting mounting =
        mounting_of(chain.model, math::translation(3, 4, 5) * math::rotation_x_deg(20));
    LegFrames frames(chain.model, mounting);
    ASSERT_TRUE(frames.set_leg(chain.q0, chain.q1));
    const double middle = 0.1 + 0.8 * unit(random);
    constexpr double kHalf = 0.05;
    const double shares[] = {middle - kHalf, middle, middle + kHalf, 1};
    std::vector<math::LaneFrame> at(static_cast<std::size_t>(frames.count()));
    frames.poses(shares, at.data());
    const Vec3 point =
        4 * unit(random) * Vec3(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5);
    for (int lane = 0; lane < math::kLanes; ++lane) {
      const auto q = configuration_at(chain.q0, chain.q1, shares[lane]);
      std::vector<Pose> X_WB;
      body_poses(chain.model, mounting, q, X_WB);
      X_WB.push_back(tool_pose(chain.model, mounting, q));
      for (std::size_t f = 0; f < at.size(); ++f) {
        EXPECT_LT((pose_of(at[f], lane).matrix() - X_WB[f].matrix()).norm(), 1e-10);
      }
    }
    // A point goes as its velocity says, but for what it accelerates at most.
    for (int f = 0; f < frames.count(); ++f) {
      const math::LaneFrame& frame = at[static_cast<std::size_t>(f)];
      const auto [acceleration, moves] = frames.motion(-1, f);
      const double most = acceleration.origin + acceleration.turning * point.norm();
      const Vec3 arm = pose_of(frame, 1).linear() * point;
      const Vec3 v(frame.v[0].v[1], frame.v[1].v[1], frame.v[2].v[1]);
      const Vec3 w(frame.w[0].v[1], frame.w[1].v[1], frame.w[2].v[1]);
      for (const int side : {-1, 1}) {
        const Vec3 went = pose_of(frame, 1 + side) * point - pose_of(frame, 1) * point;
        const double off = (went - side * kHalf * (v + w.cross(arm))).norm();
        const double bound = 0.5 * kHalf * kHalf * most;
        EXPECT_LE(off, bound + 1e-10);
        if (bound > 1e-6) closest = std::max(closest, off / bound);
        EXPECT_TRUE(moves || went.norm() < 1e-12);
      }
    }
  }
  EXPECT_GT(closest, 0.5) << "the bound is uselessly loose";
}

TEST(LegFrames, SeenFromABodyThatCarriesThemTheyAccelerateLess) {
  // A jib that slews carries a hook: as the jib sees it, the hook runs straight on.
  const RobotModel model = crane();
  LegFrames frames(model, mounting_of(model));
  ASSERT_TRUE(frames.set_leg(std::vector<double>{0, 20, 10}, std::vector<double>{90, 25, 10}));
  EXPECT_GT(frames.motion(-1, 2).acceleration.origin, 10);
  EXPECT_EQ(frames.motion(1, 2).acceleration.origin, 0);
  EXPECT_TRUE(frames.motion(1, 2).moves);
  EXPECT_FALSE(frames.motion(-1, 0).moves);
}

TEST(ChordDeviation, ShrinksWithTheSquareOfTheIntervalAndIsTightForACircle) {
  const RobotModel model = crane();
  const Mounting mounting = mounting_of(model);
  // The trolley moves by a hair, so that the hook's motion is general but all but a circle of 20 m
  // radius.
  const auto motions = step_motions(model, mounting, std::vector<double>{0, 20, 10},
                                    std::vector<double>{5, 20 + 1e-9, 10});
  const GeneralMotion* hook = general_of(motions[2]);
  ASSERT_NE(hook, nullptr);
  const double sagitta = 20 * (1 - math::cos_deg(2.5));
  EXPECT_GE(hook->chord_deviation(0, 1, 0), sagitta * 0.99999);
  EXPECT_LE(hook->chord_deviation(0, 1, 0), sagitta * 1.05);
  EXPECT_NEAR(hook->chord_deviation(0.5, 0.75, 0) * 16, hook->chord_deviation(0, 1, 0), 1e-12);
  EXPECT_EQ(hook->chord_deviation(0.3, 0.3, 5), 0);
}

}  // namespace
}  // namespace rubicon::robot
