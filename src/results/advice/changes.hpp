#pragma once

#include <functional>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/results/why/task_story.hpp"
#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::advice {

/// A change of a plan that might help a task.
struct Change {
  std::string text;  ///< "set_low before set_wall"
  std::function<void(interpreter::PlanModel&)> apply;
};

/// A change that makes no sense, or that there was no room for.
struct LeftOut {
  std::string text;
  std::string why;
};

struct Changes {
  std::vector<Change> changes;
  std::vector<LeftOut> left_out;
};

/// So many orders of two tasks are looked at where one waited for what the other had.
inline constexpr std::size_t kMostQueueOrders = 12;

/// The changes that might help the task of the story, in this order: for each thing in its way, as
/// the story names them, the task before the one that put it there, then after those that need the
/// place or take the thing away; the task before those that had a robot or crew for which it waited
/// (`queue_orders`); the task by each other robot; if it is rejected, over a waypoint 2, 5 and 10 m
/// above its goal; then the same orders of the tasks that it waited for, and so on back. Only of a
/// rejected task a link from the one to the other is turned round. `schedule`: of the plan as it
/// is.
Changes changes_for(const interpreter::PlanModel& plan, const why::TaskStory& story,
                    const taskplan::Schedule& schedule);

}  // namespace rubicon::advice
