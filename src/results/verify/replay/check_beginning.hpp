#pragma once

#include <vector>

#include "src/results/verify/replay/moving_path.hpp"
#include "src/results/verify/replay/site_parts.hpp"

namespace rubicon::verify {

/// What stands in each other when the plan begins (site, components, robots, things with a
/// timetable that are there at 0 s): all that is deeper than the contact tolerance is waived by the
/// plan or told by the header, and what it tells is so. Nothing is looked at where the header does
/// not tell. `movings`: by number, as in the scene.
void check_beginning(const Scene& scene, const SiteParts& site,
                     const std::vector<MovingPath>& movings, Faults& faults);

}  // namespace rubicon::verify
