#include "bench/change_bench.hpp"

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <ctime>
#include <functional>
#include <string>
#include <utility>

#include "bench/fcl_world.hpp"
#include "bench/lazy.hpp"
#include "bench/mesh_scene.hpp"
#include "bench/our_world.hpp"
#include "bench/panel_scene.hpp"

namespace rubicon::bench {
namespace {

constexpr int kPanels = 100000;
constexpr int kChanges = 20000;
constexpr int kMeshes = 10000;
constexpr int kRounds = 3;  // a repetition

/// Processor time of this thread, s.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Bytes in use on the heap.
double heap_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// Our engine as a site that changes.
class OurSite {
 public:
  explicit OurSite(const SweptScene& scene)
      : load_(body_of(scene.load)), queries_(queries_of(*load_, scene.steps)) {
    for (const geometry::Solid& solid : scene.solids) bodies_.push_back(body_of(solid));
  }
  void build(const std::vector<Standing>& panels, int count) {
    for (int i = 0; i < count; ++i) insert(panels[i]);
  }
  void insert(const Standing& panel) {
    ids_.push_back(world_.insert(bodies_[panel.solid], panel.X_WB));
  }
  void remove(int index) { world_.remove(ids_[index]); }
  void ask(int i) {
    benchmark::DoNotOptimize(world_.test(queries_[static_cast<std::size_t>(i) % queries_.size()]));
  }

 private:
  collision::CollisionWorld world_;
  collision::BodyPtr load_;
  std::vector<collision::BodyPtr> bodies_;
  std::vector<collision::SweptQuery> queries_;
  std::vector<collision::ObstacleId> ids_;
};

/// FCL as a site that changes.
class FclSite {
 public:
  explicit FclSite(const SweptScene& scene) : world_(scene.solids) {
    const FclWorld::LoadPtr load = FclWorld::make_load(scene.load);
    for (const geometry::ScrewMotion& step : scene.steps) {
      steps_.push_back(FclWorld::make_step(load, step, false));
    }
  }
  void build(const std::vector<Standing>& panels, int count) {
    world_.insert_all({panels.begin(), panels.begin() + count});
  }
  void insert(const Standing& panel) { world_.insert(panel); }
  void remove(int index) { world_.remove(static_cast<std::size_t>(index)); }
  void ask(int i) {
    benchmark::DoNotOptimize(
        world_.continuous(*steps_[static_cast<std::size_t>(i) % steps_.size()]));
  }

 private:
  FclWorld world_;
  std::vector<FclWorld::StepPtr> steps_;
};

enum class Change { kBuild, kInsert, kRemove };

template <typename Site>
void measure(benchmark::State& state, const SweptScene& scene, Change change, bool ask) {
  const int all = static_cast<int>(scene.standing.size());
  const int at_first = change == Change::kBuild    ? 0
                       : change == Change::kInsert ? all - kChanges
                                                   : all;
  std::vector<int> order;
  for (int i = 0; i < all; ++i) order.push_back(i);
  Random random(6);
  for (int i = all - 1; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);

  double bytes = 0;
  for (auto _ : state) {
    Site site(scene);
    if (at_first > 0) site.build(scene.standing, at_first);
    const double heap = heap_in_use();
    const double start = processor_time();
    int changes = kChanges;
    if (change == Change::kBuild) {
      site.build(scene.standing, all);
      changes = all;
      if (ask) site.ask(0);
    } else {
      for (int i = 0; i < kChanges; ++i) {
        if (change == Change::kInsert) {
          site.insert(scene.standing[at_first + i]);
        } else {
          site.remove(order[i]);
        }
        if (ask) site.ask(i);
      }
    }
    state.SetIterationTime((processor_time() - start) / changes);
    bytes = (heap_in_use() - heap) / changes;
  }
  if (change == Change::kBuild) state.counters["bytes"] = bytes;
}

}  // namespace

void register_changes() {
  const auto panels = std::make_shared<Lazy<SweptScene>>([] {
    return std::make_unique<SweptScene>(panel_scene(kPanels + kChanges, StepKind::kTranslation));
  });
  const auto built = std::make_shared<Lazy<SweptScene>>([panels] {
    auto scene = std::make_unique<SweptScene>(panels->get());
    scene->standing.resize(kPanels);
    return scene;
  });
  const auto meshes = std::make_shared<Lazy<SweptScene>>([] {
    return std::make_unique<SweptScene>(
        mesh_scene(kMeshes, StepKind::kTranslation, MeshLoad::kBox));
  });
  const auto add = [](const std::string& name, const std::shared_ptr<Lazy<SweptScene>>& scene,
                      Change change, bool ask) {
    benchmark::RegisterBenchmark(
        (name + "/ours").c_str(),
        [=](benchmark::State& state) { measure<OurSite>(state, scene->get(), change, ask); })
        ->Iterations(kRounds)
        ->UseManualTime();
    benchmark::RegisterBenchmark(
        (name + "/fcl_default").c_str(),
        [=](benchmark::State& state) { measure<FclSite>(state, scene->get(), change, ask); })
        ->Iterations(kRounds)
        ->UseManualTime();
  };
  add("build/panels/100000", built, Change::kBuild, true);
  add("build/meshes/10000", meshes, Change::kBuild, true);
  add("insert/panels/100000", panels, Change::kInsert, false);
  add("insert_ask/panels/100000", panels, Change::kInsert, true);
  add("remove/panels/120000", panels, Change::kRemove, false);
  add("remove_ask/panels/120000", panels, Change::kRemove, true);
}

}  // namespace rubicon::bench
