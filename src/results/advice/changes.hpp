#pragma once

#include <functional>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/results/why/task_story.hpp"

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

/// The changes that might help the task of the story, in this order: for each thing in its way, as
/// the story names them, the task before the one that put it there, then after those that need the
/// place or take the thing away; then the task by each other robot; then, if it is rejected, over a
/// waypoint 2, 5 and 10 m above its goal. Only of a rejected task a link from the one to the other
/// is turned round.
Changes changes_for(const interpreter::PlanModel& plan, const why::TaskStory& story);

}  // namespace rubicon::advice
