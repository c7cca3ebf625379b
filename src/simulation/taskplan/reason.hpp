#pragma once

#include <string>

#include "interpreter/machine/machine.hpp"
#include "interpreter/syntax/source.hpp"
#include "src/simulation/taskplan/hit_recorder.hpp"
#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::taskplan {

/// Why a motion did not do what its task needs, in one sentence for people: who was in the way, at
/// which step, by which script line (`hit` may be null); or the machine's own words and their
/// place.
std::string reason_of(const interpreter::MotionEnd& end, const RecordedHit* hit,
                      const interpreter::SourceMap& sources);

/// The reason of a task's motion: names the motion where the task has several.
std::string task_reason(const MotionOutcome& motion, const RecordedHit* hit,
                        const std::string& component, const interpreter::SourceMap& sources);

}  // namespace rubicon::taskplan
