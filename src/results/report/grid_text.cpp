#include "src/results/report/grid_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "src/results/report/grid_map_json.hpp"

namespace rubicon::report {

namespace {

using grid::Cell;
using grid::GridSolution;
using End = GridSolution::End;

/// Agents that a table names.
constexpr std::size_t kNamed = 10;

char letter(Cell from, Cell to) {
  if (to.x > from.x) return 'r';
  if (to.x < from.x) return 'l';
  if (to.y > from.y) return 'd';
  return to.y < from.y ? 'u' : 'w';
}

double ratio(std::int64_t cost, const GridSolution& solution) {
  return solution.least_cost == 0
             ? 1
             : static_cast<double>(cost) / static_cast<double>(solution.least_cost);
}

const char* outcome(End end) {
  if (end == End::solved) return "solved";
  return end == End::no_solution ? "no_solution" : "out_of_expansions";
}

std::string away_text(const interpreter::GridSpec& spec, const GridSolution& solution) {
  std::string text;
  for (std::size_t i = 0; i < solution.away.size() && i < kNamed; ++i) {
    text +=
        (i == 0 ? "" : ", ") + spec.problem.agents[static_cast<std::size_t>(solution.away[i])].name;
  }
  if (solution.away.size() > kNamed) {
    text += fmt::format(" and {} more", solution.away.size() - kNamed);
  }
  return text;
}

}  // namespace

std::string grid_table(const interpreter::GridSpec& spec, const GridSolution& solution) {
  std::string text =
      fmt::format("network {}: {} agents on {} x {} cells\n", spec.name, spec.problem.agents.size(),
                  spec.problem.map.columns, spec.problem.map.rows);
  if (solution.end != End::solved) {
    text += solution.end == End::no_solution
                ? std::string("no solution: all that the agents can do was tried\n")
                : fmt::format("not solved with {} expansions; more may solve it\n",
                              solution.expansions);
    return text +
           "not at their goals where most were nearest to theirs: " + away_text(spec, solution) +
           "\n";
  }
  text += fmt::format("cost       {} ticks, summed over the agents; at least {}; ratio {:.4f}\n",
                      solution.cost, solution.least_cost, ratio(solution.cost, solution));
  text += fmt::format("makespan   {} ticks; at least {}\n", solution.makespan,
                      solution.shortest.empty()
                          ? 0
                          : *std::max_element(solution.shortest.begin(), solution.shortest.end()));
  text +=
      fmt::format("first      cost {}, ratio {:.4f}, after {} expansions\n", solution.first_cost,
                  ratio(solution.first_cost, solution), solution.first_expansions);
  return text + fmt::format("work       {} expansions\n", solution.expansions);
}

std::string grid_csv(const interpreter::GridSpec& spec, const GridSolution& solution) {
  std::string text = "agent,from_x,from_y,to_x,to_y,shortest,cost\n";
  for (std::size_t i = 0; i < spec.problem.agents.size(); ++i) {
    const grid::GridAgent& agent = spec.problem.agents[i];
    text += fmt::format(
        "{},{},{},{},{},{},{}\n", agent.name, agent.from.x, agent.from.y, agent.to.x, agent.to.y,
        solution.shortest[i],
        solution.end == End::solved ? std::to_string(solution.ways[i].size() - 1) : std::string());
  }
  return text;
}

nlohmann::ordered_json grid_map_json(const interpreter::GridSpec& spec) {
  const grid::GridMap& map = spec.problem.map;
  auto rows = nlohmann::ordered_json::array();
  for (int y = 0; y < map.rows; ++y) {
    std::string row;
    for (int x = 0; x < map.columns; ++x) row += map.is_open({x, y}) ? '.' : '@';
    rows.push_back(row);
  }
  return {{"file", spec.map}, {"rows", std::move(rows)}};
}

std::string grid_json(const interpreter::GridSpec& spec, const GridSolution& solution) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["format"] = "rubicon-grid";
  json["version"] = 1;
  json["network"] = spec.name;
  json["outcome"] = outcome(solution.end);
  if (solution.end == End::solved) {
    json["cost"] = solution.cost;
    json["makespan"] = solution.makespan;
    json["first_cost"] = solution.first_cost;
  }
  json["least_cost"] = solution.least_cost;
  json["expansions"] = solution.expansions;
  json["first_expansions"] = solution.first_expansions;
  json["budget"] = spec.query.expansions;
  json["seed"] = spec.query.seed;
  json["map"] = grid_map_json(spec);
  if (!spec.scenario.empty()) json["scenario"] = spec.scenario;
  Json agents = Json::array();
  for (std::size_t i = 0; i < spec.problem.agents.size(); ++i) {
    const grid::GridAgent& agent = spec.problem.agents[i];
    Json each = {{"name", agent.name},
                 {"from", {agent.from.x, agent.from.y}},
                 {"to", {agent.to.x, agent.to.y}},
                 {"shortest", solution.shortest[i]}};
    if (solution.end == End::solved) {
      const std::vector<Cell>& way = solution.ways[i];
      std::string letters;
      for (std::size_t tick = 1; tick < way.size(); ++tick) {
        letters += letter(way[tick - 1], way[tick]);
      }
      each["way"] = letters;
    }
    agents.push_back(std::move(each));
  }
  json["agents"] = std::move(agents);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rubicon::report
