#include "bench/crane_bench.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

#include "bench/crane_path.hpp"
#include "bench/fcl_world.hpp"
#include "bench/lazy.hpp"
#include "bench/our_world.hpp"
#include "bench/residential_site.hpp"

namespace rubicon::bench {
namespace {

/// The building, the crane and its way, in the form of each engine.
class CraneSite {
 public:
  CraneSite() : scene_(residential_site()), path_(crane_path(roof_places())), site_(scene_) {
    for (const auto& boxes : crane_boxes()) {
      std::vector<geometry::Shape> shapes;
      for (const geometry::Box& box : boxes) {
        geometry::Shape shape;
        shape.solid = box;
        shapes.push_back(shape);
      }
      bodies_.push_back(collision::prepare(shapes));
    }
    for (const CraneStep& step : path_) {
      for (const bool moves : step.moves) moving_ += moves;
    }
  }

  int obstacles() const { return static_cast<int>(scene_.standing.size()); }
  /// Moving bodies and loads, summed over the steps.
  int moving() const { return moving_; }
  const collision::CollisionWorld& world() const { return site_.world; }

  std::vector<collision::SweptQuery> queries(bool own_pairs) const {
    std::vector<collision::SweptQuery> queries;
    for (const CraneStep& step : path_) {
      collision::SweptQuery query;
      std::array<int, kCraneParts> item_of{};
      const auto add = [&](int part) {
        item_of[part] = static_cast<int>(query.items.size());
        query.items.push_back({{bodies_[part].get(), {step.motions[part]}}, step.moves[part]});
      };
      for (int part = 0; part < kCraneParts; ++part) {
        if (step.moves[part]) add(part);
      }
      if (own_pairs) {
        const std::vector<std::pair<int, int>> pairs = step.pairs();
        for (int part = 0; part < kCraneParts; ++part) {
          const auto meets = [part](const auto& pair) {
            return pair.first == part || pair.second == part;
          };
          if (!step.moves[part] && std::any_of(pairs.begin(), pairs.end(), meets)) add(part);
        }
        for (const auto& [a, b] : pairs) query.pairs.emplace_back(item_of[a], item_of[b]);
      }
      queries.push_back(std::move(query));
    }
    return queries;
  }

  /// FCL knows no bodies of several boxes: each box makes its own step.
  std::vector<FclWorld::StepPtr> fcl_steps() const {
    std::array<std::vector<std::pair<FclWorld::LoadPtr, Vec3>>, kCraneParts> parts;
    const auto boxes = crane_boxes();
    for (int part = 0; part < kCraneParts; ++part) {
      for (const geometry::Box& box : boxes[part]) {
        parts[part].emplace_back(FclWorld::make_load(centred_box((box.upper - box.lower) / 2)),
                                 (box.upper + box.lower) / 2);
      }
    }
    std::vector<FclWorld::StepPtr> steps;
    for (const CraneStep& step : path_) {
      for (int part = 0; part < kCraneParts; ++part) {
        if (!step.moves[part]) continue;
        for (const auto& [load, middle] : parts[part]) {
          geometry::ScrewMotion motion = step.motions[part];
          motion.X0 = motion.X0 * Eigen::Translation3d(middle);
          steps.push_back(FclWorld::make_step(load, motion, false));
        }
      }
    }
    return steps;
  }
  const SweptScene& scene() const { return scene_; }

 private:
  SweptScene scene_;
  std::vector<CraneStep> path_;
  OurWorld site_;
  std::vector<collision::BodyPtr> bodies_;
  int moving_ = 0;
};

/// Times whole paths; `run` makes one and gives the number of hits.
template <typename Run>
void measure(benchmark::State& state, const CraneSite& site, Run run) {
  int hits = 0;
  while (state.KeepRunningBatch(site.moving())) hits = run();
  state.counters["hits"] = static_cast<double>(hits) / site.moving();
  state.counters["obstacles"] = site.obstacles();
}

void ours(benchmark::State& state, const CraneSite& site, bool own_pairs) {
  const std::vector<collision::SweptQuery> queries = site.queries(own_pairs);
  measure(state, site, [&] {
    int hits = 0;
    for (const collision::SweptQuery& query : queries) {
      hits += site.world().test(query).hit.has_value();
    }
    return hits;
  });
}

/// One budget for the crane, as a run keeps it.
void ours_with_budget(benchmark::State& state, const CraneSite& site, bool own_pairs) {
  const std::vector<collision::SweptQuery> queries = site.queries(own_pairs);
  collision::ClearanceBudget budget;
  measure(state, site, [&] {
    int hits = 0;
    for (const collision::SweptQuery& query : queries) {
      hits += site.world().test(query, budget).hit.has_value();
    }
    return hits;
  });
}

void fcl_default(benchmark::State& state, const CraneSite& site) {
  const FclWorld world(site.scene());
  const std::vector<FclWorld::StepPtr> steps = site.fcl_steps();
  measure(state, site, [&] {
    int hits = 0;
    for (const FclWorld::StepPtr& step : steps) hits += world.continuous(*step);
    return hits;
  });
}

}  // namespace

void register_crane() {
  const auto site =  // shared by the benchmarks below
      std::make_shared<Lazy<CraneSite>>([] { return std::make_unique<CraneSite>(); });
  const std::string name = "crane/path/1401/";
  const auto add = [&](const char* method, auto run) {
    benchmark::RegisterBenchmark((name + method).c_str(),
                                 [site, run](benchmark::State& state) { run(state, site->get()); });
  };
  add("ours", [](benchmark::State& state, const CraneSite& on) { ours(state, on, false); });
  add("ours_pairs", [](benchmark::State& state, const CraneSite& on) { ours(state, on, true); });
  add("ours_budget",
      [](benchmark::State& state, const CraneSite& on) { ours_with_budget(state, on, false); });
  add("ours_pairs_budget",
      [](benchmark::State& state, const CraneSite& on) { ours_with_budget(state, on, true); });
  add("fcl_default", fcl_default);
}

}  // namespace rubicon::bench
