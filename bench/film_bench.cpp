// The film of a long run: lines of a trace in, the packed bytes that the report page carries out.
// A million attempts are 350 MB of trace; the page must stay under 25 MB.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <malloc.h>

#include <array>
#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include "bench/random.hpp"
#include "src/exchange/encoding/gzip.hpp"
#include "src/results/film/film_writer.hpp"

namespace rubicon::bench {
namespace {

constexpr const char* kHeader =
    R"({"type":"header","format":"rubicon-trace","version":1,"plan":"long","path":"long.plan",)"
    R"("form":"full","detail":"steps","contact":0.001,"budget":20000,"situations":[],)"
    R"("start_at":null,"currency":"","calendars":[],"files":[],"site":[],"components":[],)"
    R"("carry":[],"crews":[],"tasks":[],"meshes":[],"robots":[{"name":"tower_crane",)"
    R"("type":"tower_crane","path":"tower_crane.robot","pose":[1,0,0,0,0,1,0,0,0,0,1,0],)"
    R"("start":{"jib.theta":0,"x":20,"z":30,"hook.theta":0},"cost_per_hour":null,)"
    R"("calendar":"","park":null,"time_step":1,"sensor":0,"touching":[],"capacity":[],)"
    R"("bodies":[{"name":"mast","parent":null,"frame":"","shapes":[]}],)"
    R"("tool":{"body":"mast","frame":""},"parameters":[)"
    R"({"name":"jib.theta","body":"mast","kind":"rotation","cyclic":true,"lower":null,)"
    R"("upper":null,"step":1,"speed":1,"loaded_speed":1,"start":0,"prefer":1,"rule":"0"},)"
    R"({"name":"x","body":"mast","kind":"translation","cyclic":false,"lower":null,)"
    R"("upper":null,"step":1,"speed":1,"loaded_speed":1,"start":0,"prefer":1,"rule":"0"},)"
    R"({"name":"z","body":"mast","kind":"translation","cyclic":false,"lower":null,)"
    R"("upper":null,"step":1,"speed":1,"loaded_speed":1,"start":0,"prefer":1,"rule":"0"},)"
    R"({"name":"hook.theta","body":"mast","kind":"rotation","cyclic":true,"lower":null,)"
    R"("upper":null,"step":1,"speed":1,"loaded_speed":1,"start":0,"prefer":1,"rule":"0"})"
    R"(]}]})";
constexpr int kTriesOfATask = 400;

/// A crane that goes to and fro by steps of 2 degrees and 0.5 m, one parameter after another as a
/// chain of move_to does, and is refused now and then.
class LongRun {
 public:
  /// The lines of the next task.
  std::vector<std::string> task() {
    std::vector<std::string> lines;
    const std::string name = fmt::format("set_panel_{}", ++task_);
    lines.push_back(fmt::format(
        R"({{"type":"task_start","task":"{}","robot":"tower_crane","t":{:.9f},"because":"the robot is free","after":""}})",
        name, t_));
    for (int n = 1; n <= kTriesOfATask; ++n) lines.push_back(attempt(name, n));
    lines.push_back(fmt::format(
        R"({{"type":"task_end","task":"{}","robot":"tower_crane","t":{:.9f},"result":"done","reason":""}})",
        name, t_));
    return lines;
  }

 private:
  std::string attempt(const std::string& name, int n) {
    constexpr std::array<double, 4> kSteps = {2, 0.5, 0.5, 15};
    constexpr std::array<double, 4> kTimes = {0.5555555, 0.625, 0.8333333, 1};
    constexpr std::array<const char*, 4> kNames = {"jib.theta", "x", "z", "hook.theta"};
    const auto way = static_cast<std::size_t>(random_.below(40) == 0 ? random_.below(4) : last_);
    if (way != last_ || random_.below(50) == 0) sign_ = -sign_;
    last_ = way;
    const bool ok = random_.below(4) != 0;
    if (ok) {
      q_[way] += sign_ * kSteps[way];
      t_ += kTimes[way];
    }
    return fmt::format(
        R"({{"type":"try","task":"{}","robot":"tower_crane","n":{},"command":"move_to","parameter":"{}","file":"robots/tower_crane/tower_crane.motion","line":{},"column":5,"ok":{},"reason":"{}"{},"t":{:.9f},"q":{{"jib.theta":{},"x":{},"z":{},"hook.theta":{}}}}})",
        name, n, kNames[way], 10 + way, ok, ok ? "" : "hit",
        ok ? "" : R"(,"hit":["tower_crane.hook","wall_7"])", t_, q_[0], q_[1], q_[2], q_[3]);
  }

  Random random_{11};
  int task_ = 0;
  std::size_t last_ = 0;
  double sign_ = 1;
  double t_ = 0;
  std::array<double, 4> q_ = {0, 20, 30, 0};
};

/// Peak memory of this process (MB).
double peak_memory() {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;) {
    double kilobytes = 0;
    if (word == "VmHWM:" && file >> kilobytes) return kilobytes / 1000;
  }
  return 0;
}

void film_of_a_long_run(benchmark::State& state) {
  const auto tries = static_cast<double>(state.range(0));
  double trace_bytes = 0;
  double film_bytes = 0;
  double packed_bytes = 0;
  double memory = 0;
  for (auto each : state) {
    ::malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
    film::FilmWriter writer;
    LongRun run;
    std::chrono::duration<double> time{0};
    trace_bytes = 0;
    writer.line(kHeader);
    for (double done = 0; done < tries; done += kTriesOfATask) {
      const std::vector<std::string> lines = run.task();
      const auto begin = std::chrono::steady_clock::now();
      for (const std::string& line : lines) writer.line(line);
      time += std::chrono::steady_clock::now() - begin;
      for (const std::string& line : lines) trace_bytes += static_cast<double>(line.size() + 1);
    }
    const auto begin = std::chrono::steady_clock::now();
    const film::Film film = writer.finish("");
    const std::string packed = encoding::gzip(film.bytes);
    time += std::chrono::steady_clock::now() - begin;
    film_bytes = static_cast<double>(film.bytes.size());
    packed_bytes = static_cast<double>(packed.size());
    memory = peak_memory();
    state.SetIterationTime(time.count());
  }
  state.counters["trace_MB"] = trace_bytes / 1e6;
  state.counters["film_MB"] = film_bytes / 1e6;
  state.counters["packed_MB"] = packed_bytes / 1e6;
  state.counters["packed_B/try"] = packed_bytes / tries;
  state.counters["memory_MB"] = memory;
  state.counters["try"] = benchmark::Counter(
      tries, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(film_of_a_long_run)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();

}  // namespace
}  // namespace rubicon::bench
