#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/unit/schedule/calendar_cases.hpp"

namespace rubicon::schedule {
namespace {

constexpr int kCalendars = 300;
constexpr int kQuestions = 60;
constexpr Date kFirst{2026, 3, 5};

/// Random rules and questions; whole numbers only, so that they are the same everywhere.
class CalendarDice {
 public:
  explicit CalendarDice(unsigned seed) : engine_(seed) {}

  std::int64_t below(std::int64_t count) {
    return static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(count));
  }

  CivilTime start() { return {kFirst, static_cast<int>(below(1440))}; }

  WorkCalendar calendar(const std::string& name, const CivilTime& start) {
    CalendarRules rules;
    rules.name = name;
    for (std::int64_t i = below(4) + 1; i > 0; --i) {
      const int first = static_cast<int>(below(7));
      const int from = static_cast<int>(below(1440));
      rules.shifts.push_back({first,
                              static_cast<int>(first + below(7 - first)),
                              {{from, static_cast<int>(from + 1 + below(1440 - from))}}});
    }
    for (std::int64_t i = below(12); i > 0; --i) {
      rules.off.push_back(date_from_days(days_from_date(kFirst) + below(40) - 20));
    }
    return test::calendar(rules, test_text(start));
  }

  /// Within three weeks of the start; now and then on a whole minute, where shifts begin and end.
  Ticks time() {
    const Ticks minutes = (below(6 * 7 * 1440) - 3 * 7 * 1440) * kMinute;
    return below(3) == 0 ? minutes : minutes + below(kMinute);
  }

  Ticks work() { return below(4) == 0 ? below(3) : below(60 * kHour); }

 private:
  static std::string test_text(const CivilTime& start) { return text_of(start); }

