#include "src/fleets/grid/solve_grid.hpp"

#include <gtest/gtest.h>

#include <map>
#include <queue>

#include "src/fleets/grid/random_bits.hpp"

namespace rubicon::grid {
namespace {

GridMap drawn_map(const std::vector<std::string>& rows) {
  GridMap map;
  map.rows = static_cast<int>(rows.size());
  map.columns = static_cast<int>(rows.front().size());
  for (const std::string& row : rows) {
    for (const char c : row) map.open.push_back(c == '.' ? 1 : 0);
  }
  return map;
}

/// Where an agent is at a tick.
Cell place(const std::vector<Cell>& way, std::size_t tick) {
  return way[std::min(tick, way.size() - 1)];
}

/// What is wrong with ways, by looking at all pairs at all ticks.
std::string fault_of(const GridProblem& problem, const GridSolution& solution) {
  std::int64_t cost = 0;
  for (std::size_t i = 0; i < problem.agents.size(); ++i) {
    const std::vector<Cell>& way = solution.ways[i];
    if (way.front() != problem.agents[i].from) return "start";
    if (way.back() != problem.agents[i].to) return "goal";
    if (way.size() > 1 && way[way.size() - 2] == way.back()) return "waits at the end";
    for (std::size_t t = 0; t < way.size(); ++t) {
      if (!problem.map.is_open(way[t])) return "wall";
      if (t > 0 && std::abs(way[t].x - way[t - 1].x) + std::abs(way[t].y - way[t - 1].y) > 1) {
        return "jump";
      }
    }
    cost += static_cast<std::int64_t>(way.size()) - 1;
    for (std::size_t j = 0; j < i; ++j) {
      const std::vector<Cell>& other = solution.ways[j];
      for (std::size_t t = 0; t < std::max(way.size(), other.size()); ++t) {
        if (place(way, t) == place(other, t)) return "vertex";
        if (t > 0 && place(way, t) == place(other, t - 1) && place(way, t - 1) == place(other, t)) {
          return "edge";
        }
      }
    }
  }
  return cost == solution.cost ? "" : "cost";
}

/// Whether two agents can get to their goals at all, and the least cost: all that they can do.
/// Their cost is counted as long as somebody is not at its goal for good.
std::int64_t least_cost_of_two(const GridProblem& problem) {
  const GridMap& map = problem.map;
  // A state: both cells, and of each whether it has stopped for good.
  using State = std::array<int, 6>;
  std::map<State, std::int64_t> best;
  using Entry = std::pair<std::int64_t, State>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const GridAgent &a = problem.agents[0], &b = problem.agents[1];
  open.push({0, {a.from.x, a.from.y, b.from.x, b.from.y, 0, 0}});
  const std::array<Cell, 5> moves = {{{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  while (!open.empty()) {
    const auto [cost, s] = open.top();
    open.pop();
    if (!best.emplace(s, cost).second) continue;
    if (s[4] != 0 && s[5] != 0) return cost;
    const Cell pa{s[0], s[1]}, pb{s[2], s[3]};
    if (s[4] == 0 && pa == a.to) open.push({cost, {s[0], s[1], s[2], s[3], 1, s[5]}});
    if (s[5] == 0 && pb == b.to) open.push({cost, {s[0], s[1], s[2], s[3], s[4], 1}});
    for (const Cell ma : moves) {
      if (s[4] != 0 && (ma.x != 0 || ma.y != 0)) continue;
      const Cell na{pa.x + ma.x, pa.y + ma.y};
      if (!map.is_open(na)) continue;
      for (const Cell mb : moves) {
        if (s[5] != 0 && (mb.x != 0 || mb.y != 0)) continue;
        const Cell nb{pb.x + mb.x, pb.y + mb.y};
        if (!map.is_open(nb) || na == nb || (na == pb && nb == pa)) continue;
        open.push({cost + (s[4] == 0 ? 1 : 0) + (s[5] == 0 ? 1 : 0),
                   {na.x, na.y, nb.x, nb.y, s[4], s[5]}});
      }
    }
  }
  return -1;
}

GridProblem random_problem(std::uint64_t seed, int side, int walls, std::size_t agents) {
  RandomBits random(seed);
  GridProblem problem;
  problem.map = drawn_map(std::vector<std::string>(
      static_cast<std::size_t>(side), std::string(static_cast<std::size_t>(side), '.')));
  for (auto& open : problem.map.open) {
    if (random.below(100) < static_cast<std::size_t>(walls)) open = 0;
  }
  for (int tries = 0; tries < 10000 && problem.agents.size() < agents; ++tries) {
    const auto any = [&] {
      return Cell{static_cast<int>(random.below(static_cast<std::size_t>(side))),
                  static_cast<int>(random.below(static_cast<std::size_t>(side)))};
    };
    problem.agents.push_back({"a" + std::to_string(problem.agents.size()), any(), any()});
    if (!faults_of(problem).empty()) problem.agents.pop_back();
  }
  return problem;
}

TEST(SolveGrid, TwoPassEachOtherByASiding) {
  // One lane, one siding in the middle.
  const GridProblem problem{drawn_map({"@@@.@@@", "......."}),
                            {{"a", {0, 1}, {6, 1}}, {"b", {6, 1}, {0, 1}}}};
  GridQuery query;
  query.expansions = 20000;
  const GridSolution solution = solve(problem, query);
  ASSERT_EQ(solution.end, GridSolution::End::solved);
  EXPECT_EQ(fault_of(problem, solution), "");
  EXPECT_EQ(solution.least_cost, 12);
  EXPECT_EQ(solution.cost, least_cost_of_two(problem));
}

TEST(SolveGrid, SaysThatThereIsNoSolution) {
  const GridProblem problem{drawn_map({"..."}), {{"a", {0, 0}, {2, 0}}, {"b", {2, 0}, {0, 0}}}};
  const GridSolution solution = solve(problem, {});
  EXPECT_EQ(solution.end, GridSolution::End::no_solution);
  EXPECT_FALSE(solution.away.empty());
  EXPECT_TRUE(solution.ways.empty());
}

TEST(SolveGrid, EndsWithItsBudget) {
  // A full map but for one cell, in an order that cannot be reached.
  const GridProblem problem{drawn_map({"...", "...", "..."}),
                            {{"a", {0, 0}, {1, 0}},
                             {"b", {1, 0}, {0, 0}},
                             {"c", {2, 0}, {2, 0}},
                             {"d", {0, 1}, {0, 1}},
                             {"e", {1, 1}, {1, 1}},
                             {"f", {2, 1}, {2, 1}},
                             {"g", {0, 2}, {0, 2}},
                             {"h", {1, 2}, {1, 2}}}};
  GridQuery query;
  query.expansions = 500;
  const GridSolution solution = solve(problem, query);
  EXPECT_NE(solution.end, GridSolution::End::no_solution);
  EXPECT_LE(solution.expansions, 520);
}

TEST(SolveGrid, RefusesWaysThatAreTooLong) {
  GridProblem problem{drawn_map({std::string(static_cast<std::size_t>(kLongestWay) + 1, '.')}), {}};
  problem.agents.push_back({"a", {0, 0}, {kLongestWay - 1, 0}});
  EXPECT_TRUE(faults_of(problem).empty());
  problem.agents[0].to.x = kLongestWay;
  ASSERT_EQ(faults_of(problem).size(), 1U);
  EXPECT_EQ(faults_of(problem)[0].message,
            "the way of agent 'a' has 65000 steps or more; expected fewer");
}

TEST(SolveGrid, NobodyToMove) {
  const GridSolution solution = solve({drawn_map({"..."}), {}}, {});
  EXPECT_EQ(solution.end, GridSolution::End::solved);
  EXPECT_EQ(solution.cost, 0);
}

/// Against all that two agents can do: solved where they can be, never below the least cost, and
/// with a budget mostly at it.
TEST(SolveGrid, TwoAgentsAgainstAllThatTheyCanDo) {
  int solvable = 0, optimal = 0, impossible = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const GridProblem problem = random_problem(seed, 4, 45, 2);
    if (problem.agents.size() < 2) continue;
    const std::int64_t least = least_cost_of_two(problem);
    GridQuery query;
    query.expansions = 20000;
    query.seed = seed;
    const GridSolution solution = solve(problem, query);
    if (least < 0) {
      ++impossible;
      EXPECT_EQ(solution.end, GridSolution::End::no_solution) << seed;
      continue;
    }
    ++solvable;
    ASSERT_EQ(solution.end, GridSolution::End::solved) << seed;
    EXPECT_EQ(fault_of(problem, solution), "") << seed;
    EXPECT_GE(solution.cost, least) << seed;
    EXPECT_LE(solution.cost, solution.first_cost) << seed;
    optimal += solution.cost == least ? 1 : 0;
  }
  EXPECT_GT(solvable, 100);
  EXPECT_GT(impossible, 2);
  EXPECT_GE(optimal * 10, solvable * 9);
}

TEST(SolveGrid, ManyAgentsOnRandomMaps) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const GridProblem problem = random_problem(seed, 12, 15, 20 + 3 * seed);
    GridQuery query;
    query.expansions = 100000;
    const GridSolution solution = solve(problem, query);
    ASSERT_EQ(solution.end, GridSolution::End::solved) << seed;
    EXPECT_EQ(fault_of(problem, solution), "") << seed;
    EXPECT_LE(solution.cost, solution.first_cost);
    EXPECT_GE(solution.cost, solution.least_cost);
  }
}

TEST(SolveGrid, SameInputSameWays) {
  const GridProblem problem = random_problem(5, 10, 10, 30);
  GridQuery query;
  query.expansions = 50000;
  EXPECT_EQ(solve(problem, query).ways, solve(problem, query).ways);
}

}  // namespace
}  // namespace rubicon::grid
