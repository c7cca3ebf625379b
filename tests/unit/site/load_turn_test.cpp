#include "src/simulation/site/load_turn.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "src/simulation/site/make_site.hpp"
#include "src/simulation/site/robot_view.hpp"
#include "tests/support/stand_at.hpp"
#include "tests/unit/site/hit_text.hpp"
#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::site {
namespace {

using math::translation;
using test::hit_text;
using Q = std::vector<double>;

/// The crane's hook at (10, 0, 3) with a panel of 6 m along x below it.
struct Hung {
  explicit Hung(const std::vector<interpreter::ComponentSpec>& others) {
    plan = test::crane_plan();
    plan.components.push_back(test::box_component("panel", {6, 0.2, 3}, translation(10, 0, 0)));
    plan.components.insert(plan.components.end(), others.begin(), others.end());
    plan.robots[0].start = {0, 10, 3, 0};
    site.emplace(make_site(plan));
    site->attach(0, 0);
  }
  interpreter::PlanModel plan;
  std::optional<SiteWorld> site;
};

TEST(LoadTurn, EndsWhereItHangsAfterwards) {
  const math::Pose X_WT =
      translation(3, 4, 5) * math::rotation_z_deg(30) * math::rotation_x_deg(20);
  const math::Pose X_TO = translation(0.5, -1, -2) * math::rotation_y_deg(15);
  const geometry::Motion motion = turn_motion(X_WT, X_TO, 250);
  EXPECT_LT((motion.pose(0).matrix() - (X_WT * X_TO).matrix()).norm(), 1e-12);
  EXPECT_LT((motion.pose(1).matrix() - (X_WT * turned(X_WT, X_TO, 250)).matrix()).norm(), 1e-12);
  // Nothing rises or sinks.
  const math::Vec3 before = X_WT * X_TO * math::Vec3(1, 2, 3);
  const math::Vec3 after = X_WT * turned(X_WT, X_TO, 250) * math::Vec3(1, 2, 3);
  EXPECT_NEAR(before.z(), after.z(), 1e-12);
}

TEST(LoadTurn, SweepsAllOnTheWay) {
  // A sheet of 2 cm far from where the panel begins and ends.
  Hung hung({test::box_component("post", {0.02, 0.02, 5}, translation(10, 2, 0))});
  const RobotView view(*hung.site, 0);
  EXPECT_EQ(hit_text(view.turn_hit(80, 0)), "free");
  EXPECT_EQ(hit_text(view.turn_hit(170, 0)), "panel meets post");
  EXPECT_EQ(hit_text(view.turn_hit(-80, 0)), "free");
  EXPECT_EQ(hit_text(view.turn_hit(-100, 0)), "panel meets post");
  EXPECT_EQ(hit_text(view.turn_hit(350, 0)), "panel meets post");
}

TEST(LoadTurn, MeetsTheMachinesOwnMastButNotItsHook) {
  Hung hung({});
  const Q outside = {0, 10, 3, 0}, inside = {0, 3.2, 3, 0};
  hung.site->begin_step(0, {outside, inside, 0, 0}, inside);
  const RobotView view(*hung.site, 0);
  EXPECT_EQ(hit_text(view.turn_hit(5, 0)), "panel meets crane.mast");
  hung.site->begin_step(0, {inside, outside, 0, 0}, outside);
  EXPECT_EQ(hit_text(view.turn_hit(359, 0)), "free");
}

/// Many moments of the turn agree: what overlaps at one of them is never told free, and what is
/// told to meet comes nearer than the contact tolerance and a little.
TEST(LoadTurn, AgreesWithManyMomentsOfIt) {
  std::mt19937 random(1995);
  std::uniform_real_distribution<double> around(-3.5, 3.5), angle(-359, 359);
  int free = 0, met = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const double x = 10 + around(random), y = around(random);
    if (std::fabs(y) < 0.3) continue;  // not where it hangs at first
    Hung hung({test::box_component("post", {0.05, 0.05, 4}, translation(x, y, 0))});
    const RobotView view(*hung.site, 0);
    const double by = angle(random);
    const bool hit = view.turn_hit(by, 0).has_value();
    const Load& load = *hung.site->load(0);
    const geometry::Motion motion = turn_motion(hung.site->tool_pose(0), load.X_TO, by);
    const collision::BodyPtr post = collision::prepare({geometry::Shape{
        geometry::Box{{-0.025, -0.025, 0}, {0.025, 0.025, 4}}, math::Pose::Identity()}});
    bool deep = false, near = false;
    for (int i = 0; i <= 3000 && !deep; ++i) {
      const math::Pose X_WO = motion.pose(i / 3000.0);
      deep = collision::overlaps(*load.body, X_WO, *post, translation(x, y, 0), 2e-3);
      near = near || collision::overlaps(*load.body, X_WO, *post, translation(x, y, 0), 0);
    }
    EXPECT_TRUE(hit || !deep) << x << " " << y << " by " << by;
    EXPECT_TRUE(deep || near || !hit) << x << " " << y << " by " << by;
    ++(hit ? met : free);
  }
  EXPECT_GT(free, 30);
  EXPECT_GT(met, 30);
}

