#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/random.hpp"
#include "src/motion/coverage/coverage.hpp"
#include "src/motion/math/angles.hpp"
#include "tests/unit/coverage/random_floors.hpp"

namespace rubicon::bench {
namespace {

using namespace coverage;

std::vector<Place> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

CoverageOptions tool() {
  CoverageOptions options;
  options.width = 1;
  options.clearance = 0.25;
  return options;
}

void plan(benchmark::State& state, const FloorDescription& floor, bool measured) {
  CoverageWay way;
  for (auto _ : state) way = plan_coverage(floor, tool());
  state.counters["lines"] = static_cast<double>(way.lines.size());
  if (!measured) return;
  const Measures measures = measure(floor, tool(), way.points);
  state.counters["coverage"] = measures.coverage;
  state.counters["length"] = measures.length;
  state.counters["bound"] = measures.lower_bound;
}

/// The slab of 40 x 20 m with six columns and two shafts.
void BM_CoverageOfTheAnchorSlab(benchmark::State& state) {
  FloorDescription floor;
  floor.outline = rectangle(0, 0, 40, 20);
  floor.shafts = {{"", rectangle(10, 5, 13, 8)}, {"", rectangle(25, 10, 27.5, 15)}};
  for (const double x : {5.0, 20.0, 35.0}) {
    for (const double y : {5.0, 15.0}) floor.columns.push_back({"", {x, y}, 0.5, false});
  }
  plan(state, floor, true);
}
BENCHMARK(BM_CoverageOfTheAnchorSlab)->Unit(benchmark::kMillisecond);

/// The ten floors of the tests, each with its bound.
void BM_CoverageOfTenFloors(benchmark::State& state) {
  const FloorCase each = ten_floors()[static_cast<std::size_t>(state.range(0))];
  state.SetLabel(each.name);
  plan(state, each.floor, true);
}
BENCHMARK(BM_CoverageOfTenFloors)->DenseRange(0, 9)->Unit(benchmark::kMillisecond);

/// Columns anywhere on 12 square metres each, a tenth as many shafts.
void BM_CoverageAmongColumns(benchmark::State& state) {
  const std::int64_t columns = state.range(0);
  const double scale = std::sqrt(static_cast<double>(columns) / 200);
  Random random(9);
  FloorDescription floor;
  floor.outline = rectangle(0, 0, 60 * scale, 40 * scale);
  const auto keep = [&](auto& things) {
    if (!faults_of(floor, tool()).empty()) things.pop_back();
  };
  while (static_cast<std::int64_t>(floor.shafts.size()) < columns / 10) {
    const double x = random.between(1, 60 * scale - 5);
    const double y = random.between(1, 40 * scale - 5);
    floor.shafts.push_back(
        {"", rectangle(x, y, x + random.between(1, 3), y + random.between(1, 3))});
    keep(floor.shafts);
  }
  while (static_cast<std::int64_t>(floor.columns.size()) < columns) {
    floor.columns.push_back(
        {"", {random.between(1, 60 * scale - 1), random.between(1, 40 * scale - 1)}, 0.5, false});
    keep(floor.columns);
  }
  plan(state, floor, columns <= 200);
  state.SetComplexityN(columns);
}
BENCHMARK(BM_CoverageAmongColumns)
    ->RangeMultiplier(2)
    ->Range(50, 800)
    ->Arg(200)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

/// A round floor of 30 m radius whose outline has many corners, each up to 2 cm off the circle.
void BM_CoverageOfManyCorners(benchmark::State& state) {
  Random random(3);
  FloorDescription floor;
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    const double angle = 360 * static_cast<double>(i) / static_cast<double>(state.range(0));
    const double radius = random.between(29.98, 30);
    floor.outline.push_back({radius * math::cos_deg(angle), radius * math::sin_deg(angle)});
  }
  plan(state, floor, false);
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_CoverageOfManyCorners)
    ->RangeMultiplier(2)
    ->Range(1250, 10000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

/// An orthogonal floor with steps along one side.
void BM_CoverageOfManySteps(benchmark::State& state) {
  Random random(3);
  const std::int64_t steps = state.range(0) / 2 - 1;
  FloorDescription floor;
  floor.outline = {{0, 0}, {0.05 * static_cast<double>(steps), 0}};
  for (std::int64_t i = steps; i-- > 0;) {
    const double y = random.between(20, 23);
    floor.outline.push_back({0.05 * static_cast<double>(i + 1), y});
    floor.outline.push_back({0.05 * static_cast<double>(i), y});
  }
  plan(state, floor, false);
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_CoverageOfManySteps)
    ->RangeMultiplier(2)
    ->Range(1250, 10000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

}  // namespace
}  // namespace rubicon::bench
