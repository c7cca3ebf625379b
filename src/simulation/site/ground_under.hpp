#pragma once

#include <cstddef>
#include <functional>

#include "src/earth/soil/terrain.hpp"
#include "src/motion/math/pose.hpp"
#include "src/simulation/site/workspace.hpp"

namespace rubicon::site {

/// Whether a cell of an earth for which `asks` holds has more than its edge in common with a part
/// of the site in the plan view.
bool has_cell_under(const PlanRegion& region, const math::Pose& X_WE, const soil::Terrain& earth,
                    const std::function<bool(std::size_t cell)>& asks);

}  // namespace rubicon::site
