#include "src/motion/collision/sweep/body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rubicon::collision {
namespace {

/// More corners than this add nothing to a test of containment.
constexpr std::size_t kProbesPerPiece = 8;
/// A search for a deep point: its steps add up to 25 times the first and end at 1e-4 of it.
constexpr int kDeepeningRounds = 225;
constexpr double kStepShrinks = 0.96;
/// A point of so much of the largest depth there can be is not searched for any more.
constexpr double kDeepEnough = 1 - 1e-9;
/// Bodies of more parts than this have a tree over them: pieces of soil, which change with every
/// bucket, have up to nine.
constexpr std::size_t kFewParts = 12;
/// Corners that are as near as this (m) to those of a box make a box: a tenth of the depth that
/// counts as rounding.
constexpr double kBoxCorners = 1e-10;
/// Unit vectors whose product is below this are perpendicular for a box around a piece.
constexpr double kPerpendicular = 1e-6;

/// A point well inside a piece: from the mean of the corners, which may be near its rim, away from
/// the nearest face, in ever smaller steps; within some percent of the deepest there is.
Vec3 deep_point(const ConvexPiece& piece) {
  Vec3 point = Vec3::Zero();
  for (const Vec3& vertex : piece.vertices) {
    point += vertex / static_cast<double>(piece.vertices.size());
  }
  if (piece.ball > 0 || piece.disc > 0 || piece.normals.empty()) return point;
  const Convex convex = piece.view();
  // Nothing is deeper than half of the least extent: of a box that is its middle.
  double deepest = std::numeric_limits<double>::infinity();
  double depth = deepest;
  for (const Vec3& normal : piece.normals) {
    const Interval extent = convex.extent(normal);
    const double at = normal.dot(point);
    deepest = std::min(deepest, 0.5 * (extent.greatest - extent.least));
    depth = std::min({depth, at - extent.least, extent.greatest - at});
  }
  if (depth >= kDeepEnough * deepest) return point;
  std::vector<Interval> extents;
  extents.reserve(piece.normals.size());
  for (const Vec3& normal : piece.normals) extents.push_back(convex.extent(normal));
  double step = 0.5 * piece.width;
  for (int round = 0; round < kDeepeningRounds; ++round) {
    double nearest = std::numeric_limits<double>::infinity();
    Vec3 away = Vec3::Zero();
    for (std::size_t i = 0; i < extents.size(); ++i) {
      const double at = piece.normals[i].dot(point);
      if (at - extents[i].least < nearest) {
        nearest = at - extents[i].least;
        away = piece.normals[i];
      }
      if (extents[i].greatest - at < nearest) {
        nearest = extents[i].greatest - at;
        away = -piece.normals[i];
      }
    }
    point += step * away;
    step *= kStepShrinks;
  }
  return point;
}

/// Axes of a close box around a piece: its own face normals where three are perpendicular.
Mat3 axes_of(const ConvexPiece& piece) {
  Vec3 x = Vec3::UnitX();
  if (!piece.normals.empty()) x = piece.normals.front();
  Vec3 y = x.unitOrthogonal();
  for (const Vec3& normal : piece.normals) {
    if (std::fabs(normal.dot(x)) < kPerpendicular) {
      y = normal;
      break;
    }
  }
  const Vec3 z = x.cross(y).normalized();
  Mat3 axes;
  axes << x, z.cross(x), z;
  return axes;
}

BodyPart part_of(const ConvexPiece& piece) {
  const Convex convex = piece.view();
  BodyPart part;
  part.width = piece.width;
  // Exact axes stay exact: most boxes are parallel to their drawing.
  const bool is_parallel = convex.normals.size() >= 3 &&
                           (piece.normals[0].array().abs() == 1).any() &&
                           (piece.normals[1].array().abs() == 1).any();
  part.box.R = is_parallel ? Mat3(Mat3::Identity()) : axes_of(piece);
  part.aligned = is_parallel || part.box.R == Mat3::Identity();
  Vec3 middle;
  for (int axis = 0; axis < 3; ++axis) {
    const Interval interval = convex.extent(part.box.R.col(axis));
    middle[axis] = 0.5 * (interval.least + interval.greatest);
    part.box.half[axis] = 0.5 * (interval.greatest - interval.least);
  }
  part.box.centre = part.aligned ? middle : Vec3(part.box.R * middle);
  if (piece.vertices.size() != 8 || piece.ball > 0 || piece.disc > 0) return part;
  // Eight different corners, each at a corner of the box.
  unsigned corners = 0;
  for (const Vec3& vertex : piece.vertices) {
    const Vec3 off = vertex - part.box.centre;
    const Vec3 at = part.aligned ? off : Vec3(part.box.R.transpose() * off);
    unsigned corner = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (std::fabs(std::fabs(at[axis]) - part.box.half[axis]) > kBoxCorners) return part;
      if (at[axis] > 0) corner |= 1U << axis;
    }
    corners |= 1U << corner;
  }
  part.is_box = corners == 0xff;
  return part;
}

}  // namespace

