#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

#include "bench/pibt_jobs.hpp"
#include "src/fleets/grid/job_traffic.hpp"

// Vehicles that do jobs on cells, ours beside PIBT by its published rule: jobs per hour with ticks
// of a second, and what planning takes for each job. The jobs are the same, and so is who gets them
// when. usage: jobs_bench MAP SCENARIO AGENTS JOBS [LATE LATE_TICKS [WINDOW [EXPANSIONS_PER_JOB]]]

namespace {

namespace grid = rubicon::grid;

std::string text_of(const char* path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

double processor_seconds() {
  timespec time = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double per_hour(std::size_t jobs, int ticks) { return 3600.0 * static_cast<double>(jobs) / ticks; }

/// Runs to the end. Prints the planning of a tick over the jobs that were given out in it, or
/// since the last tick with any: the median and the mean over jobs.
template <typename Run, typename Given>
void measure(const char* name, Run& run, const Given& delivered) {
  std::vector<double> by_job;
  std::size_t before = 0;
  double since = 0;
  double all = 0;
  for (bool goes_on = true; goes_on;) {
    const double begin = processor_seconds();
    goes_on = run.advance();
    const double took = processor_seconds() - begin;
    since += took;
    all += took;
    const std::size_t jobs = delivered() - before;
    before += jobs;
    for (std::size_t i = 0; i < jobs; ++i) by_job.push_back(since / static_cast<double>(jobs));
    if (jobs > 0) since = 0;
  }
  std::sort(by_job.begin(), by_job.end());
  if (by_job.empty()) return;
  std::printf("%-6s planning per job: median %.2f ms, mean %.2f ms, 95 %% %.2f ms\n", name,
              1e3 * by_job[by_job.size() / 2], 1e3 * all / static_cast<double>(by_job.size()),
              1e3 * by_job[by_job.size() * 95 / 100]);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 5) {
    std::fprintf(stderr,
                 "usage: jobs_bench MAP SCENARIO AGENTS JOBS [LATE LATE_TICKS [WINDOW "
                 "[EXPANSIONS_PER_JOB]]]\n");
    return 2;
  }
  const auto number = [&](int i, double otherwise) {
    return i < count ? std::atof(arguments[i]) : otherwise;
  };
  const auto map = grid::read_map(text_of(arguments[1]));
  if (!std::holds_alternative<grid::GridMap>(map)) return 2;
  grid::GridProblem problem{std::get<grid::GridMap>(map), {}};
  const auto trips = grid::read_scenario(text_of(arguments[2]), problem.map,
                                         static_cast<std::size_t>(number(3, 0)));
  if (!std::holds_alternative<std::vector<grid::Trip>>(trips)) return 2;
  for (const grid::Trip& trip : std::get<std::vector<grid::Trip>>(trips)) {
    problem.agents.push_back({std::to_string(problem.agents.size() + 1), trip.from, trip.to});
  }
  const std::vector<grid::GridJob> jobs =
      grid::draw_jobs(problem, static_cast<std::size_t>(number(4, 0)), 0, 1);
  grid::JobQuery query;
  query.late = number(5, 0);
  query.late_ticks = static_cast<int>(number(6, 0));
  query.window = static_cast<int>(number(7, query.window));
  query.expansions =
      static_cast<std::int64_t>(number(8, 0)) * static_cast<std::int64_t>(jobs.size());
  {
    grid::JobTraffic ours(problem, jobs, query);
    measure("ours", ours, [&] { return ours.board().delivered(); });
    const grid::JobsResult result = ours.take_result();
    const double vehicles = static_cast<double>(problem.agents.size());
    std::printf(
        "ours   %d ticks, %.0f jobs per hour, %s; a vehicle moved %.0f ticks, stood %.0f, waited "
        "%.0f; %.2f %% over the shortest ways and the own late moves; %d ticks pressed; %.0f "
        "expansions per job\n",
        result.ticks, per_hour(jobs.size(), result.ticks),
        result.end == grid::JobsResult::End::done ? "all done" : "standstill",
        static_cast<double>(result.moves) / vehicles, static_cast<double>(result.stood) / vehicles,
        static_cast<double>(result.waited) / vehicles,
        100 * (static_cast<double>(result.with_job) /
                   static_cast<double>(result.least + result.stood) -
               1),
        result.pressed, static_cast<double>(result.expansions) / static_cast<double>(jobs.size()));
  }
  rubicon::bench::PibtJobs pibt(problem, jobs, 1);
  measure("pibt", pibt, [&] { return pibt.board().delivered(); });
  std::printf("pibt   %d ticks, %.0f jobs per hour, %s\n", pibt.ticks(),
              per_hour(pibt.board().delivered(), pibt.ticks()),
              pibt.board().is_done() ? "all done" : "standstill");
  return 0;
}
