// The schedule of a real apartment building: the dates that the planner's own program calculated
// are the oracle.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/simulation/schedule/critical_chain.hpp"
#include "tests/support/places.hpp"
#include "tests/unit/schedule/real_schedule_io.hpp"

namespace rubicon::schedule {
namespace {

const std::string kPath =
    test::source_dir() + "/../shared/data/schependomlaan/planning-2015-02-18.mspdi.xml";

/// The file's numbers of the tasks whose start or finish is not the planner's.
std::vector<int> other_dates(const test::RealSchedule& real) {
  const auto calculated = times_of(real.network);
  const auto* times = std::get_if<NetworkTimes>(&calculated);
  if (times == nullptr) {
    ADD_FAILURE() << std::get<NetworkMistakes>(calculated).messages.front();
    return {};
  }
  std::vector<int> result;
  for (const auto& [number, task] : real.dates) {
    const TaskTimes& own = times->tasks[static_cast<std::size_t>(real.tasks.at(number))];
    const bool same = civil_time_at(real.start, own.start) == task.start &&
                      civil_time_at(real.start, own.finish) == task.finish;
    if (!same) result.push_back(number);
  }
  return result;
}

TEST(RealSchedule, HasTheDatesOfThePlannersProgram) {
  auto real = test::read_real_schedule(kPath);
  if (!real) GTEST_SKIP() << "the shared data folder is not beside the project";
  EXPECT_EQ(real->dates.size(), 114U);
  // Two links of start to start lost their lag on the way into the file, as the dates show: 20 and
  // 24 working days. Task 201 follows the first of them.
  EXPECT_THAT(other_dates(*real), testing::ElementsAre(197, 201, 204));
  const auto first_link = [&](int number) -> Link& {
    return real->network.tasks[static_cast<std::size_t>(real->tasks.at(number))].after.front();
  };
  first_link(197).lag = 160 * kHour;
  first_link(204).lag = 192 * kHour;
  EXPECT_THAT(other_dates(*real), testing::IsEmpty());
}

}  // namespace
}  // namespace rubicon::schedule
