#include "src/results/gantt/chart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace rubicon::gantt {
namespace {

using schedule::kHour;
using schedule::kMinute;
using taskplan::Schedule;
using taskplan::TaskOutcome;
using taskplan::TaskResult;

TaskOutcome task(const std::string& name, Ticks start, Ticks duration) {
  TaskOutcome outcome;
  outcome.task = name;
  outcome.robot = "crane";
  outcome.crews = {"riggers"};
  outcome.start = start;
  outcome.duration = duration;
  return outcome;
}

/// A crane sets a panel from 11:30 to 13:30; riggers hook it from 11:40 over lunch to 12:50.
Schedule lifted() {
  Schedule schedule;
  schedule.start_at = {{2026, 3, 2}, 11 * 60 + 30};
  schedule.process_time = 2 * kHour;
  schedule.tasks.push_back(task("set", 0, 2 * kHour));
  schedule.tasks.push_back(task("bad", 0, 0));
  schedule.tasks.back().result = TaskResult::rejected;
  schedule.tasks.back().reason = "blocked";
  schedule.resources.resize(2);
  schedule.resources[0].name = "crane";
  schedule.resources[0].robot = true;
  schedule.resources[1].name = "riggers";
  schedule.critical.push_back({"set", true, ""});
  return schedule;
}

TraceTimes lifted_times() {
  TraceTimes times;
  times.plan = "yard";
  times.calendars.push_back({"site", {{0, 4, {{420, 720}, {750, 960}}}}, {}, false});
  times.calendar_of = {{"crane", "site"}, {"riggers", "site"}};
  times.runs[{"set", 0}] = {0,
                            2 * kHour,
                            true,
                            {{Stretch::Kind::work, 10 * kMinute, 80 * kMinute, "riggers", "hook"},
                             {Stretch::Kind::wait, 90 * kMinute, 100 * kMinute, "", "machine"}}};
  return times;
}

std::vector<Part::Kind> kinds(const Bar& bar) {
  std::vector<Part::Kind> result;
  for (const Part& part : bar.parts) result.push_back(part.kind);
  return result;
}

TEST(Chart, DividesATaskWithoutGaps) {
  const TraceTimes times = lifted_times();
  const Chart chart = make_chart(lifted(), &times, "folder");
  EXPECT_EQ(chart.title, "yard");
  ASSERT_EQ(chart.resources.size(), 2U);
  ASSERT_EQ(chart.resources[0].bars.size(), 1U);
  const Bar& bar = chart.resources[0].bars[0];
  using enum Part::Kind;
  EXPECT_EQ(kinds(bar), (std::vector{motion, work, off, work, motion, wait, motion}));
  Ticks now = 0;
  for (const Part& part : bar.parts) {
    EXPECT_EQ(part.span.from, now);
    now = part.span.to;
  }
  EXPECT_EQ(now, 2 * kHour);
  EXPECT_EQ(bar.parts[2].span.from, 30 * kMinute);
  EXPECT_EQ(bar.parts[2].span.to, 60 * kMinute);
  EXPECT_TRUE(bar.critical);
}

TEST(Chart, GivesCrewsOnlyTheirWork) {
  TraceTimes times = lifted_times();
  const Chart hooked = make_chart(lifted(), &times, "");
  ASSERT_EQ(hooked.resources[1].bars.size(), 1U);
  EXPECT_EQ(hooked.resources[1].bars[0].span.from, 10 * kMinute);
  EXPECT_EQ(hooked.resources[1].bars[0].span.to, 80 * kMinute);
  times.held["set"] = {"riggers"};  // of `by`: they are there all the time
  const Chart held = make_chart(lifted(), &times, "");
  EXPECT_EQ(held.resources[1].bars[0].span.to, 2 * kHour);
}

TEST(Chart, ListsWhatWasNotDone) {
  const Chart chart = make_chart(lifted(), nullptr, "folder");
  ASSERT_EQ(chart.not_done.size(), 1U);
  EXPECT_EQ(chart.not_done[0].task, "bad");
  EXPECT_EQ(chart.not_done[0].why, "rejected: blocked");
  EXPECT_EQ(chart.title, "folder");
  EXPECT_EQ(chart.rows.size(), 1U);
}

TEST(Chart, GroupsManyTasksByPlace) {
  Schedule schedule = lifted();
  schedule.tasks.clear();
  for (int i = 0; i < 100; ++i) {
    const std::string place = i < 99 ? "unit_" + std::to_string(i / 33) + "." : "";
    schedule.tasks.push_back(task(place + "set_" + std::to_string(i), i * kMinute, kMinute));
  }
  const Chart chart = make_chart(schedule, nullptr, "");
  EXPECT_EQ(chart.rows_title, "Places");
  ASSERT_EQ(chart.rows.size(), 3U);
  EXPECT_EQ(chart.rows[1].name, "unit_1");
  EXPECT_EQ(chart.rows[1].bars.size(), 33U);
  schedule.tasks.resize(80);
  EXPECT_EQ(make_chart(schedule, nullptr, "").rows.size(), 80U);
}

TEST(Chart, NobodyWorksWhereAllAreOff) {
  TraceTimes times = lifted_times();
  EXPECT_EQ(make_chart(lifted(), &times, "").nobody.size(), 1U);
  times.calendar_of.erase("riggers");
  EXPECT_TRUE(make_chart(lifted(), &times, "").nobody.empty());
}

TEST(Chart, ShadesNothingWhereThatWouldMakeALargeFile) {
  Schedule schedule = lifted();
  schedule.process_time = 900 * 24 * kHour;
  TraceTimes times = lifted_times();
  EXPECT_TRUE(make_chart(schedule, &times, "").has_shifts);
  for (int i = 0; i < 100; ++i) times.calendar_of["crew_" + std::to_string(i)] = "site";
  const Chart chart = make_chart(schedule, &times, "");
  EXPECT_FALSE(chart.has_shifts);
  EXPECT_TRUE(chart.resources.front().off.empty());
}

TEST(Chart, RefusesACalendarThatIsNotThere) {
  TraceTimes times = lifted_times();
  times.calendars.clear();
  EXPECT_THROW(make_chart(lifted(), &times, ""), std::invalid_argument);
}

}  // namespace
}  // namespace rubicon::gantt
