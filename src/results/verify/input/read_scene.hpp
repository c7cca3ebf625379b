#pragma once

#include <string>

#include "src/results/verify/input/scene.hpp"

namespace rubicon::verify {

/// The scene of a trace's first line; throws UnreadableInput if it is no header, or its numbers
/// make no scene.
Scene read_scene(const std::string& line);

}  // namespace rubicon::verify
