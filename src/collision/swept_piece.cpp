#include "src/collision/swept_piece.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/collision/convex_pieces.hpp"
#include "src/math/angles.hpp"

namespace rubicon::collision {
namespace {

/// Added to what points stray (m): more than the rounding of a piece of 1 km.
constexpr double kRounding = 1e-12;
/// A motion that does not bound itself sweeps everything: a ball of this radius (m) is more than
/// any site.
constexpr double kEverywhere = 1e7;
/// Axes whose cross product is shorter than this are parallel.
constexpr double kParallel = 1e-12;
/// A disc that tilts is followed by a polygon around it of at least, and at most, so many corners.
constexpr int kLeastCorners = 8;
constexpr int kMostCorners = 256;
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
  // 1 / cos(180 / n) - 1 is at most 8 / n^2 from 8 corners on.
  const double wanted = std::sqrt(8 * radius / std::max(excess, kRounding));
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

void add_corners_of_translation(std::vector<Vec3>& corners, const std::vector<Vec3>& points,
                                const Vec3& d) {
  const bool few = points.size() <= kFewCorners;
  for (const Vec3& point : points) {
    if (!few || !passed_by_another(points, point, d)) corners.push_back(point);
    if (!few || !passed_by_another(points, point, -d)) corners.push_back(point + d);
  }
}

/// Greatest difference of the ways of two corners, with what they stray: how far a point of the
/// hull of both ends may be from every pose. A point l p(s0) + (1 - l) q(s1) of the hull is
/// l (1 - l) times that difference away from where the chord of the body's point l p + (1 - l) q is
/// at 1 - l.
double excess_of_hull(const std::vector<Vec3>& ways, double stray) {
  Bounds bounds;
  for (const Vec3& way : ways) bounds.add(way);
  double radius = 0;
  for (const Vec3& way : ways) radius = std::max(radius, (way - bounds.centre()).norm());
  return 0.25 * 2 * radius + 2 * stray;
}

}  // namespace

PieceSlice::PieceSlice(const Body& body, const Motion& motion, double s0, double s1)
    : motion_(&motion),
      extent_(body.extent()),
      s0_(s0),
      s1_(s1),
      start_(centred(motion, extent_, s0)),
      end_(centred(motion, extent_, s1)),
      shift_(end_.t - start_.t) {}

SweptPiece PieceSlice::sweep(const Convex& piece, double growth) const {
  const geometry::ScrewMotion* screw = screw_of(*motion_);
  const bool translates = screw != nullptr && screw->angle_deg == 0;
  SweptPiece result = translates ? translated(piece) : turned(piece, growth);
  result.piece.width = piece.width;
  result.piece.update_bounds();
  return result;
}

/// Faces and edges of the sum of the piece and the way: its own, and what its edges sweep.
SweptPiece PieceSlice::translated(const Convex& piece) const {
  SweptPiece result;
  ConvexPiece& swept = result.piece;
  std::vector<Vec3> points;
  for (const Vec3& vertex : piece.vertices) points.push_back(at_start(vertex));
  add_corners_of_translation(swept.vertices, points, shift_);
  swept.ball = piece.ball;
  swept.disc = piece.disc;
  swept.disc_axis = start_.R * piece.disc_axis;
  for (const Vec3& normal : piece.normals) swept.normals.push_back(start_.R * normal);
  for (const Vec3& edge : piece.edges) swept.edges.push_back(start_.R * edge);
  const double length = shift_.norm();
  if (length == 0) return result;
  const Vec3 way = shift_ / length;
  const auto add_face_along = [&](const Vec3& edge) {
    const Vec3 normal = way.cross(edge);
    if (normal.norm() > kParallel) add_direction(swept.normals, normal.normalized());
  };
  const std::vector<Vec3> edges = swept.edges;
  for (const Vec3& edge : edges) add_face_along(edge);
  if (piece.disc > 0) add_face_along(swept.disc_axis);
  add_direction(swept.edges, way);
  return result;
}

SweptPiece PieceSlice::turned(const Convex& piece, double growth) const {
  const geometry::ScrewMotion* screw = screw_of(*motion_);
  SweptPiece result;
  ConvexPiece& swept = result.piece;
  std::vector<Vec3> own(piece.vertices.begin(), piece.vertices.end());
  const bool disc_turns_in_itself =
      screw != nullptr && (start_.R * piece.disc_axis).cross(screw->axis).norm() <= kParallel;
  if (piece.disc > 0 && !disc_turns_in_itself) {
    const AroundDisc polygon = around_disc(piece.disc_axis, piece.disc, 0.25 * growth);
    own.clear();
    for (const Vec3& vertex : piece.vertices) {
      for (const Vec3& corner : polygon.corners) own.push_back(vertex + corner);
    }
    result.excess = polygon.excess;
  }
  std::vector<Vec3> ways;
  for (const Vec3& point : own) {
    swept.vertices.push_back(at_start(point));
    ways.push_back(at_end(point) - swept.vertices.back());
  }
  const double stray = sagitta(swept.vertices, own);
  for (const Vec3& point : own) swept.vertices.push_back(at_end(point));
  result.excess += excess_of_hull(ways, stray);
  swept.ball = piece.ball;
  if (screw != nullptr) {
    // Arcs stray across the axis only, whatever the slide.
    swept.disc_axis = screw->axis;
    swept.disc = stray + (disc_turns_in_itself ? piece.disc : 0);
    swept.normals.push_back(screw->axis);
  } else {
    swept.ball += stray;
  }
  if (piece.normals.size() <= kFewDirections) {
    for (const Placement* pose : {&start_, &end_}) {
      for (const Vec3& normal : piece.normals) swept.normals.push_back(pose->R * normal);
    }
  }
  return result;
}

/// How far points of the piece stray from their chords (m).
double PieceSlice::sagitta(const std::vector<Vec3>& at_start, const std::vector<Vec3>& own) const {
  if (const geometry::ScrewMotion* screw = screw_of(*motion_)) {
    const Vec3 point = screw->point + s0_ * screw->slide - start_.t;
    double lever = 0;
    for (const Vec3& corner : at_start) {
      lever = std::max(lever, screw->axis.cross(corner - point).norm());
    }
    return bulge_of((s1_ - s0_) * screw->angle_deg) * lever + kRounding;
  }
  double reach = 0;
  for (const Vec3& corner : own) reach = std::max(reach, (corner + extent_.centre).norm());
  const double stray = general_of(*motion_)->chord_deviation(s0_, s1_, reach) + kRounding;
  return stray >= 0 ? std::min(stray, kEverywhere) : kEverywhere;
}

}  // namespace rubicon::collision
