// A rejected task leaves no mark: the others go as if it had never been in the plan.

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <string>

#include "src/simulation/taskplan/run_plan.hpp"
#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::taskplan {
namespace {

using math::translation;

/// Three cranes beside each other, of which neighbours reach into each other's circle, one crew of
/// riggers for all, two more crews. Some tasks are impossible: their goal is out of reach, in the
/// ground or in a tower, or they remove what is gone.
class RandomSite {
 public:
  explicit RandomSite(unsigned seed) : dice_(seed) {
    plan_ = test::crane_plan();
    plan_.site.push_back({geometry::Box{{-90, -90, -1}, {190, 90, 0}}, math::Pose::Identity()});
    const interpreter::RobotSpec crane = plan_.robots[0];
    plan_.robots.clear();
    for (int i = 0; i < 3; ++i) {
      plan_.robots.push_back(crane);
      plan_.robots[index(i)].name = "crane_" + std::to_string(i);
      plan_.robots[index(i)].X_WM = translation(70.0 * i, 0, 12.0 * i);
      plan_.robots[index(i)].start = {90, 10, 20, 0};
    }
    plan_.crews.resize(1);
    plan_.crews.push_back({"masons", 1, {}, "", {}});
    plan_.crews.push_back({"joiners", 1, {}, "", {}});
    for (int i = 0; i < 24; ++i) add_task(i);
  }

  const interpreter::PlanModel& plan() const { return plan_; }
  int impossible() const { return impossible_; }

  /// The plan without some of its tasks; links to these are left out.
  interpreter::PlanModel without(const std::set<std::string>& names) const {
    interpreter::PlanModel rest = plan_;
    rest.tasks.clear();
    std::map<int, int> number;
    for (std::size_t i = 0; i < plan_.tasks.size(); ++i) {
      if (names.contains(plan_.tasks[i].name)) continue;
      number[static_cast<int>(i)] = static_cast<int>(rest.tasks.size());
      rest.tasks.push_back(plan_.tasks[i]);
    }
    for (interpreter::TaskSpec& task : rest.tasks) {
      std::erase_if(task.after, [&](const auto& link) { return !number.contains(link.task); });
      for (interpreter::LinkSpec& link : task.after) link.task = number.at(link.task);
    }
    return rest;
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  int below(int count) { return static_cast<int>(dice_() % static_cast<unsigned>(count)); }

  void add_task(int i) {
    interpreter::TaskSpec task;
    const int robot = below(4);  // 3: crew work
    const double x = 70.0 * robot;
    if (robot < 3) {
      const int component = static_cast<int>(plan_.components.size());
      plan_.components.push_back(test::box_component("block_" + std::to_string(i), {2, 2, 2},
                                                     translation(x + 12 + i % 3 * 4, -25 - i, 0)));
      task = test::move_task("", component, translation(x + 14 + below(5) * 4, 12 + i, 0));
      task.robot = robot;
      task.crews.clear();
      task.hook = interpreter::WorkSpec{60.0 * below(4), 0, {}};
      task.release = interpreter::WorkSpec{30.0 * below(4), 0, {}};
      const int kind = below(6);
      if (kind == 0) task.X_WO_goal = translation(x + 100, 0, 0);  // out of reach
      if (kind == 1) task.X_WO_goal.translation().z() = -1;        // in the ground
      if (kind <= 1) ++impossible_;
    } else {
      task.crews = {1 + below(2)};
      task.takes = {{60.0 * (1 + below(30)), -1, {}}};
      if (below(5) == 0 && !plan_.components.empty()) {
        task.remove = {0, 0};  // the second time it is gone
        ++impossible_;
      }
    }
    task.name = "task_" + std::to_string(i);
    task.priority = below(3);
    for (int links = i == 0 ? 0 : below(3); links > 0; --links) {
      task.after.push_back({below(i),
                            below(3) == 0 ? interpreter::LinkType::SS : interpreter::LinkType::FS,
                            30 * below(5) * schedule::kSecond,
                            {}});
    }
    plan_.tasks.push_back(std::move(task));
  }

  std::mt19937 dice_;
  interpreter::PlanModel plan_;
  int impossible_ = 0;
};

std::map<std::string, TaskOutcome> ran(const interpreter::PlanModel& plan) {
  std::map<std::string, TaskOutcome> result;
  test::Lines lines;
  for (TaskOutcome& task : run_plan(plan, test::numbered_lines(), &lines).tasks) {
    result[task.task] = std::move(task);
  }
  return result;
}

TEST(Undo, ARejectedTaskLeavesNoMark) {
  int rejected = 0;
  int done = 0;
  for (unsigned seed = 1; seed <= 150; ++seed) {
    const RandomSite site(seed);
    const auto all = ran(site.plan());
    std::set<std::string> failed;
    for (const auto& [name, task] : all) {
      if (task.result == TaskResult::done) continue;
      failed.insert(name);
      EXPECT_EQ(task.duration, 0) << name;
      if (task.result == TaskResult::rejected) ++rejected;
    }
    const auto rest = ran(site.without(failed));
    ASSERT_EQ(rest.size() + failed.size(), all.size());
    for (const auto& [name, task] : rest) {
      const TaskOutcome& beside = all.at(name);
      EXPECT_EQ(task.result, TaskResult::done) << "seed " << seed << " " << name << task.reason;
      EXPECT_EQ(task.start, beside.start) << "seed " << seed << " " << name;
      EXPECT_EQ(task.duration, beside.duration) << "seed " << seed << " " << name;
      EXPECT_EQ(task.tried, beside.tried) << "seed " << seed << " " << name;
      ++done;
    }
  }
  EXPECT_GT(rejected, 150);
  EXPECT_GT(done, 500);
}

}  // namespace
}  // namespace rubicon::taskplan
