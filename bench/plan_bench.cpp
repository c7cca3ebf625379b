// Whole plans by size: blocks of panels with as many tasks, read and run. Time a task must not grow
// with the number of tasks, and reading must be linear in the size of the text. And the residential
// plan: what a tried step costs, with everything a run does.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <malloc.h>

#include <fstream>
#include <memory>
#include <string>

#include "interpreter/check/plan_model.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/simulation/taskplan/run_plan.hpp"
#include "tests/support/memory_files.hpp"

namespace rubicon::bench {
namespace {

constexpr const char* kRobot = R"(robot gantry {
  body bridge { param x range(-10, 1e6) step(1) speed(2); frame trans(x, 0, 0); }
  body hoist on bridge {
    param y range(-20, 20) step(1) speed(1);
    param z range(0, 20) step(1) speed(1) start(10);
    frame trans(0, y, z);
    shape box(-0.2, -0.2, 0, 0.2, 0.2, 0.4);
  }
  tool hoist;
  behaviour "gantry.motion";
}
)";
constexpr const char* kScript = R"(chain { move_to(z, 6) };
chain { move_to(x, goal(x)) };
chain { move_to(y, goal(y)) };
chain { move_to(z, goal(z)) };
)";

/// Panels in a row beside the place where each is set; a panel comes after the one before, ten in a
/// chain.
std::string block(int panels) {
  std::string text =
      "plan block {\n  robot gantry \"gantry.robot\" { cost 180 per h; }\n"
      "  crew riggers { cost 165 per h; }\n";
  for (int i = 0; i < panels; ++i) {
    text += fmt::format(
        "  component panel_{0} {{ shape box(-0.1, -2, 0, 0.1, 2, 3); at trans({0}, "
        "-6, 0); grip trans(0, 0, 3); mass 2 t; }}\n",
        i);
  }
  for (int i = 0; i < panels; ++i) {
    text += fmt::format(
        "  task set_{0} {{ by gantry; move panel_{0} to trans({0}, 6, 0); hook 2 min "
        "by riggers; release 1 min by riggers;{1} }}\n",
        i, i % 10 == 0 ? "" : fmt::format(" after set_{};", i - 1));
  }
  return text + "}\n";
}

struct Loaded {
  interpreter::SourceMap sources;
  std::unique_ptr<interpreter::PlanModel> plan;
};

Loaded load(const std::string& text) {
  test::MemoryFiles files(
      {{"block.plan", text}, {"gantry.robot", kRobot}, {"gantry.motion", kScript}});
  interpreter::Diagnostics diagnostics;
  Loaded loaded;
  loaded.plan = interpreter::load_plan("block.plan", loaded.sources, files, diagnostics);
  return loaded;
}

/// Memory of this process (bytes) by a line of /proc/self/status: VmRSS now, VmHWM at most since
/// `forget_peak`.
double memory_of(const std::string& line) {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;) {
    double kilobytes = 0;
    if (word == line + ":" && file >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

void forget_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

void run_block(benchmark::State& state) {
  const int panels = static_cast<int>(state.range(0));
  const Loaded loaded = load(block(panels));
  double memory = 0;
  for (auto each : state) {
    ::malloc_trim(0);
    forget_peak();
    const double before = memory_of("VmRSS");
    const taskplan::Schedule schedule =
        taskplan::run_plan(*loaded.plan, loaded.sources, nullptr, {});
    memory = memory_of("VmHWM") - before;
    if (!schedule.feasible) state.SkipWithError("a task was rejected");
    benchmark::DoNotOptimize(schedule.process_time);
  }
  state.counters["task"] = benchmark::Counter(
      panels, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["kB/task"] = memory / panels / 1000;
}
BENCHMARK(run_block)
    ->Arg(1000)
    ->Arg(10000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// Without reading the plan and without a trace; `tried` is the time a tried step.
void run_residential(benchmark::State& state) {
  files::DiskFiles files;
  interpreter::Diagnostics diagnostics;
  interpreter::SourceMap sources;
  const auto plan = interpreter::load_plan(RUBICON_SOURCE_DIR "/taskplans/residential.plan",
                                           sources, files, diagnostics);
  if (!plan) {
    state.SkipWithError("the plan was not read");
    return;
  }
  int tried = 0;
  for (auto each : state) {
    const taskplan::Schedule schedule = taskplan::run_plan(*plan, sources, nullptr, {});
    tried = 0;
    for (const taskplan::TaskOutcome& task : schedule.tasks) tried += task.tried;
  }
  state.counters["steps"] = tried;
  state.counters["tried"] = benchmark::Counter(
      tried, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(run_residential)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void read_block(benchmark::State& state) {
  const std::string text = block(static_cast<int>(state.range(0)));
  for (auto each : state) {
    const Loaded loaded = load(text);
    if (!loaded.plan) state.SkipWithError("the plan was not read");
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size()) * state.iterations());
  state.counters["MB"] = static_cast<double>(text.size()) / 1e6;
}
// About 2.4, 24 and 64 MB: the largest text there may be.
BENCHMARK(read_block)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(260000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace rubicon::bench
