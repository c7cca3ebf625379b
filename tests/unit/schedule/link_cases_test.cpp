#include "tests/unit/schedule/link_cases.hpp"

#include <gtest/gtest.h>

#include "tests/unit/schedule/network_cases.hpp"

namespace rubicon::schedule {
namespace {

TEST(LinkCases, AreAsWorkedByHand) {
  int count = 0;
  for (const test::LinkCases& group : test::link_cases()) {
    for (const test::LinkCase& given : group.cases) {
      test::NetworkBuilder plan(group.start);
      plan.crew("first", group.rules).crew("second", group.rules).crew("third", group.rules);
      plan.task("lead", 10 * kHour, {"first"});
      plan.task("a", 6 * kHour, {"second"}, {{"lead"}});
      plan.task("b", 4 * kHour, {"third"}, {{"a", given.type, given.lag, given.clock}});
      EXPECT_EQ(plan.when("b"), given.expected)
          << group.name << " " << given.name << ": " << given.why;
      ++count;
    }
  }
  EXPECT_GE(count, 50);
}

}  // namespace
}  // namespace rubicon::schedule
