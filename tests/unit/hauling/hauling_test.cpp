#include "src/earth/hauling/hauling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "src/motion/math/random.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_cases.hpp"

namespace rubicon::hauling {
namespace {

using sampling::DurationLaw;
using sampling::Law;

constexpr double kMinute = 60;
/// Share by which an estimate of 4e5 loads may be off; fewer loads are less sure.
constexpr double kOff = test::kFewerCases == 1 ? 0.005 : 0.02;
constexpr Nanoseconds kMinuteTicks = 60'000'000'000;

StageTime minutes(double value) { return {value * kMinute, {}}; }

StageTime by_law(Law law, std::vector<double> in_minutes) {
  for (double& value : in_minutes) value *= kMinute;
  const DurationLaw made{law, std::move(in_minutes)};
  return {made.mean(), made};
}
StageTime exponential(double mean) { return by_law(Law::exponential, {mean}); }
StageTime listed(std::vector<double> values) { return by_law(Law::sequence, std::move(values)); }

CubicMillimetres cubic_metres(double value) {
  return static_cast<CubicMillimetres>(std::llround(value * kPerCubicMetre));
}

/// Loads of 1 m3, tipped at the end of the round.
Operation round_of(std::int64_t loads, int trucks, StageTime load, StageTime travel) {
  Operation result;
  result.volume = cubic_metres(static_cast<double>(loads));
  result.load = cubic_metres(1);
  result.loading = std::move(load);
  result.diggers = {{"shovel", 1}};
  result.trucks = trucks;
  result.stages = {{"travel", std::move(travel)}};
  return result;
}

/// Example 3.5 of Banks and others, Discrete-Event System Simulation: its ties go to the scale,
/// then the loader, then who arrives.
TEST(Hauling, DumpTrucksOfBanks) {
  Operation trucks =
      round_of(1000, 6, listed({10, 5, 5, 10, 15, 10, 10}), listed({60, 100, 40, 40, 80}));
  trucks.diggers = {{"loaders", 2}};
  trucks.stages.insert(trucks.stages.begin(),
                       {"weigh", listed({12, 12, 12, 16, 12, 16}), "scale", 1});
  trucks.tip = 1;
  trucks.loaded = 1;
  trucks.until = 76 * kMinuteTicks;
  const Result at_76 = simulate(trucks, std::nullopt);
  EXPECT_EQ(at_76.time, 76 * kMinuteTicks);
  ASSERT_EQ(at_76.queues.size(), 2u);
  EXPECT_EQ(at_76.queues[0].busy, 49 * kMinuteTicks);
  EXPECT_EQ(at_76.queues[1].busy, 76 * kMinuteTicks);
  EXPECT_NEAR(at_76.queues[0].utilisation(at_76.time), 0.32, 0.005);
  EXPECT_DOUBLE_EQ(at_76.queues[1].utilisation(at_76.time), 1);
  trucks.until = 12 * kMinuteTicks;
  const Result at_12 = simulate(trucks, std::nullopt);
  EXPECT_EQ(at_12.queues[0].busy, 24 * kMinuteTicks);
  EXPECT_EQ(at_12.queues[1].busy, 12 * kMinuteTicks);
}

/// The tutorial of SimPM. Its tip has room for 1,666 loads, and its trucks go on to be loaded until
/// each stands before the full tip: 1,676 loads.
TEST(Hauling, EarthmovingOfSimPM) {
  Operation trucks = round_of(0, 10, minutes(7), minutes(17));
  trucks.load = cubic_metres(60);
  trucks.stages.push_back({"dump", minutes(3)});
  trucks.stages.push_back({"return", minutes(13)});
  trucks.tip = 1;
  trucks.volume = cubic_metres(1676 * 60);
  std::map<std::int64_t, Nanoseconds> tipped;
  const Result result =
      simulate(trucks, std::nullopt, [&](const Load& load) { tipped[load.number] = load.tipped; });
  EXPECT_EQ(result.time, 11752 * kMinuteTicks);
  EXPECT_EQ(result.loads, 1676);
  EXPECT_EQ(tipped[1666], (11752 - 70) * kMinuteTicks);
  EXPECT_EQ(result.queues[0].served, 1676);
  EXPECT_NEAR(result.queues[0].mean_wait(), 30.01 * kMinute, 0.005 * kMinute);
  EXPECT_EQ(result.queues[0].longest, 63 * kMinuteTicks);
  EXPECT_NEAR(result.queues[0].utilisation(result.time), 1, 0.002);
  trucks.volume = cubic_metres(99960);
  EXPECT_EQ(simulate(trucks, std::nullopt).loads, 1666);
}

/// Loads an hour of N trucks, the rounds and the loading exponential: the machine repair queue.
double finite_source_rate(int trucks, double travels_per_hour, double loads_per_hour) {
  double sum = 0;
  double term = 1;  // N! / (N - n)! r^n
  for (int n = 0; n <= trucks; ++n) {
    sum += term;
    term *= (trucks - n) * travels_per_hour / loads_per_hour;
  }
  return loads_per_hour * (1 - 1 / sum);
}

/// Mean of the loads an hour of some runs, and half the width of its interval of 95 %.
struct Estimate {
  double mean = 0;
  double half = 0;
};
Estimate rate_of(const Operation& operation, int runs) {
  double sum = 0;
  double squares = 0;
  for (int run = 0; run < runs; ++run) {
    const double rate =
        simulate(operation, Draws{7, static_cast<std::uint64_t>(run), "pit"}).per_hour();
    sum += rate;
    squares += rate * rate;
  }
  const double mean = sum / runs;
  const double variance = (squares - runs * mean * mean) / (runs - 1);
  return {mean, 2.262 * std::sqrt(variance / runs)};  // Student, 9 degrees of freedom
}

TEST(Hauling, QueuesWithFiniteSource) {
  const std::map<int, double> printed = {
      {1, 2.500000}, {3, 7.055085}, {5, 10.726983}, {6, 12.122291}, {8, 13.949282}};
  for (const auto& [trucks, expected] : printed) {
    EXPECT_NEAR(finite_source_rate(trucks, 3, 15), expected, 1e-6);
    const Operation operation =
        round_of(test::cases(40'000), trucks, exponential(4), exponential(20));
    const Estimate found = rate_of(operation, 10);
    EXPECT_NEAR(found.mean, expected, kOff * expected) << trucks;
    EXPECT_NEAR(found.mean, expected, found.half) << trucks;
  }
}

TEST(Hauling, TwoQueues) {
  const std::vector<double> printed = {2.4,       4.672897,  6.785672,  8.700169,
                                       10.376463, 11.779540, 12.888759, 13.707006};
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const int trucks = static_cast<int>(i) + 1;
    Operation operation = round_of(test::cases(20'000), trucks, exponential(4), exponential(10));
    operation.stages.push_back({"dump", exponential(1), "dozer", 1});
    operation.stages.push_back({"return", exponential(10)});
    operation.tip = 1;
    const Estimate found = rate_of(operation, 10);
    EXPECT_NEAR(found.mean, printed[i], kOff * printed[i]) << trucks;
  }
}

TEST(Hauling, MatchFactors) {
  Operation trucks = round_of(10, 4, minutes(12), minutes(38));
  EXPECT_DOUBLE_EQ(trucks.match_factor(), 0.96);
  trucks.trucks = 5;
  EXPECT_DOUBLE_EQ(trucks.match_factor(), 1.2);
  trucks.diggers = {{"a", 1}, {"b", 1}};
  EXPECT_DOUBLE_EQ(trucks.match_factor(), 0.6);
}

/// Shovel of 300 yd3 an hour, trucks of 12 yd3, 10 minutes under way, efficiency 0.80.
TEST(Hauling, ShovelAndTrucksByTheHandbook) {
  const auto cost_per_yard = [](int trucks, double rate) { return (40 + 20.0 * trucks) / rate; };
  const auto operation = [](int trucks, bool is_queue) {
    Operation result =
        round_of(test::cases(20'000), trucks, is_queue ? exponential(2.4) : minutes(2.4),
                 is_queue ? exponential(10) : minutes(10));
    result.efficiency = 0.80;
    return result;
  };
  std::map<int, double> costs;
  std::map<int, double> costs_as_queue;
  for (int trucks = 1; trucks <= 8; ++trucks) {
    costs[trucks] =
        cost_per_yard(trucks, 12 * simulate(operation(trucks, false), std::nullopt).per_hour());
    costs_as_queue[trucks] = cost_per_yard(trucks, 12 * rate_of(operation(trucks, true), 10).mean);
  }
  EXPECT_NEAR(costs[5], 0.6028, 0.6028 * 0.0015 * test::kFewerCases);
  EXPECT_NEAR(costs_as_queue[5], 0.7421, 0.7421 * kOff);
  EXPECT_NEAR(costs_as_queue[4], 0.7424, 0.7424 * kOff);
  const auto cheaper = [](const auto& a, const auto& b) { return a.second < b.second; };
  EXPECT_EQ(std::min_element(costs.begin(), costs.end(), cheaper)->first, 5);
}

/// The table of ../shared/data/productivity: case, N, load, travel, match factor, then what is
/// certain (loads an hour, wait, use of the loader) and the exponential queue.
TEST(Hauling, TableOfFiniteSources) {
  std::ifstream file(test::source_dir() + "/../shared/data/productivity/finite_source.csv");
  if (!file) GTEST_SKIP() << "../shared/data/productivity/finite_source.csv is not there";
  std::string line;
  std::getline(file, line);
  int rows = 0;
  while (std::getline(file, line)) {
    std::vector<double> values;
    std::stringstream fields(line);
    std::string field;
    std::getline(fields, field, ',');
    while (std::getline(fields, field, ',')) values.push_back(std::stod(field));
    ASSERT_GE(values.size(), 10u) << line;
    const int trucks = static_cast<int>(values[0]);
    Operation operation = round_of(20'000, trucks, minutes(values[1]), minutes(values[2]));
    EXPECT_NEAR(operation.match_factor(), values[3], 1e-9) << line;
    const Result certain = simulate(operation, std::nullopt);
    EXPECT_NEAR(certain.per_hour(), values[4], 0.002 * values[4]) << line;
    EXPECT_NEAR(certain.queues[0].mean_wait() / kMinute, values[5], 0.02) << line;
    EXPECT_NEAR(certain.queues[0].utilisation(certain.time), values[6], 0.002) << line;
    operation.loading = exponential(values[1]);
    operation.stages[0].time = exponential(values[2]);
    EXPECT_NEAR(finite_source_rate(trucks, 60 / values[2], 60 / values[1]), values[8],
                1e-3 * values[8]);
    const Result drawn = simulate(operation, Draws{1, 0, "pit"});
    EXPECT_NEAR(drawn.per_hour(), values[8], 0.02 * values[8]) << line;
    EXPECT_NEAR(drawn.queues[0].mean_length(drawn.time), values[9], 0.05 * values[9] + 0.01)
        << line;
    ++rows;
  }
  EXPECT_EQ(rows, 20);
}

TEST(Hauling, PassesFillATruckAndTheLastLoadIsWhatIsLeft) {
  Operation trucks = round_of(0, 1, {20, {}}, minutes(5));
  trucks.volume = cubic_metres(25);
  trucks.load = cubic_metres(10);
  trucks.bucket = cubic_metres(3);
  std::vector<Load> loads;
  const Result result =
      simulate(trucks, std::nullopt, [&](const Load& load) { loads.push_back(load); });
  ASSERT_EQ(loads.size(), 3u);
  EXPECT_EQ(loads[0].loaded - loads[0].began, 80'000'000'000);  // 4 passes
  EXPECT_EQ(loads[2].volume, cubic_metres(5));
  EXPECT_EQ(loads[2].loaded - loads[2].began, 40'000'000'000);
  EXPECT_EQ(result.passes, 10);
  EXPECT_TRUE(result.is_complete);
  EXPECT_DOUBLE_EQ(trucks.mean_loading(), 80);
  EXPECT_DOUBLE_EQ(trucks.mean_round(), 380);
}

TEST(Hauling, TrucksGoToTheShortestQueue) {
  Operation trucks = round_of(12, 6, minutes(4), minutes(3));
  trucks.diggers = {{"near", 1}, {"far", 1}};
  std::map<int, int> by;
  simulate(trucks, std::nullopt, [&](const Load& load) { ++by[load.diggers]; });
  EXPECT_EQ(by[0], 6);
  EXPECT_EQ(by[1], 6);
}

/// Random fleets against a second account: each load by the times of those before it.
TEST(Hauling, RandomFleetsKeepTheirOrderAndTheirSoil) {
  math::Random random(5);
  for (int round = 0; round < test::cases(2000); ++round) {
    const auto some = [&](int least, int most) {
      return least + static_cast<int>(random.index(static_cast<std::size_t>(most - least + 1)));
    };
    Operation operation =
        round_of(0, some(1, 9), exponential(random.between(0.5, 5)),
                 by_law(Law::gamma, {random.between(1, 20), random.between(0.5, 4)}));
    operation.volume = static_cast<CubicMillimetres>(random.between(1, 60) * kPerCubicMetre);
    operation.load = static_cast<CubicMillimetres>(random.between(0.7, 5) * kPerCubicMetre);
    if (some(0, 1)) operation.bucket = operation.load / some(1, 5) + some(0, 1000);
    operation.diggers = {{"a", some(1, 3)}};
    if (some(0, 1)) operation.diggers.push_back({"b", some(1, 2)});
    operation.stages.push_back({"tip", exponential(1), "dozer", some(0, 2)});
    operation.stages.push_back({"return", minutes(some(0, 8))});
    operation.tip = 1;
    operation.loaded = some(0, operation.trucks);
    operation.efficiency = random.between(0.4, 1);
    if (some(0, 3) == 0) operation.until = some(1, 200) * kMinuteTicks;
    std::vector<Load> loads;
    const Draws draws{3, static_cast<std::uint64_t>(round), "pit"};
    const Result result =
        simulate(operation, draws, [&](const Load& load) { loads.push_back(load); });
    // Soil and loads.
    CubicMillimetres sum = 0;
    for (const Load& load : loads) sum += load.volume;
    EXPECT_EQ(sum, result.tipped);
    EXPECT_EQ(result.loads, static_cast<std::int64_t>(loads.size()));
    EXPECT_EQ(result.is_complete, result.tipped == operation.volume);
    if (!operation.until) {
      EXPECT_TRUE(result.is_complete);
      EXPECT_EQ(result.loads, operation.loads());
    }
    // Each digger fills one truck at a time, in the order of arrival.
    std::sort(loads.begin(), loads.end(),
              [](const Load& a, const Load& b) { return a.number < b.number; });
    std::vector<Nanoseconds> arrived(operation.diggers.size(), 0);
    for (const Load& load : loads) {
      if (load.diggers < 0) continue;
      const auto k = static_cast<std::size_t>(load.diggers);
      EXPECT_GE(load.began, load.arrived);
      EXPECT_GE(load.loaded, load.began);
      EXPECT_GE(load.tipped, load.loaded);
      EXPECT_LE(load.tipped, result.time);
      EXPECT_GE(load.arrived, arrived[k]);
      arrived[k] = load.arrived;
      const auto at_once = std::count_if(loads.begin(), loads.end(), [&](const Load& other) {
        return other.diggers == load.diggers && other.began <= load.began &&
               other.loaded > load.began;
      });
      EXPECT_LE(at_once, operation.diggers[k].count);
    }
    for (const Queue& queue : result.queues) {
      EXPECT_GE(queue.busy, 0);
      EXPECT_LE(queue.utilisation(result.time), 1 + 1e-12);
      EXPECT_LE(queue.longest, result.time);
    }
  }
}

/// A draw is of its place and use: one more truck does not shift what a load takes.
TEST(Hauling, DrawsDoNotShift) {
  Operation few = round_of(50, 2, exponential(3), minutes(5));
  Operation more = few;
  more.trucks = 4;
  std::vector<Nanoseconds> of_few, of_more;
  simulate(few, Draws{1, 2, "pit"},
           [&](const Load& load) { of_few.push_back(load.loaded - load.began); });
  simulate(more, Draws{1, 2, "pit"},
           [&](const Load& load) { of_more.push_back(load.loaded - load.began); });
  EXPECT_EQ(of_few, of_more);
  EXPECT_NE(simulate(few, Draws{1, 3, "pit"}).time, simulate(few, Draws{1, 2, "pit"}).time);
  EXPECT_EQ(simulate(few, Draws{1, 3, "pit"}).time, simulate(few, Draws{1, 3, "pit"}).time);
}

}  // namespace
}  // namespace rubicon::hauling
