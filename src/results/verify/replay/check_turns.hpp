#pragma once

#include "src/results/verify/input/record.hpp"

namespace rubicon::verify {

/// The ways of machines that turn with a radius, by the frames of their waypoints: none turns more
/// between two of them than its radius allows on that length, and each lies ahead of the one
/// before.
void check_turns(const Trace& trace, Faults& faults);

}  // namespace rubicon::verify
