#include "tests/unit/schedule/link_cases.hpp"

namespace rubicon::test {

namespace {

using enum schedule::LinkType;
using enum schedule::LagClock;
using schedule::kHour;

// ---- Day and night. Monday 07:00: lead until 17:00, a from 17:00 to 23:00.

std::vector<LinkCase> day_and_night() {
  return {
      {"FS", FS, 0, elapsed, "2026-03-02 23:00 .. 2026-03-03 03:00", "a ends at 23:00"},
      {"FSlater", FS, 2 * kHour, elapsed, "2026-03-03 01:00 .. 2026-03-03 05:00", "23:00 and 2 h"},
      {"FSsooner", FS, -2 * kHour, elapsed, "2026-03-02 21:00 .. 2026-03-03 01:00",
       "2 h before a ends"},
      {"SS", SS, 0, elapsed, "2026-03-02 17:00 .. 2026-03-02 21:00", "with a"},
      {"SSlater", SS, 2 * kHour, elapsed, "2026-03-02 19:00 .. 2026-03-02 23:00",
       "2 h after a starts"},
      {"SSsooner", SS, -2 * kHour, elapsed, "2026-03-02 15:00 .. 2026-03-02 19:00",
       "2 h before a starts, while lead goes on"},
      {"FF", FF, 0, elapsed, "2026-03-02 19:00 .. 2026-03-02 23:00",
       "b ends with a, so it starts 4 h before 23:00"},
      {"FFlater", FF, 2 * kHour, elapsed, "2026-03-02 21:00 .. 2026-03-03 01:00",
       "b ends at 01:00"},
      {"FFsooner", FF, -2 * kHour, elapsed, "2026-03-02 17:00 .. 2026-03-02 21:00",
       "b ends at 21:00"},
      {"SF", SF, 0, elapsed, "2026-03-02 13:00 .. 2026-03-02 17:00", "b ends when a starts"},
      {"SFlater", SF, 2 * kHour, elapsed, "2026-03-02 15:00 .. 2026-03-02 19:00",
       "b ends 2 h after a starts"},
      {"SFsooner", SF, -2 * kHour, elapsed, "2026-03-02 11:00 .. 2026-03-02 15:00",
       "b ends 2 h before a starts"},
      {"SFfarSooner", SF, -8 * kHour, elapsed, "2026-03-02 07:00 .. 2026-03-02 11:00",
       "an end at 09:00 would be a start at 05:00: nothing starts before the plan, and "
       "an end at 11:00 is not too early"}};
}

// ---- Every day 07-12 and 13-16. Monday 07:00: lead 8 h on Monday, 2 h on Tuesday, until Tuesday
// 09:00; a Tuesday 09-12 and 13-16.

std::vector<LinkCase> daily() {
  return {
      {"FS", FS, 0, elapsed, "2026-03-04 07:00 .. 2026-03-04 11:00",
       "a ends with Tuesday's shift, b starts with Wednesday's"},
      {"FSlater", FS, 2 * kHour, elapsed, "2026-03-04 07:00 .. 2026-03-04 11:00",
       "the lag is over on Tuesday 18:00"},
      {"FSmuchLater", FS, 18 * kHour, elapsed, "2026-03-04 10:00 .. 2026-03-04 15:00",
       "Tuesday 16:00 and 18 h is Wednesday 10:00; 2 h, lunch, 2 h"},
      {"FSsooner", FS, -2 * kHour, elapsed, "2026-03-03 14:00 .. 2026-03-04 09:00",
       "Tuesday 14-16, Wednesday 07-09"},
      {"SS", SS, 0, elapsed, "2026-03-03 09:00 .. 2026-03-03 14:00", "09-12, lunch, 13-14"},
      {"SSlater", SS, 2 * kHour, elapsed, "2026-03-03 11:00 .. 2026-03-03 16:00", "11-12, 13-16"},
      {"SSintoLunch", SS, 3 * kHour, elapsed, "2026-03-03 13:00 .. 2026-03-04 08:00",
       "12:00 is the end of a shift: 13-16, Wednesday 07-08"},
      {"SSsooner", SS, -2 * kHour, elapsed, "2026-03-03 07:00 .. 2026-03-03 11:00",
       "Tuesday 07:00"},
      {"FF", FF, 0, elapsed, "2026-03-03 11:00 .. 2026-03-03 16:00",
       "back from 16:00: 13-16, 11-12"},
      {"FFlater", FF, 2 * kHour, elapsed, "2026-03-03 11:00 .. 2026-03-03 18:00",
       "18:00 is out of shift: the work is done by 16:00, the finish is held"},
      {"FFsooner", FF, -2 * kHour, elapsed, "2026-03-03 09:00 .. 2026-03-03 14:00",
       "back from 14:00: 13-14, 09-12"},
      {"SF", SF, 0, elapsed, "2026-03-02 14:00 .. 2026-03-03 09:00",
       "back from Tuesday 09:00: 07-09, Monday 14-16"},
      {"SFlater", SF, 2 * kHour, elapsed, "2026-03-03 07:00 .. 2026-03-03 11:00",
       "back from 11:00"},
      {"SFsooner", SF, -2 * kHour, elapsed, "2026-03-02 11:00 .. 2026-03-03 07:00",
       "Tuesday 07:00 is the begin of a shift: the work is done on Monday, 11-12 and "
       "13-16, the finish is held overnight"}};
}

// ---- Monday to Friday as above, Monday 2026-03-09 off. Thursday 07:00: lead 8 h on Thursday, 2 h
// on Friday, until Friday 09:00; a Friday 09-12 and 13-16. The next shift is on Tuesday,
// 2026-03-10.

std::vector<LinkCase> weekend_and_day_off() {
  return {
      {"FS", FS, 0, elapsed, "2026-03-10 07:00 .. 2026-03-10 11:00", "weekend and Monday off"},
      {"FSoverWeekend", FS, 48 * kHour, elapsed, "2026-03-10 07:00 .. 2026-03-10 11:00",
       "two days of drying end on Sunday 16:00"},
      {"FSlater", FS, 96 * kHour, elapsed, "2026-03-11 07:00 .. 2026-03-11 11:00",
       "four days of drying end on Tuesday 16:00, with the shift"},
      {"FSsooner", FS, -2 * kHour, elapsed, "2026-03-06 14:00 .. 2026-03-10 09:00",
       "Friday 14-16, Tuesday 07-09"},
      {"SS", SS, 0, elapsed, "2026-03-06 09:00 .. 2026-03-06 14:00", "09-12, 13-14"},
      {"SSlater", SS, 96 * kHour, elapsed, "2026-03-10 09:00 .. 2026-03-10 14:00",
       "Friday 09:00 and four days"},
      {"SSoverWeekend", SS, 24 * kHour, elapsed, "2026-03-10 07:00 .. 2026-03-10 11:00",
       "Saturday 09:00 is out of shift"},
      {"SSsooner", SS, -2 * kHour, elapsed, "2026-03-06 07:00 .. 2026-03-06 11:00", "Friday 07:00"},
      {"FF", FF, 0, elapsed, "2026-03-06 11:00 .. 2026-03-06 16:00",
       "back from Friday 16:00: 13-16, 11-12"},
      {"FFlater", FF, 96 * kHour, elapsed, "2026-03-10 11:00 .. 2026-03-10 16:00",
       "back from Tuesday 16:00"},
      {"FFsooner", FF, -2 * kHour, elapsed, "2026-03-06 09:00 .. 2026-03-06 14:00",
       "back from Friday 14:00"},
      {"SF", SF, 0, elapsed, "2026-03-05 14:00 .. 2026-03-06 09:00",
       "back from Friday 09:00: 07-09, Thursday 14-16"},
      {"SFlater", SF, 96 * kHour, elapsed, "2026-03-06 14:00 .. 2026-03-10 09:00",
       "back from Tuesday 09:00: 07-09, over the weekend, Friday 14-16"},
      {"SFoverWeekend", SF, 26 * kHour, elapsed, "2026-03-06 11:00 .. 2026-03-07 11:00",
       "Saturday 11:00: done by Friday 16:00, held"},
      {"SFsooner", SF, -2 * kHour, elapsed, "2026-03-05 11:00 .. 2026-03-06 07:00",
       "Friday 07:00: Thursday 11-12 and 13-16, held overnight"}};
}

// ---- As DailyShift, but lags are counted in working hours of b.

std::vector<LinkCase> working_lag() {
  return {{"FSlater", FS, 2 * kHour, working, "2026-03-04 09:00 .. 2026-03-04 14:00",
           "Wednesday 07-09 is the lag; 09-12, 13-14"},
          {"FSsooner", FS, -4 * kHour, working, "2026-03-03 11:00 .. 2026-03-03 16:00",
           "back from Tuesday 16:00: 13-16, 11-12"},
          {"SSlater", SS, 4 * kHour, working, "2026-03-03 14:00 .. 2026-03-04 09:00",
           "09-12, 13-14 is the lag"},
          {"SSsooner", SS, -3 * kHour, working, "2026-03-02 15:00 .. 2026-03-03 10:00",
           "back from Tuesday 09:00: 07-09, Monday 15-16"},
          {"FFlater", FF, 2 * kHour, working, "2026-03-03 14:00 .. 2026-03-04 09:00",
           "b ends Wednesday 09:00: 07-09, Tuesday 14-16"},
          {"FFsooner", FF, -4 * kHour, working, "2026-03-03 07:00 .. 2026-03-03 11:00",
           "b ends Tuesday 11:00"},
          {"SFlater", SF, 4 * kHour, working, "2026-03-03 09:00 .. 2026-03-03 14:00",
           "b ends Tuesday 14:00: 13-14, 09-12"},
          {"SFsooner", SF, -4 * kHour, working, "2026-03-02 09:00 .. 2026-03-02 14:00",
           "b ends Monday 14:00: 13-14, 09-12"}};
}

}  // namespace

const std::vector<LinkCases>& link_cases() {
  static const std::vector<LinkCases> cases = {
      {"DayAndNight", "2026-03-02 07:00", std::nullopt, day_and_night()},
      {"DailyShift", "2026-03-02 07:00", daily_shift(), daily()},
      {"WeekendAndDayOff", "2026-03-05 07:00", weekday_shift(), weekend_and_day_off()},
      {"WorkingLag", "2026-03-02 07:00", daily_shift(), working_lag()},
  };
  return cases;
}

}  // namespace rubicon::test
