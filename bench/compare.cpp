#include "bench/compare.hpp"

#include <benchmark/benchmark.h>

#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "bench/fcl_world.hpp"
#include "bench/lazy.hpp"
#include "bench/our_world.hpp"

namespace rubicon::bench {
namespace {

using Answers = std::vector<bool>;

const char* name_of(Method method) {
  switch (method) {
    case Method::kOurs:
      return "ours";
    case Method::kOursBaseline:
      return "ours_baseline";
    case Method::kFclDefault:
      return "fcl_default";
    case Method::kFcl10mm:
      return "fcl_10mm";
    case Method::kFcl10mmOneTree:
      return "fcl_10mm_one_tree";
    case Method::kFclDropped:
      return "fcl_dropped";
    case Method::kFclTight:
      return "fcl_tight";
  }
  return "";
}

/// FCL's side of a scene.
struct FclSide {
  FclSide(const SweptScene& scene, FclBounds bounds, bool with_poses) : world(scene, bounds) {
    const FclWorld::LoadPtr load = FclWorld::make_load(scene.load);
    for (const geometry::ScrewMotion& step : scene.steps) {
      steps.push_back(FclWorld::make_step(load, step, with_poses));
    }
  }

  FclWorld world;
  std::vector<FclWorld::StepPtr> steps;
};

/// A scene, in the engines that were asked so far.
class Comparison {
 public:
  explicit Comparison(const std::function<SweptScene()>& build)
      : scene_([build] { return std::make_unique<SweptScene>(build()); }),
        ours_([this] { return std::make_unique<OurWorld>(scene_.get()); }),
        fcl_([this] { return side(FclBounds::kAsItComes, false); }),
        fcl_poses_([this] { return side(FclBounds::kAsItComes, true); }),
        fcl_tight_([this] { return side(FclBounds::kTight, false); }) {}

  /// Calls `use` with a function that answers step number i by `method`.
  template <typename Use>
  void with(Method method, Use use) {
    if (method == Method::kOurs || method == Method::kOursBaseline) {
      const OurWorld& ours = ours_.get();
      if (method == Method::kOursBaseline) collision::use_simd(collision::Simd::kBaseline);
      use([&ours](std::size_t i) { return ours.world.test(ours.queries[i]).hit.has_value(); });
      collision::use_simd(collision::Simd::kAvx2);
      return;
    }
    const bool poses = method == Method::kFcl10mm || method == Method::kFcl10mmOneTree;
    const FclSide& fcl = poses                         ? fcl_poses_.get()
                         : method == Method::kFclTight ? fcl_tight_.get()
                                                       : fcl_.get();
    const FclWorld& world = fcl.world;
    if (method == Method::kFcl10mm) {
      use([&](std::size_t i) { return world.every_10_mm(*fcl.steps[i]); });
    } else if (method == Method::kFcl10mmOneTree) {
      use([&](std::size_t i) { return world.every_10_mm_one_tree_query(*fcl.steps[i]); });
    } else {
      const auto rotation =
          method == Method::kFclDropped ? FclRotation::kDropped : FclRotation::kScrew;
      use([&, rotation](std::size_t i) { return world.continuous(*fcl.steps[i], rotation); });
    }
  }

  std::size_t steps() { return scene_.get().steps.size(); }

  const Answers& answers(Method method) {
    const auto known = answers_.find(method);
    if (known != answers_.end()) return known->second;
    Answers made;
    with(method, [&](const auto& ask) {
      for (std::size_t i = 0; i < steps(); ++i) made.push_back(ask(i));
    });
    return answers_.emplace(method, std::move(made)).first->second;
  }

 private:
  std::unique_ptr<FclSide> side(FclBounds bounds, bool with_poses) {
    return std::make_unique<FclSide>(scene_.get(), bounds, with_poses);
  }

  Lazy<SweptScene> scene_;
  Lazy<OurWorld> ours_;
  Lazy<FclSide> fcl_;
  Lazy<FclSide> fcl_poses_;
  Lazy<FclSide> fcl_tight_;
  std::map<Method, Answers> answers_;
};

double share(double part, double whole) { return whole > 0 ? part / whole : 0; }

void count_answers(benchmark::State& state, Comparison& comparison, Method method) {
  const Answers& ours = comparison.answers(Method::kOurs);
  const Answers& its = comparison.answers(method);
  double our_hits = 0;
  double hits = 0;
  double missed = 0;
  for (std::size_t i = 0; i < its.size(); ++i) {
    our_hits += ours[i];
    hits += its[i];
    missed += ours[i] && !its[i];
  }
  const auto all = static_cast<double>(its.size());
  state.counters["hits"] = share(hits, all);
  if (method == Method::kOurs) return;
  state.counters["missed"] = share(missed, our_hits);
  state.counters["false_hits"] = share(hits - (our_hits - missed), all - our_hits);
}

void measure(benchmark::State& state, Comparison& comparison, Method method) {
  const std::size_t steps = comparison.steps();
  comparison.with(method, [&](const auto& ask) {
    while (state.KeepRunningBatch(static_cast<benchmark::IterationCount>(steps))) {
      for (std::size_t i = 0; i < steps; ++i) benchmark::DoNotOptimize(ask(i));
    }
  });
  count_answers(state, comparison, method);
}

}  // namespace

void register_comparison(const std::string& scene, const std::string& kind, int count,
                         const std::function<SweptScene()>& build,
                         const std::vector<Method>& methods) {
  const auto comparison = std::make_shared<Comparison>(build);  // shared by the benchmarks below
  for (const Method method : methods) {
    const std::string name =
        scene + "/" + kind + "/" + std::to_string(count) + "/" + name_of(method);
    benchmark::RegisterBenchmark(name.c_str(), [comparison, method](benchmark::State& state) {
      measure(state, *comparison, method);
    });
  }
}

}  // namespace rubicon::bench
