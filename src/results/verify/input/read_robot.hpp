#pragma once

#include "src/results/verify/input/json_fields.hpp"
#include "src/results/verify/input/scene.hpp"

namespace rubicon::verify {

/// One robot of a header, but for its calendar; `meshes` is how many meshes there are. Throws
/// UnreadableInput.
SceneRobot read_robot(const JsonFields& fields, std::size_t meshes);

/// m and degrees. Throws UnreadableInput.
SceneDeviation read_deviation(const JsonFields& fields);

}  // namespace rubicon::verify
