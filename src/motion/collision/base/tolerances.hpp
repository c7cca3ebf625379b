#pragma once

#include <algorithm>

namespace rubicon::collision {

/// Depths below this are contact whatever the tolerance (m). Reason: poses 1e5 m from the origin
/// are rounded to 1.5e-11 m and rotations of such a radius to 1e-10 m. Consequence: a tolerance of
/// 0 means one nanometre.
inline constexpr double kRoundingDepth = 1e-9;

/// A pair's tolerance is at most this share of the thinner one's width. Reason: two sheets thinner
/// than the tolerance would otherwise pass through each other in small steps, and a rod through the
/// internal cut of a prism. Consequence: below a width of four tolerances contact is judged more
/// strictly.
inline constexpr double kThinShare = 0.25;

/// The share above never asks for more than this precision (m). Reason: vertices of fine meshes are
/// often single precision.
inline constexpr double kThinFloor = 10e-6;

/// The most that something of this width (m) is allowed to be deep in anything (m).
inline double thickness_tolerance(double width) { return std::max(kThinShare * width, kThinFloor); }

/// The contact tolerance of a pair of pieces by their widths: the given one, less for thin things.
inline double pair_tolerance(double width_a, double width_b, double contact_tolerance) {
  return std::max(std::min(contact_tolerance, thickness_tolerance(std::min(width_a, width_b))),
                  kRoundingDepth);
}

/// Triangles whose smallest altitude is below this (m) are dropped: their plane is noise, their
/// neighbours cover the place.
inline constexpr double kDegenerateAltitude = 1e-9;

/// A screw's interval is not split further once the sagitta of its arcs (m) is below this; still
/// undecided means hit.
inline constexpr double kScrewResolution = 1e-7;

/// The same for general motions (m), whose bounds are looser; never more than a quarter of the
/// contact tolerance.
inline constexpr double kGeneralResolution = 1e-5;

/// An interval must also turn so little that no point of the smaller part moves more than this
/// against a fixed direction (m) before "undecided" may be called a hit. Consequence: false hits
/// only nearer than about this to the tolerance.
inline constexpr double kTurnResolution = 1e-5;

/// And it must travel so little (m): where a corner passes a corner the swept volume is deeper than
/// any pose, by up to some share of the way. Without this 35 of a million random steps were called
/// hits with 0.1 to 0.4 mm to spare.
inline constexpr double kTravelResolution = 1e-4;

/// Intervals one pair of pieces may look at before it is called a hit: keeps hostile motions from
/// taking for ever.
inline constexpr int kMaxIntervals = 1 << 16;

/// The same for all pairs of pieces of two bodies together: about a second. Two meshes of tens of
/// thousands of triangles that turn a long way closely past each other are called a hit.
inline constexpr int kMaxIntervalsOfBodies = 1 << 20;

/// No interval is split below this share of the step: a motion whose bounds never become small is
/// called a hit.
inline constexpr double kShortestInterval = 1e-8;

/// When a contact begins is sought to this share of the step; a step of a metre is so known to 0.1
/// mm.
inline constexpr double kContactResolution = 1e-4;

/// The bounding boxes of a slice are useful while its growth is below this share of the bodies'
/// size; larger steps are cut into slices, at most so many.
inline constexpr double kUsefulGrowth = 0.05;
inline constexpr int kMaxSlices = 64;

/// Times a slice is halved by the fast path for what is neither proved free nor seen to hit; the
/// growth falls to a quarter each time. What is still undecided is left to the general narrow
/// phase.
inline constexpr int kHalvings = 8;

/// Directions nearer than this (sine of their angle) are one direction in the feature lists.
/// Consequence: at 100 m extent a lost direction costs 1e-7 m of false depth, never a miss.
inline constexpr double kSameDirection = 1e-9;

/// Axes whose cross product is shorter than this count as parallel; over a metre of disc that is
/// below 1e-12 m.
inline constexpr double kParallel = 1e-12;

/// Added around bounding boxes (m) so that rounding never hides a pair.
inline constexpr double kBoundsMargin = 1e-6;

}  // namespace rubicon::collision
