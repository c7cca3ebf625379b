#include "src/fleets/grid/job_traffic.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <set>

#include "src/fleets/grid/keep_order.hpp"

namespace rubicon::grid {
namespace {

/// A map with walls here and there.
GridProblem random_floor(std::uint64_t seed, int side, int walls, std::size_t agents) {
  RandomBits random(seed);
  GridProblem problem;
  problem.map.columns = problem.map.rows = side;
  for (int i = 0; i < side * side; ++i) {
    problem.map.open.push_back(random.below(100) < static_cast<std::size_t>(walls) ? 0 : 1);
  }
  const auto any = [&] {
    const int x = static_cast<int>(random.below(static_cast<std::size_t>(side)));
    return Cell{x, static_cast<int>(random.below(static_cast<std::size_t>(side)))};
  };
  for (int tries = 0; tries < 20'000 && problem.agents.size() < agents; ++tries) {
    const Cell from = any();
    problem.agents.push_back({"a" + std::to_string(problem.agents.size()), from, any()});
    const std::vector<GridJob> to_others = {{"j", problem.agents.front().from, from, 0}};
    if (!faults_of(problem).empty() || !faults_of_jobs(problem, to_others).empty()) {
      problem.agents.pop_back();
    }
  }
  return problem;
}

/// What is wrong with a result, by walking all of it.
std::string fault_of(const GridProblem& problem, const std::vector<GridJob>& jobs,
                     const JobsResult& result) {
  std::vector<Cell> at_now;
  std::vector<std::vector<Cell>> at_tick;
  for (const GridAgent& agent : problem.agents) at_now.push_back(agent.from);
  at_tick.push_back(at_now);
  for (int tick = 0; tick < result.ticks; ++tick) {
    const std::vector<Cell> before = at_now;
    std::map<std::pair<int, int>, std::size_t> here;
    for (std::size_t i = 0; i < at_now.size(); ++i) {
      const char move = result.ways[i][static_cast<std::size_t>(tick)];
      at_now[i].x += move == 'r' ? 1 : move == 'l' ? -1 : 0;
      at_now[i].y += move == 'd' ? 1 : move == 'u' ? -1 : 0;
      if (!problem.map.is_open(at_now[i])) return "wall";
      if (!here.emplace(std::pair(at_now[i].x, at_now[i].y), i).second) return "two in a cell";
    }
    for (std::size_t i = 0; i < at_now.size(); ++i) {
      const auto other = here.find({before[i].x, before[i].y});
      if (other == here.end() || other->second == i) continue;
      if (before[other->second] == at_now[i]) return "through each other";
    }
    at_tick.push_back(at_now);
  }
  for (const Stand& stand : result.stands) {
    const std::string& way = result.ways[static_cast<std::size_t>(stand.vehicle)];
    if (way[static_cast<std::size_t>(stand.tick) - 1] == 'w') return "late without a move";
    for (int k = 0; k < stand.ticks && stand.tick + k < result.ticks; ++k) {
      if (way[static_cast<std::size_t>(stand.tick + k)] != 'w') return "moves and is late";
    }
  }
  std::map<int, std::set<int>> busy;  // by vehicle: ticks in which it has a job
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const JobRecord& record = result.records[i];
    if (record.delivered < 0) return "not delivered";
    if (record.taken < jobs[i].arrives || record.picked < record.taken) return "too early";
    const auto place = [&](int tick) {
      return at_tick[static_cast<std::size_t>(tick)][static_cast<std::size_t>(record.vehicle)];
    };
    if (place(record.picked) != jobs[i].from) return "picked elsewhere";
    if (place(record.delivered) != jobs[i].to) return "delivered elsewhere";
    for (int tick = record.taken; tick < record.delivered; ++tick) {
      if (!busy[record.vehicle].insert(tick).second) return "two jobs at a time";
    }
  }
  return "";
}

TEST(JobTraffic, OneDoesItsJobs) {
  GridProblem problem;
  problem.map = {5, 1, {1, 1, 1, 1, 1}};
  problem.agents = {{"a", {0, 0}, {0, 0}}};
  const std::vector<GridJob> jobs = {{"far", {4, 0}, {2, 0}, 3}, {"near", {1, 0}, {3, 0}, 0}};
  const JobsResult result = do_jobs(problem, jobs, {});
  ASSERT_EQ(result.end, JobsResult::End::done);
  EXPECT_EQ(result.ways[0], "rrrrll");
  EXPECT_EQ(result.records[1].picked, 1);
  EXPECT_EQ(result.records[1].delivered, 3);
  EXPECT_EQ(result.records[0].taken, 3);
  EXPECT_EQ(result.records[0].delivered, 6);
  EXPECT_EQ(result.least, 6);
}

TEST(JobTraffic, WithoutAWaySaysWhoStandsStill) {
  // Two in a lane of cells want past each other.
  GridProblem problem;
  problem.map = {4, 1, {1, 1, 1, 1}};
  problem.agents = {{"a", {0, 0}, {0, 0}}, {"b", {3, 0}, {3, 0}}};
  const std::vector<GridJob> jobs = {{"j", {0, 0}, {3, 0}, 0}, {"k", {3, 0}, {0, 0}, 0}};
  const JobsResult result = do_jobs(problem, jobs, {});
  EXPECT_EQ(result.end, JobsResult::End::standstill);
  EXPECT_EQ(result.stuck, (std::vector<int>{0, 1}));
}

TEST(JobTraffic, WhatIsWrongWithJobs) {
  GridProblem problem;
  problem.map = {5, 1, {1, 1, 0, 1, 0}};
  problem.agents = {{"a", {0, 0}, {0, 0}}};
  const auto faults = faults_of_jobs(problem, {{"j", {1, 0}, {3, 0}, 0}, {"k", {2, 0}, {9, 0}, 0}});
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(faults[0].message,
            "job 'j' ends at (3, 0), which no agent can reach: walls lie between");
  EXPECT_EQ(faults[1].message, "job 'k' begins at (2, 0), which is on a wall");
  EXPECT_EQ(faults[2].message, "job 'k' ends at (9, 0), which is outside of the map of 5 x 1");
  problem.agents.push_back({"b", {3, 0}, {3, 0}});
  ASSERT_EQ(faults_of_jobs(problem, {{"j", {0, 0}, {1, 0}, 0}}).size(), 1U);
}

/// A ring that turns is not held up, and who is held up comes in the same order.
TEST(KeepOrder, KeepsTheOrderOfEachCell) {
  // Cells 0 1 / 2 3 in a square; three go round it, all at the same time.
  std::vector<WindowWay> ways = {{0, 1, 3}, {1, 3, 2}, {3, 2, 0}, {2, 0, 1}};
  KeepOrder keep(4);
  keep.retime(ways, {0, 0, 0, 0}, {0, 0, 2, 0}, 5);
  // Vehicle 2 stands for two ticks, and so do all.
  EXPECT_EQ(ways[0], (WindowWay{0, 0, 0, 1, 3, 3}));
  EXPECT_EQ(ways[2], (WindowWay{3, 3, 3, 2, 0, 0}));
  ways = {{0, 1, 1, 1}, {2, 2, 0, 1}};
  ways[0] = {0, 1, 3, 3};
  ways[1] = {2, 0, 1, 1};
  keep.retime(ways, {0, 0}, {1, 0}, 4);
  EXPECT_EQ(ways[0], (WindowWay{0, 0, 1, 3, 3}));
  EXPECT_EQ(ways[1], (WindowWay{2, 2, 0, 1, 1}));
}

/// Executions with moves that end late by chance. RUBICON_RANDOM_PLANS sets how many.
TEST(JobTraffic, ManyRandomFloors) {
  const char* wanted = std::getenv("RUBICON_RANDOM_PLANS");
  const std::uint64_t runs = wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 120;
  int late = 0;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    const int side = 6 + static_cast<int>(seed % 5);
    const GridProblem problem = random_floor(seed, side, 10, 2 + seed % 9);
    JobQuery query;
    query.seed = seed;
    query.window = 5 + static_cast<int>(seed % 26);
    query.expansions = 20'000;
    if (seed % 3 != 0) {
      query.late = 0.05 * static_cast<double>(1 + seed % 4);
      query.late_ticks = 20;
    }
    const double interval = seed % 2 == 0 ? 0 : 2.5;
    const auto jobs = draw_jobs(problem, 3 * problem.agents.size(), interval, seed);
    if (jobs.empty()) continue;
    const JobsResult result = do_jobs(problem, jobs, query);
    ASSERT_EQ(result.end, JobsResult::End::done) << seed;
    ASSERT_EQ(fault_of(problem, jobs, result), "") << seed;
    late += result.stands.empty() ? 0 : 1;
  }
  EXPECT_GT(late, static_cast<int>(runs) / 2);
}

