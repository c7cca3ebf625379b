#pragma once

#include "src/motion/geometry/motion.hpp"

namespace rubicon::site {

/// The motion of a body {O} that is fixed to a moving frame {T} at X_TO: X_WO(s) = X_WT(s) * X_TO,
/// with the same rigour as the motion of {T}.
geometry::Motion attached_motion(const geometry::Motion& tool, const math::Pose& X_TO);

}  // namespace rubicon::site
