#include <gtest/gtest.h>

#include <memory>
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

constexpr int kJib = 1;
constexpr int kHook = 2;

/// Gives a body of a robot of the plan a buffer (m).
void give_buffer(interpreter::RobotSpec& robot, int body, double buffer) {
  const auto changed = test::crane(test::lifting_script());
  changed->model.bodies[static_cast<std::size_t>(body)].buffer = buffer;
  robot.robot = changed;
}

/// A tower crane at the origin whose jib turns 44 m up, and a post beside its way.
class Buffers : public testing::Test {
 protected:
  /// A post of 1 m by 1 m with its top at z, 30 m out at 90 degrees.
  void post(double top) {
    plan_.components.push_back(test::box_component("post", {1, 1, 1}, translation(0, 30, top - 1)));
  }
  void make() {
    site_ = std::make_unique<SiteWorld>(make_site(plan_));
    view_ = std::make_unique<RobotView>(*site_, 0);
  }
  std::string turn() { return hit_text(view_->propose({kFrom, kTo, 0, 10})); }

  const Q kFrom = {60, 10, 20, 0};
  const Q kTo = {120, 10, 20, 0};
  interpreter::PlanModel plan_ = test::crane_plan();
  std::unique_ptr<SiteWorld> site_;
  std::unique_ptr<RobotView> view_;
};

TEST_F(Buffers, AStepThatComesNearerIsRefused) {
  post(43.2);  // the jib passes 0.8 m above
  make();
  EXPECT_EQ(turn(), "free");
  give_buffer(plan_.robots[0], kJib, 0.7);
  make();
  EXPECT_EQ(turn(), "free");
  give_buffer(plan_.robots[0], kJib, 0.9);
  make();
  EXPECT_EQ(turn(), "the buffer of crane.jib meets post");
  EXPECT_EQ(hit_text(view_->blocked_at(Q{90, 10, 20, 0})), "the buffer of crane.jib meets post");
  EXPECT_EQ(hit_text(view_->blocked_at(kFrom)), "free");
}

TEST_F(Buffers, WhatIsMetIsNamedBeforeTheBuffer) {
  post(44.5);
  give_buffer(plan_.robots[0], kJib, 0.9);
  make();
  EXPECT_EQ(turn(), "crane.jib meets post");
}

TEST_F(Buffers, DoNotHoldBetweenAMachineAndItsLoad) {
  give_buffer(plan_.robots[0], kJib, 30);
  plan_.components.push_back(test::box_component("panel", {1, 1, 1}, translation(5, 8.66, 18)));
  make();
  test::stand_at(*site_, 0, kFrom);
  site_->attach(0, 0);
  EXPECT_EQ(turn(), "free");
}

TEST_F(Buffers, OfTwoMachinesTheLargerHolds) {
  plan_.robots.push_back(plan_.robots[0]);
  plan_.robots[1].name = "other";
  plan_.robots[1].X_WM = translation(0, 60, -3);  // jibs that meet half way, 3 m apart in height
  plan_.robots[1].start = {-90, 10, 20, 0};
  const auto asked = [&](double own, double others) {
    give_buffer(plan_.robots[0], kJib, own);
    give_buffer(plan_.robots[1], kJib, others);
    make();
    return turn();
  };
  ASSERT_EQ(asked(0, 0), "free");
  const double gap = [&] {
    double most = 0;
    for (double own = 0.1; own < 5 && asked(own, 0) == "free"; own += 0.1) most = own;
    return most;
  }();
  ASSERT_GT(gap, 0.2);
  EXPECT_EQ(asked(gap, gap), "free");
  EXPECT_EQ(asked(gap + 0.2, 0), "the buffer of crane.jib meets other.jib");
  EXPECT_EQ(asked(0, gap + 0.2), "crane.jib meets the buffer of other.jib");
}

TEST_F(Buffers, TheHookMayHaveOne) {
  plan_.components.push_back(test::box_component("crate", {1, 1, 1}, translation(10, 0, 15)));
  give_buffer(plan_.robots[0], kHook, 2);
  make();
  const Q high = {0, 10, 25, 0};
  const Q above = {0, 10, 19, 0};
  const Q low = {0, 10, 17, 0};
  EXPECT_EQ(hit_text(view_->propose({high, above, 0, 10})), "free");
  EXPECT_EQ(hit_text(view_->propose({above, low, 0, 10})), "the buffer of crane.hook meets crate");
}

}  // namespace
}  // namespace rubicon::site
