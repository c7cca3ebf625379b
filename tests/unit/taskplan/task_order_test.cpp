#include "src/taskplan/task_order.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rubicon::taskplan {
namespace {

using testing::ElementsAre;

std::vector<interpreter::TaskSpec> tasks(const std::vector<std::vector<int>>& after) {
  std::vector<interpreter::TaskSpec> tasks(after.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    for (const int other : after[i]) tasks[i].after.push_back({other, {}, 0, {}});
  }
  return tasks;
}

TEST(TaskOrder, IsTheFilesWhereThePlanLeavesItOpen) {
  EXPECT_THAT(task_order(tasks({{}, {}, {}})), ElementsAre(0, 1, 2));
}

TEST(TaskOrder, PutsATaskAfterThoseItFollows) {
  EXPECT_THAT(task_order(tasks({{2}, {}, {1}, {}})), ElementsAre(1, 2, 0, 3));
  EXPECT_THAT(task_order(tasks({{1, 1}, {}})), ElementsAre(1, 0));
}

TEST(TaskOrder, LosesNoTaskOnACycle) {
  EXPECT_THAT(task_order(tasks({{1}, {0}, {}})), ElementsAre(2, 0, 1));
}

}  // namespace
}  // namespace rubicon::taskplan
