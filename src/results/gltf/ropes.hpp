#pragma once

#include <optional>
#include <vector>

#include "src/results/gltf/motion_curves.hpp"

namespace rubicon::gltf {

using math::Pose;

/// m: half the thickness of a rope. Thicker than ropes are, so that it is seen from far away.
inline constexpr double kRopeHalf = 0.05;

/// The rope of a crane, which no body of it stands for: plumb, from the frame of the body that
/// carries the hook down to that of the hook.
struct Rope {
  int above = -1;  ///< the body that it hangs on
  double start = 0;
  KeyCurve length;  ///< m, in the first component; without keys it stays as at the start
};

/// Nothing for a machine whose tool does not hang below a body, at least 1 m at some time and
/// always upright. The page decides in the same way (viewer/src/view/ropes.ts), moment by moment.
std::optional<Rope> rope_of(const replay::Machine& machine, const std::vector<FrameCurves>& frames);

/// A rope of 1 m, from the origin down.
geometry::Shape rope_shape();

/// Slings from the tool to the upper corners of a load, in the frame of the load; none where it
/// does not hang below the tool.
std::vector<geometry::Shape> slings(const std::vector<geometry::Shape>& load, const Pose& X_TO);

}  // namespace rubicon::gltf