/// Racks of eight cells, with aisles of one cell between them, and vehicles here and there.
GridProblem store_floor(std::size_t agents) {
  GridProblem problem;
  problem.map.columns = 40;
  problem.map.rows = 21;
  for (int i = 0; i < 40 * 21; ++i) {
    const int x = i % 40, y = i / 40;
    const bool is_rack = y % 2 == 1 && x > 1 && x < 38 && x % 9 != 0;
    problem.map.open.push_back(is_rack ? 0 : 1);
  }
  for (std::size_t i = 0; i < agents; ++i) {
    const Cell cell{static_cast<int>(7 * i % 40), 2 * static_cast<int>(i % 11)};
    problem.agents.push_back({"a" + std::to_string(i), cell, cell});
  }
  return problem;
}

/// What vehicles wait for because of late ones: beyond the shortest ways and their own late moves.
TEST(JobTraffic, LateMovesHoldOthersUpLittle) {
  const GridProblem problem = store_floor(20);
  ASSERT_TRUE(faults_of(problem).empty());
  const auto jobs = draw_jobs(problem, 300, 0, 5);
  JobQuery query;
  for (const double late : {0.0, 0.05}) {
    query.late = late;
    query.late_ticks = late > 0 ? 20 : 0;
    const JobsResult result = do_jobs(problem, jobs, query);
    ASSERT_EQ(result.end, JobsResult::End::done);
    ASSERT_EQ(fault_of(problem, jobs, result), "");
    const auto own = static_cast<double>(result.least + result.stood);
    EXPECT_LT(static_cast<double>(result.with_job), (late > 0 ? 1.15 : 1.05) * own);
  }
}

TEST(JobTraffic, SameInputSameWays) {
  const GridProblem problem = random_floor(7, 12, 15, 20);
  const auto jobs = draw_jobs(problem, 60, 0.5, 3);
  JobQuery query;
  query.late = 0.1;
  query.late_ticks = 5;
  EXPECT_EQ(do_jobs(problem, jobs, query).ways, do_jobs(problem, jobs, query).ways);
}

}  // namespace
}  // namespace rubicon::grid
