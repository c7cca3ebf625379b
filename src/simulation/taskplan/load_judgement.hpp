#pragma once

#include <optional>
#include <string>

#include "src/simulation/taskplan/stage.hpp"

namespace rubicon::taskplan {

/// Why the load chart of its robot forbids a task before anything moves: the component is too heavy
/// where it stands now, or where it is to be set down. Nothing where neither is so, without a chart
/// and without a move. The radii are those of the tool at its two goals, less what `within` leaves
/// free.
std::optional<std::string> too_heavy(const Stage& stage, int task);

}  // namespace rubicon::taskplan
