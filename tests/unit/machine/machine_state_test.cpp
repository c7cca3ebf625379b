#include <gtest/gtest.h>

#include "tests/support/scripted_run.hpp"

namespace rubicon::test {
namespace {

using interpreter::Hash128;
using interpreter::Machine;
using interpreter::StateTable;

const char* const kScript = R"(
  var(way) = dir(x, goal(x));
  chain {
    move_to(x, goal(x)),
    each { move_dir(y, var(way)), move_dir(y, -var(way)) },
    cycle { move_dir(x, 1), move_dir(y, -1) } until (x > 4)
  };)";

PredicateWorld obstacle() {
  PredicateWorld world;
  world.blocked = [](std::span<const double> q) { return q[0] > 2.5 && q[0] < 3.5 && q[1] < 4.5; };
  return world;
}

TEST(MachineState, IsAValueThatCanBeCopiedAndResumed) {
  const Scenario setup = set_up(kGantry, kScript);
  PredicateWorld world = obstacle();
  Machine whole(*setup.program, setup.task({}, {{"x", 6}}));
  std::vector<Machine> copies;
  do {
    copies.push_back(whole);
  } while (whole.advance(world, nullptr));
  ASSERT_GT(copies.size(), 10u);
  for (Machine& copy : copies) {
    const Hash128 before = copy.state_hash(world);
    Machine twin = copy;
    EXPECT_EQ(twin.state_hash(world), before);
    while (copy.advance(world, nullptr)) {
    }
    EXPECT_EQ(copy.end().q, whole.end().q);
    EXPECT_EQ(copy.end().tries, whole.end().tries);
    EXPECT_EQ(copy.end().time, whole.end().time);
    EXPECT_EQ(copy.end().message, whole.end().message);
    // Running the copy did not touch its twin.
    EXPECT_EQ(twin.state_hash(world), before);
  }
}

TEST(MachineState, HashesDifferBetweenTheStatesOfARun) {
  const Scenario setup = set_up(kGantry, kScript);
  PredicateWorld world = obstacle();
  Machine machine(*setup.program, setup.task({}, {{"x", 6}}));
  std::vector<Hash128> seen;
  do {
    const Hash128 hash = machine.state_hash(world);
    for (const Hash128& other : seen) EXPECT_FALSE(hash == other);
    seen.push_back(hash);
  } while (machine.advance(world, nullptr));
}

TEST(StateTable, FindsWhatWasPutInAndNothingElse) {
  StateTable table;
  bool inserted = false;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    // low words collide on purpose
    table.find_or_insert({i % 7, i}, static_cast<std::uint32_t>(i), inserted);
    EXPECT_TRUE(inserted);
  }
  for (std::uint64_t i = 0; i < 5000; ++i) {
    EXPECT_EQ(table.find_or_insert({i % 7, i}, 0, inserted), i);
    EXPECT_FALSE(inserted);
  }
  EXPECT_EQ(table.size(), 5000u);
  table.clear();
  table.find_or_insert({1, 1}, 9, inserted);
  EXPECT_TRUE(inserted);
}

// However long a motion lasts, its memory stays bounded, and what is in the table is found.
TEST(StateTable, ForgetsAllBeforeItGrowsWithoutEnd) {
  StateTable table;
  bool inserted = false;
  for (std::uint64_t i = 0; i < StateTable::kMostStates; ++i) {
    table.find_or_insert({i, i}, static_cast<std::uint32_t>(i), inserted);
  }
  EXPECT_EQ(table.find_or_insert({7, 7}, 0, inserted), 7u);
  EXPECT_FALSE(inserted);
  EXPECT_EQ(table.size(), StateTable::kMostStates);
  table.find_or_insert({0, 1}, 3, inserted);
  EXPECT_TRUE(inserted);
  EXPECT_EQ(table.size(), 1u);
  EXPECT_EQ(table.find_or_insert({0, 1}, 0, inserted), 3u);
  EXPECT_FALSE(inserted);
  table.find_or_insert({7, 7}, 0, inserted);
  EXPECT_TRUE(inserted);
}

}  // namespace
}  // namespace rubicon::test
