// Floats: by hand, and on random networks by trying it: a task that begins as late as its float
// allows moves nothing, one that begins later does.

#include "src/simulation/schedule/task_float.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <variant>
#include <vector>

#include "src/simulation/schedule/index.hpp"
#include "src/simulation/schedule/network.hpp"
#include "tests/unit/schedule/calendar_cases.hpp"
#include "tests/unit/schedule/network_cases.hpp"
#include "tests/unit/schedule/random_network.hpp"

namespace rubicon::schedule {
namespace {

using test::calculated;

const WorkCalendar kAlways;

TimedTask task(Ticks start, Ticks finish, const WorkCalendar& calendar = kAlways) {
  return {start, finish, &calendar};
}

Precedence finish_to_start(int before, int after, Ticks gap = 0) {
  return {before, TaskEnd::finish, after, TaskEnd::start, gap};
}

TEST(TaskFloat, OfAShortBranch) {
  // 0 takes 4 h, 1 takes 1 h, then 2; 3 stands alone.
  const auto floats =
      floats_of({task(0, 4 * kHour), task(0, kHour), task(4 * kHour, 6 * kHour), task(0, kHour)},
                {finish_to_start(0, 2), finish_to_start(1, 2)}, 6 * kHour);
  EXPECT_EQ(floats[0].total, 0);
  EXPECT_EQ(floats[1].total, 3 * kHour);
  EXPECT_EQ(floats[1].free, 3 * kHour);
  EXPECT_EQ(floats[1].latest_start, 3 * kHour);
  EXPECT_EQ(floats[2].total, 0);
  EXPECT_EQ(floats[3].total, 5 * kHour);
}

TEST(TaskFloat, IsSharedAlongAChain) {
  // 0 and 1 in a row may use 2 h together: the first has them, but not free.
  const auto floats = floats_of({task(0, kHour), task(kHour, 2 * kHour), task(0, 4 * kHour)},
                                {finish_to_start(0, 1)}, 4 * kHour);
  EXPECT_EQ(floats[0].total, 2 * kHour);
  EXPECT_EQ(floats[0].free, 0);
  EXPECT_EQ(floats[1].total, 2 * kHour);
  EXPECT_EQ(floats[1].free, 2 * kHour);
}

TEST(TaskFloat, CountsWorkingTime) {
  // Thursday 07:00; the second begins on Friday, and may not come later.
  const WorkCalendar day = test::calendar(test::weekday_shift(), "2026-03-05 07:00");
  const Ticks finish = day.finish(0, kHour);
  const Ticks friday = day.next_working(kDay - kHour);
  const auto floats = floats_of({task(0, finish, day), task(friday, friday + kHour, day)},
                                {finish_to_start(0, 1)}, friday + kHour);
  EXPECT_EQ(floats[0].total, day.work_between(finish, friday));
  EXPECT_EQ(floats[0].latest_finish, day.last_working(friday));
  EXPECT_GT(friday - finish, floats[0].total);  // nights are no float
}

TEST(TaskFloat, ALiftStaysInItsShift) {
  const WorkCalendar day = test::calendar(test::weekday_shift(), "2026-03-05 07:00");
  const Ticks shift_end = day.shift_end(0);
  TimedTask lift = task(0, 2 * kHour, day);
  const Ticks next = day.next_working(shift_end + kMinute);
  // An hour into the next shift it would hang over the break.
  const auto free_to_stop = floats_of({lift}, {}, next + kHour);
  EXPECT_EQ(free_to_stop[0].latest_finish, next + kHour);
  lift.parts = {{2 * kHour, &day, true}};
  const auto whole = floats_of({lift}, {}, next + kHour);
  EXPECT_EQ(whole[0].latest_finish, shift_end);
  EXPECT_EQ(whole[0].latest_start, shift_end - 2 * kHour);
}

TEST(TaskFloat, PartsKeepTheirOwnHours) {
  // Monday 07:00: a machine that works day and night for 2 h, then people by day for 1 h, then the
  // machine for 1 h.
  const WorkCalendar day = test::calendar(test::weekday_shift(), "2026-03-02 07:00");
  const Ticks evening = day.last_working(kDay - kMinute);
  const Ticks morning = day.next_working(evening);
  TimedTask each = task(0, 4 * kHour);
  each.parts = {{2 * kHour, &kAlways, false}, {kHour, &day, true}, {kHour, &kAlways, false}};
  // In the night nobody could follow.
  const auto night = floats_of({each}, {}, evening + 3 * kHour);
  EXPECT_EQ(night[0].latest_finish, evening + 3 * kHour);
  EXPECT_EQ(night[0].latest_start, evening - 3 * kHour);
  const auto next = floats_of({each}, {}, morning + 2 * kHour);
  EXPECT_EQ(next[0].latest_start, morning - 2 * kHour);
  // Held by its start, it does not wait on its way.
  const auto held = floats_of({each, task(6 * kHour, 40 * kHour)},
                              {{0, TaskEnd::start, 1, TaskEnd::start, 0}}, 40 * kHour);
  EXPECT_EQ(held[0].latest_start, 6 * kHour);
  EXPECT_EQ(held[0].latest_finish, 10 * kHour);
}

TEST(TaskFloat, OfARingEnds) {
  // SS one way, FF the other: tied at both ends.
  const auto floats = floats_of(
      {task(0, 3 * kHour), task(0, 3 * kHour), task(0, 5 * kHour)},
      {{0, TaskEnd::start, 1, TaskEnd::start, 0}, {1, TaskEnd::finish, 0, TaskEnd::finish, 0}},
      5 * kHour);
  EXPECT_EQ(floats[0].total, 2 * kHour);
  EXPECT_EQ(floats[1].total, 2 * kHour);
}

/// Links of all types, or of FS and SS only; no lag below zero and none of working time, and a
/// calendar for each task.
Network random_network(test::Dice& dice, bool with_finishes) {
  Network network =
      dice.network({.calendars = false, .resources = false, .forward = !with_finishes});
  network.resources.clear();
  for (std::size_t i = 0; i < network.tasks.size(); ++i) {
    NetworkTask& each = network.tasks[i];
    network.resources.push_back({each.name, dice.below(3) - 1});
    if (each.work > 0) each.resources = {static_cast<int>(i)};
    for (Link& link : each.after) {
      link.lag = std::llabs(link.lag);
      link.clock = LagClock::elapsed;
    }
  }
  return network;
}

TEST(TaskFloat, IsHowMuchLaterATaskCanBegin) {
  test::Dice dice(7);
  int with_float = 0;
  for (int i = 0; i < 150; ++i) {
    const bool with_finishes = i % 2 == 1;
    Network network = random_network(dice, with_finishes);
    const NetworkTimes times = calculated(network);
    std::vector<TimedTask> tasks;
    std::vector<Precedence> precedences;
    for (std::size_t t = 0; t < network.tasks.size(); ++t) {
      const int calendar = network.resources[t].calendar;
      const bool always = calendar < 0 || network.tasks[t].work == 0;
      tasks.push_back({times.tasks[t].start, times.tasks[t].finish,
                       always ? &kAlways : &network.calendars[at(calendar)],
                       network.tasks[t].work == 0});
      for (const Link& link : network.tasks[t].after) {
        precedences.push_back({link.task, end_before(link.type), static_cast<int>(t),
                               end_after(link.type), link.lag});
      }
    }
    const auto floats = floats_of(tasks, precedences, times.finish);
    for (std::size_t t = 0; t < tasks.size(); ++t) {
      const auto finish_if_not_before = [&](Ticks moment) {
        network.tasks[t].not_before = moment;
        const NetworkTimes later = calculated(network);
        network.tasks[t].not_before = 0;
        return later;
      };
      ASSERT_GE(floats[t].free, 0);
      ASSERT_LE(floats[t].free, floats[t].total);
      ASSERT_EQ(finish_if_not_before(floats[t].latest_start).finish, times.finish)
          << "network " << i << " " << network.tasks[t].name;
      const Ticks too_late = tasks[t].calendar->next_working(floats[t].latest_start + kMinute);
      // Finishes that are held, also out of shift, may leave more room than is said.
      if (!with_finishes) {
        ASSERT_GT(finish_if_not_before(too_late).finish, times.finish)
            << "network " << i << " " << network.tasks[t].name;
      }
      if (floats[t].total > 0) ++with_float;
      if (floats[t].free == 0 || network.tasks[t].work == 0) continue;
      const WorkCalendar& calendar = *tasks[t].calendar;
      const Ticks free_finish = calendar.finish(tasks[t].finish, floats[t].free);
      const NetworkTimes moved =
          finish_if_not_before(calendar.latest_start(free_finish, network.tasks[t].work));
      for (std::size_t other = 0; other < tasks.size(); ++other) {
        if (other == t) continue;
        ASSERT_EQ(moved.tasks[other].start, times.tasks[other].start) << "network " << i;
        ASSERT_EQ(moved.tasks[other].finish, times.tasks[other].finish) << "network " << i;
      }
    }
  }
  EXPECT_GT(with_float, 500);
}

}  // namespace
}  // namespace rubicon::schedule
