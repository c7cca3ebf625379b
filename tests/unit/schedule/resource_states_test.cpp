// Who has what: shares of a crew, and since when what a task asks for is free.

#include "src/simulation/schedule/resource_states.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rubicon::schedule {
namespace {

/// A machine, and a crew of four.
ResourceStates machine_and_crew() { return ResourceStates({1, 4}); }

TEST(ResourceStates, NobodyHasHadWhatIsFreeFromTheBeginning) {
  const ResourceStates states = machine_and_crew();
  EXPECT_TRUE(states.are_free({{0, 1}, {1, 4}}));
  EXPECT_EQ(states.last_free({{0, 1}, {1, 4}}).resource, -1);
  EXPECT_EQ(states.of(0).holder(), -1);
}

TEST(ResourceStates, ACrewIsSharedUpToItsSize) {
  ResourceStates states = machine_and_crew();
  states.take({1, 3}, 7);
  EXPECT_TRUE(states.are_free({{1, 1}}));
  EXPECT_FALSE(states.are_free({{1, 2}}));
  states.take({1, 1}, 8);
  EXPECT_FALSE(states.are_free({{1, 1}}));
  EXPECT_EQ(states.of(1).holder(), 7);
  EXPECT_EQ(states.of(1).last, 8);
  states.release(1, 7, 50, false);
  EXPECT_TRUE(states.are_free({{1, 3}}));
  EXPECT_FALSE(states.are_free({{1, 4}}));
  EXPECT_EQ(states.of(1).holder(), 8);
}

TEST(ResourceStates, WhatIsFreeLongestIsGivenFirst) {
  ResourceStates states = machine_and_crew();
  states.take({1, 2}, 1);
  states.take({1, 2}, 2);
  states.release(1, 2, 30, true);
  states.release(1, 1, 20, false);
  const ResourceStates::Last two = states.last_free({{1, 2}});
  EXPECT_EQ(two.task_before, 1);
  EXPECT_EQ(two.since, 20);
  EXPECT_FALSE(two.midway);
  const ResourceStates::Last three = states.last_free({{1, 3}});
  EXPECT_EQ(three.task_before, 2);
  EXPECT_EQ(three.since, 30);
  EXPECT_TRUE(three.midway);
  states.take({1, 3}, 3);
  EXPECT_EQ(states.last_free({{1, 1}}).task_before, 2);
}

TEST(ResourceStates, OfSeveralTheOneThatCameLastCounts) {
  ResourceStates states = machine_and_crew();
  states.take({0, 1}, 1);
  states.take({1, 4}, 2);
  states.release(1, 2, 10, false);
  states.release(0, 1, 40, false);
  EXPECT_EQ(states.last_free({{0, 1}, {1, 4}}).resource, 0);
  EXPECT_EQ(states.last_free({{0, 1}, {1, 4}}).since, 40);
  EXPECT_EQ(states.last_free({{1, 4}}).resource, 1);
}

TEST(ResourceStates, EachSetIsThereOnce) {
  ResourceSets sets({-1, -1}, {});
  const int both = std::get<int>(sets.set_of({{1, 2}, {0, 1}}, {0, 1}));
  EXPECT_EQ(std::get<int>(sets.set_of({{0, 1}, {1, 2}}, {1, 0})), both);
  EXPECT_NE(std::get<int>(sets.set_of({{0, 1}, {1, 3}}, {1, 0})), both);
  EXPECT_EQ(sets.resources(both), (std::vector<int>{0, 1}));
  EXPECT_EQ(sets.size(), 2);
}

}  // namespace
}  // namespace rubicon::schedule
