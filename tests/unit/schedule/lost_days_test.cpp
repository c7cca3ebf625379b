#include "src/simulation/schedule/lost_days.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "src/motion/math/random.hpp"
#include "src/simulation/schedule/calendar_rules.hpp"

namespace rubicon::schedule {
namespace {

constexpr CivilTime kBegin{{2026, 3, 4}, 7 * 60};  // a Wednesday

CalendarRules rules_of(double share, std::uint64_t run) {
  CalendarRules rules;
  rules.name = "site";
  rules.shifts = {{0, 4, {{7 * 60, 12 * 60}, {13 * 60, 16 * 60}}}, {5, 5, {{8 * 60, 12 * 60}}}};
  rules.off = {{2026, 4, 3}, {2026, 4, 6}, {2025, 12, 25}};
  rules.lost.fill(share);
  rules.weather = Weather{11, run};
  return rules;
}

WorkCalendar made(const CalendarRules& rules) {
  return std::get<WorkCalendar>(calendar_of(rules, kBegin));
}

/// The same calendar with its lost days of twenty years written down as days off.
WorkCalendar listed(CalendarRules rules) {
  const LostDays lost{rules.lost, *rules.weather};
  const std::int64_t first = days_from_date(kBegin.date);
  for (std::int64_t day = first; day < first + 20 * 366; ++day) {
    if (lost.is_lost(day)) rules.off.push_back(date_from_days(day));
  }
  rules.weather.reset();
  return made(rules);
}

TEST(LostDays, AreDaysOffWhateverIsAskedFirst) {
  math::Random random(5);
  for (std::uint64_t run = 0; run < 20; ++run) {
    const CalendarRules rules = rules_of(run % 2 == 0 ? 0.3 : 0.9, run);
    const WorkCalendar drawn = made(rules);
    const WorkCalendar off = listed(rules);
    for (int i = 0; i < 200; ++i) {
      const auto from = static_cast<Ticks>(random.between(-60, 900) * static_cast<double>(kDay));
      const auto work = static_cast<Ticks>(random.between(-20, 60) * static_cast<double>(kHour));
      EXPECT_EQ(drawn.finish(from, work), off.finish(from, work));
      EXPECT_EQ(drawn.latest_start(from, work), off.latest_start(from, work));
      EXPECT_EQ(drawn.work_between(from, from + 9 * kDay), off.work_between(from, from + 9 * kDay));
      EXPECT_EQ(drawn.shift_end(from), off.shift_end(from));
      EXPECT_EQ(drawn.next_working(from), off.next_working(from));
      EXPECT_EQ(drawn.works_at(from), off.works_at(from));
    }
  }
}

TEST(LostDays, EndAShiftThatGoesRoundTheClock) {
  CalendarRules rules = rules_of(0.05, 3);
  rules.shifts = {{0, 6, {{0, 24 * 60}}}};
  const WorkCalendar drawn = made(rules);
  const WorkCalendar off = listed(rules);
  for (Ticks from = 0; from < 900 * kDay; from += 17 * kHour) {
    EXPECT_EQ(drawn.shift_end(from), off.shift_end(from));
  }
}

/// Of n days each is lost with the same probability: their number is binomial.
TEST(LostDays, AreAsManyAsTheirShareSays) {
  constexpr int kDays = 200'000;
  LostDays lost;
  lost.shares.fill(0.1);
  int count = 0, both = 0;
  for (int day = 20'000; day < 20'000 + kDays; ++day) {
    count += lost.is_lost(day) ? 1 : 0;
    both += lost.is_lost(day) && lost.is_lost(day + 1) ? 1 : 0;
  }
  EXPECT_NEAR(count, 0.1 * kDays, 4 * std::sqrt(kDays * 0.1 * 0.9));
  EXPECT_NEAR(both, 0.01 * kDays, 5 * std::sqrt(kDays * 0.01));  // days do not know each other
}

/// What is lost with a share is lost with a greater one, in every calendar of the run.
TEST(LostDays, AreOfOneWeather) {
  LostDays rain, wind;
  rain.shares.fill(0.1);
  wind.shares.fill(0.25);
  wind.shares[6] = 0;  // not in July
  LostDays other = rain;
  other.weather.run = 1;
  int differs = 0;
  for (std::int64_t day = 20'000; day < 22'000; ++day) {
    const bool july = date_from_days(day).month == 7;
    EXPECT_TRUE(wind.is_lost(day) || !rain.is_lost(day) || july);
    EXPECT_FALSE(july && wind.is_lost(day));
    EXPECT_EQ(both_lost(rain, wind).is_lost(day), rain.is_lost(day) || wind.is_lost(day));
    differs += rain.is_lost(day) != other.is_lost(day) ? 1 : 0;
  }
  EXPECT_GT(differs, 200);
}

TEST(LostDays, AreLostToWhoeverNeedsEither) {
  CalendarRules crane = rules_of(0.4, 9);
  CalendarRules crew = rules_of(0.1, 9);
  crew.name = "crew";
  crew.shifts = {{0, 6, {{6 * 60, 14 * 60}}}};
  const WorkCalendar a = made(crane), b = made(crew);
  const WorkCalendar both = std::get<WorkCalendar>(intersection(a, b));
  for (Ticks time = 0; time < 200 * kDay; time += kHour) {
    EXPECT_EQ(both.works_at(time), a.works_at(time) && b.works_at(time));
  }
}

TEST(LostDays, AreToldUpToAnEnd) {
  CalendarRules rules = rules_of(0.3, 4);
  const WorkCalendar drawn = made(rules);
  rules.weather.reset();
  const WorkCalendar dry = made(rules);
  const Ticks end = 45 * kDay + 3 * kHour;
  const WorkCalendar::Lost lost = drawn.lost_until(end);
  std::int64_t working = 0;
  std::set<std::int64_t> days(lost.days.begin(), lost.days.end());
  Ticks taken = 0;
  for (std::int64_t day = 0; day <= 45; ++day) {
    const Ticks midnight = day * kDay - 7 * kHour;
    const Ticks from = std::max<Ticks>(midnight, 0), to = std::min(midnight + kDay, end);
    if (dry.work_between(from, to) == 0) continue;
    ++working;
    if (days.contains(days_from_date(kBegin.date) + day)) taken += dry.work_between(from, to);
  }
  EXPECT_EQ(lost.working_days, working);
  EXPECT_FALSE(lost.days.empty());
  EXPECT_EQ(taken, dry.work_between(0, end) - drawn.work_between(0, end));
  EXPECT_EQ(dry.lost_until(end).working_days, 0);
}

}  // namespace
}  // namespace rubicon::schedule
