#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "src/simulation/site/make_site.hpp"
#include "src/simulation/site/robot_view.hpp"
#include "tests/support/stand_at.hpp"
#include "tests/unit/site/hit_text.hpp"
#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::site {
namespace {

using interpreter::HitPair;
using interpreter::MotionStep;
using math::translation;
using test::hit_text;
using Q = std::vector<double>;

/// Turns of the lower crane, over whatever is at (20, 0) when it points to -90 degrees.
const Q kBefore = {-120, 10, 20, 0};
const Q kAfter = {-60, 10, 20, 0};
/// The hook of the upper one at (20, 0): below, and above, the jib of the lower one.
const Q kLow = {0, 20, 20, 0};
const Q kHigh = {0, 20, 40, 0};

/// Two tower cranes: "crane" at the origin, its jib 44 m up, and "other" at (20, 20) with its jib
/// from 34 to 36 m.
interpreter::PlanModel two_cranes() {
  interpreter::PlanModel plan = test::crane_plan();
  plan.robots.push_back(plan.robots[0]);
  plan.robots[0].start = kLow;
  plan.robots[1].name = "other";
  plan.robots[1].X_WM = translation(20, 20, -10);
  plan.robots[1].start = kBefore;
  return plan;
}

class OtherMachines : public testing::Test {
 protected:
  interpreter::PlanModel plan_ = two_cranes();
  SiteWorld site_ = make_site(plan_);
  RobotView crane_{site_, 0};
  RobotView other_{site_, 1};

