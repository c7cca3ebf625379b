#include "src/earth/hauling/truck_rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/motion/math/random.hpp"

namespace rubicon::hauling {
namespace {

/// From `least` to `most`.
int whole(math::Random& random, int least, int most) {
  return least + static_cast<int>(random.index(static_cast<std::size_t>(most - least + 1)));
}

/// A digger that loads as long as the operation says, by asking for one truck after the other.
Result dig_by_asking(const Operation& operation, std::vector<Load>& loads) {
  TruckRounds rounds(operation, std::nullopt, "dig");
  Result result;
  Nanoseconds now = 0;
  for (CubicMillimetres soil = operation.volume; soil > 0;) {
    now = rounds.next_arrival(now);
    rounds.call(now);
    const CubicMillimetres load = std::min(operation.load, soil);
    soil -= load;
    rounds.load(load);
    now += std::llround(operation.loading.seconds * kPerSecond);
    rounds.leave(now);
  }
  result.time = rounds.last_tip();
  loads = rounds.loads();
  result.queues = rounds.queues();
  return result;
}

/// One digger's trucks, asked for step by step, do what the simulation of the whole says.
TEST(TruckRounds, AreThoseOfTheSimulation) {
  math::Random random(5);
  for (int i = 0; i < 200; ++i) {
    Operation operation;
    operation.load = 1'000'000'000;
    operation.volume = operation.load * whole(random, 1, 40) - whole(random, 0, 900'000'000);
    operation.trucks = whole(random, 1, 6);
    operation.diggers = {{"digger", 1}};
    operation.loading.seconds = random.between(10, 200);
    operation.stages = {{"haul", {random.between(50, 400), {}}},
                        {"weigh", {random.between(1, 90), {}}, "scale", whole(random, 0, 2)},
                        {"tip", {random.between(5, 60), {}}, "dozer", whole(random, 0, 1)},
                        {"return", {random.between(40, 300), {}}}};
    operation.tip = 2;
    std::vector<Load> expected;
    const Result whole =
        simulate(operation, std::nullopt, [&](const Load& load) { expected.push_back(load); });
    std::vector<Load> loads;
    const Result asked = dig_by_asking(operation, loads);
    EXPECT_EQ(asked.time, whole.time) << i;
    ASSERT_EQ(loads.size(), expected.size());
    for (std::size_t k = 0; k < loads.size(); ++k) {
      EXPECT_EQ(loads[k].volume, expected[k].volume);
      EXPECT_EQ(loads[k].arrived, expected[k].arrived);
      EXPECT_EQ(loads[k].began, expected[k].began);
      EXPECT_EQ(loads[k].tipped, expected[k].tipped);
    }
    ASSERT_EQ(asked.queues.size() + 1, whole.queues.size());
    for (std::size_t k = 0; k < asked.queues.size(); ++k) {
      EXPECT_EQ(asked.queues[k].longest, whole.queues[k + 1].longest);
    }
  }
}

}  // namespace
}  // namespace rubicon::hauling
