#pragma once

#include "bench/near_steps.hpp"

namespace rubicon::bench {

/// `count` panels at constant density: walls and slabs of 1 to 6 m on four storeys, half of them
/// parallel to the axes. The load, a wall panel, makes its steps among them.
SweptScene panel_scene(int count, StepKind kind);

/// The same panels; the load travels to and fro along a line far above all of them.
SweptScene free_scene(int count, StepKind kind);

}  // namespace rubicon::bench
