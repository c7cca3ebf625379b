#include "src/simulation/taskplan/motion_task.hpp"

#include <fmt/format.h>

namespace rubicon::taskplan {

namespace {

/// The way of the task's robot to a frame about whose vertical it may come as it likes.
site::FreeTurn free_way(const interpreter::TaskSpec& task, const site::SiteWorld& site,
                        const math::Pose& X_meant) {
  const site::SiteRobot& robot = site.robot(task.robot);
  return site::free_turn(*robot.model, robot.mounting, site.configuration(task.robot), X_meant);
}

}  // namespace

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
  // What people turn is taken, and brought, as the machine comes.
  const bool turned = task.adjust && task.adjust->turning;
  if (turned && purpose == MotionPurpose::grip) goal.X_WG = free_way(task, site, *goal.X_WG).X_WG;
  if (turned && purpose == MotionPurpose::carry) goal.X_WG = way_to_goal(task, site).X_WG;
  goals.push_back(goal);
  return goals;
}

site::FreeTurn way_to_goal(const interpreter::TaskSpec& task, const site::SiteWorld& site) {
  return free_way(task, site,
                  task.X_WO_goal * site.load(task.robot)->X_TO.inverse(Eigen::Isometry));
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

std::string missed_text(int number, double off) {
  if (off < 0.0005) {
    return fmt::format("waypoint {} is not reached: the tool was there, otherwise turned or posed",
                       number);
  }
  return fmt::format("waypoint {} is not reached: the tool was {:.3f} m from it", number, off);
}

}  // namespace rubicon::taskplan
