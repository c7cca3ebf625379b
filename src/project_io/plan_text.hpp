#pragma once

#include <string>

#include "interpreter/check_number.hpp"
#include "interpreter/diagnostic.hpp"
#include "src/project_io/project.hpp"

namespace rubicon::project_io {

/// Longest duration and lag of a plan, in seconds: what `rubicon check` takes.
inline constexpr double kMaxPlanSeconds = interpreter::kMaxDuration;

/// The project as a plan that a person can read and `rubicon check` takes, in canonical form.
/// Headings are comments, tasks take their duration and wait for what they are linked to, resources
/// are crews, and a task without one gets a crew of its own where a calendar holds. What a plan has
/// no word for is carried along in an import block, so that `project_of` gives an equal project;
/// where the plan then goes by less than the schedule says, a warning tells (I08). `file` is the
/// name of the schedule's file.
std::string plan_text(const Project& project, const std::string& file,
                      interpreter::Diagnostics& diagnostics);

}  // namespace rubicon::project_io
