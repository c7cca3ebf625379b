#pragma once

#include <cstddef>
#include <vector>

#include "src/results/gltf/key_curve.hpp"
#include "src/results/replay/robot_track.hpp"

namespace rubicon::gltf {

/// How one element of a frame moves: `start` is its value at the beginning; metres, or degrees in
/// the first component. Without keys it stands still. Times are seconds of the plan.
struct ElementCurve {
  robot::FrameElement::Kind kind = robot::FrameElement::Kind::trans;
  Vec3 start = Vec3::Zero();
  KeyCurve keys;
};

/// The elements of one frame: of a body, or of the tool (which comes last).
using FrameCurves = std::vector<ElementCurve>;

/// How all frames of a robot move along its track. Elements whose formulas are no straight lines
/// are sampled; keys on a line are left out. No value is off by more than kCurveSlack (m) or
/// kTurnSlack (degrees). Throws std::invalid_argument for frames that go beyond all bounds, or
/// take more than kMostKeys.
std::vector<FrameCurves> motion_curves(const replay::Machine& machine,
                                       const replay::RobotTrack& track);

/// How many keys of the film they take.
std::size_t film_keys(const std::vector<FrameCurves>& frames);

/// A film has no more keys than this; frames that need more are hostile.
inline constexpr std::size_t kMostKeys = 4'000'000;
/// Degrees from key to key: turns run the shorter way.
inline constexpr double kShortTurn = 90;

/// m. With half a dozen elements the load of a crane is off by less than 1 mm.
inline constexpr double kCurveSlack = 1e-4;
/// Degrees: 0.17 mm at the end of a jib of 100 m.
inline constexpr double kTurnSlack = 1e-4;

}  // namespace rubicon::gltf
