#include "src/simulation/taskplan/motion_task.hpp"

namespace rubicon::taskplan {

std::vector<interpreter::GoalSpec> goals_of(const interpreter::PlanModel& plan,
                                            const interpreter::TaskSpec& task,
                                            MotionPurpose purpose, const site::SiteWorld& site) {
  std::vector<interpreter::GoalSpec> goals;
  if (purpose == MotionPurpose::carry || purpose == MotionPurpose::go) goals = task.via;
  if (purpose == MotionPurpose::go) {
    goals.push_back(*task.go);
    return goals;
  }
  interpreter::GoalSpec goal;
  goal.span = task.move_span;
  if (purpose == MotionPurpose::grip) {
    const auto component = static_cast<std::size_t>(*task.move);
    goal.X_WG = site.X_WO(*task.move) * plan.components[component].X_OG;
  } else {
    // The load hangs as it was taken: where the tool must go follows from that.
    goal.X_WG = task.X_WO_goal * site.load(task.robot)->X_TO.inverse(Eigen::Isometry);
  }
  goals.push_back(goal);
  return goals;
}

std::vector<std::string> situations_of(const interpreter::PlanModel& plan,
                                       const interpreter::TaskSpec& task, MotionPurpose purpose) {
  std::vector<std::string> situations = plan.situations;
  if (purpose != MotionPurpose::grip) {
    situations.insert(situations.end(), task.situations.begin(), task.situations.end());
  }
  if (purpose == MotionPurpose::place) situations.emplace_back("place");
  return situations;
}

interpreter::Within within_of(const interpreter::PlanModel& plan, const interpreter::TaskSpec& task,
                              MotionPurpose purpose) {
  if (purpose != MotionPurpose::grip) return task.within;
  const auto& model = plan.robots[static_cast<std::size_t>(task.robot)].robot->model;
  interpreter::Within angles;
  for (const auto& value : task.within.values) {
    if (model.parameters[static_cast<std::size_t>(value.first)].rotation) {
      angles.values.push_back(value);
    }
  }
  return angles;
}

bool is_enough(MotionPurpose purpose, const interpreter::MotionEnd& end) {
  return end.reached ||
         (purpose == MotionPurpose::carry && end.status == interpreter::MotionStatus::done);
}

}  // namespace rubicon::taskplan
