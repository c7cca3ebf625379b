#pragma once

#include <string>

#include "src/results/debug/paint.hpp"
#include "src/results/debug/recording.hpp"

namespace rubicon::debug {

/// "t 6.667 s  (2026-05-04 07:00:06)"; the date only where the plan has one.
std::string time_text(const Recording& recording, double t);

/// What a record tells, in one line without its end: "chain ends exhausted, 3 successes".
std::string record_text(const Recording& recording, const TaskRun& run, const Event& event);

/// What is shown at a stop: the task, the number of the attempt and the time; the line of the
/// script; what was tried and how it ended.
std::string stop_text(const Recording& recording, const TaskRun& run, const TaskState& state,
                      const Paint& paint);

/// "motion 2 of 3: carrying wall_1, waypoint 1"; what is done, if no motion goes on.
std::string situation_text(const Recording& recording, const TaskRun& run, const TaskState& state);

}  // namespace rubicon::debug
