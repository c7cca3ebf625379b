#pragma once

#include "src/results/verify/replay/task_run.hpp"

namespace rubicon::verify {

/// Checks that the records of a task leave no moment out and none double: each begins where the one
/// before it ended; that attempts are numbered without a gap; and that what `end` counts is there.
/// Of a task that was rejected only that its end is its start.
void check_clock(const Trace& trace, const TaskRun& run, Faults& faults);

/// Times of a trace for people: h:mm:ss, and more digits where the second alone would not tell.
std::string clock_text(Ticks time);

}  // namespace rubicon::verify
