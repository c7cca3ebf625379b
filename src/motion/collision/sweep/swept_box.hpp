#pragma once

#include "src/motion/collision/base/oriented_box.hpp"
#include "src/motion/collision/base/verdict.hpp"

namespace rubicon::collision {

/// A box that is translated by `d` (m) against one that stands, both in the same frame; d may be 0.
/// Exact, never undecided (21 axes: Gottschalk, Lin, Manocha 1996, with displacement x edge).
Verdict translated_box_verdict(const OrientedBox& moving, const Vec3& d, const OrientedBox& fixed,
                               double tolerance);

/// A box over one interval of a rotation, screw or general motion: at all times inside the hull of
/// its poses at the start and at the end, grown along a unit direction n by
/// axial_growth |n across growth_axis| + uniform_growth (docs/collision.md).
struct TurnedBox {
  Mat3 R_start = Mat3::Identity();
  Mat3 R_end = Mat3::Identity();
  Vec3 start = Vec3::Zero();  ///< of the centre
  Vec3 end = Vec3::Zero();
  Vec3 half = Vec3::Zero();
  Vec3 growth_axis = Vec3::UnitZ();
  double axial_growth = 0;    ///< m
  double uniform_growth = 0;  ///< m
};

/// A turning box against one that stands. The axes tried are those of the standing box, then those
/// of the moving one at its middle pose with all products of edges and the displacement: the same
/// as for translations. Free is proved, anything else undecided.
class TurnedBoxAxes {
 public:
  TurnedBoxAxes(const TurnedBox& moving, const OrientedBox& fixed, double tolerance);

  /// By the normals of the standing box alone; settles most pairs, and needs no middle pose.
  bool free_along_fixed_normals() const;
  /// By those of the moving one.
  bool free_along_moving_normals(const Mat3& R_middle) const;
  /// By all products of edges, and of the displacement with edges.
  bool free_along_edges(const Mat3& R_middle) const;

 private:
  bool free_along_scaled(const Vec3& n, double scale_squared) const;
  bool free_along(const Vec3& n) const;

  const TurnedBox& moving_;
  const OrientedBox& fixed_;
  double tolerance_;
  Mat3 to_fixed_;
  Mat3 R_start_;  ///< these in the frame of the fixed box
  Mat3 R_end_;
  Vec3 start_;
  Vec3 end_;
  Vec3 axis_;
};

}  // namespace rubicon::collision
