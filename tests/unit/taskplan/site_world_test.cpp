#include "src/simulation/site/site_world.hpp"

#include <gtest/gtest.h>

#include "src/simulation/site/load_chart.hpp"
#include "src/simulation/site/make_site.hpp"
#include "src/simulation/site/robot_view.hpp"
#include "tests/support/stand_at.hpp"
#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::site {
namespace {

using math::translation;

interpreter::PlanModel plan_with_panel() {
  interpreter::PlanModel plan = test::crane_plan();
  plan.components.push_back(test::box_component("panel", {2, 1, 3}, translation(10, 0, 16)));
  return plan;
}

TEST(SiteWorld, AnAttachedComponentHangsAsItWasTaken) {
  const interpreter::PlanModel plan = plan_with_panel();
  SiteWorld site = make_site(plan);
  ASSERT_TRUE(site.stands(0));
  site.attach(0, 0);
  EXPECT_FALSE(site.stands(0));
  ASSERT_TRUE(site.load(0));
  EXPECT_TRUE(site.load(0)->X_TO.isApprox(translation(0, 0, -4), 1e-12));
  test::stand_at(site, 0, {90, 12, 30, 0});
  site.detach(0);
  EXPECT_TRUE(site.stands(0));
  EXPECT_TRUE(site.X_WO(0).isApprox(translation(0, 12, 26) * math::rotation_z_deg(90), 1e-12));
  EXPECT_FALSE(site.load(0));
}

TEST(SiteWorld, RestoreUndoesATask) {
  const interpreter::PlanModel plan = plan_with_panel();
  SiteWorld site = make_site(plan);
  const MachineState machine = site.machine_state(0);
  const ComponentState component = site.component_state(0);
  const std::uint64_t version = site.version(0);
  site.attach(0, 0);
  test::stand_at(site, 0, {90, 12, 30, 0});
  site.set_machine_state(0, machine);
  site.set_component_state(0, component);
  EXPECT_TRUE(site.stands(0));
  EXPECT_TRUE(site.X_WO(0).isApprox(translation(10, 0, 16), 0));
  EXPECT_EQ(site.configuration(0), plan.robots[0].start);
  EXPECT_FALSE(site.load(0));
  EXPECT_NE(site.version(0), version);
  // It is an obstacle again: the hook cannot be lowered into it.
  RobotView view(site, 0);
  EXPECT_TRUE(view.blocked_at(std::vector<double>{0, 10, 18, 0}));
  site.remove(0);
  EXPECT_FALSE(view.blocked_at(std::vector<double>{0, 10, 18, 0}));
  site.set_component_state(0, component);
  EXPECT_TRUE(view.blocked_at(std::vector<double>{0, 10, 18, 0}));
}

TEST(SiteWorld, RobotsAtRestAreInTheWayOfTheOneAtWork) {
  interpreter::PlanModel plan = test::crane_plan();
  plan.robots.push_back(plan.robots[0]);
  plan.robots[1].name = "other";
  plan.robots[1].X_WM = translation(0, 20, -10);
  plan.robots[1].start = {0, 10, 20, 0};
  SiteWorld site = make_site(plan);
  RobotView first(site, 0);
  const std::uint64_t version = site.version(0);
  // The other's jib runs at y 20, z 34 to 36; the hook at (20, 20) meets it.
  const std::vector<double> q = {45, 28.28, 34.5, 0};
  const auto pair = first.blocked_at(q);
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->moved, "crane.hook");
  EXPECT_EQ(pair->met, "other.jib");
  {
    RobotView second(site, 1);
    const std::vector<double> from = {0, 10, 20, 0};
    const std::vector<double> to = {-5, 10, 20, 0};
    EXPECT_FALSE(second.propose({from, to, 0, 0}));
    test::stand_at(site, 1, {90, 10, 20, 0});
  }
  EXPECT_NE(site.version(0), version);
  RobotView again(site, 0);
  const auto freed = again.blocked_at(q);
  EXPECT_FALSE(freed) << freed->moved << " meets " << freed->met;
}

TEST(LoadChart, IsLinearBetweenItsPointsAndEndsAtTheLast) {
  const std::vector<robot::CapacityPoint> chart = {{10, 8000}, {20, 4000}, {40, 1000}};
  EXPECT_EQ(capacity_at(chart, 5), 8000);
  EXPECT_EQ(capacity_at(chart, 15), 6000);
  EXPECT_EQ(capacity_at(chart, 30), 2500);
  EXPECT_EQ(capacity_at(chart, 40), 1000);
  EXPECT_EQ(capacity_at(chart, 40.1), 0);
  EXPECT_TRUE(capacity_at({}, 100) > 1e300);
  EXPECT_NEAR(chart_radius(translation(1, 1, 0), {4, 5, 9}), 5, 1e-12);
}

}  // namespace
}  // namespace rubicon::site
