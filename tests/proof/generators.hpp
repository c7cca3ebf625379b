#pragma once

#include <span>

#include "tests/proof/case.hpp"

namespace rubicon::collision::proof {

/// Steps, by family; each list in the order of the table.
std::span<const Generator> box_generators();
std::span<const Generator> touch_generators();
std::span<const Generator> convex_generators();
std::span<const Generator> mesh_generators();
std::span<const Generator> scene_generators();
/// Poses.
std::span<const Generator> static_generators();
/// Poses and steps of meshes whose faces lie in each other.
std::span<const Generator> aligned_generators();
/// Steps over soil that is dug bit by bit.
std::span<const Generator> soil_generators();

}  // namespace rubicon::collision::proof
