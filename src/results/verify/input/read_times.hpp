#pragma once

#include <string>

#include "src/results/verify/input/scene.hpp"

namespace rubicon::verify {

/// The number in `scene.times` of a column of a file of measured times, which is read from the text
/// that the trace has of it when it is first named. Throws UnreadableInput.
int times_of(Scene& scene, const std::string& file, const std::string& unit, int column);

/// Whether so many seconds are one of the times, to the rounding of a trace.
bool was_measured(const SceneTimes& times, double seconds);

}  // namespace rubicon::verify
