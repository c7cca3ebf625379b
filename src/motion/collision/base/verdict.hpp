#pragma once

namespace rubicon::collision {

/// What a test of a step found. `kFree` and `kHit` are proved; undecided means: look closer.
enum class Verdict { kFree, kHit, kUndecided };

}  // namespace rubicon::collision
