#pragma once

#include <string>
#include <vector>

namespace rubicon::test {

/// The lines of a trace in tests/unit/verify. Those that are there have no fault:
/// carry_a_block.jsonl: a gantry carries a block from x = 3 to x = 5, then a crew works;
/// two_machines.jsonl: two gantries on one rail, the second makes way for the first.
std::vector<std::string> sample_trace(const std::string& name);

}  // namespace rubicon::test
