#pragma once

#include "src/results/verify/input/record.hpp"

namespace rubicon::verify {

/// Whether durations that are not certain are what their laws allow: the mean of the law in a run
/// without draws, else between its least and its greatest value.
void check_durations(const Trace& trace, Faults& faults);

/// Whether a law allows so long.
bool allows(const Scene& scene, const SceneLaw& law, Ticks duration);

}  // namespace rubicon::verify
