#include "src/motion/guides/forbidden_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/guides/guide_machines.hpp"

namespace rubicon::guides {
namespace {

using Q = std::vector<double>;

/// A search from q to the goal that grew these legs.
std::optional<ForbiddenGrid> grid_of(const robot::RobotModel& model, const Q& q, const Q& goal,
                                     std::vector<std::pair<Q, Q>> tree, MotionTests& tests) {
  const GuideSpec spec = default_guide(GuideKind::rrt_connect);
  const robot::Mounting mounting = test::standing(model);
  GuideTask task;
  task.model = &model;
  task.mounting = mounting;
  PlanReport report;
  report.goal = goal;
  report.tree = std::move(tree);
  return sample_forbidden(spec, task, q, report, tests);
}

/// The middle of a cell, as values of the parameters of the grid.
Q middle_of(const ForbiddenGrid& grid, std::size_t cell) {
  const auto columns = static_cast<std::size_t>(grid.cells[0]);
  const auto rows = static_cast<std::size_t>(grid.cells[1]);
  const std::size_t place[2] = {cell % columns, cell / columns % rows};
  Q values;
  for (std::size_t k = 0; k < 2; ++k) {
    const double size = (grid.high[k] - grid.low[k]) / grid.cells[k];
    values.push_back(grid.low[k] + size / 2 + size * static_cast<double>(place[k]));
  }
  if (!grid.layers.empty()) values.push_back(grid.layers[cell / columns / rows]);
  return values;
}

TEST(ForbiddenGrid, TellsOfEachCellWhetherTheRobotMayStandInItsMiddle) {
  // Of two parameters, without layers; y went farther than x, and both near their limits.
  const auto blocked = [](std::span<const double> q) { return q[0] > 3 && q[0] + q[1] < 9; };
  test::PredicateTests tests(blocked);
  const auto grid = grid_of(test::gantry(), {1, 1}, {4, 8}, {{{1, 1}, {4, 8}}}, tests);
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->parameters, (std::vector<int>{0, 1}));
  EXPECT_TRUE(grid->layers.empty());
  EXPECT_EQ(grid->low, (std::array<double, 2>{0, 0}));
  EXPECT_EQ(grid->high, (std::array<double, 2>{5, 9.1}));
  ASSERT_EQ(grid->blocked.size(), static_cast<std::size_t>(grid->cells[0] * grid->cells[1]));
  int count = 0;
  for (std::size_t cell = 0; cell < grid->blocked.size(); ++cell) {
    EXPECT_EQ(grid->blocked[cell], blocked(middle_of(*grid, cell))) << cell;
    count += grid->blocked[cell] ? 1 : 0;
  }
  EXPECT_GT(count, 0);
}

TEST(ForbiddenGrid, OfAVehicleIsItsPlaceInLayersOfItsHeading) {
  const auto blocked = [](std::span<const double> q) {
    return std::fabs(q[0] - 5) < 1 + std::fabs(q[2]) / 90 && q[1] < 3;
  };
  test::PredicateTests tests(blocked);
  const Q start = {1, 2, 7};
  const Q goal = {9, 2.5, -170};
  const auto grid = grid_of(test::vehicle(), start, goal,
                            {{{1, 2, 7}, {3, 6, 170}}, {{3, 6, 170}, {9, 2.5, -170}}}, tests);
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->parameters, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(grid->q, start);
  // It turned over 180 degrees: layers all round, and those of start and goal.
  EXPECT_EQ(grid->layers.front(), -180);
  EXPECT_EQ(grid->layers.back(), 180);
  EXPECT_TRUE(std::is_sorted(grid->layers.begin(), grid->layers.end()));
  for (const double value : {7.0, -170.0}) {
    EXPECT_NE(std::find(grid->layers.begin(), grid->layers.end(), value), grid->layers.end());
  }
  ASSERT_EQ(grid->blocked.size(),
            static_cast<std::size_t>(grid->cells[0] * grid->cells[1]) * grid->layers.size());
  for (std::size_t cell = 0; cell < grid->blocked.size(); ++cell) {
    ASSERT_EQ(grid->blocked[cell], blocked(middle_of(*grid, cell))) << cell;
  }
}

TEST(ForbiddenGrid, HasTheParametersThatChangedMostAndTheOthersAsTheyWere) {
  std::vector<Q> asked;
  test::PredicateTests tests([&](std::span<const double> q) {
    asked.emplace_back(q.begin(), q.end());
    return false;
  });
  // Swing, boom, stick and bucket: the stick changes least.
  const Q start = {0, 30, 100, 60};
  const auto grid = grid_of(test::excavator(), start, {20, 0, 101, 100}, {}, tests);
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->parameters, (std::vector<int>{3, 1, 0}));
  ASSERT_EQ(asked.size(), grid->blocked.size());
  for (const Q& q : asked) EXPECT_EQ(q[2], start[2]);
}

}  // namespace
}  // namespace rubicon::guides
