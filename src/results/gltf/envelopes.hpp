#pragma once

#include <vector>

#include "src/results/replay/machine.hpp"

namespace rubicon::gltf {

/// Of each body of a robot, whether it is no thing but room that the machine keeps for itself, such
/// as the column about the rope of a crane that reaches over another: it may touch another of its
/// bodies, and has it, or half of it, inside, as the machine stands at first. The page decides in
/// the same way (viewer/src/view/site_model.ts).
std::vector<bool> envelopes_of(const replay::Machine& machine);

}  // namespace rubicon::gltf
