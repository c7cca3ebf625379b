#pragma once

#include <string>

#include "src/motion/guides/guide_spec.hpp"

namespace rubicon::comparison {

/// A guide by a planner of OMPL, as it is by default. Throws std::invalid_argument with a message
/// for the user: there is no such planner, guides do not take it, or this build has no OMPL.
guides::GuideSpec ompl_guide(const std::string& planner);

}  // namespace rubicon::comparison