  std::optional<HitPair> lift(Ticks start = 0) { return crane_.propose({kLow, kHigh, start, 10}); }
};

TEST_F(OtherMachines, AStepOwnsAllThatItSweepsWhileItLasts) {
  const MotionStep up{kLow, kHigh, 0, 10};
  EXPECT_TRUE(crane_.would_accept(up));
  EXPECT_EQ(hit_text(other_.propose({kBefore, kAfter, 0, 100})), "free");
  // Neither where it began nor where it ends is in the way.
  const auto met = lift(50);
  EXPECT_EQ(hit_text(met), "crane.hook meets other.jib");
  EXPECT_EQ(met->machine, 1);
  EXPECT_EQ(met->zone_task, -1);
  EXPECT_EQ(site_.configuration(0), kLow);
  site_.set_time(99);
  EXPECT_FALSE(crane_.would_accept(up));
  site_.set_time(100);
  EXPECT_EQ(hit_text(lift(100)), "free");
  EXPECT_EQ(site_.configuration(0), kHigh);
}

TEST_F(OtherMachines, WhoWasFirstIsTheOneThatIsMet) {
  EXPECT_EQ(hit_text(lift()), "free");
  const auto met = other_.propose({kBefore, kAfter, 0, 100});
  EXPECT_EQ(hit_text(met), "other.jib meets crane.hook");
  EXPECT_EQ(met->machine, 0);
  // Half the way does not reach it.
  const Q half = {-110, 10, 20, 0};
  EXPECT_EQ(hit_text(other_.propose({kBefore, half, 0, 100})), "free");
}

TEST_F(OtherMachines, AStandingMachineOwnsWhereItStands) {
  test::stand_at(site_, 1, {-90, 10, 20, 0});
  EXPECT_EQ(hit_text(lift()), "crane.hook meets other.jib");
  EXPECT_EQ(hit_text(crane_.blocked_at(Q{0, 20, 35, 0})), "crane.hook meets other.jib");
  EXPECT_EQ(crane_.blocked_at(Q{0, 20, 35, 0})->machine, 1);
  EXPECT_EQ(hit_text(crane_.blocked_at(kHigh)), "free");
  // Up to touching it.
  const Q below = {0, 20, 33, 0};
  EXPECT_EQ(hit_text(crane_.propose({kLow, below, 0, 0})), "free");
}

TEST_F(OtherMachines, PosesAreNotTestedAgainstStepsInProgress) {
  ASSERT_FALSE(other_.propose({kBefore, kAfter, 0, 100}));
  EXPECT_EQ(hit_text(crane_.blocked_at(Q{0, 20, 35, 0})), "free");
  site_.set_time(100);
  EXPECT_EQ(hit_text(crane_.blocked_at(Q{0, 31.5, 34.5, 0})), "crane.hook meets other.jib");
}

TEST_F(OtherMachines, AStepOfNoTimeOrNoWayLeavesTheMachineStanding) {
  ASSERT_FALSE(other_.propose({kBefore, kAfter, 0, 0}));
  EXPECT_FALSE(site_.machine_state(1).step);
  EXPECT_TRUE(crane_.would_accept({kLow, kHigh, 0, 10}));
  const std::uint64_t version = crane_.version();
  ASSERT_FALSE(other_.propose({kAfter, kAfter, 0, 100}));  // it waits
  EXPECT_FALSE(site_.machine_state(1).step);
  EXPECT_EQ(crane_.version(), version);
}

TEST_F(OtherMachines, TheLoadIsPartOfTheSweep) {
  plan_.components.push_back(test::box_component("panel", {1, 1, 24}, translation(15, 11.34, -14)));
  site_ = make_site(plan_);
  site_.attach(1, 0);
  ASSERT_EQ(hit_text(other_.propose({kBefore, kAfter, 0, 100})), "free");
  // The hook at (20, 10): the panel passes below it, the other's hook does not reach up to it.
  const Q from = {26.565, 22.3607, 5, 0};
  const Q to = {26.565, 22.3607, 4, 0};
  const auto met = crane_.propose({from, to, 50, 10});
  EXPECT_EQ(hit_text(met), "crane.hook meets panel");
  EXPECT_EQ(met->machine, 1);
  EXPECT_EQ(met->moved, "crane.hook");
  site_.set_time(100);
  EXPECT_EQ(hit_text(crane_.propose({from, to, 100, 10})), "free");
}

TEST_F(OtherMachines, ZonesKeepMachinesOutButTheExemptOne) {
  const geometry::Shape zone{geometry::Box{{19, -1, 25}, {21, 1, 30}}, math::Pose::Identity()};
  site_.hold_zone(7, "dig", {{zone}, {}}, 1);
  const auto met = lift();
  EXPECT_EQ(hit_text(met), "crane.hook meets the zone of dig");
  EXPECT_EQ(met->machine, -1);
  EXPECT_EQ(met->zone_task, 7);
  EXPECT_EQ(hit_text(crane_.blocked_at(Q{0, 20, 27, 0})), "free");
  // The exempt one may come in: its hook at (20, 0, 27).
  EXPECT_EQ(hit_text(other_.propose({Q{-90, 20, 34, 0}, Q{-90, 20, 38, 0}, 0, 0})), "free");
  test::stand_at(site_, 1, kAfter);
  site_.release_zone(7);
  EXPECT_EQ(hit_text(lift()), "free");
}

TEST_F(OtherMachines, ZonesComeBeforeMachinesAndByTask) {
  test::stand_at(site_, 1, {-90, 10, 20, 0});
  const geometry::Shape zone{geometry::Box{{19, -1, 25}, {21, 1, 30}}, math::Pose::Identity()};
  site_.hold_zone(7, "dig", {{zone}, {}}, -1);
  site_.hold_zone(3, "pour", {{zone}, {}}, -1);
  EXPECT_EQ(lift()->zone_task, 3);
  site_.release_zone(3);
  EXPECT_EQ(lift()->zone_task, 7);
  site_.release_zone(7);
  EXPECT_EQ(lift()->machine, 1);
}

TEST_F(OtherMachines, SaysWhichMachineIsInAZone) {
  const std::vector<geometry::Shape> zone = {
      {geometry::Box{{19, -1, 30}, {21, 1, 38}}, math::Pose::Identity()}};
  EXPECT_FALSE(site_.machine_in({zone, {}}, -1));
  ASSERT_FALSE(other_.propose({kBefore, kAfter, 0, 100}));
  EXPECT_EQ(site_.machine_in({zone, {}}, -1), 1);
  EXPECT_EQ(site_.machine_in({zone, {}}, 0), 1);
  EXPECT_FALSE(site_.machine_in({zone, {}}, 1));
  site_.set_time(100);
  EXPECT_FALSE(site_.machine_in({zone, {}}, -1));
  test::stand_at(site_, 0, {0, 20, 35, 0});
  EXPECT_EQ(site_.machine_in({zone, {}}, -1), 0);
}

/// A panel 2 m high hangs on the hook of "crane" over a zone at (20, 0) that ends 10 m below it.
class LoadOverPeople : public testing::Test {
 protected:
  LoadOverPeople() {
    interpreter::PlanModel plan = test::crane_plan();
    plan.robots[0].start = {-30, 20, 20, 0};
    plan.components.push_back(test::box_component("panel", {1, 1, 2}, translation(0, 0, 0)));
    plan.components.push_back(test::box_component("office", {2, 2, 2}, translation(0, 20, 0)));
    plan.components.back().people = true;
    site_.emplace(make_site(plan));
    crane_.emplace(*site_, 0);
    math::Pose X_WO = site_->tool_pose(0);
    X_WO.translation().z() -= 2;
    site_->set_component_state(0, {true, X_WO, std::nullopt});
  }

