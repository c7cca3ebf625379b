#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/exchange/building_io/element.hpp"
#include "src/exchange/building_io/match_file.hpp"
#include "src/exchange/project_io/project.hpp"

namespace rubicon::building_io {

/// A task of the schedule and what it puts into place.
struct Activity {
  std::size_t task = 0;   ///< index in Project::tasks
  std::string plan_name;  ///< of its line in the plan
  struct Move {
    std::size_t element = 0;
    std::size_t rule = 0;
  };
  std::vector<Move> moves;  ///< in the order in which they are done
};

/// What belongs to what.
struct Matching {
  std::vector<Activity> activities;     ///< in the order of the schedule
  std::vector<std::size_t> standing;    ///< elements that stand from the beginning
  std::vector<std::size_t> left_out;    ///< elements that a rule leaves out
  std::vector<std::size_t> unmatched;   ///< elements that no rule is about
  std::vector<std::size_t> idle_tasks;  ///< indices of tasks that put nothing into place
  std::vector<std::string> plan_names;  ///< of the lines of the schedule in the plan
};

/// Joins elements to tasks: for each element the first rule that fits. Within a task the rules
/// come one after the other; of one rule the lower elements before the higher (by their lower
/// sides, in steps of 10 cm), those of one height along the longer side of the task's work, then
/// across it. A rule whose task is not in the schedule, or is called like others, is an error
/// (I13).
Matching match_elements(const std::vector<Element>& elements, const MatchFile& match,
                        const project_io::Project& project, interpreter::Diagnostics& diagnostics);

}  // namespace rubicon::building_io
