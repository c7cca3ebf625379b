#include <cstdint>
#include <string>

#include "src/fleets/grid/solve_grid.hpp"

/// Any bytes as a map and, behind a line "scenario", a scenario: no crash, no hang; what is right
/// is solved with a small budget.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace grid = rubicon::grid;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = bytes.find("scenario\n");
  const auto map = grid::read_map(bytes.substr(0, cut));
  if (std::holds_alternative<grid::TextFault>(map) || cut == std::string::npos) return 0;
  grid::GridProblem problem{std::get<grid::GridMap>(map), {}};
  const auto trips = grid::read_scenario(bytes.substr(cut + 9), problem.map, 1000);
  if (std::holds_alternative<grid::TextFault>(trips)) return 0;
  for (const grid::Trip& trip : std::get<0>(trips)) {
    problem.agents.push_back({std::to_string(problem.agents.size()), trip.from, trip.to});
  }
  if (!grid::faults_of(problem).empty()) return 0;
  grid::GridQuery query;
  query.expansions = 2000;
  grid::solve(problem, query);
  return 0;
}
