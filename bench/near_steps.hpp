#pragma once

#include <functional>

#include "bench/random.hpp"
#include "bench/swept_scene.hpp"

namespace rubicon::bench {

/// What a step does: half a metre in any direction, or five degrees about an axis up to 30 m away
/// (every second axis is vertical, as a crane's).
enum class StepKind { kTranslation, kRotation };

/// "T" or "R".
const char* name_of(StepKind kind);

/// A step from X0 with the centre of the load at its origin.
geometry::ScrewMotion random_step(StepKind kind, const Pose& X0, Random& random);

/// `count` steps that start where `start` puts them and nothing is in the way (`blocked` says no).
/// Throws std::runtime_error if such places cannot be found.
std::vector<geometry::ScrewMotion> steps_from_free_places(
    StepKind kind, int count, Random& random, const std::function<Pose()>& start,
    const std::function<bool(const Pose&)>& blocked);

}  // namespace rubicon::bench
