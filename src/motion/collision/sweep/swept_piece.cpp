#include "src/motion/collision/sweep/swept_piece.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/convex/convex_pieces.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::collision {
namespace {

/// Added to the chord deviation of points (m): more than the rounding of a piece of 1 km.
constexpr double kChordRounding = 1e-12;
/// A motion that does not bound itself sweeps everything: a ball of this radius (m) is more than
/// any site.
constexpr double kEverywhere = 1e7;
/// A disc that tilts is followed by a polygon around it of at least, and at most, so many corners.
constexpr int kLeastCorners = 8;
constexpr int kMostCorners = 1024;
/// This share of what a slice may have of excess goes to the polygon.
constexpr double kPolygonShare = 0.25;
/// Directions of ordinary contact are kept for pieces with few; the others need none.
constexpr std::size_t kFewDirections = 8;
/// Corners are looked through for those that add nothing where they are so few.
constexpr std::size_t kFewCorners = 32;

/// A regular polygon around a disc.
struct AroundDisc {
  std::vector<Vec3> corners;  ///< about the disc's centre
  double excess = 0;          ///< m, of the corners over the disc
};

AroundDisc around_disc(const Vec3& axis, double radius, double excess) {
  // 1 / cos(180 / n) - 1 is at most 5.3 / n^2 from 8 corners on.
  const double wanted = std::sqrt(5.3 * radius / std::max(excess, kChordRounding));
  const int count =
      static_cast<int>(std::ceil(std::clamp<double>(wanted, kLeastCorners, kMostCorners)));
  const double outer = radius / math::cos_deg(180.0 / count);
  const Vec3 x = axis.unitOrthogonal();
  const Vec3 y = axis.cross(x);
  AroundDisc result;
  result.excess = outer - radius;
  for (int i = 0; i < count; ++i) {
    const double angle = 360.0 * i / count;
    result.corners.push_back(outer * (math::cos_deg(angle) * x + math::sin_deg(angle) * y));
  }
  return result;
}

/// Whether one of the others lies behind `point` along d: on the way it passes where `point` starts
/// or ends.
bool passed_by_another(const std::vector<Vec3>& points, const Vec3& point, const Vec3& d) {
  const double length = d.norm();
  return std::any_of(points.begin(), points.end(), [&](const Vec3& other) {
    const Vec3 between = point - other;
    return between.dot(d) > 0 && between.cross(d).norm() <= kParallel * length;
  });
}

std::vector<Vec3> corners_of_translation(const std::vector<Vec3>& points, const Vec3& way) {
  const bool few = points.size() <= kFewCorners;
  std::vector<Vec3> corners;
  for (const Vec3& point : points) {
    if (!few || !passed_by_another(points, point, way)) corners.push_back(point);
    if (!few || !passed_by_another(points, point, -way)) corners.push_back(point + way);
  }
  return corners;
}

/// Greatest difference of the ways of two corners, with their chord deviation: how far a point of
/// the hull of both ends may be from every pose. A point l p(s0) + (1 - l) q(s1) of the hull is l
/// (1 - l) times that difference away from where the chord of the body's point l p + (1 - l) q is
/// at 1 - l.
double excess_of_hull(const std::vector<Vec3>& ways, double deviation) {
  Bounds bounds;
  for (const Vec3& way : ways) bounds.add(way);
  double radius = 0;
  for (const Vec3& way : ways) radius = std::max(radius, (way - bounds.centre()).norm());
  return 0.25 * 2 * radius + 2 * deviation;
}

}  // namespace

PieceSlice::PieceSlice(const Body& body, const Motion& motion, double s0, double s1)
    : extent_(body.extent()),
      motion_(motion),
      screw_(screw_of(motion)),
      s0_(s0),
      s1_(s1),
      start_(centred(motion, extent_, s0)),
      end_(centred(motion, extent_, s1)),
      shift_(end_.t - start_.t) {}

Bounds PieceSlice::bounds(const Bounds& own) const {
  Bounds result = placed(own, start_);
  result.add(placed(own, end_));
  if (screw_ != nullptr && screw_->angle_deg == 0) return result;
  const double radius = own.half().norm();
  const double deviation = chord_deviation(distance_from_axis(at_start(own.centre())) + radius,
                                           (own.centre() + extent_.centre).norm() + radius);
  result.grow(screw_ != nullptr ? Vec3(deviation * across_axes(screw_->axis))
                                : Vec3::Constant(deviation));
  return result;
}

SweptPiece PieceSlice::sweep(const Convex& piece, double growth) const {
  SweptPiece result;
  if (screw_ != nullptr && screw_->angle_deg == 0) {
    result.piece = translated(piece, shift_);
  } else {
    result = turned(piece, growth);
  }
  result.piece.width = piece.width;
  result.piece.update_bounds();
  return result;
}