  std::mt19937_64 engine_;
};

TEST(CalendarProperty, WorkNeverStopsBeforeTheEndOfAShift) {
  CalendarDice dice(7);
  for (int i = 0; i < kCalendars; ++i) {
    const WorkCalendar calendar = dice.calendar("a", dice.start());
    const WorkCalendar::Interval longest = calendar.longest_shift();
    for (int j = 0; j < kQuestions; ++j) {
      const Ticks from = dice.time();
      const Ticks end = calendar.shift_end(from);
      ASSERT_EQ(end == from, !calendar.works_at(from));
      ASSERT_EQ(calendar.work_between(from, end), end - from);
      if (end == kEndOfTime) continue;
      ASSERT_FALSE(calendar.works_at(end));
      ASSERT_LE(end - from, longest.to - longest.from);
    }
  }
}

TEST(CalendarProperty, FinishAndLatestStartAreTight) {
  CalendarDice dice(1);
  for (int i = 0; i < kCalendars; ++i) {
    const WorkCalendar calendar = dice.calendar("a", dice.start());
    for (int j = 0; j < kQuestions; ++j) {
      const Ticks t = dice.time(), work = dice.work() + 1;
      const Ticks finish = calendar.finish(t, work);
      ASSERT_EQ(calendar.work_between(t, finish), work);
      ASSERT_EQ(calendar.work_between(t, finish - 1), work - 1);
      const Ticks start = calendar.latest_start(t, work);
      ASSERT_EQ(calendar.work_between(start, t), work);
      ASSERT_EQ(calendar.work_between(start + 1, t), work - 1);
      ASSERT_EQ(calendar.finish(start, work), calendar.last_working(t));
    }
  }
}

TEST(CalendarProperty, NextAndLastWorkingMomentsAreNearest) {
  CalendarDice dice(2);
  for (int i = 0; i < kCalendars; ++i) {
    const WorkCalendar calendar = dice.calendar("a", dice.start());
    for (int j = 0; j < kQuestions; ++j) {
      const Ticks t = dice.time();
      const Ticks next = calendar.next_working(t), last = calendar.last_working(t);
      ASSERT_GE(next, t);
      ASSERT_LE(last, t);
      ASSERT_TRUE(calendar.works_at(next));
      ASSERT_TRUE(calendar.works_at(last - 1));
      ASSERT_EQ(calendar.work_between(t, next), 0);
      ASSERT_EQ(calendar.work_between(last, t), 0);
      ASSERT_EQ(calendar.next_working(next), next);
      ASSERT_EQ(calendar.last_working(last), last);
    }
  }
}

TEST(CalendarProperty, MoreTimeIsNeverEarlier) {
  CalendarDice dice(3);
  for (int i = 0; i < kCalendars; ++i) {
    const WorkCalendar calendar = dice.calendar("a", dice.start());
    for (int j = 0; j < kQuestions; ++j) {
      const Ticks t = dice.time(), later = t + dice.work(), work = dice.work();
      const Ticks more = work + dice.work();
      ASSERT_LE(calendar.finish(t, work), calendar.finish(later, work));
      ASSERT_LE(calendar.finish(t, work), calendar.finish(t, more));
      ASSERT_LE(calendar.latest_start(t, work), calendar.latest_start(later, work));
      ASSERT_GE(calendar.latest_start(t, work), calendar.latest_start(t, more));
      ASSERT_LE(calendar.next_working(t), calendar.next_working(later));
      ASSERT_EQ(calendar.work_between(t, later) + calendar.idle_between(t, later), later - t);
      ASSERT_EQ(calendar.finish(calendar.finish(t, work), more - work), calendar.finish(t, more));
    }
  }
}

TEST(CalendarProperty, IntersectionCommutesAndAsksBoth) {
  CalendarDice dice(4);
  int met = 0;
  for (int i = 0; i < kCalendars; ++i) {
    const CivilTime start = dice.start();
    const WorkCalendar a = dice.calendar("a", start), b = dice.calendar("b", start),
                       c = dice.calendar("c", start);
    const auto ab = intersection(a, b), ba = intersection(b, a);
    ASSERT_EQ(ab.index(), ba.index());
    ASSERT_EQ(std::get<WorkCalendar>(intersection(a, a)), a);
    ASSERT_EQ(std::get<WorkCalendar>(intersection(a, WorkCalendar())), a);
    const auto* both = std::get_if<WorkCalendar>(&ab);
    if (both == nullptr) {
      ASSERT_EQ(std::get<CalendarMistake>(ab).message, std::get<CalendarMistake>(ba).message);
      continue;
    }
    ++met;
    ASSERT_EQ(*both, std::get<WorkCalendar>(ba));
    for (int j = 0; j < kQuestions; ++j) {
      const Ticks t = dice.time();
      ASSERT_EQ(both->works_at(t), a.works_at(t) && b.works_at(t));
    }
    const auto bc = intersection(b, c);
    if (!std::holds_alternative<WorkCalendar>(bc)) continue;
    const auto left = intersection(*both, c), right = intersection(a, std::get<WorkCalendar>(bc));
    ASSERT_EQ(left.index(), right.index());
    if (std::holds_alternative<WorkCalendar>(left)) {
      ASSERT_EQ(std::get<WorkCalendar>(left), std::get<WorkCalendar>(right));
    }
  }
  EXPECT_GT(met, kCalendars / 2);
}

// The other way to count: minute by minute over the rules themselves.
TEST(CalendarProperty, AgreesWithCountingMinutes) {
  const WorkCalendar calendar = test::calendar(test::weekday_shift(), "2026-03-05 09:17");
  const CivilTime start{{2026, 3, 5}, 9 * 60 + 17};
  Ticks counted = 0;
  for (std::int64_t minute = -20 * 1440; minute < 20 * 1440; ++minute) {
    const Ticks t = minute * kMinute;
    ASSERT_EQ(calendar.work_between(-20 * kDay, t), counted);
    const CivilTime now = civil_time_at(start, t);
    const int m = now.minute_of_day;
    const bool shift = (m >= 420 && m < 720) || (m >= 780 && m < 960);
    const bool works = shift && weekday_of(now.date) < 5 && now.date != Date{2026, 3, 9};
    ASSERT_EQ(calendar.works_at(t), works) << text_of(now);
    if (works) counted += kMinute;
  }
}

}  // namespace
}  // namespace rubicon::schedule
