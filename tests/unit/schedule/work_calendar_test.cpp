#include "src/simulation/schedule/work_calendar.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "tests/unit/schedule/calendar_cases.hpp"

namespace rubicon::schedule {
namespace {

using test::calendar;
using test::moment_text;

// A Friday; the Monday after it is off in weekday_shift().
constexpr const char* kStart = "2026-03-06 07:00";

Ticks at(const char* text) { return test::moment(kStart, text); }
std::string text(Ticks time) { return moment_text(kStart, time); }

std::string message(const std::variant<WorkCalendar, CalendarMistake>& made) {
  const auto* mistake = std::get_if<CalendarMistake>(&made);
  return mistake ? mistake->message : "";
}

TEST(WorkCalendar, FindsTheNextWorkingMoment) {
  const WorkCalendar weekdays = calendar(test::weekday_shift(), kStart);
  const auto next = [&](const char* from) { return text(weekdays.next_working(at(from))); };
  EXPECT_EQ(next("2026-03-06 07:00"), "2026-03-06 07:00");  // a shift begins
  EXPECT_EQ(next("2026-03-06 11:59"), "2026-03-06 11:59");  // inside
  EXPECT_EQ(next("2026-03-06 12:00"), "2026-03-06 13:00");  // the end of a shift is outside: lunch
  EXPECT_EQ(next("2026-03-06 16:00"), "2026-03-10 07:00");  // weekend, then Monday off
  EXPECT_EQ(next("2026-03-09 08:00"), "2026-03-10 07:00");  // on the day off
  EXPECT_EQ(next("2026-03-05 03:00"), "2026-03-05 07:00");  // before the start of the plan
}

TEST(WorkCalendar, FindsTheLastWorkingMoment) {
  const WorkCalendar weekdays = calendar(test::weekday_shift(), kStart);
  const auto last = [&](const char* from) { return text(weekdays.last_working(at(from))); };
  EXPECT_EQ(last("2026-03-06 12:00"), "2026-03-06 12:00");  // work can end where the shift ends
  EXPECT_EQ(last("2026-03-06 12:30"), "2026-03-06 12:00");
  EXPECT_EQ(last("2026-03-06 13:00"), "2026-03-06 12:00");  // nothing is done yet at 13:00
  EXPECT_EQ(last("2026-03-06 13:01"), "2026-03-06 13:01");
  EXPECT_EQ(last("2026-03-10 07:00"), "2026-03-06 16:00");  // back over the day off and weekend
}

TEST(WorkCalendar, FindsTheEndOfAShiftAndTheLongestOne) {
  const WorkCalendar weekdays = calendar(test::weekday_shift(), kStart);
  const auto end = [&](const char* from) { return text(weekdays.shift_end(at(from))); };
  EXPECT_EQ(end("2026-03-06 07:00"), "2026-03-06 12:00");
  EXPECT_EQ(end("2026-03-06 12:00"), "2026-03-06 12:00");  // no shift there
  EXPECT_EQ(end("2026-03-06 15:59"), "2026-03-06 16:00");
  EXPECT_EQ(weekdays.longest_shift().to - weekdays.longest_shift().from, 5 * kHour);
  EXPECT_EQ(WorkCalendar().shift_end(7), kEndOfTime);
  EXPECT_EQ(WorkCalendar().longest_shift().to, kEndOfTime);
}

TEST(WorkCalendar, FinishesWorkOverShifts) {
  const WorkCalendar weekdays = calendar(test::weekday_shift(), kStart);
  const auto finish = [&](const char* from, Ticks work) {
    return text(weekdays.finish(at(from), work));
  };
  EXPECT_EQ(finish("2026-03-06 07:00", 5 * kHour), "2026-03-06 12:00");  // to the minute at lunch
  EXPECT_EQ(finish("2026-03-06 07:00", 6 * kHour), "2026-03-06 14:00");  // 5 h, lunch, 1 h
  EXPECT_EQ(finish("2026-03-06 07:00", 8 * kHour), "2026-03-06 16:00");  // the whole day
  EXPECT_EQ(finish("2026-03-06 15:00", 2 * kHour), "2026-03-10 08:00");  // 1 h Friday, 1 h Tuesday
  EXPECT_EQ(finish("2026-03-07 10:00", kHour), "2026-03-10 08:00");      // begins out of shift
  EXPECT_EQ(finish("2026-03-07 10:00", 0), "2026-03-07 10:00");          // nothing to do
  // 52 weeks of 40 h from Tuesday: 2026-03-10 to 2027-03-09 has no other day off.
  EXPECT_EQ(finish("2026-03-10 07:00", 52 * 40 * kHour), "2027-03-08 16:00");
}

TEST(WorkCalendar, FindsTheLatestStart) {
  const WorkCalendar weekdays = calendar(test::weekday_shift(), kStart);
  const auto latest = [&](const char* to, Ticks work) {
    return text(weekdays.latest_start(at(to), work));
  };
  EXPECT_EQ(latest("2026-03-06 16:00", 4 * kHour), "2026-03-06 11:00");  // 3 h, lunch, 1 h
  EXPECT_EQ(latest("2026-03-10 08:00", 2 * kHour), "2026-03-06 15:00");  // over the day off
  EXPECT_EQ(latest("2026-03-08 12:00", kHour), "2026-03-06 15:00");      // the end is out of shift
  EXPECT_EQ(latest("2026-03-06 16:00", 3 * kHour), "2026-03-06 13:00");  // begins with the shift
  EXPECT_EQ(latest("2026-03-08 12:00", 0), "2026-03-08 12:00");
}

TEST(WorkCalendar, CountsWorkAndTimeOutsideOfShifts) {
  const WorkCalendar weekdays = calendar(test::weekday_shift(), kStart);
  const Ticks from = at("2026-03-06 11:00"), to = at("2026-03-10 08:00");
  EXPECT_EQ(weekdays.work_between(from, to), 5 * kHour);   // 11-12, 13-16, Tuesday 7-8
  EXPECT_EQ(weekdays.idle_between(from, to), 88 * kHour);  // of 93 h
  EXPECT_EQ(weekdays.work_between(to, from), 0);
  EXPECT_EQ(weekdays.idle_between(to, from), 0);
  EXPECT_TRUE(weekdays.works_at(from));
  EXPECT_FALSE(weekdays.works_at(at("2026-03-06 12:00")));
}

TEST(WorkCalendar, WorksDayAndNightWithoutRules) {
  const WorkCalendar always;
  EXPECT_EQ(always.next_working(5), 5);
  EXPECT_EQ(always.last_working(5), 5);
  EXPECT_EQ(always.finish(-3, 10 * kWeek), 10 * kWeek - 3);
  EXPECT_EQ(always.latest_start(7, 9), -2);
  EXPECT_EQ(always.idle_between(-kWeek, kWeek), 0);
  EXPECT_EQ(always.work_between(-kWeek, kWeek), 2 * kWeek);
}

TEST(WorkCalendar, JoinsANightShiftAtMidnightButNotOnADayOff) {
  CalendarRules rules;
  rules.name = "night";
  rules.shifts = {{0, 6, {{0, 6 * 60}, {22 * 60, 24 * 60}}}};
  rules.off = {{2026, 3, 8}};
  const WorkCalendar night = calendar(rules, kStart);
  EXPECT_EQ(text(night.finish(at("2026-03-06 22:00"), 8 * kHour)), "2026-03-07 06:00");
  // Saturday 22:00 to 24:00, nothing on Sunday the 8th, then from Monday 00:00.
  EXPECT_EQ(text(night.finish(at("2026-03-07 22:00"), 3 * kHour)), "2026-03-09 01:00");
}

TEST(WorkCalendar, AddsShiftsOfADayUp) {
  CalendarRules rules;
  rules.name = "two lines";
  rules.shifts = {{4, 4, {{7 * 60, 9 * 60}}}, {0, 6, {{8 * 60, 10 * 60}}}};
  const WorkCalendar made = calendar(rules, kStart);
  EXPECT_EQ(made.work_between(at("2026-03-06 00:00"), at("2026-03-07 00:00")), 3 * kHour);
  EXPECT_EQ(made.work_between(at("2026-03-07 00:00"), at("2026-03-08 00:00")), 2 * kHour);
}

TEST(WorkCalendar, IsTheSameHoweverItsHoursAreWritten) {
  CalendarRules whole, parts;
  whole.name = parts.name = "site";
  whole.shifts = {{0, 4, {{7 * 60, 16 * 60}}}};
  parts.shifts = {{0, 4, {{12 * 60, 16 * 60}, {7 * 60, 12 * 60}}}, {2, 2, {{8 * 60, 9 * 60}}}};
  EXPECT_EQ(calendar(whole, kStart), calendar(parts, kStart));
  whole.off = {{2026, 3, 7}};  // a Saturday, on which nobody works anyhow
  EXPECT_EQ(calendar(whole, kStart), calendar(parts, kStart));
  whole.off = {{2026, 3, 9}};
  EXPECT_NE(calendar(whole, kStart), calendar(parts, kStart));
}

TEST(WorkCalendar, IntersectsHoursAndJoinsDaysOff) {
  CalendarRules late = test::daily_shift();
  late.name = "late";
  late.shifts = {{0, 6, {{10 * 60, 18 * 60}}}};
  late.off = {{2026, 3, 10}};
  late.carry_over = true;
  const auto both = std::get<WorkCalendar>(
      intersection(calendar(test::weekday_shift(), kStart), calendar(late, kStart)));
  // Friday 10-12 and 13-16; then Monday off (weekdays), Tuesday off (late), Wednesday from 10.
  EXPECT_EQ(text(both.next_working(0)), "2026-03-06 10:00");
  EXPECT_EQ(text(both.finish(0, 5 * kHour)), "2026-03-06 16:00");
  EXPECT_EQ(text(both.finish(0, 6 * kHour)), "2026-03-11 11:00");
  EXPECT_TRUE(both.carries_over());
  EXPECT_THAT(both.names(), testing::ElementsAre("late", "weekdays"));
}

TEST(WorkCalendar, SaysThatItNeverWorks) {
  CalendarRules rules;
  rules.name = "holiday";
  const CivilTime start = parse_civil_time(kStart).value();
  EXPECT_EQ(message(calendar_of(rules, start)), "calendar 'holiday' has no working hours");
  CalendarRules night;
  night.name = "night";
  night.shifts = {{0, 6, {{20 * 60, 24 * 60}}}};
  EXPECT_EQ(message(intersection(calendar(test::daily_shift(), kStart), calendar(night, kStart))),
            "calendars 'daily', 'night' have no working hours in common");
  EXPECT_EQ(message(intersection(calendar(test::daily_shift(), kStart),
                                 calendar(night, "2026-03-02 07:00"))),
            "calendars 'daily', 'night' do not count from the same start");
}

TEST(WorkCalendar, RefusesRulesThatMakeNoSense) {
  const CivilTime start = parse_civil_time(kStart).value();
  const auto said = [&](CalendarRules rules) {
    rules.name = "bad";
    return message(calendar_of(rules, start));
  };
  CalendarRules rules;
  rules.shifts = {{0, 6, {{60, 60}}}};
  EXPECT_THAT(said(rules), testing::HasSubstr("shift from minute 60 to minute 60"));
  rules.shifts = {{0, 6, {{60, 1441}}}};
  EXPECT_THAT(said(rules), testing::HasSubstr("expected 0 to 1440"));
  rules.shifts = {{5, 2, {{60, 90}}}};
  EXPECT_THAT(said(rules), testing::HasSubstr("from day 5 to day 2"));
  rules.shifts = {{0, 7, {{60, 90}}}};
  EXPECT_THAT(said(rules), testing::HasSubstr("to day 7"));
  rules.shifts = {{0, 6, {{60, 90}}}};
  rules.off = {{2026, 2, 30}};
  EXPECT_THAT(said(rules), testing::HasSubstr("2026-02-30, that is no date"));
  EXPECT_THAT(message(WorkCalendar::make({{"x"}, 1, {{0, 1}}, {}, false})),
              testing::HasSubstr("Monday"));
  EXPECT_THAT(message(WorkCalendar::make({{"x"}, 0, {{5, 5}}, {}, false})),
              testing::HasSubstr("does not end"));
}

TEST(WorkCalendar, AnswersBeyondTheEndOfTime) {
  CalendarRules rules;
  rules.name = "a minute a week";
  rules.shifts = {{0, 0, {{0, 1}}}};
  const WorkCalendar slow = calendar(rules, kStart);
  EXPECT_EQ(slow.finish(0, kEndOfTime), kEndOfTime);
  EXPECT_EQ(slow.finish(0, 10'000 * kMinute), kEndOfTime);  // 192 years
  EXPECT_EQ(slow.latest_start(0, 10'000 * kMinute), -kEndOfTime);
  EXPECT_EQ(slow.next_working(kEndOfTime), kEndOfTime);
  EXPECT_EQ(slow.next_working(std::numeric_limits<Ticks>::max()), kEndOfTime);
  EXPECT_EQ(slow.last_working(std::numeric_limits<Ticks>::min()), -kEndOfTime);
  EXPECT_EQ(slow.shifted(0, std::numeric_limits<Ticks>::min()), -kEndOfTime);

  rules.shifts = {{0, 6, {{0, 24 * 60}}}};
  for (int year = 1; year <= 9999; year += 1) {
    for (int month = 1; month <= 12; ++month) rules.off.push_back({year, month, 1});
  }
  const WorkCalendar firsts_off = calendar(rules, kStart);
  EXPECT_EQ(firsts_off.finish(0, kEndOfTime), kEndOfTime);
  EXPECT_EQ(text(firsts_off.next_working(at("2126-03-01 00:00"))), "2126-03-02 00:00");
}

}  // namespace
}  // namespace rubicon::schedule
