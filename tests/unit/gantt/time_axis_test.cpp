#include "src/results/gantt/time_axis.hpp"

#include <gtest/gtest.h>

#include "src/results/gantt/chart_labels.hpp"

namespace rubicon::gantt {
namespace {

using schedule::CivilTime;
using schedule::kDay;
using schedule::kHour;
using schedule::kMinute;
using schedule::kSecond;

std::vector<std::string> labels(const std::vector<AxisMark>& marks) {
  std::vector<std::string> texts;
  for (const AxisMark& mark : marks) texts.push_back(mark.label);
  return texts;
}

TEST(TimeAxis, StandsAtRoundTimesOfTheClock) {
  const TimeAxis axis = make_axis(CivilTime{{2026, 3, 2}, 7 * 60 + 20}, 3 * kHour, 6);
  EXPECT_EQ(labels(axis.marks), (std::vector<std::string>{"08:00", "09:00", "10:00"}));
  EXPECT_EQ(axis.marks.front().time, 40 * kMinute);
  EXPECT_EQ(labels(axis.heads), (std::vector<std::string>{"Mon 2 Mar 2026"}));
}

TEST(TimeAxis, NamesDaysAndMonths) {
  const TimeAxis axis = make_axis(CivilTime{{2026, 2, 27}, 12 * 60}, 4 * kDay, 6);
  EXPECT_EQ(labels(axis.marks), (std::vector<std::string>{"28 Feb", "1 Mar", "2 Mar", "3 Mar"}));
  EXPECT_EQ(labels(axis.heads), (std::vector<std::string>{"Feb 2026", "Mar 2026"}));
  EXPECT_EQ(axis.heads.back().time, 36 * kHour);
}

TEST(TimeAxis, PutsWeeksOnMondays) {
  const TimeAxis axis = make_axis(CivilTime{{2026, 3, 4}, 0}, 60 * kDay, 10);
  EXPECT_EQ(axis.marks.front().label, "9 Mar");
  EXPECT_EQ(axis.marks[1].time - axis.marks[0].time, 7 * kDay);
}

TEST(TimeAxis, CountsFromTheBeginWithoutADate) {
  EXPECT_EQ(labels(make_axis(std::nullopt, 2 * kHour, 5).marks),
            (std::vector<std::string>{"0:00 h", "0:30 h", "1:00 h", "1:30 h", "2:00 h"}));
  EXPECT_EQ(labels(make_axis(std::nullopt, 3 * kSecond, 5).marks).back(), "0:00:03");
  EXPECT_EQ(labels(make_axis(std::nullopt, 3 * kDay, 5).marks).front(), "day 1");
}

TEST(TimeAxis, NeverHasTooManyMarks) {
  for (const Ticks end : {Ticks{0}, Ticks{1}, kSecond, kHour, 10 * kDay, 365 * kDay, 40'000 * kDay,
                          schedule::kEndOfTime}) {
    for (const int most : {2, 5, 25}) {
      const CivilTime start{{2026, 3, 2}, 437};
      EXPECT_LE(make_axis(std::nullopt, end, most).marks.size(), static_cast<std::size_t>(most));
      EXPECT_LE(make_axis(start, end, most).marks.size(), static_cast<std::size_t>(most));
      EXPECT_LE(make_axis(start, end, most).heads.size(), 200U);
    }
  }
}

TEST(TimeAxis, SaysDaysWhereThereAreNoDates) {
  const auto marks = labels(make_axis(std::nullopt, 2 * kDay, 9).marks);
  EXPECT_EQ(marks[1], "6:00 h");
  EXPECT_EQ(marks[5], "1 d 06:00");
}

TEST(DurationLabel, SaysDaysAndHours) {
  EXPECT_EQ(duration_label(7256 * kHour), "302 d 08:00");
  EXPECT_EQ(duration_label(12 * kDay + 4 * kHour + 10 * kMinute + 7 * kSecond), "12 d 04:10");
  EXPECT_EQ(duration_label(kDay - kSecond), "23:59:59");
  EXPECT_EQ(duration_label(kDay - 1), "1 d 00:00");
  EXPECT_EQ(duration_label(2 * kDay - 20 * kSecond), "2 d 00:00");
}

}  // namespace
}  // namespace rubicon::gantt
