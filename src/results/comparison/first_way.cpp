#include "src/results/comparison/first_way.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>
#include <vector>

#include "interpreter/syntax/name_suggestion.hpp"
#include "src/results/comparison/first_report.hpp"
#include "src/results/comparison/looked_at.hpp"
#include "src/results/comparison/ompl_guide.hpp"
#include "src/simulation/taskplan/run_plan.hpp"

namespace rubicon::comparison {

namespace {

constexpr std::string_view kOmplPrefix = "ompl ";

/// The guide of the task of that kind, or one as it is by default.
guides::GuideSpec chosen_guide(const std::vector<guides::GuideSpec>& named,
                               const std::string& kind) {
  if (kind.empty()) {
    return named.empty() ? guides::default_guide(guides::GuideKind::rrt_connect) : named.front();
  }
  if (kind.starts_with(kOmplPrefix)) {
    for (const guides::GuideSpec& spec : named) {
      if (guides::full_name(spec) == kind) return spec;
    }
    return ompl_guide(kind.substr(kOmplPrefix.size()));
  }
  const auto found = guides::find_kind(kind);
  if (!found) {
    std::vector<std::string> names;
    for (const guides::KindInfo& info : guides::guide_kinds()) names.emplace_back(info.name);
    interpreter::NameSuggestions suggestions;
    throw std::invalid_argument(fmt::format("unknown kind of guide '{}'{}", kind,
                                            suggestions.ending(kind, [&] { return names; })));
  }
  for (const guides::GuideSpec& spec : named) {
    if (spec.kind == *found) return spec;
  }
  if (*found == guides::GuideKind::ompl) {
    throw std::invalid_argument(
        "which planner of OMPL? The task names none; for example --kind \"ompl RRTConnect\"");
  }
  return guides::default_guide(*found);
}

}  // namespace

void with_first_way(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                    const std::string& task, const std::string& kind,
                    const std::function<void(const FirstWay& way)>& use) {
  bool used = false;
  taskplan::RunOptions options;
  options.detail = trace::TraceDetail::none;
  options.on_motion = [&](const std::string& name, taskplan::MotionPurpose,
                          const interpreter::Program& program,
                          const interpreter::MotionTask& motion, const interpreter::World& world) {
    if (name != task || used) return;
    interpreter::MotionTask planned = motion;
    guides::GuideSpec spec = chosen_guide(motion.guides, kind);
    spec.tells_tree = true;
    spec.thinks = 0;
    planned.guides = {spec};
    LookedAt looked_at(world);
    FirstReport first;
    interpreter::Machine(program, planned).advance(looked_at, &first);
    if (!first.report) return;
    used = true;
    use({program, planned, world, spec, *first.report, first.cause});
  };
  taskplan::run_plan(plan, sources, nullptr, options);
}

}  // namespace rubicon::comparison
