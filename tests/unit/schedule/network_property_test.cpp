// Random networks against the rules themselves: each is checked task by task, not by calculating it
// again.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "src/simulation/schedule/critical_chain.hpp"
#include "src/simulation/schedule/index.hpp"
#include "tests/unit/schedule/calendar_cases.hpp"
#include "tests/unit/schedule/network_cases.hpp"
#include "tests/unit/schedule/random_network.hpp"

namespace rubicon::schedule {
namespace {

constexpr int kNetworks = 400;

using test::calculated;
using test::Dice;
using Wanted = test::RandomNetworkWanted;

WorkCalendar calendar_of(const Network& network, const NetworkTask& task) {
  WorkCalendar common;
  for (const int resource : task.resources) {
    const int calendar = network.resources[at(resource)].calendar;
    if (calendar < 0) continue;
    common = std::get<WorkCalendar>(intersection(common, network.calendars[at(calendar)]));
  }
  return common;
}

Ticks event(const TaskTimes& times, TaskEnd end) {
  return end == TaskEnd::start ? times.start : times.finish;
}

TEST(NetworkProperty, KeepsLinksShiftsAndWork) {
  Dice dice(1);
  for (int i = 0; i < 2 * kNetworks; ++i) {
    const Network network = dice.network({.shares = i >= kNetworks});
    const NetworkTimes times = calculated(network);
    Ticks last = 0;
    for (std::size_t t = 0; t < network.tasks.size(); ++t) {
      const NetworkTask& task = network.tasks[t];
      const TaskTimes& own = times.tasks[t];
      const WorkCalendar calendar = calendar_of(network, task);
      last = std::max(last, own.finish);
      ASSERT_GE(own.start, 0);
      ASSERT_LE(own.ready, own.wanted);
      ASSERT_LE(own.wanted, own.start);
      ASSERT_LE(own.start, own.finish);
      if (task.work > 0) {
        ASSERT_TRUE(calendar.works_at(own.start));
        ASSERT_EQ(calendar.work_between(own.start, own.finish), task.work);
        ASSERT_EQ(calendar.work_between(own.wanted, own.start), 0);
      }
      for (const Link& link : task.after) {
        const Ticks before = event(times.tasks[at(link.task)], end_before(link.type));
        ASSERT_GE(event(own, end_after(link.type)), bound_of(link, before, calendar));
      }
    }
    ASSERT_EQ(times.finish, last);
  }
}

TEST(NetworkProperty, NeverGivesAResourceTwice) {
  Dice dice(2);
  for (int i = 0; i < kNetworks; ++i) {
    const Network network = dice.network({});
    const NetworkTimes times = calculated(network);
    for (int resource = 0; resource < 5; ++resource) {
      std::vector<std::pair<Ticks, Ticks>> uses;
      for (std::size_t t = 0; t < network.tasks.size(); ++t) {
        const std::vector<int>& needed = network.tasks[t].resources;
        if (network.tasks[t].work == 0) continue;
        if (std::find(needed.begin(), needed.end(), resource) == needed.end()) continue;
        uses.emplace_back(times.tasks[t].start, times.tasks[t].finish);
      }
      std::sort(uses.begin(), uses.end());
      for (std::size_t use = 1; use < uses.size(); ++use) {
        ASSERT_GE(uses[use].first, uses[use - 1].second);
      }
    }
  }
}

TEST(NetworkProperty, NeverGivesMoreOfAResourceThanThereIs) {
  Dice dice(12);
  int shared = 0;
  for (int i = 0; i < kNetworks; ++i) {
    const Network network = dice.network({.shares = true});
    const NetworkTimes times = calculated(network);
    const auto used_at = [&](int resource, Ticks moment) {
      int units = 0;
      for (std::size_t t = 0; t < network.tasks.size(); ++t) {
        const NetworkTask& task = network.tasks[t];
        const TaskTimes& own = times.tasks[t];
        if (task.work == 0 || moment < own.start || moment >= own.finish) continue;
        for (std::size_t k = 0; k < task.resources.size(); ++k) {
          if (task.resources[k] == resource) units += task.units[k];
        }
      }
      return units;
    };
    for (const TaskTimes& own : times.tasks) {
      for (int resource = 0; resource < 5; ++resource) {
        const int used = used_at(resource, own.start);
        ASSERT_LE(used, network.resources[at(resource)].size);
        shared += used > 1;
      }
    }
  }
  EXPECT_GT(shared, 1000);
}

// What is said to have held a task did: sooner by a tick it could not start.
TEST(NetworkProperty, TellsWhatHeldEachTask) {
  Dice dice(3);
  for (int i = 0; i < kNetworks; ++i) {
    const Network network = dice.network({});
    const NetworkTimes times = calculated(network);
    for (std::size_t t = 0; t < network.tasks.size(); ++t) {
      const NetworkTask& task = network.tasks[t];
      const TaskTimes& own = times.tasks[t];
      const WorkCalendar calendar = calendar_of(network, task);
      if (own.held == Held::plan_start) {
        ASSERT_EQ(own.wanted, 0);
      } else if (own.held == Held::resource) {
        ASSERT_EQ(own.wanted, times.tasks[at(own.task_before)].finish);
        const std::vector<int>& had = network.tasks[at(own.task_before)].resources;
        ASSERT_NE(std::find(had.begin(), had.end(), own.resource), had.end());
      } else {
        const Link& link = task.after[at(own.link)];
        const Ticks before = event(times.tasks[at(link.task)], end_before(link.type));
        const Ticks bound = bound_of(link, before, calendar);
        if (end_after(link.type) == TaskEnd::start) {
          ASSERT_EQ(own.wanted, bound);
        } else {
          ASSERT_EQ(own.wanted, calendar.latest_start(bound, task.work));
          ASSERT_EQ(own.finish, bound);
        }
      }
      if (own.finish_link >= 0) {
        const Link& link = task.after[at(own.finish_link)];
        const Ticks before = event(times.tasks[at(link.task)], end_before(link.type));
        ASSERT_EQ(own.finish, bound_of(link, before, calendar));
      } else {
        ASSERT_EQ(own.finish, calendar.finish(own.start, task.work));
      }
      if (task.work > 0) {
        const Ticks sooner = own.wanted - own.first_gain;
        ASSERT_EQ(calendar.next_working(sooner), own.start);
        ASSERT_LT(calendar.next_working(sooner - 1), own.start);
      }
    }
  }
}

// Whenever a task waits though its links let it start, something it needs is in use, or was given
// at this very moment to a task of higher priority.
TEST(NetworkProperty, LetsNobodyWaitForNothing) {
  Dice dice(8);
  int waits = 0;
  for (int i = 0; i < kNetworks; ++i) {
    const Network network = dice.network({.forward = true});
    const NetworkTimes times = calculated(network);
    for (std::size_t t = 0; t < network.tasks.size(); ++t) {
      const NetworkTask& task = network.tasks[t];
      const TaskTimes& own = times.tasks[t];
      if (task.work == 0) continue;
      const WorkCalendar calendar = calendar_of(network, task);
      const Ticks could = calendar.next_working(own.ready);
      // Something changes only when a task ends or a shift begins: look at these moments.
      std::vector<Ticks> moments{could};
      for (const TaskTimes& other : times.tasks) {
        moments.push_back(calendar.next_working(other.finish));
      }
      for (const Ticks moment : moments) {
        if (moment < could || moment >= own.start) continue;
        bool excused = false;
        for (std::size_t v = 0; v < network.tasks.size(); ++v) {
          const TaskTimes& other = times.tasks[v];
          const bool uses = other.start <= moment && moment < other.finish;
          if (v == t || !uses || network.tasks[v].work == 0) continue;
          for (const int resource : network.tasks[v].resources) {
            const auto& needed = task.resources;
            if (std::find(needed.begin(), needed.end(), resource) == needed.end()) continue;
            // One that starts at the moment at which this becomes ready may be what made it so.
            excused = excused || other.start < moment || own.ready == moment ||
                      network.tasks[v].priority > task.priority;
          }
        }
        ASSERT_TRUE(excused) << i << " " << task.name;
        ++waits;
      }
    }
  }
  EXPECT_GT(waits, 1000);
}

TEST(NetworkProperty, DoesNotDependOnFileOrderWherePrioritiesDiffer) {
  Dice dice(4);
  for (int i = 0; i < kNetworks; ++i) {
    const Network network = dice.network({});
    const NetworkTimes times = calculated(network);
    const int count = static_cast<int>(network.tasks.size());
    Network reversed = network;
    std::reverse(reversed.tasks.begin(), reversed.tasks.end());
    for (NetworkTask& task : reversed.tasks) {
      for (Link& link : task.after) link.task = count - 1 - link.task;
    }
    const NetworkTimes other = calculated(reversed);
    for (int t = 0; t < count; ++t) {
      ASSERT_EQ(times.tasks[at(t)].start, other.tasks[at(count - 1 - t)].start);
      ASSERT_EQ(times.tasks[at(t)].finish, other.tasks[at(count - 1 - t)].finish);
    }
  }
}

TEST(NetworkProperty, TheChainIsUnbroken) {
  Dice dice(5);
  for (int i = 0; i < kNetworks; ++i) {
    const Network network = dice.network({});
    const NetworkTimes times = calculated(network);
    const std::vector<ChainStep> chain = critical_chain(network, times);
    ASSERT_FALSE(chain.empty());
    ASSERT_EQ(chain.front().held, Held::plan_start);
    ASSERT_EQ(chain.front().task_before, -1);
    ASSERT_EQ(times.tasks[at(chain.back().task)].finish, times.finish);
    for (std::size_t step = 1; step < chain.size(); ++step) {
      ASSERT_EQ(chain[step].task_before, chain[step - 1].task);
    }
    // A step is the start or the finish of a task, and no event comes twice.
    std::vector<std::pair<int, bool>> events;
    for (const ChainStep& step : chain) events.emplace_back(step.task, step.at_finish);
    std::sort(events.begin(), events.end());
    ASSERT_EQ(std::adjacent_find(events.begin(), events.end()), events.end());
  }
}

// Without shifts and shared crews the chain is exactly what counts: an hour more in a task whose
// work counts is an hour more in all, and an hour less anywhere else shortens nothing.
TEST(NetworkProperty, TheChainIsWhatMakesTheWholeLong) {
  Dice dice(6);
  int on_chain = 0, off_chain = 0;
  for (int i = 0; i < kNetworks; ++i) {
    const Network network = dice.network({false, false, true});
    const NetworkTimes times = calculated(network);
    std::vector<bool> counts(network.tasks.size(), false), named(network.tasks.size(), false);
    for (const ChainStep& step : critical_chain(network, times)) {
      named[at(step.task)] = true;
      if (step.work_counts) counts[at(step.task)] = true;
    }
    for (std::size_t t = 0; t < network.tasks.size(); ++t) {
      Network changed = network;
      if (counts[t]) {
        changed.tasks[t].work += kHour;
        ASSERT_GE(calculated(changed).finish, times.finish + kHour);
        ++on_chain;
      } else if (!named[t] && network.tasks[t].work > kHour) {
        changed.tasks[t].work -= kHour;
        ASSERT_GE(calculated(changed).finish, times.finish);
        ++off_chain;
      }
    }
  }
  EXPECT_GT(on_chain, 300);
  EXPECT_GT(off_chain, 300);
}

// The longest path, calculated by repeating all links until nothing moves.
TEST(NetworkProperty, IsTheEarliestWithoutSharedCrews) {
  Dice dice(7);
  for (int i = 0; i < kNetworks; ++i) {
    const Network network = dice.network({false, false, true});
    const NetworkTimes times = calculated(network);
    std::vector<Ticks> start(network.tasks.size(), 0);
    for (bool moved = true; moved;) {
      moved = false;
      for (std::size_t t = 0; t < network.tasks.size(); ++t) {
        for (const Link& link : network.tasks[t].after) {
          const std::size_t p = at(link.task);
          const Ticks from =
              start[p] + (end_before(link.type) == TaskEnd::finish ? network.tasks[p].work : 0);
          const Ticks to = end_after(link.type) == TaskEnd::finish ? network.tasks[t].work : 0;
          if (from + link.lag - to <= start[t]) continue;
          start[t] = from + link.lag - to;
          moved = true;
        }
      }
    }
    for (std::size_t t = 0; t < network.tasks.size(); ++t) {
      ASSERT_EQ(times.tasks[t].start, start[t]);
      ASSERT_EQ(times.tasks[t].finish, start[t] + network.tasks[t].work);
    }
  }
}

TEST(NetworkProperty, GivesALongPlanItsTimes) {
  // As many tasks as a large plan has, in one chain and in one queue: must not run out of stack.
  Network network;
  network.calendars = {test::calendar(test::weekday_shift(), test::kRandomStart)};
  network.resources = {{"crew", 0}};
  constexpr int kTasks = 100000;
  network.tasks.resize(2 * kTasks);
  for (int i = 0; i < kTasks; ++i) {
    network.tasks[at(i)].work = kMinute;
    network.tasks[at(i)].resources = {0};
    network.tasks[at(kTasks + i)].work = kMinute;
    if (i > 0) network.tasks[at(kTasks + i)].after = {{kTasks + i - 1}};
  }
  const NetworkTimes times = calculated(network);
  EXPECT_EQ(times.finish, network.calendars[0].finish(0, kTasks * kMinute));
  EXPECT_EQ(times.tasks.back().finish, kTasks * kMinute);
  EXPECT_EQ(critical_chain(network, times).size(), at(kTasks));
}

}  // namespace
}  // namespace rubicon::schedule
