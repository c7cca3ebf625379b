#pragma once

#include "src/results/verify/replay/site_parts.hpp"

namespace rubicon::verify {

/// What stands in each other when the plan begins (site, components, robots): all that is deeper
/// than the contact tolerance is waived by the plan or told by the header, and what it tells is
/// so. Nothing is looked at where the header does not tell.
void check_beginning(const Scene& scene, const SiteParts& site, Faults& faults);

}  // namespace rubicon::verify
