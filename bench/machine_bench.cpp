// How many attempts a second the abstract machine makes in a world without obstacles: the promise
// is 1,000,000 in under a second of a Release build. "Null world" is the machine alone; "empty
// site" goes through the real site.

#include <benchmark/benchmark.h>

#include <map>
#include <stdexcept>
#include <string>

#include "interpreter/machine/machine.hpp"
#include "src/simulation/site/make_site.hpp"
#include "src/simulation/site/robot_view.hpp"
#include "tests/support/memory_files.hpp"

namespace {

using namespace rubicon;

constexpr int kAttempts = 1'000'000;

/// Drives for ever along its own axis, turning now and then: four parameters, local rules, a chain
/// in a chain, variables.
const char* const kRobot = R"(robot agent {
  body truck {
    param x step(0.5);
    param y;
    param z;
    param theta cyclic step(0.01);
    rule x <- x + x_s * cos(theta) - y_s * sin(theta);
    rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    rule z <- z_c;
    frame trans(x, y, z) * rotz(theta);
    shape box(-1.2, -0.7, 0, 1.2, 0.7, 2);
  }
  tool truck;
  behaviour "script.motion";
}
)";
const char* const kScripts[] = {
    // one command, always accepted
    "chain { move_dir(x, 1) };",
    // every second attempt refused, arguments computed from the configuration
    "chain { move_dir(theta, dir(theta, theta)), move_dir(x, dir(x, x + 1)) };",
    // drive by bearing, as the paper's mobile agent does
    "chain { move_to(theta, r_goal(theta)), move_to(x, r_goal(x)) } until (dist() < 1);"};

struct NullWorld : interpreter::World {
  std::optional<interpreter::HitPair> propose(const interpreter::MotionStep&) override {
    return {};
  }
  std::optional<interpreter::HitPair> refusal(const interpreter::MotionStep&) const override {
    return {};
  }
  double free_distance(std::span<const double>, double, double range) const override {
    return range;
  }
  std::optional<interpreter::HitPair> blocked_at(std::span<const double>) const override {
    return {};
  }
  std::uint64_t version() const override { return 0; }
  bool situation(const std::string&, std::span<const double>,
                 std::span<const double>) const override {
    return false;
  }
  bool loaded() const override { return false; }
};

struct Fixture {
  explicit Fixture(int script)
      : files({{"agent.robot", kRobot},
               {"script.motion", kScripts[script]},
               {"p.plan",
                "plan p { robot \"agent.robot\"; start x 0; goal x 1000000, y 300000; budget "
                "100000000; }"}}) {
    interpreter::Diagnostics diagnostics;
    plan = load_plan("p.plan", sources, files, diagnostics);
    if (!plan) throw std::runtime_error("the plan of this benchmark is wrong");
    program = compile(plan->robots[0].robot);
  }

  interpreter::MotionTask task() const {
    interpreter::MotionTask motion;
    motion.goals = {*plan->goal};
    motion.budget = plan->budget;
    motion.q = plan->robots[0].start;
    motion.mounting.starts = plan->robots[0].start;
    return motion;
  }

  test::MemoryFiles files;
  interpreter::SourceMap sources;
  std::unique_ptr<interpreter::PlanModel> plan;
  interpreter::Program program;
};

void run(benchmark::State& state, const Fixture& fixture, interpreter::World& world) {
  for (auto _ : state) {
    interpreter::Machine machine(fixture.program, fixture.task());
    while (machine.tries() < kAttempts && machine.advance(world, nullptr)) {
    }
    if (machine.tries() < kAttempts)
      state.SkipWithError("the motion ended before its attempts were made");
    benchmark::DoNotOptimize(machine.q().data());
  }
  state.SetItemsProcessed(state.iterations() * kAttempts);
}

void machine_in_null_world(benchmark::State& state) {
  const Fixture fixture(static_cast<int>(state.range(0)));
  NullWorld world;
  run(state, fixture, world);
}

void machine_on_empty_site(benchmark::State& state) {
  const Fixture fixture(static_cast<int>(state.range(0)));
  site::SiteWorld site = site::make_site(*fixture.plan);
  site::RobotView world(site, 0);
  run(state, fixture, world);
}

BENCHMARK(machine_in_null_world)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(machine_on_empty_site)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

}  // namespace
