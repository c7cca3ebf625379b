// What it costs to test the legs of a machine with many joints, and to find a way with them: the
// excavator with a full bucket between trench and truck (robots/excavator/cases/trench_to_truck).
// Run in the project's folder.

#include <benchmark/benchmark.h>

#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/machine/machine.hpp"
#include "interpreter/machine/world_tests.hpp"
#include "src/motion/guides/guide.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/simulation/site/make_site.hpp"
#include "src/simulation/site/robot_view.hpp"
#include "tests/support/memory_files.hpp"

namespace {

using namespace rubicon;
using interpreter::WorldTests;

class DiskFiles : public test::MemoryFiles {
 public:
  std::variant<std::string, interpreter::FileFailure> read_text(const std::string& path) override {
    std::ifstream file(path, std::ios::binary);
    if (!file) return interpreter::FileFailure{"there is no such file"};
    return std::string(std::istreambuf_iterator<char>(file), {});
  }
};

struct Scene {
  Scene() {
    interpreter::Diagnostics diagnostics;
    plan =
        load_plan("robots/excavator/cases/trench_to_truck/site.plan", sources, files, diagnostics);
    if (!plan) throw std::runtime_error("run this benchmark in the project's folder");
    world.emplace(site::make_site(*plan));
    view.emplace(*world, 0);
    mounting.starts = plan->robots[0].start;
  }

  const robot::RobotModel& model() const { return plan->robots[0].robot->model; }
  const std::vector<double>& start() const { return plan->robots[0].start; }

  DiskFiles files;
  interpreter::SourceMap sources;
  std::unique_ptr<interpreter::PlanModel> plan;
  robot::Mounting mounting;
  std::optional<site::SiteWorld> world;
  std::optional<site::RobotView> view;
};

/// Legs from random configurations in which the machine may stand, each joint by up to `most_deg`,
/// either all free or all refused.
void leg(benchmark::State& state) {
  const Scene scene;
  const double most_deg = static_cast<double>(state.range(0));
  const bool free = state.range(1) != 0;
  WorldTests tests(scene.model(), *scene.view);
  std::mt19937_64 random(7);
  const auto between = [&](double lower, double upper) {
    return lower + (upper - lower) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  std::vector<std::pair<std::vector<double>, std::vector<double>>> legs;
  while (legs.size() < 200) {
    std::vector<double> from = scene.start();
    for (std::size_t i = 0; i < from.size(); ++i) {
      const robot::Parameter& p = scene.model().parameters[i];
      if (!p.derived) from[i] = p.cyclic ? between(-180, 180) : between(p.lower, p.upper);
    }
    std::vector<double> to = from;
    for (std::size_t i = 0; i < to.size(); ++i) {
      if (!scene.model().parameters[i].derived) to[i] += between(-most_deg, most_deg);
    }
    robot::update_derived(scene.model(), scene.mounting, from);
    robot::update_derived(scene.model(), scene.mounting, to);
    if (!tests.stands(from)) continue;
    if (scene.view->refusal({from, to, 0, 0}).has_value() == free) continue;
    legs.emplace_back(std::move(from), std::move(to));
  }
  std::size_t next = 0;
  for (auto _ : state) {
    const auto& [from, to] = legs[next];
    next = (next + 1) % legs.size();
    benchmark::DoNotOptimize(scene.view->refusal({from, to, 0, 0}).has_value());
  }
}

/// A whole way by rrt_connect, certified again step by step, over the seeds from 1 to 20.
void way(benchmark::State& state) {
  const Scene scene;
  guides::GuideTask task;
  task.model = &scene.model();
  task.mounting = scene.mounting;
  std::vector<double> goal = scene.start();
  for (const auto& [index, value] : scene.plan->goal->values) {
    goal[static_cast<std::size_t>(index)] = value;
  }
  robot::update_derived(scene.model(), scene.mounting, goal);
  task.goals = {goal};
  guides::GuideSpec spec = guides::default_guide(guides::GuideKind::rrt_connect);
  spec.improve = static_cast<double>(state.range(0));
  WorldTests tests(scene.model(), *scene.view);
  double checks = 0;
  double motion_time = 0;
  spec.seed = 0;
  for (auto _ : state) {
    spec.seed = spec.seed < 20 ? spec.seed + 1 : 1;
    const guides::PlanReport report = guides::plan_way(spec, task, scene.start(), tests);
    if (!report.found()) state.SkipWithError("no way");
    checks += static_cast<double>(report.checks);
    motion_time += report.metrics.motion_time;
  }
  state.counters["checks"] = benchmark::Counter(checks, benchmark::Counter::kAvgIterations);
  state.counters["motion_s"] = benchmark::Counter(motion_time, benchmark::Counter::kAvgIterations);
}

BENCHMARK(leg)
    ->ArgNames({"degrees", "free"})
    ->ArgsProduct({{5, 12, 45}, {1, 0}})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(way)->ArgName("improve")->Arg(0)->Arg(200)->Unit(benchmark::kMillisecond);

}  // namespace
