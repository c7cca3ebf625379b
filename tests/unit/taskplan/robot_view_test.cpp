#include "src/simulation/site/robot_view.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "src/simulation/site/make_site.hpp"
#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::site {
namespace {

using math::translation;
using Q = std::vector<double>;

/// A step of the crane's four parameters (jib.theta, x, z, hook.theta).
std::optional<interpreter::HitPair> step(RobotView& view, const Q& from, const Q& to) {
  return view.propose({from, to, 0, 0});
}

std::string names(const std::optional<interpreter::HitPair>& pair) {
  return pair ? pair->moved + " meets " + pair->met : "free";
}

TEST(RobotView, NamesWhatMovedAndWhatItMet) {
  interpreter::PlanModel plan = test::crane_plan();
  plan.components.push_back(test::box_component("wall", {1, 4, 15}, translation(12, 0, 0)));
  plan.site.push_back({geometry::Box{{-60, -60, -1}, {60, 60, 0}}, math::Pose::Identity()});
  SiteWorld site = make_site(plan);
  RobotView view(site, 0);
  const Q at{0, 10, 3, 0};
  EXPECT_EQ(names(step(view, {0, 10, 20, 0}, {0, 10, 10, 0})), "free");
  EXPECT_EQ(names(step(view, {0, 10, 10, 0}, {0, 11.5, 10, 0})), "crane.hook meets wall");
  EXPECT_EQ(site.configuration(0), (Q{0, 10, 10, 0}));  // nothing changed
  EXPECT_FALSE(view.would_accept({Q{0, 10, 10, 0}, Q{0, 13, 10, 0}, 0, 0}));
  EXPECT_TRUE(view.would_accept({Q{0, 10, 10, 0}, Q{0, 11, 10, 0}, 0, 0}));
  EXPECT_EQ(site.configuration(0), (Q{0, 10, 10, 0}));
  EXPECT_EQ(names(step(view, {0, 10, 10, 0}, {0, 10, -0.5, 0})), "crane.hook meets site");
  EXPECT_EQ(names(view.blocked_at(Q{0, 12, 10, 0})), "crane.hook meets wall");
}

TEST(RobotView, SweepsThinThingsAndAllowsContact) {
  interpreter::PlanModel plan = test::crane_plan();
  plan.components.push_back(test::box_component("sheet", {0.02, 4, 15}, translation(12, 0, 0)));
  SiteWorld site = make_site(plan);
  RobotView view(site, 0);
  EXPECT_EQ(names(step(view, {0, 10, 10, 0}, {0, 14, 10, 0})), "crane.hook meets sheet");
  // Hook side exactly at the sheet, then sliding down along it.
  EXPECT_EQ(names(step(view, {0, 10, 10, 0}, {0, 11.49, 10, 0})), "free");
  EXPECT_EQ(names(step(view, {0, 11.49, 10, 0}, {0, 11.49, 3, 0})), "free");
}

TEST(RobotView, TestsOwnBodiesThatAreNotJoined) {
  interpreter::PlanModel plan = test::crane_plan();
  SiteWorld site = make_site(plan);
  RobotView view(site, 0);
  // The hook's travel is not limited here by its range: into the mast.
  EXPECT_EQ(names(step(view, {0, 4, 10, 0}, {0, 1, 10, 0})), "crane.hook meets crane.mast");
  EXPECT_EQ(names(view.blocked_at(Q{0, 1, 10, 0})), "crane.mast meets crane.hook");
  EXPECT_EQ(names(step(view, {0, 4, 10, 0}, {0, 4, 44, 0})), "free");  // into its parent, the jib

  auto robot = test::crane(test::lifting_script());
  robot->model.touching = {{0, 2}};
  plan.robots[0].robot = robot;
  SiteWorld declared = make_site(plan);
  RobotView touching(declared, 0);
  EXPECT_EQ(names(step(touching, {0, 4, 10, 0}, {0, 1, 10, 0})), "free");
}

TEST(RobotView, SweepsTheLoadButNotAgainstItsHook) {
  interpreter::PlanModel plan = test::crane_plan();
  plan.components.push_back(test::box_component("wall", {1, 4, 15}, translation(20, 0, 0)));
  plan.components.push_back(test::box_component("panel", {6, 0.2, 3}, translation(10, 0, 0)));
  SiteWorld site = make_site(plan);
  RobotView view(site, 0);
  const Q at{0, 10, 3, 0};
  EXPECT_EQ(names(step(view, {0, 10, 20, 0}, {0, 10, 3, 0})), "free");
  EXPECT_EQ(names(view.blocked_at(Q{0, 10, 2.9, 0})), "crane.hook meets panel");
  EXPECT_FALSE(view.situation("transport", at, at));
  EXPECT_FALSE(view.loaded());
  site.attach(0, 1);
  EXPECT_TRUE(view.situation("transport", at, at));
  EXPECT_FALSE(view.situation("place", at, at));
  EXPECT_TRUE(view.loaded());
  EXPECT_EQ(names(view.blocked_at(Q{0, 10, 3, 0})), "free");
  EXPECT_EQ(names(step(view, {0, 10, 3, 0}, {0, 10, 4, 0})), "free");
  EXPECT_EQ(names(step(view, {0, 10, 4, 0}, {0, 17, 4, 0})), "panel meets wall");
  EXPECT_EQ(names(step(view, {0, 10, 4, 0}, {0, 3, 4, 0})), "panel meets crane.mast");
  EXPECT_EQ(names(view.blocked_at(Q{0, 3, 4, 0})), "panel meets crane.mast");
}

TEST(RobotView, SweepsTheLoadWhenItTurnsOnTheHook) {
  interpreter::PlanModel plan = test::crane_plan();
  plan.components.push_back(test::box_component("post", {0.1, 0.1, 5}, translation(10, 2, 0)));
  plan.components.push_back(test::box_component("panel", {6, 0.2, 3}, translation(10, 0, 0)));
  SiteWorld site = make_site(plan);
  RobotView view(site, 0);
  ASSERT_EQ(names(step(view, {0, 10, 20, 0}, {0, 10, 3, 0})), "free");
  site.attach(0, 1);
  // At 170 degrees the panel is clear of the post, as at 0; the way there is not.
  EXPECT_EQ(names(step(view, {0, 10, 3, 0}, {0, 10, 3, 170})), "panel meets post");
  EXPECT_EQ(names(view.blocked_at(Q{0, 10, 3, 170})), "free");
}

TEST(RobotView, LoadChartStopsALoadOnItsWayOut) {
  interpreter::PlanModel plan = test::crane_plan();
  auto robot = test::crane(test::lifting_script());
  robot->model.capacity = {{10, 5000}, {20, 1000}};
  plan.robots[0].robot = robot;
  plan.components.push_back(test::box_component("panel", {1, 1, 1}, translation(10, 0, 19)));
  plan.components[0].mass = 3000;
  SiteWorld site = make_site(plan);
  RobotView view(site, 0);
  site.attach(0, 0);
  EXPECT_EQ(names(step(view, {0, 10, 20, 0}, {0, 15, 20, 0})), "free");
  EXPECT_EQ(names(step(view, {0, 15, 20, 0}, {0, 16, 20, 0})),
            "panel meets the load chart of crane");
  EXPECT_EQ(names(step(view, {0, 15, 20, 0}, {5, 15, 20, 0})), "free");
  EXPECT_EQ(names(step(view, {5, 15, 20, 0}, {5, 14, 20, 0})), "free");
}

TEST(RobotView, FreeDistanceEndsAtContact) {
  interpreter::PlanModel plan = test::crane_plan();
  plan.contact = 1e-6;
  plan.components.push_back(test::box_component("wall", {1, 4, 15}, translation(20, 0, 0)));
  SiteWorld site = make_site(plan);
  RobotView view(site, 0);
  const Q q = {0, 10, 10, 0};
  EXPECT_NEAR(view.free_distance(q, 0, 30), 9, 3e-6);
  EXPECT_EQ(view.free_distance(q, 0, 5), 5);
  EXPECT_EQ(view.free_distance(q, 90, 30), 30);
  EXPECT_EQ(view.free_distance(q, 0, 0), 0);
}

TEST(RobotView, AnythingGoesWhereThereIsNothing) {
  interpreter::PlanModel plan = test::crane_plan();
  auto robot = test::crane(test::lifting_script());
  robot->model.touching = {{0, 2}};
  plan.robots[0].robot = robot;
  SiteWorld site = make_site(plan);
  RobotView view(site, 0);
  const std::uint64_t version = view.version();
  EXPECT_EQ(names(step(view, {0, 10, 20, 350}, {0, 10, 20, 365})), "free");
  EXPECT_EQ(site.configuration(0), (Q{0, 10, 20, 5}));  // cyclic angles are kept reduced
  EXPECT_EQ(view.version(), version);                   // its own steps change nothing for it
}

}  // namespace
}  // namespace rubicon::site
