#include "src/fleets/grid/solve_grid.hpp"

#include <algorithm>

#include "src/fleets/grid/improve.hpp"
#include "src/fleets/grid/lacam.hpp"

namespace rubicon::grid {

namespace {

/// The way of one agent, until it is at its goal for good.
CellWay way_of(const std::vector<Configuration>& steps, std::size_t agent) {
  CellWay way;
  for (const Configuration& step : steps) way.push_back(step[agent]);
  while (way.size() > 1 && way[way.size() - 2] == way.back()) way.pop_back();
  return way;
}

std::int64_t cost_of(const std::vector<CellWay>& ways) {
  std::int64_t cost = 0;
  for (const CellWay& way : ways) cost += static_cast<std::int64_t>(way.size()) - 1;
  return cost;
}

}  // namespace

GridSolution solve(const GridProblem& problem, const GridQuery& query) {
  const CellGraph graph(problem.map);
  Configuration starts, goals;
  for (const GridAgent& agent : problem.agents) {
    starts.push_back(graph.id(agent.from));
    goals.push_back(graph.id(agent.to));
  }
  Distances distances(graph, goals);
  GridSolution solution;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    solution.shortest.push_back(distances.of(static_cast<int>(i), starts[i]));
    solution.least_cost += solution.shortest.back();
  }
  LacamResult first = lacam(graph, distances, starts, goals, query.seed,
                            std::min(query.expansions, kMostFirstExpansions));
  solution.expansions = solution.first_expansions = first.expansions;
  if (first.end != LacamResult::End::solved) {
    solution.end = first.end == LacamResult::End::exhausted ? GridSolution::End::no_solution
                                                            : GridSolution::End::out_of_work;
    solution.away = std::move(first.away);
    return solution;
  }
  solution.end = GridSolution::End::solved;
  std::vector<CellWay> ways;
  for (std::size_t i = 0; i < starts.size(); ++i) ways.push_back(way_of(first.steps, i));
  first.steps.clear();
  solution.first_cost = cost_of(ways);
  solution.expansions += improve(graph, distances, ways, solution.least_cost, query.seed,
                                 query.expansions - solution.first_expansions);
  solution.cost = cost_of(ways);
  for (const CellWay& way : ways) {
    std::vector<Cell>& cells = solution.ways.emplace_back();
    for (const CellId id : way) cells.push_back(graph.cell(id));
    solution.makespan = std::max(solution.makespan, static_cast<int>(way.size()) - 1);
  }
  return solution;
}

}  // namespace rubicon::grid
