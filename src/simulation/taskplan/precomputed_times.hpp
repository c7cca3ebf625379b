#pragma once

#include <optional>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/schedule/network.hpp"

namespace rubicon::taskplan {

/// When tasks start and finish that can be computed before the plan begins: crew work that comes
/// after such work only, by crews that do nothing else, without zones and without anything to
/// remove. For them links may look ahead (LANGUAGE section 12: a task may start before the one it
/// is tied to). `tasks` are the plan's (`network_tasks`); to each its times, or nothing.
std::vector<std::optional<schedule::TaskTimes>> precomputed_times(
    const interpreter::PlanModel& plan, const std::vector<schedule::NetworkTask>& tasks,
    const interpreter::Draws& draws);

}  // namespace rubicon::taskplan
