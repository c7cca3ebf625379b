#pragma once

#include "src/motion/collision/base/verdict.hpp"
#include "src/motion/collision/sweep/sweep.hpp"

namespace rubicon::collision {

/// The short way to an answer for a moving body and one that stands at `X_WB` (of its centred
/// coordinates): boxes around parts, exact for parts that are boxes. Says free or hit only where
/// that is proved; containment is not looked at.
Verdict fast_path_verdict(Sweep& sweep, const Body& standing, const Placement& X_WB,
                          double contact_tolerance);

}  // namespace rubicon::collision
