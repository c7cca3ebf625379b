#pragma once

#include <optional>

#include "src/exchange/project_io/project.hpp"

namespace rubicon::project_io {

/// When a task is that no link moves: it has begun in fact, or was placed by hand.
struct FixedDates {
  /// Seconds from the beginning of the plan, 0 or more: what was before it is at it.
  std::int64_t start = 0;
  std::optional<std::int64_t> finish;  ///< the same; not before the start. Nothing: not known
  bool cut = false;                    ///< it begins before the plan does
};

/// The dates in fact; of a task under way the finish that the schedule expects. Else, of a task
/// that is placed by hand, those it has. `start` is the moment at which the plan starts.
std::optional<FixedDates> fixed_dates(const Task& task, const Moment& start);

}  // namespace rubicon::project_io
