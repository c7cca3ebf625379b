#include "bench/question_bench.hpp"

#include <benchmark/benchmark.h>

#include <string>
#include <utility>

#include "bench/lazy.hpp"
#include "bench/mesh_scene.hpp"
#include "bench/our_world.hpp"
#include "bench/panel_scene.hpp"

namespace rubicon::bench {
namespace {

constexpr int kPanels = 10000;
constexpr int kMeshes = 1000;
constexpr int kManyPanels = 100000;
constexpr double kRange = 2;  // m

/// A scene of ours, and which of its steps are hits.
struct Asked {
  explicit Asked(const SweptScene& scene) : ours(scene) {
    for (const collision::SweptQuery& query : ours.queries) {
      if (const auto result = ours.world.test(query); result.hit)
        hits.emplace_back(&query, *result.hit);
    }
  }

  OurWorld ours;
  std::vector<std::pair<const collision::SweptQuery*, collision::SweptHit>> hits;
};

benchmark::IterationCount batch(std::size_t size) {
  return static_cast<benchmark::IterationCount>(size);
}

void contact(benchmark::State& state, const Asked& asked) {
  while (state.KeepRunningBatch(batch(asked.hits.size()))) {
    for (const auto& [query, hit] : asked.hits) {
      benchmark::DoNotOptimize(asked.ours.world.contact(*query, hit));
    }
  }
}

void explain(benchmark::State& state, const Asked& asked) {
  std::size_t pairs = 0;
  while (state.KeepRunningBatch(batch(asked.hits.size()))) {
    pairs = 0;
    for (const auto& [query, hit] : asked.hits) pairs += asked.ours.world.explain(*query).size();
  }
  state.counters["pairs"] = static_cast<double>(pairs) / static_cast<double>(asked.hits.size());
}

void clearance(benchmark::State& state, const Asked& asked) {
  while (state.KeepRunningBatch(batch(asked.ours.queries.size()))) {
    for (const collision::SweptQuery& query : asked.ours.queries) {
      benchmark::DoNotOptimize(asked.ours.world.clearance(query, kRange));
    }
  }
}

void with_budget(benchmark::State& state, const Asked& asked) {
  collision::ClearanceBudget budget;
  std::size_t hits = 0;
  while (state.KeepRunningBatch(batch(asked.ours.queries.size()))) {
    hits = 0;
    for (const collision::SweptQuery& query : asked.ours.queries) {
      hits += asked.ours.world.test(query, budget).hit.has_value();
    }
  }
  state.counters["hits"] =
      static_cast<double>(hits) / static_cast<double>(asked.ours.queries.size());
}

}  // namespace

void register_questions() {
  using Run = void (*)(benchmark::State&, const Asked&);
  const auto lazy = [](auto build) {
    return std::make_shared<Lazy<Asked>>([build] { return std::make_unique<Asked>(build()); });
  };
  const auto add = [](const std::string& name, const std::shared_ptr<Lazy<Asked>>& asked, Run run) {
    benchmark::RegisterBenchmark(
        name.c_str(), [asked, run](benchmark::State& state) { run(state, asked->get()); });
  };
  for (const StepKind kind : {StepKind::kTranslation, StepKind::kRotation}) {
    const auto ask_all = [&](const std::string& scene, int count, const auto& asked) {
      const std::string rest =
          std::string("/") + name_of(kind) + "/" + std::to_string(count) + "/ours";
      add(scene + "_contact" + rest, asked, contact);
      add(scene + "_explain" + rest, asked, explain);
      add(scene + "_clearance" + rest, asked, clearance);
    };
    ask_all("panels", kPanels, lazy([kind] { return panel_scene(kPanels, kind); }));
    ask_all("meshes", kMeshes, lazy([kind] { return mesh_scene(kMeshes, kind, MeshLoad::kBox); }));
    add(std::string("free/") + name_of(kind) + "/100000/ours_budget",
        lazy([kind] { return free_scene(kManyPanels, kind); }), with_budget);
  }
}

}  // namespace rubicon::bench
