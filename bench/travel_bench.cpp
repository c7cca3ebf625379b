#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bench/random.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/travel/outline.hpp"
#include "src/motion/travel/travel.hpp"

namespace rubicon::bench {
namespace {

using namespace travel;

/// The side of a square field, m, with one obstacle on 100 square metres.
double side_of(std::int64_t obstacles) { return 10 * std::sqrt(static_cast<double>(obstacles)); }

/// Obstacles of eight corners; `size` 1: many of them in contact with others; 4: nearly all are one
/// heap.
std::vector<std::vector<Vec2>> field(std::int64_t obstacles, double size = 1) {
  Random random(7);
  const double side = side_of(obstacles);
  std::vector<std::vector<Vec2>> shapes;
  for (std::int64_t i = 0; i < obstacles; ++i) {
    const Vec2 centre(random.between(0, side), random.between(0, side));
    const double radius = size * random.between(1, 3);
    std::vector<Vec2> corners;
    for (int k = 0; k < 8; ++k) {
      const double angle = 45.0 * k + random.between(0, 40);
      corners.push_back(centre + radius * Vec2(math::cos_deg(angle), math::sin_deg(angle)));
    }
    shapes.push_back(std::move(corners));
  }
  return shapes;
}

std::vector<Piece> pieces_of(std::int64_t obstacles, double size = 1) {
  std::vector<Piece> pieces;
  for (const auto& corners : field(obstacles, size)) pieces.push_back({ring_of(corners), 0});
  return pieces;
}

void BM_OutlineBuild(benchmark::State& state) {
  const std::vector<Piece> pieces = pieces_of(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(Outline(pieces));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_OutlineBuild)->RangeMultiplier(2)->Range(250, 8000)->Complexity();

/// The first obstacle of the largest heap moves by half a metre, to and fro: the heap is built
/// anew.
void move_one(benchmark::State& state, double size) {
  const std::vector<Piece> pieces = pieces_of(state.range(0), size);
  Outline outline(pieces);
  std::vector<int> heap;
  for (const Composite& composite : outline.composites()) {
    if (composite.pieces.size() > heap.size()) heap = composite.pieces;
  }
  state.counters["heap"] = static_cast<double>(heap.size());
  const Ring& ring = pieces[static_cast<std::size_t>(heap.front())].ring;
  Ring moved = ring;
  for (LatticePoint& corner : moved) corner.x += 1 << 19;
  bool away = false;
  for (auto _ : state) {
    away = !away;
    const Outline::Change change{heap.front(), away ? moved : ring};
    outline.replace({&change, 1});
  }
  state.SetComplexityN(state.range(0));
}

void BM_OutlineMove(benchmark::State& state) { move_one(state, 1); }
BENCHMARK(BM_OutlineMove)->RangeMultiplier(2)->Range(250, 8000)->Complexity();

void BM_OutlineMoveInAHeap(benchmark::State& state) { move_one(state, 4); }
BENCHMARK(BM_OutlineMoveInAHeap)->RangeMultiplier(2)->Range(250, 8000)->Complexity();

/// From corner to corner of the field, with the building of its outline.
void BM_Bug2(benchmark::State& state) {
  TravelQuery query;
  for (auto& corners : field(state.range(0))) query.obstacles.push_back({"o", {corners}, {}});
  const double side = side_of(state.range(0));
  query.start = {-5, -5};
  query.destination = {side + 5, side + 5};
  double length = 0;
  for (auto _ : state) length = travel::travel(Method::kBug2, query).length;
  state.counters["length"] = length;
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_Bug2)
    ->RangeMultiplier(2)
    ->Range(250, 8000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

}  // namespace
}  // namespace rubicon::bench
