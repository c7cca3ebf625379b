// Who waits for whom as a graph: which tasks can never go on, one cycle of them, and its text.

#include "src/simulation/taskplan/wait_graph.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace rubicon::taskplan {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Graph = std::map<int, WaitSet>;

WaitTarget target(std::vector<int> by) {
  WaitTarget each;
  each.by = std::move(by);
  return each;
}

/// Waits for all of the targets.
WaitSet all(std::vector<std::vector<int>> targets) {
  WaitSet waits;
  for (auto &by : targets) waits.targets.push_back(target(std::move(by)));
  return waits;
}

WaitSet any(std::vector<std::vector<int>> targets) {
  WaitSet waits = all(std::move(targets));
  waits.any = true;
  return waits;
}

/// Tasks that the graph does not name are over.
WaitsOf in(const Graph &graph) {
  return [&graph](int task) {
    const auto found = graph.find(task);
    return found == graph.end() ? std::nullopt : std::optional(found->second);
  };
}

std::vector<int> deadlocked(const Graph &graph, std::vector<int> roots) {
  std::vector<int> tasks;
  for (const auto &[task, waits] : deadlocked_from(std::move(roots), in(graph))) {
    tasks.push_back(task);
  }
  return tasks;
}

TEST(WaitGraph, TwoThatWaitForEachOtherAreDeadlocked) {
  EXPECT_THAT(deadlocked({{1, all({{2}})}, {2, all({{1}})}}, {1}), ElementsAre(1, 2));
}

TEST(WaitGraph, WhoWaitsForADeadlockIsDeadlockedToo) {
  const Graph graph = {{1, all({{2}})}, {2, all({{1}})}, {3, all({{1}})}};
  EXPECT_THAT(deadlocked(graph, {3}), ElementsAre(1, 2, 3));
}

TEST(WaitGraph, WhoGoesOnByItselfAndWhoIsOverHelp) {
  EXPECT_THAT(deadlocked({{1, all({{2}})}, {2, {}}}, {1}), IsEmpty());
  EXPECT_THAT(deadlocked({{1, all({{7}})}}, {1}), IsEmpty());
}

TEST(WaitGraph, OneOfSeveralWaysOutIsEnoughForAny) {
  const Graph base = {{2, all({{1}})}, {3, {}}};
  Graph graph = base;
  graph[1] = any({{2}, {3}});
  EXPECT_THAT(deadlocked(graph, {1}), IsEmpty());
  graph[1] = all({{2}, {3}});
  EXPECT_THAT(deadlocked(graph, {1}), ElementsAre(1, 2));
  graph[1] = all({{2, 3}});  // either of the two brings it about
  EXPECT_THAT(deadlocked(graph, {1}), IsEmpty());
}

TEST(WaitGraph, OneOfSeveralChoicesIsEnoughIfAllOfItComes) {
  Graph graph = {{2, all({{1}})}, {3, {}}};
  graph[1] = any({{3}, {2}, {3}});
  graph[1].targets[0].choice = graph[1].targets[1].choice = 0;
  graph[1].targets[2].choice = 1;
  EXPECT_THAT(deadlocked(graph, {1}), IsEmpty());
  graph[1].targets.pop_back();
  EXPECT_THAT(deadlocked(graph, {1}), ElementsAre(1, 2));
}

TEST(WaitGraph, SoManyPeopleMustComeAsAreMissing) {
  Graph graph = {{1, all({{3, 2}})}, {2, all({{1}})}, {3, {}}};
  graph[1].targets.front().gives = {1, 2};
  graph[1].targets.front().missing = 1;
  EXPECT_THAT(deadlocked(graph, {1}), IsEmpty());
  graph[1].targets.front().missing = 2;
  EXPECT_THAT(deadlocked(graph, {1}), ElementsAre(1, 2));
  EXPECT_THAT(tasks_of(cycle_in(deadlocked_from({1}, in(graph)))), ElementsAre(1, 2));
}

TEST(WaitGraph, WhatNobodyBringsAboutIsNoDeadlock) {
  EXPECT_THAT(deadlocked({{1, all({{}})}}, {1}), IsEmpty());
}

TEST(WaitGraph, LooksAtSoManyTasksOnly) {
  Graph graph;
  const int count = static_cast<int>(kMostLookedAt);
  for (int i = 0; i < count; ++i) graph[i] = all({{(i + 1) % count}});
  EXPECT_EQ(deadlocked(graph, {0}).size(), kMostLookedAt);
  graph[count - 1] = all({{count}});
  graph[count] = all({{0}});
  EXPECT_THAT(deadlocked(graph, {0}), IsEmpty());
}

/// Whether nobody outside of `left` brings it about.
bool is_barred(const WaitTarget &each, const std::set<int> &left) {
  int given = 0;
  for (std::size_t i = 0; i < each.by.size(); ++i) {
    if (!left.contains(each.by[i])) given += each.gives.empty() ? 1 : each.gives[i];
  }
  return !each.by.empty() && given < (each.gives.empty() ? 1 : each.missing);
}

