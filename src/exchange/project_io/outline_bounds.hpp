#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/exchange/project_io/carried_project.hpp"

namespace rubicon::project_io {

/// What the links of headings bind in a plan that came from a schedule: below a heading all wait
/// for its beginning, and its end waits for them.
class OutlineBounds {
 public:
  OutlineBounds(const interpreter::PlanModel& plan, const CarriedProject& carried);

  /// The line of the schedule at whose beginning or end this milestone stands; null if at none.
  const MilestonePlace* place(const std::string& milestone) const;

  /// The task of the plan that stands for the beginning or the end of a line; null if there is
  /// none.
  const interpreter::TaskSpec* milestone_of(const std::string& line, bool ends) const;

  /// What the links of a heading would say of a task (an index of the plan) below it and the plan
  /// does not; empty: nothing.
  std::string objection(const std::string& heading, std::size_t task);

 private:
  using Key = std::pair<std::string, bool>;  // the line, whether its end

  /// The tasks that by their links do not start before this one; or those that are finished when it
  /// is.
  std::vector<bool> bound_to(std::size_t milestone, bool ends) const;

  const interpreter::PlanModel& plan_;
  std::map<std::string, MilestonePlace> places_;
  std::map<Key, std::string> names_;
  std::unordered_map<std::string, std::size_t> index_;  ///< of the plan's tasks
  std::vector<std::vector<std::size_t>> started_by_;    ///< what starts no sooner than each
  std::map<Key, std::vector<bool>> bound_;
};

}  // namespace rubicon::project_io
