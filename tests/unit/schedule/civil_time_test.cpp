#include "src/simulation/schedule/civil_time.hpp"

#include <gtest/gtest.h>

namespace rubicon::schedule {
namespace {

/// The day after, by the rule of leap years alone.
Date next_day(Date date) {
  ++date.day;
  if (is_valid(date)) return date;
  date.day = 1;
  if (++date.month <= 12) return date;
  date.month = 1;
  ++date.year;
  return date;
}

TEST(CivilTime, CountsEveryDayOfFourHundredYears) {
  Date date{1800, 1, 1};
  std::int64_t days = days_from_date(date);
  int weekday = weekday_of(date);
  const std::int64_t first = days;
  while (date.year < 2200) {
    ASSERT_EQ(days_from_date(date), days) << text_of(date);
    ASSERT_EQ(date_from_days(days), date) << days;
    ASSERT_EQ(weekday_of(date), weekday) << text_of(date);
    ASSERT_EQ(parse_date(text_of(date)), date);
    date = next_day(date);
    weekday = (weekday + 1) % 7;
    ++days;
  }
  EXPECT_EQ(days - first, 146097);  // 400 years have 97 leap days
}

TEST(CivilTime, KnowsDatesOfHistory) {
  EXPECT_EQ(days_from_date({1970, 1, 1}), 0);
  EXPECT_EQ(days_from_date({2000, 3, 1}), 11017);
  EXPECT_EQ(days_from_date({1, 1, 1}), -719162);
  EXPECT_EQ(days_from_date({9999, 12, 31}), 2932896);
  EXPECT_EQ(weekday_of({1970, 1, 1}), 3);   // a Thursday
  EXPECT_EQ(weekday_of({1969, 7, 20}), 6);  // the moon landing, a Sunday
  EXPECT_EQ(weekday_of({2026, 3, 2}), 0);   // a Monday
  EXPECT_EQ(date_from_days(-1), (Date{1969, 12, 31}));
}

TEST(CivilTime, HasLeapDaysByTheGregorianRule) {
  EXPECT_TRUE(is_valid({2024, 2, 29}));
  EXPECT_TRUE(is_valid({2000, 2, 29}));
  EXPECT_FALSE(is_valid({1900, 2, 29}));
  EXPECT_FALSE(is_valid({2026, 2, 29}));
  EXPECT_FALSE(is_valid({2026, 4, 31}));
  EXPECT_FALSE(is_valid({2026, 0, 1}));
  EXPECT_FALSE(is_valid({2026, 13, 1}));
  EXPECT_FALSE(is_valid({2026, 1, 0}));
}

TEST(CivilTime, ReadsAndWritesText) {
  const auto time = parse_civil_time("2026-03-02 07:05");
  ASSERT_TRUE(time);
  EXPECT_EQ(*time, (CivilTime{{2026, 3, 2}, 425}));
  EXPECT_EQ(text_of(*time), "2026-03-02 07:05");
  EXPECT_EQ(text_of(Date{7, 1, 2}), "0007-01-02");
  for (const char* wrong :
       {"", "2026-03-02", "2026-03-02T07:00", "2026-03-02 24:00", "2026-03-02 07:60",
        "2026-02-29 07:00", "2026-3-2 07:00", "0000-01-01 00:00", "2026-03-02 -7:00",
        "2026-03-02 07:00 ", "2026-03-02 0x:00", "+026-03-02 07:00"}) {
    EXPECT_FALSE(parse_civil_time(wrong)) << wrong;
  }
}

TEST(CivilTime, CountsTicksFromTheStart) {
  const CivilTime start = parse_civil_time("2026-12-31 22:30").value();
  EXPECT_EQ(text_of(civil_time_at(start, 0)), "2026-12-31 22:30");
  EXPECT_EQ(text_of(civil_time_at(start, 90 * kMinute)), "2027-01-01 00:00");
  EXPECT_EQ(text_of(civil_time_at(start, kMinute - 1)), "2026-12-31 22:30");
  EXPECT_EQ(text_of(civil_time_at(start, -1)), "2026-12-31 22:29");
  EXPECT_EQ(text_of(civil_time_at(start, -24 * kHour)), "2026-12-30 22:30");
  EXPECT_EQ(ticks_between(start, parse_civil_time("2027-01-01 00:00").value()), 90 * kMinute);
  EXPECT_EQ(ticks_between(start, parse_civil_time("2026-12-31 22:29").value()), -kMinute);
  EXPECT_EQ(ticks_between(start, parse_civil_time("2126-12-31 22:30").value()),
            (100 * 365 + 24) * kDay);  // 2028 ... 2124 less 2100
}

TEST(CivilTime, SaysWhatIsTooFarToCount) {
  const CivilTime start = parse_civil_time("2026-03-02 07:00").value();
  EXPECT_TRUE(ticks_between(start, parse_civil_time("2150-01-01 00:00").value()));
  EXPECT_FALSE(ticks_between(start, parse_civil_time("2160-01-01 00:00").value()));
  EXPECT_FALSE(ticks_between(start, parse_civil_time("9999-12-31 23:59").value()));
  EXPECT_FALSE(ticks_between(start, parse_civil_time("0001-01-01 00:00").value()));
}

}  // namespace
}  // namespace rubicon::schedule
