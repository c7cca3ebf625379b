#include "src/taskplan/unsupported.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::taskplan {
namespace {

using interpreter::Severity;
using testing::HasSubstr;

TEST(Unsupported, SaysNothingOfAPlainPlan) {
  interpreter::PlanModel plan = test::crane_plan();
  plan.tasks.resize(2);
  plan.tasks[1].after.push_back({0, interpreter::LinkType::FS, 0, {}});
  EXPECT_TRUE(unsupported(plan).empty());
}

TEST(Unsupported, RefusesEveryUseAtItsPlace) {
  std::uint32_t place = 10;
  for (const char* what : {"calendar", "cost", "currency", "start_at", "park", "zone", "guide",
                           "import", "priority", "SS", "FF", "SF", "lag", "teleport"}) {
    interpreter::PlanModel plan = test::crane_plan();
    plan.uses.push_back({what, {0, place, place + 4}});
    const auto diagnostics = unsupported(plan);
    ASSERT_EQ(diagnostics.size(), 1u) << what;
    EXPECT_EQ(diagnostics[0].severity, Severity::error);
    EXPECT_EQ(diagnostics[0].code, "X01");
    EXPECT_EQ(diagnostics[0].span.begin, place);
    EXPECT_THAT(diagnostics[0].message, HasSubstr("run does not execute"));
    ++place;
  }
}

TEST(Unsupported, WarnsOfTheSizeOfACrew) {
  interpreter::PlanModel plan = test::crane_plan();
  plan.uses.push_back({"size", {0, 3, 7}});
  const auto diagnostics = unsupported(plan);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].severity, Severity::warning);
  EXPECT_EQ(diagnostics[0].code, "X02");
}

TEST(Unsupported, LooksAtTheModelTooAndSaysEverythingOnce) {
  interpreter::PlanModel plan = test::crane_plan();
  plan.tasks.resize(2);
  plan.tasks[0].guide = "tangent";
  plan.tasks[0].guide_span = {0, 5, 10};
  plan.tasks[1].priority = 2;
  plan.tasks[1].priority_span = {0, 40, 48};
  plan.tasks[1].after.push_back({0, interpreter::LinkType::SS, 0, {0, 50, 54}});
  plan.tasks[1].after.push_back({0, interpreter::LinkType::FS, 3600, {0, 60, 64}});
  plan.uses.push_back({"guide", {0, 5, 10}});
  EXPECT_EQ(unsupported(plan).size(), 4u);
  // A calendar is listed at its keyword; the model knows its name.
  plan.calendars.emplace_back();
  plan.calendars.back().span = {0, 80, 84};
  EXPECT_EQ(unsupported(plan).size(), 5u);
  plan.uses.push_back({"calendar", {0, 71, 79}});
  EXPECT_EQ(unsupported(plan).size(), 5u);
}

}  // namespace
}  // namespace rubicon::taskplan
