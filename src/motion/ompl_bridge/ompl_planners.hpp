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
  /// Their names, with spaces between them; not those with which an assertion of OMPL may end the
  /// program.
  const char* parameters;
  const char* refusal;  ///< why guides do not take it; "": they do

  bool taken() const { return *refusal == '\0'; }
};
std::span<const OmplPlanner> ompl_planners();
const OmplPlanner* find_ompl_planner(std::string_view name);
std::vector<std::string> parameters_of(const OmplPlanner& planner);

/// Which values a parameter may be given: counts of samples are from 1 on.
struct Setting {
  double least = 0;
  double most = 0;
};
Setting setting_of(std::string_view parameter);

}  // namespace rubicon::ompl_bridge
