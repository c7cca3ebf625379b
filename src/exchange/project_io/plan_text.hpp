#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "interpreter/check/check_number.hpp"
#include "interpreter/syntax/diagnostic.hpp"
#include "src/exchange/project_io/plan_crews.hpp"
#include "src/exchange/project_io/project.hpp"

namespace rubicon::project_io {

/// Longest duration and lag of a plan, in seconds: what `rubicon check` takes.
inline constexpr double kMaxPlanSeconds = interpreter::kMaxDuration;

/// What a plan has that is made of a schedule and something else.
struct PlanInsert {
  /// A task of the plan that does a part of a task of the schedule.
  struct Part {
    std::string name;     ///< unique among the parts
    std::string items;    ///< all but its links, as plan text
    bool awaited = true;  ///< what comes after the task waits for this part
  };
  std::string items;                ///< of the plan, before its tasks: robots, components ...
  std::set<std::string> workers;    ///< names of robots and crews in them
  std::set<std::string> calendars;  ///< names of calendars in them
  /// By uid of a task: what is done in place of its duration. Such a task becomes a milestone
  /// NAME_begins, to which the links to its start go, its parts, which wait for that, and a
  /// milestone NAME_ends behind all of them.
  std::map<std::int64_t, std::vector<Part>> parts;
};

/// Whether tasks of the plan say when the schedule has them (`baseline`: its baseline, else its
/// dates) and their deadlines (`due`).
enum class Baselines { left_out, written };

/// The project as a plan that a person can read and `rubicon check` takes, in canonical form.
/// Headings are comments, tasks have their name there as attribute, take their duration and wait
/// for what they are linked to, resources are crews (several, where it is not levelled and their
/// tasks may meet), and a task without one gets a crew of its own where a calendar holds. What a
/// plan has no word for is carried along in an import block, so that `project_of` gives an equal
/// project; where the plan then goes by less than the schedule says, a warning tells (I08). `file`
/// is the name of the schedule's file.
std::string plan_text(const Project& project, const std::string& file,
                      interpreter::Diagnostics& diagnostics, const PlanInsert& insert = {},
                      Levelling levelling = Levelling::none,
                      Baselines baselines = Baselines::left_out);

}  // namespace rubicon::project_io
