#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scripted_run.hpp"

namespace rubicon::test {
namespace {

using interpreter::MotionEnd;
using interpreter::MotionStatus;
using interpreter::MotionTask;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

guides::GuideSpec guide_of(guides::GuideKind kind = guides::GuideKind::rrt_connect) {
  guides::GuideSpec spec = guides::default_guide(kind);
  spec.name = "way";
  return spec;
}

/// A wall with a gap at y > 8, between x = 4 and 6 (the gantry goes from 0 to 10).
bool in_wall(std::span<const double> q) { return q[0] > 3.5 && q[0] < 6.5 && q[1] < 8; }

/// Straight pieces are sampled.
class WallWorld : public PredicateWorld {
 public:
  std::optional<interpreter::HitPair> refusal(const interpreter::MotionStep& step) const override {
    std::vector<double> q(step.q_from.size());
    for (int k = 0; k <= 200; ++k) {
      for (std::size_t i = 0; i < q.size(); ++i) {
        q[i] = step.q_from[i] + k / 200.0 * (step.q_to[i] - step.q_from[i]);
      }
      if (auto pair = blocked_at(q)) return pair;
    }
    return std::nullopt;
  }
  std::optional<interpreter::HitPair> propose(const interpreter::MotionStep& step) override {
    return refusal(step);
  }
};

class GuidedMotion : public ::testing::Test {
 protected:
  GuidedMotion() { world_.blocked = in_wall; }

  MotionTask task(const Scenario& setup) {
    MotionTask motion = setup.task({{"x", 1}, {"y", 1}}, {{"x", 9}, {"y", 1}});
    motion.guides = {guide_of()};
    return motion;
  }

