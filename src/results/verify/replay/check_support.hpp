#pragma once

#include <vector>

#include "src/results/verify/replay/component_stays.hpp"
#include "src/results/verify/replay/site_parts.hpp"

namespace rubicon::verify {

/// Whether what the header says does not stand at the beginning is all that does not, and whether
/// what is put down, and what is near what is taken away, stands then; in plans with support on.
void check_support(const Trace& trace, const SiteParts& site, const std::vector<Stay>& stays,
                   Ticks until, Faults& faults);

}  // namespace rubicon::verify
