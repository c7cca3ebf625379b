#pragma once

#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/machine/machine.hpp"
#include "src/simulation/site/load_turn.hpp"
#include "src/simulation/site/site_world.hpp"
#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::taskplan {

/// Where a motion of a task goes: its waypoints, if it has any, and its goal, as the component
/// stands or hangs now (LANGUAGE section 12).
std::vector<interpreter::GoalSpec> goals_of(const interpreter::PlanModel& plan,
                                            const interpreter::TaskSpec& task,
                                            MotionPurpose purpose, const site::SiteWorld& site);

/// Where the tool goes with a load that people turn, which hangs: to the place where it is set
/// down, turned about the vertical as the machine comes there; and how far it is to be turned then.
site::FreeTurn way_to_goal(const interpreter::TaskSpec& task, const site::SiteWorld& site);

/// The situations that are on during a motion of a task, besides those of the world.
std::vector<std::string> situations_of(const interpreter::PlanModel& plan,
                                       const interpreter::TaskSpec& task, MotionPurpose purpose);

/// How near is near enough for a motion of a task: for a grip only the angles of `within` count, it
/// is taken where it is, at whatever angle the task allows.
interpreter::Within within_of(const interpreter::PlanModel& plan, const interpreter::TaskSpec& task,
                              MotionPurpose purpose);

/// Whether a motion did what its task needs: carrying may end short on purpose, all others must
/// reach.
bool is_enough(MotionPurpose purpose, const interpreter::MotionEnd& end);

/// Says that the script left waypoint `number` (from 1) with the tool `off` m from it.
std::string missed_text(int number, double off);

}  // namespace rubicon::taskplan
