#pragma once

#include "src/collision/placement.hpp"
#include "src/collision/verdict.hpp"

namespace rubicon::collision {

/// A box with its own axes: the points centre + R v with |v_i| <= half_i (m).
struct OrientedBox {
  Mat3 R = Mat3::Identity();
  Vec3 centre = Vec3::Zero();
  Vec3 half = Vec3::Zero();
};

inline OrientedBox placed(const OrientedBox& box, const Placement& X) {
  return {X.R * box.R, X * box.centre, box.half};
}

/// A box that is translated by `d` (m) against one that stands, both in the same frame; d may be 0.
/// Exact (21 axes: Gottschalk, Lin, Manocha 1996, with displacement x edge) but for pairs of edges
/// that are nearly parallel, which leave it undecided.
Verdict translated_box_verdict(const OrientedBox& moving, const Vec3& d, const OrientedBox& fixed,
                               double tolerance);

/// A box over one interval of a rotation, screw or general motion: at all times inside the hull of
/// its poses at the start and at the end, grown along a unit direction n by
/// axial_growth |n across growth_axis| + uniform_growth (docs/collision.md).
struct TurnedBox {
  Mat3 R_start = Mat3::Identity();
  Mat3 R_middle = Mat3::Identity();
  Mat3 R_end = Mat3::Identity();
  Vec3 start = Vec3::Zero();  ///< of the centre
  Vec3 end = Vec3::Zero();
  Vec3 half = Vec3::Zero();
  Vec3 growth_axis = Vec3::UnitZ();
  double axial_growth = 0;    ///< m
  double uniform_growth = 0;  ///< m
};

/// Whether a turning box is proved free of one that stands: with the same axes, those of the moving
/// box at the middle pose. Never `kHit`.
Verdict turned_box_verdict(const TurnedBox& moving, const OrientedBox& fixed, double tolerance);

}  // namespace rubicon::collision