  std::optional<SiteWorld> site_;
  std::optional<RobotView> crane_;
  const std::vector<geometry::Shape> zone_ = {
      {geometry::Box{{18, -2, 0}, {22, 2, 6}}, math::Pose::Identity()}};
  const std::vector<geometry::Shape> up_to_sky_ = {
      {geometry::Box{{18, -2, 0}, {22, 2, 1000}}, math::Pose::Identity()}};
  const std::vector<geometry::Shape> up_to_12_ = {
      {geometry::Box{{18, -2, 0}, {22, 2, 12}}, math::Pose::Identity()}};
  const Q before_{-30, 20, 20, 0}, after_{30, 20, 20, 0};
};

TEST_F(LoadOverPeople, IsRefusedAtAnyHeightUnlessTheZoneEnds) {
  const MotionStep turn{before_, after_, 0, 0};
  site_->hold_zone(7, "dig", {zone_, up_to_sky_}, -1);
  EXPECT_TRUE(crane_->would_accept(turn)) << "an empty hook may pass";
  EXPECT_FALSE(site_->machine_in({zone_, up_to_sky_}, -1));
  site_->attach(0, 0);
  const auto met = crane_->refusal(turn);
  EXPECT_EQ(hit_text(met), "panel meets the air above the zone of dig");
  EXPECT_EQ(met->zone_task, 7);
  site_->hold_zone(7, "dig", {zone_, up_to_12_}, -1);
  EXPECT_TRUE(crane_->would_accept(turn)) << "it passes at 18 m";
  site_->hold_zone(7, "dig", {zone_, up_to_sky_}, 0);
  EXPECT_TRUE(crane_->would_accept(turn)) << "the task's own robot may";
}

TEST_F(LoadOverPeople, KeepsATaskFromBeginning) {
  site_->attach(0, 0);
  test::stand_at(*site_, 0, {0, 20, 20, 0});
  EXPECT_EQ(site_->machine_in({zone_, up_to_sky_}, -1), 0);
  EXPECT_FALSE(site_->machine_in({zone_, up_to_12_}, -1));
  EXPECT_FALSE(site_->machine_in({zone_, up_to_sky_}, 0));
}

TEST_F(LoadOverPeople, SwitchesSafetyOnWhereTheWayLeads) {
  const auto safety = [&](const Q& q, const Q& goal) {
    return crane_->situation("safety", q, goal);
  };
  EXPECT_FALSE(safety(before_, after_)) << "nobody is there";
  site_->hold_zone(7, "dig", {zone_, up_to_12_}, -1);
  EXPECT_FALSE(safety(before_, after_)) << "it passes above what the zone says";
  site_->hold_zone(7, "dig", {zone_, up_to_sky_}, -1);
  EXPECT_TRUE(safety(before_, after_));
  EXPECT_FALSE(safety(after_, {60, 20, 20, 0})) << "they are passed";
  EXPECT_TRUE(safety(after_, {90, 20, 20, 0})) << "the office is at 90 degrees";
  site_->attach(0, 0);
  EXPECT_TRUE(safety(before_, after_));
  site_->release_zone(7);
  EXPECT_FALSE(safety(before_, after_));
  EXPECT_TRUE(safety(after_, {90, 20, 20, 0}));
  site_->remove(1);
  EXPECT_FALSE(safety(after_, {90, 20, 20, 0}));
}

TEST_F(OtherMachines, FreeDistanceEndsAtOthers) {
  const Q q = {0, 20, 34.5, 0};
  EXPECT_EQ(crane_.free_distance(q, 180, 5), 5);
  ASSERT_FALSE(other_.propose({kBefore, kAfter, 0, 100}));
  EXPECT_EQ(crane_.free_distance(q, 180, 5), 0);
  site_.set_time(100);
  const geometry::Shape zone{geometry::Box{{10, -1, 30}, {15.5, 1, 38}}, math::Pose::Identity()};
  site_.hold_zone(7, "dig", {{zone}, {}}, -1);
  // From the hook's side at 19.5 to the zone.
  EXPECT_NEAR(crane_.free_distance(q, 180, 5), 4 + plan_.contact, 3e-6);
}

TEST_F(OtherMachines, TheVersionTellsWhatOthersDid) {
  std::uint64_t version = crane_.version();
  const auto changed = [&] {
    const std::uint64_t before = version;
    version = crane_.version();
    return version != before;
  };
  ASSERT_FALSE(crane_.propose({kLow, Q{0, 20, 21, 0}, 0, 10}));
  EXPECT_FALSE(changed());
  ASSERT_FALSE(other_.propose({kBefore, kAfter, 0, 100}));
  EXPECT_TRUE(changed());
  site_.set_time(10);  // its own step ends
  EXPECT_FALSE(changed());
  site_.set_time(100);
  EXPECT_TRUE(changed());
  site_.set_time(200);
  EXPECT_FALSE(changed());
  const std::vector<geometry::Shape> ball = {
      {geometry::Sphere{{0, 0, -50}, 1}, math::Pose::Identity()}};
  site_.hold_zone(0, "dig", {ball, ball}, -1);
  EXPECT_TRUE(changed());
  site_.release_zone(0);
  EXPECT_TRUE(changed());
  site_.release_zone(0);
  EXPECT_FALSE(changed());
}

TEST_F(OtherMachines, AStateCanBeGoneBackTo) {
  const MachineState before = site_.machine_state(1);
  EXPECT_FALSE(before.step);
  ASSERT_FALSE(other_.propose({kBefore, kAfter, 0, 100}));
  const MachineState during = site_.machine_state(1);
  ASSERT_TRUE(during.step);
  EXPECT_EQ(during.step->end, 100);
  EXPECT_EQ(during.q, kAfter);
  site_.set_machine_state(1, before);
  EXPECT_TRUE(crane_.would_accept({kLow, kHigh, 0, 10}));
  EXPECT_EQ(site_.configuration(1), kBefore);
  site_.set_machine_state(1, during);
  EXPECT_FALSE(crane_.would_accept({kLow, kHigh, 0, 10}));
}

}  // namespace
}  // namespace rubicon::site
