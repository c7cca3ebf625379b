#include <benchmark/benchmark.h>

#include <string>
#include <variant>

#include "src/simulation/schedule/calendar_rules.hpp"
#include "src/simulation/schedule/critical_chain.hpp"
#include "src/simulation/schedule/network.hpp"

namespace rubicon::bench {
namespace {

using namespace schedule;

constexpr CivilTime kStart{{2026, 3, 2}, 7 * 60};
constexpr int kCrews = 20;
constexpr int kFloorTasks = 40;

WorkCalendar site_calendar() {
  CalendarRules rules;
  rules.name = "site";
  rules.shifts = {{0, 4, {{7 * 60, 12 * 60}, {12 * 60 + 30, 16 * 60}}}};
  for (int year = 2026; year < 2046; ++year) {
    for (int day = 24; day <= 31; ++day) rules.off.push_back({year, 12, day});
  }
  return std::get<WorkCalendar>(calendar_of(rules, kStart));
}

/// Floor upon floor of tasks, each after its neighbour (with every type of link) and after the same
/// task of the floor below, by one or two of the crews.
Network building(int tasks) {
  Network network;
  network.calendars = {site_calendar()};
  for (int crew = 0; crew < kCrews; ++crew) {
    network.resources.push_back({"crew " + std::to_string(crew), crew % 4 == 0 ? -1 : 0});
  }
  for (int i = 0; i < tasks; ++i) {
    NetworkTask task;
    task.name = "task " + std::to_string(i);
    task.work = (5 + i * 7 % 23) * kMinute;
    task.priority = i % 5;
    task.resources = {i % kCrews};
    if (i % 3 == 0) task.resources.push_back((i + 1) % kCrews);
    if (i % kFloorTasks != 0) {
      task.after.push_back({i - 1, static_cast<LinkType>(i % 4), (i % 7 - 3) * kMinute});
    }
    if (i >= kFloorTasks) task.after.push_back({i - kFloorTasks, LinkType::FS, 2 * kHour});
    network.tasks.push_back(std::move(task));
  }
  return network;
}

void network_times(benchmark::State& state) {
  const Network network = building(static_cast<int>(state.range(0)));
  std::size_t steps = 0;
  for (auto _ : state) {
    const auto times = times_of(network);
    steps = critical_chain(network, std::get<NetworkTimes>(times)).size();
  }
  state.counters["chain"] = static_cast<double>(steps);
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(network_times)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

/// When work is done that takes so many working hours: a day, a year, twenty years.
void calendar_finish(benchmark::State& state) {
  const WorkCalendar calendar = site_calendar();
  Ticks from = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(calendar.finish(from, state.range(0) * kHour));
    from = (from + 37 * kMinute) % (52 * kWeek);
  }
}
BENCHMARK(calendar_finish)->Arg(8)->Arg(2000)->Arg(40000);

}  // namespace
}  // namespace rubicon::bench