  WallWorld world_;
  EventLog log_;
};

constexpr const char* kFollow = "chain { follow };";

TEST_F(GuidedMotion, FollowIsRefusedNothingOnAWayThatWasFound) {
  const Scenario setup = set_up(kGantry, kFollow);
  const MotionEnd end = run(setup, task(setup), world_, &log_);
  EXPECT_TRUE(end.reached) << end.message;
  EXPECT_EQ(end.rejected.hit, 0);
  EXPECT_THAT(log_.lines, Contains(StartsWith("guide way: ")));
  EXPECT_THAT(log_.lines, Contains(StartsWith("waypoint 1 of ")));
}

TEST_F(GuidedMotion, WithoutAGuideFollowGoesStraightToTheGoal) {
  const Scenario setup = set_up(kGantry, kFollow);
  MotionTask motion = task(setup);
  motion.guides.clear();
  const MotionEnd end = run(setup, motion, world_, &log_);
  EXPECT_FALSE(end.reached);
  EXPECT_EQ(end.rejected.hit, 1);
}

TEST_F(GuidedMotion, GoalsAndSituationsAreThoseOfTheWayPoint) {
  const Scenario setup = set_up(kGantry,
                                "which { via: chain { move_to(y, goal(y)), move_to(x, goal(x)) }; "
                                "guided: chain { follow }; default: wait; };");
  MotionTask motion = task(setup);
  motion.budget = 200;
  run(setup, motion, world_, &log_);
  EXPECT_THAT(log_.lines, Contains(HasSubstr("which via")));
  EXPECT_THAT(log_.lines, testing::Not(Contains(HasSubstr("which default"))));
}

TEST_F(GuidedMotion, NoWayEndsTheMotionWithWhatWasTriedAndMet) {
  const Scenario setup = set_up(kGantry, kFollow);
  world_.blocked = [](std::span<const double> q) { return q[0] > 3.5 && q[0] < 6.5; };
  MotionTask motion = task(setup);
  motion.guides.front().nodes = 40;
  const MotionEnd end = run(setup, motion, world_);
  EXPECT_EQ(end.status, MotionStatus::no_way);
  EXPECT_THAT(end.message, StartsWith("guide way (rrt_connect): no way found with "));
  EXPECT_THAT(end.message, HasSubstr("robot.body meets wall"));
  EXPECT_EQ(end.tries, 0);
}

TEST_F(GuidedMotion, AGoalInContactIsSaidAtOnce) {
  const Scenario setup = set_up(kGantry, kFollow);
  MotionTask motion = setup.task({{"x", 1}, {"y", 1}}, {{"x", 5}, {"y", 1}});
  motion.guides = {guide_of()};
  const MotionEnd end = run(setup, motion, world_);
  EXPECT_EQ(end.status, MotionStatus::no_way);
  EXPECT_EQ(end.message,
            "guide way (rrt_connect): no way: the robot may not stand at the goal: robot.body "
            "meets wall");
}

TEST_F(GuidedMotion, TheSecondGuideIsAskedWhereTheFirstFindsNothing) {
  const Scenario setup = set_up(kGantry, kFollow);
  MotionTask motion = task(setup);
  guides::GuideSpec weak = guide_of(guides::GuideKind::rrt);
  weak.name = "weak";
  weak.nodes = 3;
  motion.guides.insert(motion.guides.begin(), weak);
  const MotionEnd end = run(setup, motion, world_, &log_);
  EXPECT_TRUE(end.reached) << end.message;
  EXPECT_THAT(log_.lines, Contains(StartsWith("guide weak: no way found with 3 nodes")));
  EXPECT_THAT(log_.lines, Contains(HasSubstr("guide way: ")));
}

TEST_F(GuidedMotion, AScriptThatEndsShortIsPlannedForAgainFromThere) {
  // Two steps for each waypoint: the guide plans on from where they lead.
  const Scenario setup = set_up(kGantry, "follow; follow;");
  MotionTask motion = task(setup);
  motion.guides.front().replans = 100;
  const MotionEnd end = run(setup, motion, world_, &log_);
  EXPECT_TRUE(end.reached) << end.message;
  EXPECT_GE(std::count_if(log_.lines.begin(), log_.lines.end(),
                          [](const std::string& line) { return line.starts_with("guide way:"); }),
            2);
}

TEST_F(GuidedMotion, AScriptThatNeverStepsIsGivenUp) {
  const Scenario setup = set_up(kGantry, "var(n) = 1;");
  const MotionEnd end = run(setup, task(setup), world_);
  EXPECT_EQ(end.status, MotionStatus::done);
  EXPECT_FALSE(end.reached);
  EXPECT_THAT(end.message, HasSubstr("at 2 waypoints in a row the script made no step"));
}

TEST_F(GuidedMotion, ReplansAreCountedAndTheMotionEnds) {
  const Scenario setup = set_up(kGantry, "move_dir(x, -1);");
  MotionTask motion = task(setup);
  motion.guides.front().replans = 3;
  const MotionEnd end = run(setup, motion, world_, &log_);
  EXPECT_FALSE(end.reached);
  EXPECT_EQ(std::count_if(log_.lines.begin(), log_.lines.end(),
                          [](const std::string& line) { return line.starts_with("guide way:"); }),
            4);
  // Each is another way.
  const double first = motion.guides.front().seed;
  EXPECT_THAT(log_.seeds, ElementsAre(first, first + 1, first + 2, first + 3));
}

/// Scripts that go to and fro, count or look at the clock end by livelock, circling, budget or with
/// their replans, whatever the guide does.
TEST_F(GuidedMotion, NoScriptRunsForEverUnderAGuide) {
  const char* const scripts[] = {
      "chain { move_dir(x, 1), move_dir(x, -1) };",
      "cycle { move_dir(x, -1), move_dir(y, 1), move_dir(x, 1), move_dir(y, -1) };",
      "var(n) = 0; chain { var(n) = var(n) + 1, wait };",
      "chain { move_to(x, goal(x)), move_dir(y, -1) } until (time() > 1e9);",
      "cycle { follow, move_dir(y, -1) } until (y > 100);",
      "chain { wait } until (time() > 5); move_dir(x, -1);",
      "which { guided: move_dir(y, 1); default: wait; };"};
  for (const char* script : scripts) {
    const Scenario setup = set_up(kGantry, script);
    MotionTask motion = task(setup);
    motion.budget = 500;
    const MotionEnd end = run(setup, motion, world_);
    EXPECT_LE(end.tries, 501) << script;
  }
}

/// A copy of a machine under way makes the same steps as the machine: all its state is a value.
TEST_F(GuidedMotion, ACopyOfTheMachineGoesOnTheSameWay) {
  const Scenario setup = set_up(kGantry, kFollow);
  interpreter::Machine machine(*setup.program, task(setup));
  for (int n = 0; n < 4; ++n) ASSERT_TRUE(machine.advance(world_, nullptr));
  interpreter::Machine copy = machine;
  EXPECT_EQ(copy.state_hash(world_), machine.state_hash(world_));
  while (machine.advance(world_, nullptr)) {
    ASSERT_TRUE(copy.advance(world_, nullptr));
    EXPECT_EQ(copy.q(), machine.q());
    EXPECT_EQ(copy.state_hash(world_), machine.state_hash(world_));
  }
  EXPECT_FALSE(copy.advance(world_, nullptr));
  EXPECT_TRUE(copy.end().reached);
}

}  // namespace
}  // namespace rubicon::test
