#pragma once

#include "src/results/verify/input/record.hpp"

namespace rubicon::verify {

/// Whether each text that the trace's header carries is the one of its checksum.
void check_files(const Trace& trace, Faults& faults);

}  // namespace rubicon::verify
