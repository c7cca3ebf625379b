#pragma once

#include <string_view>

#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::report {

/// The schedule that `schedule_json` wrote: `schedule_json` of it gives the same text again. What
/// that text does not hold (the single motions, who had what for how long) stays empty. Throws
/// std::invalid_argument, with a message for the user, for any other text.
taskplan::Schedule schedule_from_json(std::string_view text);

}  // namespace rubicon::report
