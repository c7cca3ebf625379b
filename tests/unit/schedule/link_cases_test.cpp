// Schedules worked by hand: every type of link, without lag, with a positive and a negative one,
// without a calendar, with a daily shift, and over a weekend with a day off.
//
// `lead` (10 h) comes first, then `a` (6 h, after lead), and `b` (4 h) follows `a` by the link of
// the case. Each has a crew of its own, so only links and shifts matter.

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "src/schedule/link.hpp"
#include "tests/unit/schedule/calendar_cases.hpp"
#include "tests/unit/schedule/network_cases.hpp"

namespace rubicon::schedule {
namespace {

struct LinkCase {
  const char* name;
  LinkType type;
  Ticks lag;
  LagClock clock;
  const char* expected;  ///< "START .. FINISH" of b
  const char* why;
};

using enum LinkType;
using enum LagClock;

std::string when_b(const char* start, const std::optional<CalendarRules>& rules,
                   const LinkCase& given) {
  test::NetworkBuilder plan(start);
  plan.crew("first", rules).crew("second", rules).crew("third", rules);
  plan.task("lead", 10 * kHour, {"first"});
  plan.task("a", 6 * kHour, {"second"}, {{"lead"}});
  plan.task("b", 4 * kHour, {"third"}, {{"a", given.type, given.lag, given.clock}});
  return plan.when("b");
}

std::string case_name(const testing::TestParamInfo<LinkCase>& info) { return info.param.name; }

void PrintTo(const LinkCase& given, std::ostream* out) { *out << given.name; }

// ---- Day and night. Monday 07:00: lead until 17:00, a from 17:00 to 23:00.

class DayAndNight : public testing::TestWithParam<LinkCase> {};

TEST_P(DayAndNight, IsAsWorkedByHand) {
  EXPECT_EQ(when_b("2026-03-02 07:00", {}, GetParam()), GetParam().expected) << GetParam().why;
}

INSTANTIATE_TEST_SUITE_P(
    Links, DayAndNight,
    testing::Values(
        LinkCase{"FS", FS, 0, elapsed, "2026-03-02 23:00 .. 2026-03-03 03:00", "a ends at 23:00"},
        LinkCase{"FSlater", FS, 2 * kHour, elapsed, "2026-03-03 01:00 .. 2026-03-03 05:00",
                 "23:00 and 2 h"},
        LinkCase{"FSsooner", FS, -2 * kHour, elapsed, "2026-03-02 21:00 .. 2026-03-03 01:00",
                 "2 h before a ends"},
        LinkCase{"SS", SS, 0, elapsed, "2026-03-02 17:00 .. 2026-03-02 21:00", "with a"},
        LinkCase{"SSlater", SS, 2 * kHour, elapsed, "2026-03-02 19:00 .. 2026-03-02 23:00",
                 "2 h after a starts"},
        LinkCase{"SSsooner", SS, -2 * kHour, elapsed, "2026-03-02 15:00 .. 2026-03-02 19:00",
                 "2 h before a starts, while lead goes on"},
        LinkCase{"FF", FF, 0, elapsed, "2026-03-02 19:00 .. 2026-03-02 23:00",
                 "b ends with a, so it starts 4 h before 23:00"},
        LinkCase{"FFlater", FF, 2 * kHour, elapsed, "2026-03-02 21:00 .. 2026-03-03 01:00",
                 "b ends at 01:00"},
        LinkCase{"FFsooner", FF, -2 * kHour, elapsed, "2026-03-02 17:00 .. 2026-03-02 21:00",
                 "b ends at 21:00"},
        LinkCase{"SF", SF, 0, elapsed, "2026-03-02 13:00 .. 2026-03-02 17:00",
                 "b ends when a starts"},
        LinkCase{"SFlater", SF, 2 * kHour, elapsed, "2026-03-02 15:00 .. 2026-03-02 19:00",
                 "b ends 2 h after a starts"},
        LinkCase{"SFsooner", SF, -2 * kHour, elapsed, "2026-03-02 11:00 .. 2026-03-02 15:00",
                 "b ends 2 h before a starts"},
        LinkCase{"SFfarSooner", SF, -8 * kHour, elapsed, "2026-03-02 07:00 .. 2026-03-02 11:00",
                 "an end at 09:00 would be a start at 05:00: nothing starts before the plan, and "
                 "an end at 11:00 is not too early"}),
    case_name);

// ---- Every day 07-12 and 13-16. Monday 07:00: lead 8 h on Monday, 2 h on Tuesday, until Tuesday
// 09:00; a Tuesday 09-12 and 13-16.

class DailyShift : public testing::TestWithParam<LinkCase> {};

TEST_P(DailyShift, IsAsWorkedByHand) {
  EXPECT_EQ(when_b("2026-03-02 07:00", test::daily_shift(), GetParam()), GetParam().expected)
      << GetParam().why;
}

INSTANTIATE_TEST_SUITE_P(
    Links, DailyShift,
    testing::Values(
        LinkCase{"FS", FS, 0, elapsed, "2026-03-04 07:00 .. 2026-03-04 11:00",
                 "a ends with Tuesday's shift, b starts with Wednesday's"},
        LinkCase{"FSlater", FS, 2 * kHour, elapsed, "2026-03-04 07:00 .. 2026-03-04 11:00",
                 "the lag is over on Tuesday 18:00"},
        LinkCase{"FSmuchLater", FS, 18 * kHour, elapsed, "2026-03-04 10:00 .. 2026-03-04 15:00",
                 "Tuesday 16:00 and 18 h is Wednesday 10:00; 2 h, lunch, 2 h"},
        LinkCase{"FSsooner", FS, -2 * kHour, elapsed, "2026-03-03 14:00 .. 2026-03-04 09:00",
                 "Tuesday 14-16, Wednesday 07-09"},
        LinkCase{"SS", SS, 0, elapsed, "2026-03-03 09:00 .. 2026-03-03 14:00",
                 "09-12, lunch, 13-14"},
        LinkCase{"SSlater", SS, 2 * kHour, elapsed, "2026-03-03 11:00 .. 2026-03-03 16:00",
                 "11-12, 13-16"},
        LinkCase{"SSintoLunch", SS, 3 * kHour, elapsed, "2026-03-03 13:00 .. 2026-03-04 08:00",
                 "12:00 is the end of a shift: 13-16, Wednesday 07-08"},
        LinkCase{"SSsooner", SS, -2 * kHour, elapsed, "2026-03-03 07:00 .. 2026-03-03 11:00",
                 "Tuesday 07:00"},
        LinkCase{"FF", FF, 0, elapsed, "2026-03-03 11:00 .. 2026-03-03 16:00",
                 "back from 16:00: 13-16, 11-12"},
        LinkCase{"FFlater", FF, 2 * kHour, elapsed, "2026-03-03 11:00 .. 2026-03-03 18:00",
                 "18:00 is out of shift: the work is done by 16:00, the finish is held"},
        LinkCase{"FFsooner", FF, -2 * kHour, elapsed, "2026-03-03 09:00 .. 2026-03-03 14:00",
                 "back from 14:00: 13-14, 09-12"},
        LinkCase{"SF", SF, 0, elapsed, "2026-03-02 14:00 .. 2026-03-03 09:00",
                 "back from Tuesday 09:00: 07-09, Monday 14-16"},
        LinkCase{"SFlater", SF, 2 * kHour, elapsed, "2026-03-03 07:00 .. 2026-03-03 11:00",
                 "back from 11:00"},
        LinkCase{"SFsooner", SF, -2 * kHour, elapsed, "2026-03-02 11:00 .. 2026-03-03 07:00",
                 "Tuesday 07:00 is the begin of a shift: the work is done on Monday, 11-12 and "
                 "13-16, the finish is held overnight"}),
    case_name);

// ---- Monday to Friday as above, Monday 2026-03-09 off. Thursday 07:00: lead 8 h on Thursday, 2 h
// on Friday, until Friday 09:00; a Friday 09-12 and 13-16. The next shift is on Tuesday,
// 2026-03-10.

class WeekendAndDayOff : public testing::TestWithParam<LinkCase> {};

TEST_P(WeekendAndDayOff, IsAsWorkedByHand) {
  EXPECT_EQ(when_b("2026-03-05 07:00", test::weekday_shift(), GetParam()), GetParam().expected)
      << GetParam().why;
}

INSTANTIATE_TEST_SUITE_P(
    Links, WeekendAndDayOff,
    testing::Values(
        LinkCase{"FS", FS, 0, elapsed, "2026-03-10 07:00 .. 2026-03-10 11:00",
                 "weekend and Monday off"},
        LinkCase{"FSoverWeekend", FS, 48 * kHour, elapsed, "2026-03-10 07:00 .. 2026-03-10 11:00",
                 "two days of drying end on Sunday 16:00"},
        LinkCase{"FSlater", FS, 96 * kHour, elapsed, "2026-03-11 07:00 .. 2026-03-11 11:00",
                 "four days of drying end on Tuesday 16:00, with the shift"},
        LinkCase{"FSsooner", FS, -2 * kHour, elapsed, "2026-03-06 14:00 .. 2026-03-10 09:00",
                 "Friday 14-16, Tuesday 07-09"},
        LinkCase{"SS", SS, 0, elapsed, "2026-03-06 09:00 .. 2026-03-06 14:00", "09-12, 13-14"},
        LinkCase{"SSlater", SS, 96 * kHour, elapsed, "2026-03-10 09:00 .. 2026-03-10 14:00",
                 "Friday 09:00 and four days"},
        LinkCase{"SSoverWeekend", SS, 24 * kHour, elapsed, "2026-03-10 07:00 .. 2026-03-10 11:00",
                 "Saturday 09:00 is out of shift"},
        LinkCase{"SSsooner", SS, -2 * kHour, elapsed, "2026-03-06 07:00 .. 2026-03-06 11:00",
                 "Friday 07:00"},
        LinkCase{"FF", FF, 0, elapsed, "2026-03-06 11:00 .. 2026-03-06 16:00",
                 "back from Friday 16:00: 13-16, 11-12"},
        LinkCase{"FFlater", FF, 96 * kHour, elapsed, "2026-03-10 11:00 .. 2026-03-10 16:00",
                 "back from Tuesday 16:00"},
        LinkCase{"FFsooner", FF, -2 * kHour, elapsed, "2026-03-06 09:00 .. 2026-03-06 14:00",
                 "back from Friday 14:00"},
        LinkCase{"SF", SF, 0, elapsed, "2026-03-05 14:00 .. 2026-03-06 09:00",
                 "back from Friday 09:00: 07-09, Thursday 14-16"},
        LinkCase{"SFlater", SF, 96 * kHour, elapsed, "2026-03-06 14:00 .. 2026-03-10 09:00",
                 "back from Tuesday 09:00: 07-09, over the weekend, Friday 14-16"},
        LinkCase{"SFoverWeekend", SF, 26 * kHour, elapsed, "2026-03-06 11:00 .. 2026-03-07 11:00",
                 "Saturday 11:00: done by Friday 16:00, held"},
        LinkCase{"SFsooner", SF, -2 * kHour, elapsed, "2026-03-05 11:00 .. 2026-03-06 07:00",
                 "Friday 07:00: Thursday 11-12 and 13-16, held overnight"}),
    case_name);

// ---- As DailyShift, but lags are counted in working hours of b.

class WorkingLag : public testing::TestWithParam<LinkCase> {};

TEST_P(WorkingLag, IsAsWorkedByHand) {
  EXPECT_EQ(when_b("2026-03-02 07:00", test::daily_shift(), GetParam()), GetParam().expected)
      << GetParam().why;
}

INSTANTIATE_TEST_SUITE_P(
    Links, WorkingLag,
    testing::Values(
        LinkCase{"FSlater", FS, 2 * kHour, working, "2026-03-04 09:00 .. 2026-03-04 14:00",
                 "Wednesday 07-09 is the lag; 09-12, 13-14"},
        LinkCase{"FSsooner", FS, -4 * kHour, working, "2026-03-03 11:00 .. 2026-03-03 16:00",
                 "back from Tuesday 16:00: 13-16, 11-12"},
        LinkCase{"SSlater", SS, 4 * kHour, working, "2026-03-03 14:00 .. 2026-03-04 09:00",
                 "09-12, 13-14 is the lag"},
        LinkCase{"SSsooner", SS, -3 * kHour, working, "2026-03-02 15:00 .. 2026-03-03 10:00",
                 "back from Tuesday 09:00: 07-09, Monday 15-16"},
        LinkCase{"FFlater", FF, 2 * kHour, working, "2026-03-03 14:00 .. 2026-03-04 09:00",
                 "b ends Wednesday 09:00: 07-09, Tuesday 14-16"},
        LinkCase{"FFsooner", FF, -4 * kHour, working, "2026-03-03 07:00 .. 2026-03-03 11:00",
                 "b ends Tuesday 11:00"},
        LinkCase{"SFlater", SF, 4 * kHour, working, "2026-03-03 09:00 .. 2026-03-03 14:00",
                 "b ends Tuesday 14:00: 13-14, 09-12"},
        LinkCase{"SFsooner", SF, -4 * kHour, working, "2026-03-02 09:00 .. 2026-03-02 14:00",
                 "b ends Monday 14:00: 13-14, 09-12"}),
    case_name);

}  // namespace
}  // namespace rubicon::schedule
