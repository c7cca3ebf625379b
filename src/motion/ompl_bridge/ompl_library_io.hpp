#pragma once

#include <string>

#include "src/motion/ompl_bridge/ompl_plugin.hpp"

namespace rubicon::ompl_bridge {

/// The file rubicon-ompl.so beside the command, loaded when first asked for; null: it is not there,
/// or cannot be loaded.
const OmplPlugin* ompl_library();

/// Why it is null; "" if it is there.
const std::string& ompl_fault();
/// What to do then.
inline constexpr const char* kGetOmpl =
    "install libompl-dev and build again, or take another kind of guide";

}  // namespace rubicon::ompl_bridge
