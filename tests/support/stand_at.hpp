#pragma once

#include <utility>
#include <vector>

#include "src/simulation/site/site_world.hpp"

namespace rubicon::test {

/// The robot stands at q, whatever it was doing.
inline void stand_at(site::SiteWorld& site, int robot, std::vector<double> q) {
  site::MachineState state = site.machine_state(robot);
  state.q = std::move(q);
  state.step.reset();
  site.set_machine_state(robot, std::move(state));
}

}  // namespace rubicon::test
