#pragma once

#include <optional>
#include <string>

#include "src/results/verify/input/fault.hpp"
#include "src/results/verify/input/record.hpp"

namespace rubicon::verify {

/// A result as it was read. The schedules are there where the result is a folder.
struct Result {
  Trace trace;
  std::optional<std::string> schedule_json;
  std::optional<std::string> schedule_csv;
  std::optional<std::string> loads_csv;
  std::string trace_digest;           ///< SHA-256 of its lines, each with a line feed
  std::optional<std::string> report;  ///< the text of report.html, if there is one
};

/// What was looked at, and what is wrong with it.
struct Verdict {
  int tasks = 0;   ///< of the plan
  int done = 0;    ///< of these
  long steps = 0;  ///< that robots made
  long pairs = 0;  ///< of solids that were looked at closely
  Faults faults;   ///< by file, line and text
};

/// Replays a result: clock, motion rules, loads, contact, resources, shifts, links, schedules
/// (docs/verify.md). Throws UnreadableInput if a schedule cannot be read or a shape is none.
Verdict verify(const Result& result);

}  // namespace rubicon::verify
