#include "src/simulation/taskplan/preflight_errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::taskplan {
namespace {

using testing::HasSubstr;

interpreter::CalendarSpec calendar(const std::string& name, int day, int from, int to) {
  interpreter::CalendarSpec spec;
  spec.name = name;
  spec.shifts.push_back({day, day, {{from, to}}});
  spec.span = {0, 20, 24};
  return spec;
}

TEST(PreflightErrors, SaysNothingOfAPlainPlan) {
  interpreter::PlanModel plan = test::crane_plan();
  plan.tasks.resize(2);
  plan.tasks[1].after.push_back({0, interpreter::LinkType::SF, -schedule::kMinute, {}});
  plan.tasks[1].priority = 3;
  for (const char* what : {"calendar", "cost", "currency", "start_at", "park", "zone", "priority",
                           "SS", "FF", "SF", "lag", "size"}) {
    plan.uses.push_back({what, {0, 1, 2}});
  }
  EXPECT_TRUE(preflight_errors(plan).empty());
}

TEST(PreflightErrors, RefusesImportsAtTheirPlace) {
  interpreter::PlanModel plan = test::crane_plan();
  plan.uses.push_back({"import", {0, 30, 36}});
  const auto mistakes = preflight_errors(plan);
  ASSERT_EQ(mistakes.size(), 1u);
  EXPECT_EQ(mistakes[0].code, "X01");
  EXPECT_EQ(mistakes[0].span.begin, 30u);
}

TEST(PreflightErrors, DaysOffNeedADate) {
  interpreter::PlanModel plan = test::crane_plan();
  plan.calendars.push_back(calendar("site", 0, 420, 960));
  plan.calendars[0].off = {{2026, 12, 25}};
  ASSERT_EQ(preflight_errors(plan).size(), 1u);
  EXPECT_EQ(preflight_errors(plan)[0].code, "X02");
  plan.start_at = {{2026, 3, 2}, 7 * 60};
  EXPECT_TRUE(preflight_errors(plan).empty());
}

TEST(PreflightErrors, WhoWorksTogetherNeedsCommonHours) {
  interpreter::PlanModel plan = test::crane_plan();
  plan.calendars.push_back(calendar("day", 0, 420, 960));
  plan.calendars.push_back(calendar("night", 0, 1200, 1440));
  plan.robots[0].calendar = "day";
  plan.crews[0].calendar = "night";
  plan.components.push_back(test::box_component("block", {1, 1, 1}, math::Pose::Identity()));
  plan.tasks.push_back(test::move_task("set", 0, math::Pose::Identity()));
  plan.tasks[0].crews.clear();
  EXPECT_TRUE(preflight_errors(plan).empty());
  plan.tasks[0].hook = interpreter::WorkSpec{60, 0, {}};
  const auto mistakes = preflight_errors(plan);
  ASSERT_EQ(mistakes.size(), 1u);
  EXPECT_EQ(mistakes[0].code, "X03");
  EXPECT_THAT(mistakes[0].message, HasSubstr("task 'set' never begins"));
}

}  // namespace
}  // namespace rubicon::taskplan
