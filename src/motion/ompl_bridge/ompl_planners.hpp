#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubicon::ompl_bridge {

/// A geometric planner of OMPL 1.5 by its name there. Known here, so that a plan is judged the same
/// whether OMPL is there or not.
struct OmplPlanner {
  const char* name;
  const char* parameters;  ///< their names, with spaces between them
  const char* refusal;     ///< why guides do not take it; "": they do

  bool taken() const { return *refusal == '\0'; }
};
std::span<const OmplPlanner> ompl_planners();
const OmplPlanner* find_ompl_planner(std::string_view name);
std::vector<std::string> parameters_of(const OmplPlanner& planner);

}  // namespace rubicon::ompl_bridge
