#include "src/results/comparison/ompl_guide.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

#include "interpreter/syntax/name_suggestion.hpp"
#include "src/motion/ompl_bridge/ompl_library_io.hpp"
#include "src/motion/ompl_bridge/ompl_planners.hpp"

namespace rubicon::comparison {

guides::GuideSpec ompl_guide(const std::string& planner) {
  const ompl_bridge::OmplPlanner* const found = ompl_bridge::find_ompl_planner(planner);
  if (found == nullptr) {
    std::vector<std::string> names;
    for (const auto& each : ompl_bridge::ompl_planners()) {
      if (each.taken()) names.emplace_back(each.name);
    }
    interpreter::NameSuggestions suggestions;
    throw std::invalid_argument(fmt::format("OMPL has no geometric planner '{}'{}", planner,
                                            suggestions.ending(planner, [&] { return names; })));
  }
  if (!found->taken()) {
    throw std::invalid_argument(
        fmt::format("guides do not take {} of OMPL: {}", planner, found->refusal));
  }
  if (ompl_bridge::ompl_library() == nullptr) {
    throw std::invalid_argument(
        fmt::format("{}; {}", ompl_bridge::ompl_fault(), ompl_bridge::kGetOmpl));
  }
  guides::GuideSpec spec = guides::default_guide(guides::GuideKind::ompl);
  spec.planner = planner;
  return spec;
}

}  // namespace rubicon::comparison
