#include "src/simulation/site/beginning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::site {
namespace {

using interpreter::PlanModel;
using interpreter::ThingRef;

constexpr auto kComponent = ThingRef::Kind::component;

void add_box(PlanModel& plan, const std::string& name, const math::Vec3& at, double size) {
  interpreter::ComponentSpec component;
  component.name = name;
  const auto place = static_cast<std::uint32_t>(10 * plan.components.size());
  component.span = {0, place, place + 1};
  component.X_WO = math::translation(at.x(), at.y(), at.z());
  component.shapes.push_back({geometry::Box{math::Vec3::Constant(0), math::Vec3::Constant(size)}});
  plan.components.push_back(std::move(component));
}

PlanModel ground() {
  PlanModel plan;
  plan.site.push_back({geometry::Box{{-50, -50, -1}, {50, 50, 0}}});
  return plan;
}

TEST(Beginning, WhatTouchesIsFreeAndWhatIsInEachOtherIsToldWithItsDepth) {
  PlanModel plan = ground();
  add_box(plan, "a", {0, 0, 0}, 1);
  add_box(plan, "b", {1, 0, 0}, 1);
  add_box(plan, "c", {1.2, 0.97, 0}, 1);
  add_box(plan, "d", {5, 0, -0.25}, 1);
  const Beginning beginning = look_at_beginning(plan);
  ASSERT_EQ(beginning.overlaps.size(), 2u);
  EXPECT_EQ(beginning.overlaps[0].pair.first, "b");
  EXPECT_EQ(beginning.overlaps[0].pair.second, "c");
  EXPECT_NEAR(beginning.overlaps[0].pair.depth, 0.03, 2e-5);
  EXPECT_EQ(beginning.overlaps[1].pair.first, "site");
  EXPECT_EQ(beginning.overlaps[1].pair.second, "d");
  EXPECT_NEAR(beginning.overlaps[1].pair.depth, 0.25, 2e-5);
  const auto told = warnings_of(plan, beginning);
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[0].code, "P33");
  EXPECT_EQ(told[0].message, "at the beginning c is 30 mm deep in b");
  EXPECT_THAT(told[0].hint, ::testing::HasSubstr("write touching b c;"));
  EXPECT_EQ(told[0].span.begin, plan.components[2].span.begin);
  ASSERT_EQ(told[0].notes.size(), 1u);
  EXPECT_TRUE(told[1].notes.empty());
}

TEST(Beginning, WaiversSilenceTheirPairEitherWayRoundAndAreToldWhereTheyAreIdle) {
  PlanModel plan = ground();
  add_box(plan, "a", {0, 0, 0}, 2);
  add_box(plan, "anchor", {0.5, 0.5, 0.5}, 0.1);
  add_box(plan, "c", {9, 0, 0}, 1);
  plan.waivers.push_back({{kComponent, 1}, {kComponent, 0}, {0, 1, 2}});
  plan.waivers.push_back({{kComponent, 0}, {kComponent, 2}, {0, 3, 4}});
  const Beginning beginning = look_at_beginning(plan);
  EXPECT_TRUE(beginning.overlaps.empty());
  ASSERT_EQ(beginning.idle_waivers.size(), 1u);
  EXPECT_EQ(beginning.idle_waivers[0].begin, 3u);
  EXPECT_EQ(warnings_of(plan, beginning).at(0).code, "P34");
}

TEST(Beginning, WhatIsWhollyInsideIsTold) {
  PlanModel plan;
  add_box(plan, "a", {0, 0, 0}, 2);
  add_box(plan, "inside", {0.5, 0.5, 0.5}, 0.1);
  const Beginning beginning = look_at_beginning(plan);
  ASSERT_EQ(beginning.overlaps.size(), 1u);
  EXPECT_NEAR(beginning.overlaps[0].pair.depth, 0.6, 2e-5);
}

TEST(Beginning, MachinesAreComparedWithWhatStandsAndWithEachOtherButNotWithThemselves) {
  PlanModel plan = ground();
  auto crane = test::crane(test::lifting_script());
  for (const double x : {0.0, 100.0}) {
    interpreter::RobotSpec robot;
    robot.name = x == 0 ? "first" : "second";
    robot.robot = crane;
    robot.X_WM = math::translation(x, 0, 0);
    for (const auto& parameter : crane->model.parameters) robot.start.push_back(parameter.start);
    plan.robots.push_back(std::move(robot));
  }
  EXPECT_TRUE(look_at_beginning(plan).overlaps.empty());
  plan.robots[1].X_WM = math::translation(0.5, 0, 0);
  const Beginning beginning = look_at_beginning(plan);
  ASSERT_FALSE(beginning.overlaps.empty());
  for (const BeginningOverlap& each : beginning.overlaps) {
    EXPECT_EQ(each.first_owner, "first");
    EXPECT_EQ(each.second_owner, "second");
    EXPECT_THAT(each.pair.second, ::testing::StartsWith("second."));
  }
}

TEST(Beginning, ManyOverlapsAreToldByTheirNumber) {
  PlanModel plan = ground();
  for (int i = 0; i < 25; ++i) add_box(plan, "c" + std::to_string(i), {2.0 * i, 0, -0.1}, 1);
  const auto told = warnings_of(plan, look_at_beginning(plan));
  ASSERT_EQ(told.size(), 21u);
  EXPECT_EQ(told.back().message, "5 more pairs overlap at the beginning");
}

}  // namespace
}  // namespace rubicon::site
