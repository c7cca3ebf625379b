#pragma once

#include "src/results/verify/input/record.hpp"

namespace rubicon::verify {

/// Whether tasks that dig take as long, and tip as much, as their rounds do. Where each duration is
/// certain the rounds are gone through again, truck by truck; where some were drawn, the time and
/// the loads are held against what the least durations allow.
void check_digs(const Trace& trace, Faults& faults);

}  // namespace rubicon::verify
