// Going back: each part gives its state and takes it back. And one activity alone on its stage.

#include "src/simulation/taskplan/checkpoint.hpp"

#include <gtest/gtest.h>

#include "src/simulation/site/make_site.hpp"
#include "src/simulation/taskplan/work_activity.hpp"
#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::taskplan {
namespace {

using schedule::kHour;

/// A task of two hours by a crew, and one of an hour by the same.
interpreter::PlanModel crew_plan() {
  interpreter::PlanModel plan;
  plan.crews.emplace_back().name = "masons";
  for (const double hours : {2.0, 1.0}) {
    interpreter::TaskSpec& task = plan.tasks.emplace_back();
    task.name = hours > 1 ? "wall" : "pillar";
    task.crews = {0};
    interpreter::WorkSpec& work = task.takes.emplace_back();
    work.duration = hours * 3600;
    work.crew = -1;
  }
  return plan;
}

class CheckpointTest : public testing::Test {
 protected:
  CheckpointTest()
      : plan_(crew_plan()),
        stage_(plan_, sources_, draws_, nullptr, trace::TraceDetail::none,
               site::prepare_site(plan_)),
        records_(stage_.tasks()),
        checkpoints_(stage_, records_, zone_waits_) {}

  /// As the loop begins a task.
  ActiveTask& begin(int task) {
    stage_.allocator->ask(stage_.queue_of(task), task, 0, stage_.now());
    const auto grant = stage_.allocator->take(stage_.now());
    EXPECT_TRUE(grant && grant->task == task);
    checkpoints_.add(task, grant->before);
    records_.set_status(task, TaskRecords::Status::active);
    ActiveTask active;
    active.task = task;
    active.phases = phases_of(stage_.spec(task), draws_);
    active.account.over_time.resize(1);
    active.account.worked.resize(1);
    active.activity = Snapshot(activity_of(active.phases.front()));
    stage_.active.add(std::move(active));
    return *stage_.active.find(task);
  }

  interpreter::PlanModel plan_;
  interpreter::SourceMap sources_;
  interpreter::Draws draws_;
  Stage stage_;
  TaskRecords records_;
  ZoneWaits zone_waits_;
  Checkpoints checkpoints_;
};

TEST_F(CheckpointTest, AnActivityAloneSetsItsEventAndIsOverWhenItComes) {
  ActiveTask& wall = begin(0);
  EXPECT_EQ(wall.activity->begin(wall, stage_), Step::pending);
  EXPECT_EQ(stage_.events.next(), std::optional<Ticks>(2 * kHour));
  EXPECT_TRUE(wall.activity->waits(wall, stage_).targets.empty());
  stage_.events.advance_to(2 * kHour);
  EXPECT_EQ(stage_.events.take_due(), std::optional(0));
  EXPECT_EQ(wall.activity->resume(wall, stage_), Step::over);
  EXPECT_EQ(wall.account.outcome.work_time, 2 * kHour);
  EXPECT_EQ(wall.account.worked.front(), 2 * kHour);
}

TEST_F(CheckpointTest, GoingBackGivesBackWhatTheTaskTookAndDid) {
  ActiveTask& wall = begin(0);
  wall.activity->begin(wall, stage_);
  stage_.events.advance_to(kHour);
  stage_.made_progress();
  EXPECT_EQ(stage_.allocator->state(0).holder(), 0);
  EXPECT_TRUE(checkpoints_.go_back(0));
  EXPECT_EQ(stage_.now(), 0);
  EXPECT_EQ(stage_.events.next(), std::nullopt);
  EXPECT_EQ(stage_.allocator->state(0).holder(), -1);
  EXPECT_TRUE(stage_.active.empty());
  EXPECT_EQ(stage_.progress.count, 0u);
  EXPECT_EQ(records_.status(0), TaskRecords::Status::pending);
  EXPECT_FALSE(checkpoints_.go_back(0));
}

TEST_F(CheckpointTest, GoingBackTakesLaterTasksAlong) {
  begin(0);
  stage_.events.advance_to(kHour);
  stage_.allocator->release(0, 0, kHour, false, kHour);
  stage_.active.erase(0);
  begin(1);
  EXPECT_EQ(stage_.allocator->state(0).holder(), 1);
  EXPECT_TRUE(checkpoints_.go_back(1));
  EXPECT_EQ(stage_.now(), kHour);
  EXPECT_EQ(stage_.allocator->state(0).holder(), -1);
  EXPECT_EQ(stage_.allocator->state(0).last, 0);
  EXPECT_TRUE(checkpoints_.go_back(0));
  EXPECT_EQ(stage_.now(), 0);
  EXPECT_EQ(stage_.allocator->state(0).last, -1);
}

TEST_F(CheckpointTest, WhatIsDroppedIsNotGoneBackTo) {
  begin(0);
  stage_.events.advance_to(kHour);
  stage_.allocator->release(0, 0, kHour, false, kHour);
  stage_.active.erase(0);
  checkpoints_.drop(0);
  begin(1);
  EXPECT_FALSE(checkpoints_.go_back(0));
  EXPECT_TRUE(checkpoints_.go_back(1));
  EXPECT_EQ(stage_.allocator->state(0).last, 0);
}

}  // namespace
}  // namespace rubicon::taskplan
