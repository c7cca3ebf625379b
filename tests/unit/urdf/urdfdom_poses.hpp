#pragma once

#include <map>
#include <string>

#include "src/motion/math/pose.hpp"

namespace rubicon::urdf::testing {

/// Where the links of a URDF text are at these joint values (m, rad; those that mimic others are
/// counted here), by the library urdfdom and the standard mathematics of C++: an oracle that shares
/// nothing with the import. Empty if urdfdom cannot read the text.
std::map<std::string, math::Pose> urdfdom_poses(const std::string& text,
                                                const std::map<std::string, double>& values);

}  // namespace rubicon::urdf::testing
