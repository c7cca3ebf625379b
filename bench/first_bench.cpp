#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

#include "bench/lacam_paper.hpp"
#include "src/fleets/grid/solve_grid.hpp"

// First solutions for agents on cells: ours beside a LaCAM that was written from its paper, one
// after the other in one run. usage: first_bench AGENTS MAP SCENARIO [MAP SCENARIO ...]

namespace {

namespace grid = rubicon::grid;

std::string file_text(const char* path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

double seconds() {
  timespec time = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Configurations that the baseline may keep.
constexpr std::int64_t kMostNodes = 3'000;

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) {
    std::fprintf(stderr, "usage: first_bench AGENTS MAP SCENARIO [MAP SCENARIO ...]\n");
    return 2;
  }
  const auto agents = static_cast<std::size_t>(std::atoi(arguments[1]));
  std::printf("%-42s %10s %8s %12s %8s\n", "scenario", "ours, ms", "ratio", "paper, ms", "ratio");
  for (int i = 2; i + 1 < count; i += 2) {
    const auto map = grid::read_map(file_text(arguments[i]));
    if (!std::holds_alternative<grid::GridMap>(map)) return 2;
    grid::GridProblem problem{std::get<grid::GridMap>(map), {}};
    const auto trips = grid::read_scenario(file_text(arguments[i + 1]), problem.map, agents);
    if (!std::holds_alternative<std::vector<grid::Trip>>(trips)) return 2;
    for (const grid::Trip& trip : std::get<std::vector<grid::Trip>>(trips)) {
      problem.agents.push_back({std::to_string(problem.agents.size() + 1), trip.from, trip.to});
    }
    grid::GridQuery query;
    // The first solution alone: once to know its work, once with one expansion more.
    query.expansions = 10'000'000;
    query.expansions = grid::solve(problem, query).first_expansions + 1;
    const double begin = seconds();
    const grid::GridSolution ours = grid::solve(problem, query);
    const double between = seconds();
    const auto paper = rubicon::bench::lacam_of_the_paper(problem, 1, kMostNodes);
    const double end = seconds();
    const auto least = static_cast<double>(ours.least_cost);
    const std::string name = arguments[i + 1];
    std::printf("%-42s %10.1f %8.3f %12.1f ", name.substr(name.rfind('/') + 1).c_str(),
                1e3 * (between - begin), static_cast<double>(ours.first_cost) / least,
                1e3 * (end - between));
    if (paper.solved) {
      std::printf("%8.3f\n", static_cast<double>(paper.cost) / least);
    } else {
      std::printf("not solved\n");
    }
    std::fflush(stdout);
  }
  return 0;
}
