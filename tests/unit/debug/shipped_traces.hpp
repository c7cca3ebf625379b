#pragma once

#include <string>
#include <vector>

#include "src/results/debug/session.hpp"

namespace rubicon::test {

/// The lines of the trace of a shipped plan (a path from the top folder), which is run.
const std::vector<std::string>& trace_of(const std::string& plan);

/// The recording of such lines.
debug::Recording recording_of(const std::vector<std::string>& lines);

/// A session over all tasks, or over one, without colour.
debug::Session session_of(const std::vector<std::string>& lines, const std::string& task = "");

/// Plans of several machines, crews, refusals and waits, and the tour: those that are walked
/// through whole.
const std::vector<std::string>& walked_plans();

}  // namespace rubicon::test
