#pragma once

#include <vector>

#include "src/results/replay/task_run.hpp"
#include "src/simulation/trace/header.hpp"

namespace rubicon::replay {

/// A component that stands somewhere for some time.
struct Stay {
  int component = -1;
  math::Pose X_WO = math::Pose::Identity();
  Ticks from = 0;
  Ticks to = 0;
};

/// Where the components stand through the plan (its end is `until`), by component, then by time.
std::vector<Stay> component_stays(const std::vector<trace::HeaderComponent>& components,
                                  const std::vector<TaskRun>& runs, Ticks until);

}  // namespace rubicon::replay