ConvexPiece PieceSlice::standing(const Convex& piece) const {
  ConvexPiece result = translated(piece, Vec3::Zero());
  result.width = piece.width;
  result.update_bounds();
  return result;
}

/// Faces and edges of the sum of the piece and the way: its own, and what its edges sweep.
ConvexPiece PieceSlice::translated(const Convex& piece, const Vec3& way) const {
  ConvexPiece swept;
  for (const Vec3& vertex : piece.vertices) swept.vertices.push_back(at_start(vertex));
  swept.ball = piece.ball;
  swept.disc = piece.disc;
  swept.disc_axis = at_start(piece.disc_axis);
  for (const Vec3& normal : piece.normals) swept.normals.push_back(at_start(normal));
  for (const Vec3& edge : piece.edges) swept.edges.push_back(at_start(edge));
  const double length = way.norm();
  if (length == 0) return swept;
  swept.vertices = corners_of_translation(swept.vertices, way);
  const Vec3 direction = way / length;
  const auto add_face_along = [&](const Vec3& edge) {
    const Vec3 normal = direction.cross(edge);
    if (normal.norm() > kParallel) add_direction(swept.normals, normal.normalized());
  };
  for (const Vec3& edge : swept.edges) add_face_along(edge);
  if (piece.disc > 0) add_face_along(swept.disc_axis);
  add_direction(swept.edges, direction);
  return swept;
}

SweptPiece PieceSlice::turned(const Convex& piece, double growth) const {
  SweptPiece result;
  ConvexPiece& swept = result.piece;
  std::vector<Vec3> own(piece.vertices.begin(), piece.vertices.end());
  const bool disc_turns_in_itself =
      screw_ != nullptr && at_start(piece.disc_axis).cross(screw_->axis).norm() <= kParallel;
  if (piece.disc > 0 && !disc_turns_in_itself) {
    const double allowed = kPolygonShare * std::max(growth, excess_estimate(piece));
    const AroundDisc polygon = around_disc(piece.disc_axis, piece.disc, allowed);
    own.clear();
    for (const Vec3& vertex : piece.vertices) {
      for (const Vec3& corner : polygon.corners) own.push_back(vertex + corner);
    }
    result.excess = polygon.excess;
  }
  std::vector<Vec3> ways;
  double greatest_radius = 0;
  double reach = 0;
  for (const Vec3& point : own) {
    swept.vertices.push_back(at_start(point));
    ways.push_back(at_end(point) - swept.vertices.back());
    greatest_radius = std::max(greatest_radius, distance_from_axis(swept.vertices.back()));
    reach = std::max(reach, (point + extent_.centre).norm());
  }
  for (const Vec3& point : own) swept.vertices.push_back(at_end(point));
  const double deviation = chord_deviation(greatest_radius, reach);
  result.excess += excess_of_hull(ways, deviation);
  swept.ball = piece.ball;
  if (screw_ != nullptr) {
    // Arcs deviate across the axis only, whatever the slide.
    swept.disc_axis = screw_->axis;
    swept.disc = deviation + (disc_turns_in_itself ? piece.disc : 0);
    swept.normals.push_back(screw_->axis);
  } else {
    swept.ball += deviation;
  }
  if (piece.normals.size() <= kFewDirections) {
    for (const Placement* pose : {&start_, &end_}) {
      for (const Vec3& normal : piece.normals) swept.normals.push_back(pose->R * normal);
    }
  }
  return result;
}

/// About what the hull of both ends has of excess because the piece turns.
double PieceSlice::excess_estimate(const Convex& piece) const {
  return 0.5 * (end_.R - start_.R).norm() * piece.bounds.half().norm();
}

/// Distance from the axis of a screw (m).
double PieceSlice::distance_from_axis(const Vec3& at_start) const {
  if (screw_ == nullptr) return 0;
  return screw_->axis.cross(at_start + start_.t - screw_->point).norm();
}

/// How far points deviate from their chords (m), by their greatest radius about the axis of a
/// screw, or by how far they are from the origin of the body's frame.
double PieceSlice::chord_deviation(double radius, double reach) const {
  if (screw_ != nullptr)
    return unit_sagitta_of((s1_ - s0_) * screw_->angle_deg) * radius + kChordRounding;
  const double deviation = general_of(motion_)->chord_deviation(s0_, s1_, reach) + kChordRounding;
  return deviation >= 0 ? std::min(deviation, kEverywhere) : kEverywhere;
}

}  // namespace rubicon::collision
