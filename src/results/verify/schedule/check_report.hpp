#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "src/results/verify/input/fault.hpp"

namespace rubicon::verify {

/// Whether the text of a report.html says which trace it was made of; an older version's does not.
bool says_its_origin(std::string_view report);

/// Whether a report was made of the trace with this digest and of the schedule beside it.
void check_report(std::string_view report, std::string_view trace_digest,
                  const std::optional<std::string>& schedule_json, Faults& faults);

}  // namespace rubicon::verify
