#include "src/results/gantt/off_times.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace rubicon::gantt {

bool operator==(const Span& a, const Span& b) { return a.from == b.from && a.to == b.to; }
void PrintTo(const Span& span, std::ostream* out) {
  *out << span.from / schedule::kMinute << " to " << span.to / schedule::kMinute;
}

namespace {

using schedule::kDay;
using schedule::kHour;
using schedule::kMinute;

schedule::CalendarRules site() {
  schedule::CalendarRules rules;
  rules.name = "site";
  rules.shifts.push_back({0, 4, {{7 * 60, 12 * 60}, {12 * 60 + 30, 16 * 60}}});
  return rules;
}

constexpr schedule::CivilTime kMondayAtEight{{2026, 3, 2}, 8 * 60};

TEST(OffTimes, AreTheLunchBreakTheNightAndTheWeekend) {
  const std::vector<Span> lunch_and_night = {{4 * kHour, 4 * kHour + 30 * kMinute},
                                             {8 * kHour, 23 * kHour}};
  EXPECT_EQ(off_times(site(), kMondayAtEight, kDay), lunch_and_night);
  const auto week = off_times(site(), kMondayAtEight, 7 * kDay);
  ASSERT_EQ(week.size(), 10U);  // five breaks, four nights, the weekend
  EXPECT_EQ(week.back(), (Span{4 * kDay + 8 * kHour, 6 * kDay + 23 * kHour}));
}

TEST(OffTimes, HoldDaysOffAndEndWithThePlan) {
  schedule::CalendarRules rules = site();
  rules.off.push_back({2026, 3, 3});
  const auto off = off_times(rules, kMondayAtEight, 30 * kHour);
  EXPECT_EQ(off.back(), (Span{8 * kHour, 30 * kHour}));
  EXPECT_TRUE(off_times(rules, kMondayAtEight, 0).empty());
  EXPECT_TRUE(off_times(rules, kMondayAtEight, 40'000 * kDay).empty());
}

TEST(OffTimes, AreNotCountedForShiftsOfMinutes) {
  schedule::CalendarRules rules;
  rules.name = "minutes";
  rules.shifts.push_back({0, 6, {}});
  for (int minute = 0; minute < schedule::kDay / kMinute; minute += 2) {
    rules.shifts.back().minutes.emplace_back(minute, minute + 1);
  }
  EXPECT_EQ(off_times(rules, kMondayAtEight, kDay).size(), 720U);
  EXPECT_TRUE(off_times(rules, kMondayAtEight, 1000 * kDay).empty());
}

TEST(OffTimes, RefuseRulesThatAreNone) {
  EXPECT_THROW(off_times({}, kMondayAtEight, kDay), std::invalid_argument);
}

TEST(OffTimes, AreTakenOutOfASpan) {
  const std::vector<Span> off = {{2, 4}, {6, 8}, {10, 12}};
  EXPECT_EQ(without({0, 20}, off), (std::vector<Span>{{0, 2}, {4, 6}, {8, 10}, {12, 20}}));
  EXPECT_EQ(without({3, 7}, off), (std::vector<Span>{{4, 6}}));
  EXPECT_EQ(without({6, 8}, off), (std::vector<Span>{}));
  EXPECT_EQ(without({4, 6}, off), (std::vector<Span>{{4, 6}}));
  EXPECT_EQ(without({0, 5}, {}), (std::vector<Span>{{0, 5}}));
}

TEST(OffTimes, AreJoined) {
  EXPECT_EQ(in_both({{0, 5}, {8, 12}}, {{2, 9}, {11, 20}}),
            (std::vector<Span>{{2, 5}, {8, 9}, {11, 12}}));
  EXPECT_EQ(in_both({{0, 5}}, {}), (std::vector<Span>{}));
}

}  // namespace
}  // namespace rubicon::gantt
