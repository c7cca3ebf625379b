#include "src/fleets/grid/grid_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "src/fleets/grid/cell_graph.hpp"
#include "src/fleets/grid/distances.hpp"

namespace rubicon::grid {

namespace {

std::string text(Cell cell) { return fmt::format("({}, {})", cell.x, cell.y); }

/// To each cell the part of the map that it belongs to, -1 for walls.
std::vector<int> parts_of(const GridMap& map) {
  std::vector<int> part(map.open.size(), -1);
  std::vector<Cell> open;
  int parts = 0;
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.columns; ++x) {
      if (!map.is_open({x, y}) || part[map.index({x, y})] >= 0) continue;
      part[map.index({x, y})] = parts;
      open.push_back({x, y});
      while (!open.empty()) {
        const Cell at = open.back();
        open.pop_back();
        for (const Cell next : std::array<Cell, 4>{
                 {{at.x + 1, at.y}, {at.x - 1, at.y}, {at.x, at.y + 1}, {at.x, at.y - 1}}}) {
          if (!map.is_open(next) || part[map.index(next)] >= 0) continue;
          part[map.index(next)] = parts;
          open.push_back(next);
        }
      }
      ++parts;
    }
  }
  return part;
}

}  // namespace

std::vector<GridFault> faults_of(const GridProblem& problem) {
  std::vector<GridFault> faults;
  const GridMap& map = problem.map;
  const auto cells = static_cast<std::size_t>(std::count(map.open.begin(), map.open.end(), 1));
  const std::size_t agents = problem.agents.size();
  if (agents > kMostAgents || agents * cells > kMostPairs) {
    faults.push_back({-1, -1, false,
                      fmt::format("{} agents on {} open cells; expected up to {} agents, and up to "
                                  "{} as the product of both",
                                  agents, cells, kMostAgents, kMostPairs)});
    return faults;
  }
  const std::vector<int> part = parts_of(map);
  std::vector<int> starts(map.open.size(), -1), goals(map.open.size(), -1);
  for (std::size_t i = 0; i < agents; ++i) {
    const GridAgent& agent = problem.agents[i];
    const int index = static_cast<int>(i);
    bool stands = true;
    for (const bool at_goal : {false, true}) {
      const Cell cell = at_goal ? agent.to : agent.from;
      const char* what = at_goal ? "goal" : "start";
      if (!map.has(cell)) {
        stands = false;
        faults.push_back({index, -1, at_goal,
                          fmt::format("the {} {} of agent '{}' is outside of the map of {} x {}",
                                      what, text(cell), agent.name, map.columns, map.rows)});
      } else if (!map.is_open(cell)) {
        stands = false;
        faults.push_back(
            {index, -1, at_goal,
             fmt::format("the {} {} of agent '{}' is on a wall", what, text(cell), agent.name)});
      } else {
        int& first = (at_goal ? goals : starts)[map.index(cell)];
        if (first >= 0) {
          faults.push_back({index, first, at_goal,
                            fmt::format("agents '{}' and '{}' have the same {} {}",
                                        problem.agents[static_cast<std::size_t>(first)].name,
                                        agent.name, what, text(cell))});
        } else {
          first = index;
        }
      }
    }
    if (stands && part[map.index(agent.from)] != part[map.index(agent.to)]) {
      faults.push_back({index, -1, true,
                        fmt::format("agent '{}' cannot reach {} from {}: walls lie between",
                                    agent.name, text(agent.to), text(agent.from))});
    }
  }
  if (faults.empty() && map.open.size() > static_cast<std::size_t>(kLongestWay)) {
    const CellGraph graph(map);
    for (std::size_t i = 0; i < problem.agents.size(); ++i) {
      const GridAgent& agent = problem.agents[i];
      Distances ways(graph, {graph.id(agent.to)});
      if (ways.of(0, graph.id(agent.from)) < kLongestWay) continue;
      faults.push_back({static_cast<int>(i), -1, true,
                        fmt::format("the way of agent '{}' has {} steps or more; expected fewer",
                                    agent.name, kLongestWay)});
    }
  }
  return faults;
}

}  // namespace rubicon::grid