Body::Body(std::vector<ConvexPiece> pieces, std::vector<TriangleSoup> soups, const Vec3& centre)
    : pieces_(std::move(pieces)), soups_(std::move(soups)) {
  extent_.centre = centre;
  const auto reach_to = [this](double square, double square_of_reach, double disc) {
    extent_.radius = std::max(extent_.radius, std::sqrt(square) + disc);
    extent_.reach = std::max(extent_.reach, std::sqrt(square_of_reach) + disc);
  };
  parts_.reserve(pieces_.size() + soups_.size());
  convexes_.reserve(pieces_.size());
  std::size_t probes = 0;
  for (const ConvexPiece& piece : pieces_) {
    probes += 1 + std::min(piece.vertices.size(), kProbesPerPiece);
  }
  for (const TriangleSoup& soup : soups_) probes += soup.probes().size();
  probes_.reserve(probes);
  for (const ConvexPiece& piece : pieces_) {
    parts_.push_back(part_of(piece));
    parts_.back().piece = static_cast<int>(convexes_.size());
    convexes_.push_back(piece.view());
    bounds_.add(piece.bounds);
    double square = 0;
    double square_of_reach = 0;
    for (const Vec3& vertex : piece.vertices) {
      square = std::max(square, vertex.squaredNorm());
      square_of_reach = std::max(square_of_reach, (vertex + extent_.centre).squaredNorm());
    }
    reach_to(square, square_of_reach, piece.disc);
    probes_.push_back({deep_point(piece), piece.width});
    const std::size_t corners = std::min(piece.vertices.size(), kProbesPerPiece);
    for (std::size_t i = 0; i < corners; ++i) {
      probes_.push_back({piece.vertices[i], piece.width});
    }
  }
  for (const TriangleSoup& soup : soups_) {
    BodyPart& part = parts_.emplace_back();
    part.aligned = true;
    part.box.centre = soup.bounds().centre();
    part.box.half = soup.bounds().half();
    part.soup = static_cast<int>(&soup - soups_.data());
    bounds_.add(soup.bounds());
    for (const auto& triangle : soup.triangles()) {
      for (const int index : triangle) {
        const Vec3& vertex = soup.vertices()[index];
        reach_to(vertex.squaredNorm(), (vertex + extent_.centre).squaredNorm(), 0);
      }
    }
    for (const Vec3& point : soup.probes())
      probes_.push_back({point, std::numeric_limits<double>::infinity()});
    mesh_insides_.emplace_back(soup);
    for (const MeshInside::Middle& middle : mesh_insides_.back().middles()) {
      surface_probes_.push_back({middle.point, middle.width});
    }
    has_closed_soup_ = has_closed_soup_ || soup.closed();
  }
  std::vector<Bounds> probe_bounds;
  for (const Probe& probe : surface_probes_) probe_bounds.emplace_back().add(probe.point);
  surface_probe_tree_ = WideTree(probe_bounds);
  if (parts_.size() <= kFewParts) return;
  std::vector<Bounds> part_bounds;
  part_bounds.reserve(parts_.size());
  for (const BodyPart& part : parts_) {
    part_bounds.push_back(part.piece >= 0 ? pieces_[part.piece].bounds
                                          : soups_[part.soup].bounds());
  }
  part_tree_ = WideTree(part_bounds);
}

}  // namespace rubicon::collision