TEST(LoadTurn, OwnsAllThatItSweepsWhileItLasts) {
  interpreter::PlanModel plan = test::crane_plan();
  plan.components.push_back(test::box_component("panel", {6, 0.2, 3}, translation(10, 0, 0)));
  plan.robots[0].start = {0, 10, 3, 0};
  plan.robots.push_back(plan.robots[0]);
  plan.robots[1].name = "other";
  plan.robots[1].X_WM = translation(10, 12, 0);
  plan.robots[1].start = {-90, 5, 3, 0};
  SiteWorld site = make_site(plan);
  site.attach(0, 0);
  RobotView other(site, 1);
  // Its hook comes to (10, 2.4): free as the panel hangs at first, and as it hangs at last.
  const Q from = {-90, 5, 3, 0}, to = {-90, 9.6, 1, 0};
  const auto meets = [&] { return hit_text(other.propose({from, to, 0, 0})); };
  EXPECT_EQ(meets(), "free");
  const std::uint64_t before = site.version(1);
  const MachineState hanging = site.machine_state(0);
  site.begin_turn(0, 120, 100);
  site.set_time(99);
  EXPECT_EQ(meets(), "other.hook meets panel");
  EXPECT_NE(site.version(1), before);
  const MachineState turning = site.machine_state(0);
  EXPECT_TRUE(turning.turn.has_value());
  site.set_time(100);
  EXPECT_FALSE(site.machine_state(0).turn.has_value());
  EXPECT_NE((site.load(0)->X_TO.matrix() - hanging.load->X_TO.matrix()).norm(), 0);
  EXPECT_EQ(meets(), "free");
  site.set_machine_state(0, turning);
  EXPECT_EQ(meets(), "other.hook meets panel");
  site.set_machine_state(0, hanging);
  EXPECT_EQ(site.load(0)->X_TO.matrix(), hanging.load->X_TO.matrix());
  EXPECT_EQ(meets(), "free");
}

/// A crane without a swivel comes as its jib points, one with a swivel keeps the load as it hangs.
TEST(LoadTurn, GoesToAFrameAsTheMachineComes) {
  interpreter::PlanModel plan = test::crane_plan();
  const robot::RobotModel& model = plan.robots[0].robot->model;
  const robot::Mounting mounting{math::Pose::Identity(), model.start_values()};
  const Q q = {0, 10, 20, 0};
  const math::Pose meant = translation(0, 12, 3) * math::rotation_z_deg(-60);
  const FreeTurn free = free_turn(model, mounting, q, meant);
  EXPECT_NEAR(free.angle_deg, -60, 1e-6);
  EXPECT_NEAR(free.tilt_deg, 0, 1e-6);
  EXPECT_LT((free.X_WG.linear() - math::Mat3::Identity()).norm(), 1e-6);
  const FreeTurn tilted = free_turn(model, mounting, q, meant * math::rotation_x_deg(90));
  EXPECT_NEAR(tilted.tilt_deg, 90, 1e-3);
}

}  // namespace
}  // namespace rubicon::site
