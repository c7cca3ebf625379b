#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <memory>

#include "src/earth/hauling/hauling.hpp"
#include "src/earth/soil/blocks.hpp"
#include "src/earth/soil/excavation.hpp"
#include "src/simulation/site/site_world.hpp"

namespace rubicon::bench {
namespace {

/// Rounds of twelve trucks before two shovels and a dozer, all times by chance. To compare: the
/// time of one load, whatever their number.
void BM_Rounds(benchmark::State& state) {
  const auto exponential = [](double mean) {
    const sampling::DurationLaw law{sampling::Law::exponential, {mean}};
    return hauling::StageTime{mean, law};
  };
  hauling::Operation operation;
  operation.load = 1'000'000'000;
  operation.volume = state.range(0) * operation.load;
  operation.loading = exponential(150);
  operation.diggers = {{"shovels", 2}};
  operation.trucks = 12;
  operation.stages = {{"haul", exponential(400)},
                      {"tip", exponential(60), "dozer", 1},
                      {"return", exponential(300)}};
  operation.tip = 1;
  std::int64_t loads = 0;
  for (auto _ : state) loads += simulate(operation, hauling::Draws{1, 0, "pit"}).loads;
  state.counters["time_per_load"] = benchmark::Counter(
      static_cast<double>(loads), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_Rounds)->RangeMultiplier(10)->Range(1'000, 1'000'000)->Unit(benchmark::kMillisecond);

soil::Terrain hills(int side) {
  soil::Terrain ground = soil::flat(side, side, 250, 0);
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      ground.heights.set(ground.index(column, row), 100 * std::lround(20 * std::sin(column / 17.0) +
                                                                      15 * std::cos(row / 11.0)));
    }
  }
  return ground;
}

/// A pit over half of rough ground, with slopes, and the boxes of what is left.
void BM_PitInHills(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  const soil::Terrain ground = hills(side);
  const double length = side * 0.25;
  const soil::Pit pit = {{{length * 0.2, length * 0.2},
                          {length * 0.8, length * 0.25},
                          {length * 0.75, length * 0.8},
                          {length * 0.3, length * 0.7}},
                         -6000};
  std::size_t boxes = 0;
  for (auto _ : state) {
    const soil::Excavation dug = excavate(ground, pit, 60);
    boxes = soil::blocks_between(soil::flat(side, side, 250, -8000), dug.after).size();
  }
  state.counters["boxes"] = static_cast<double>(boxes);
  state.counters["time_per_cell"] = benchmark::Counter(
      static_cast<double>(side) * side,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_PitInHills)->Arg(100)->Arg(200)->Arg(500)->Unit(benchmark::kMillisecond);

/// Soil of side x side cells that is in the way of machines; buckets of 24 cells each lower it here
/// and there. To compare: the time of a changed cell in the tree of the engine, whatever the size.
void BM_ChangedCell(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  site::SiteWorld world(1e-3);
  const int ground = world.add_component("ground", nullptr, math::Pose::Identity(), 0);
  world.open_soil(ground, soil::flat(side, side, 250, 0),
                  std::make_shared<const soil::Terrain>(soil::flat(side, side, 250, -1'000'000)));
  constexpr int kAlong = 6;
  constexpr int kAcross = 4;
  std::uint64_t random = 1;
  std::int64_t cells = 0;
  for (auto _ : state) {
    random = random * 6364136223846793005ULL + 1442695040888963407ULL;
    const int column = static_cast<int>((random >> 33) % static_cast<unsigned>(side - kAlong));
    const int row = static_cast<int>((random >> 13) % static_cast<unsigned>(side - kAcross));
    std::map<int, soil::Millimetres> heights;
    const soil::Terrain& now = *world.surface(ground);
    for (int r = row; r < row + kAcross; ++r) {
      for (int c = column; c < column + kAlong; ++c) {
        const std::size_t cell = now.index(c, r);
        heights[static_cast<int>(cell)] = now.heights[cell] - 40 - (c * 7 + r * 3) % 20;
      }
    }
    world.set_surface(ground, heights);
    cells += static_cast<std::int64_t>(heights.size());
  }
  state.counters["time_per_changed_cell"] = benchmark::Counter(
      static_cast<double>(cells), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_ChangedCell)->Arg(100)->Arg(200)->Arg(500)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace rubicon::bench
