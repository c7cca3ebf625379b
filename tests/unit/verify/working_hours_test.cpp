#include "src/results/verify/schedule/working_hours.hpp"

#include <gtest/gtest.h>

#include "tests/unit/verify/random.hpp"

namespace rubicon::verify {
namespace {

constexpr Ticks kMinute = 60 * kSecond;
constexpr Ticks kHour = 60 * kMinute;

Scene scene() {
  Scene scene;
  scene.start_at = "2026-03-06 14:30";  // a Friday
  SceneCalendar day;
  day.shifts = {{0, 4, {{7 * 60, 12 * 60}, {12 * 60 + 30, 16 * 60}}}};
  day.off = {"2026-03-09"};
  SceneCalendar night;
  night.shifts = {{0, 6, {{22 * 60, 24 * 60}, {0, 6 * 60}}}, {5, 5, {{7 * 60, 9 * 60}}}};
  SceneCalendar long_day;
  long_day.shifts = {{0, 6, {{6 * 60, 13 * 60}, {13 * 60, 20 * 60}, {8 * 60, 9 * 60}}}};
  scene.calendars = {day, night, long_day};
  return scene;
}

TEST(WorkingHours, OfAWeekendWithADayOff) {
  const WorkingHours hours(scene());
  const std::vector<int> day = {0};
  EXPECT_EQ(hours.between(day, 0, 90 * kMinute), 90 * kMinute);  // Friday to 16:00
  EXPECT_EQ(hours.between(day, 0, 88 * kHour), 90 * kMinute);    // Tuesday 06:30
  EXPECT_EQ(hours.between(day, 0, 89 * kHour), 2 * kHour);       // Tuesday 07:30
  EXPECT_EQ(hours.between({}, kHour, 3 * kHour), 2 * kHour);
  EXPECT_TRUE(hours.at(day, 0));
  EXPECT_FALSE(hours.at(day, 2 * kHour));
  EXPECT_TRUE(hours.at(day, 90 * kMinute));  // the end of a shift
  EXPECT_FALSE(hours.at(day, 90 * kMinute + kSecond));
}

TEST(WorkingHours, OfSeveralAreThoseOfAll) {
  const WorkingHours hours(scene());
  EXPECT_EQ(hours.between(std::vector{0, 1}, 0, 2000 * kHour), 0);
  const std::vector<int> both = {0, 2};
  EXPECT_EQ(hours.between(both, 0, 89 * kHour), 2 * kHour);
  const std::vector<int> nights = {1, 2};
  EXPECT_EQ(hours.between(nights, 0, 24 * kHour), 2 * kHour);  // Saturday 07:00-09:00
}

TEST(WorkingHours, AreThoseOfACountMinuteByMinute) {
  const WorkingHours hours(scene());
  Random random(11);
  for (int round = 0; round < 100; ++round) {
    std::vector<int> calendars = {random.whole(0, 2)};
    if (round % 3 == 0) calendars.push_back(random.whole(0, 2));
    const Ticks from = random.whole(0, 6000) * kMinute;
    const Ticks to = from + random.whole(0, 9000) * kMinute;
    Ticks counted = 0;
    for (Ticks t = from; t < to; t += kMinute) {
      if (hours.at(calendars, t + kMinute / 2)) counted += kMinute;
    }
    EXPECT_EQ(hours.between(calendars, from, to), counted);
  }
}

TEST(WorkingHours, BeginOnAMondayWhereThePlanDoesNotTell) {
  Scene undated = scene();
  undated.start_at.clear();
  const WorkingHours hours(undated);
  const std::vector<int> day = {0};
  EXPECT_EQ(hours.between(day, 0, 24 * kHour), 8 * kHour + 30 * kMinute);
  EXPECT_EQ(hours.between(day, 5 * 24 * kHour, 7 * 24 * kHour), 0);
}

TEST(WorkingHours, RefuseWhatIsNoDate) {
  for (const char* text : {"2026", "2026-13-01 07:00", "2026-03-06 25:00", "today", "2026-03-06"}) {
    Scene wrong = scene();
    wrong.start_at = text;
    EXPECT_THROW(WorkingHours{wrong}, UnreadableInput) << text;
  }
}

}  // namespace
}  // namespace rubicon::verify