/// By the definition: the greatest set each member of which waits for members only.
std::set<int> deadlocked_by_definition(const Graph &graph) {
  std::set<int> left;
  for (const auto &[task, waits] : graph) left.insert(task);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto &[task, waits] : graph) {
      if (!left.contains(task)) continue;
      std::map<int, bool> ways;  // whether each is barred; a target without a choice is one
      for (std::size_t i = 0; i < waits.targets.size(); ++i) {
        const int choice = waits.targets[i].choice;
        const int way = !waits.any ? 0 : choice < 0 ? -1 - static_cast<int>(i) : choice;
        ways[way] = ways[way] || is_barred(waits.targets[i], left);
      }
      bool barred = !ways.empty();
      for (const auto &[way, is] : ways) barred = barred && is;
      if (barred) continue;
      left.erase(task);
      changed = true;
    }
  }
  return left;
}

TEST(WaitGraph, AgreesWithTheDefinition) {
  std::mt19937 random(7);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  int found = 0;
  for (int round = 0; round < 3000; ++round) {
    Graph graph;
    const int count = 1 + below(8);
    std::vector<int> roots;
    for (int task = 0; task < count; ++task) {
      roots.push_back(task);
      WaitSet &waits = graph[task];
      waits.any = below(2) == 0;
      for (int i = below(4); i > 0; --i) {
        std::vector<int> by;
        for (int j = below(3); j >= 0; --j) by.push_back(below(count + 1));
        WaitTarget &each = waits.targets.emplace_back(target(std::move(by)));
        if (below(2) == 0) each.choice = below(2);
        if (below(3) != 0) continue;
        int most = 0;
        for (std::size_t j = 0; j < each.by.size(); ++j) {
          most += each.gives.emplace_back(1 + below(3));
        }
        each.missing = 1 + below(most);
      }
      std::stable_sort(waits.targets.begin(), waits.targets.end(),
                       [](const auto &a, const auto &b) { return a.choice < b.choice; });
    }
    const Deadlocked tasks = deadlocked_from(roots, in(graph));
    std::set<int> names;
    for (const auto &[task, waits] : tasks) names.insert(task);
    ASSERT_EQ(names, deadlocked_by_definition(graph));
    if (tasks.empty()) continue;
    ++found;
    const WaitCycle cycle = cycle_in(tasks);
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      EXPECT_TRUE(names.contains(cycle[i].task));
      EXPECT_EQ(cycle[i].target.by.front(), cycle[(i + 1) % cycle.size()].task);
      EXPECT_LE(cycle.front().task, cycle[i].task);
    }
  }
  EXPECT_GT(found, 300);
}

TEST(WaitGraph, NamesEveryLinkOfACycle) {
  Graph graph = {{5, all({{3}})}, {3, all({{4}})}, {4, all({{3}})}};
  const auto text = [](const WaitLink &link) { return "t" + std::to_string(link.task); };
  const WaitCycle cycle = cycle_in(deadlocked_from({5}, in(graph)));
  EXPECT_THAT(tasks_of(cycle), ElementsAre(3, 4));
  EXPECT_EQ(text_of(cycle, text), "tasks wait for each other: t3; t4");
  for (auto &[task, waits] : graph) waits.targets.front().machine = true;
  EXPECT_EQ(text_of(cycle_in(deadlocked_from({5}, in(graph))), text),
            "machines wait for each other: t3, t4");
}

TEST(WaitGraph, AnIdleMachineIsNotHelpedByTakingAwayWhoWouldMoveIt) {
  Graph graph = {{1, all({{2}})}, {2, all({{1}})}};
  graph[1].targets.front().idle = true;
  EXPECT_THAT(helpful_in(cycle_in(deadlocked_from({1}, in(graph)))), ElementsAre(1));
  graph[2].targets.front().idle = true;
  EXPECT_THAT(helpful_in(cycle_in(deadlocked_from({1}, in(graph)))), ElementsAre(1, 2));
}

TEST(WaitGraph, WalksToWhoWaitsForNobodyOrRoundACycle) {
  const Graph graph = {
      {1, all({{2}})}, {2, all({{}})}, {3, all({{4}})}, {4, all({{5}})}, {5, all({{4}})}};
  EXPECT_THAT(walk_from(1, in(graph)).tasks, ElementsAre(1, 2));
  EXPECT_THAT(walk_from(1, in(graph)).cycle, IsEmpty());
  EXPECT_THAT(walk_from(3, in(graph)).tasks, ElementsAre(3, 4, 5));
  EXPECT_THAT(tasks_of(walk_from(3, in(graph)).cycle), ElementsAre(4, 5));
}

}  // namespace
}  // namespace rubicon::taskplan
