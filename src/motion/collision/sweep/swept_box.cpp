#include "src/motion/collision/sweep/swept_box.hpp"

#include <algorithm>
#include <cmath>

namespace rubicon::collision {
namespace {

/// Squared lengths of cross products below this share of what they could be are rounding alone: the
/// two are parallel, and their direction is among the face normals. Any longer one is a valid, if
/// noisy, axis: extents are worked out for the axis as it is.
constexpr double kNoAxis = 1e-24;

/// Ways below this (m2, squared) have no direction: products of theirs would vanish in rounding.
constexpr double kNoWaySquared = 1e-100;

/// The extent of a box along n (both sides of its centre), its axes being the columns of R.
double reach(const Mat3& R, const Vec3& half, const Vec3& n) {
  return half[0] * std::fabs(R.col(0).dot(n)) + half[1] * std::fabs(R.col(1).dot(n)) +
         half[2] * std::fabs(R.col(2).dot(n));
}

double reach(const Vec3& half, const Vec3& n) {
  return half[0] * std::fabs(n[0]) + half[1] * std::fabs(n[1]) + half[2] * std::fabs(n[2]);
}

/// Unit vector i x v.
Vec3 unit_cross(int i, const Vec3& v) {
  switch (i) {
    case 0:
      return {0, -v[2], v[1]};
    case 1:
      return {v[2], 0, -v[0]};
    default:
      return {-v[1], v[0], 0};
  }
}

/// In the frame of the fixed box, which is at the origin.
class Translated {
 public:
  Translated(const OrientedBox& moving, const Vec3& d, const OrientedBox& fixed, double tolerance)
      : R_(fixed.R.transpose() * moving.R),
        displacement_(fixed.R.transpose() * d),
        start_(fixed.R.transpose() * (moving.centre - fixed.centre)),
        end_(start_ + displacement_),
        moving_half_(moving.half),
        fixed_half_(fixed.half),
        tolerance_(tolerance) {}

  Verdict verdict() const {
    for (int i = 0; i < 3; ++i) {
      const double moving_reach = moving_half_[0] * std::fabs(R_(i, 0)) +
                                  moving_half_[1] * std::fabs(R_(i, 1)) +
                                  moving_half_[2] * std::fabs(R_(i, 2));
      if (std::max(std::min(start_[i], end_[i]), -std::max(start_[i], end_[i])) - fixed_half_[i] -
              moving_reach >=
          -tolerance_) {
        return Verdict::kFree;
      }
    }
    for (int j = 0; j < 3; ++j) {
      if (gap(R_.col(j)) >= -tolerance_) return Verdict::kFree;
    }
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) {
        if (free_along(unit_cross(i, R_.col(j)), 1)) return Verdict::kFree;
      }
    }
    const double length_squared = displacement_.squaredNorm();
    if (length_squared > kNoWaySquared) {
      for (int i = 0; i < 3; ++i) {
        if (free_along(unit_cross(i, displacement_), length_squared)) return Verdict::kFree;
      }
      for (int j = 0; j < 3; ++j) {
        if (free_along(displacement_.cross(R_.col(j)), length_squared)) return Verdict::kFree;
      }
    }
    return Verdict::kHit;
  }

 private:
  /// By both ends, not by the middle and half of the way: these cancel where the way is very long.
  double gap(const Vec3& n) const {
    const double at_start = n.dot(start_);
    const double at_end = n.dot(end_);
    return std::max(std::min(at_start, at_end), -std::max(at_start, at_end)) -
           reach(fixed_half_, n) - reach(R_, moving_half_, n);
  }

  bool free_along(const Vec3& n, double scale_squared) const {
    const double length_squared = n.squaredNorm();
    if (length_squared <= kNoAxis * scale_squared) return false;
    const double found = gap(n);
    return found >= 0 || (found * found <= tolerance_ * tolerance_ * length_squared);
  }

  Mat3 R_;
  Vec3 displacement_;
  Vec3 start_;
  Vec3 end_;
  Vec3 moving_half_;
  Vec3 fixed_half_;
  double tolerance_;
};

}  // namespace

Verdict translated_box_verdict(const OrientedBox& moving, const Vec3& d, const OrientedBox& fixed,
                               double tolerance) {
  return Translated(moving, d, fixed, tolerance).verdict();
}

TurnedBoxAxes::TurnedBoxAxes(const TurnedBox& moving, const OrientedBox& fixed, double tolerance)
    : moving_(moving),
      fixed_(fixed),
      tolerance_(tolerance),
      to_fixed_(fixed.R.transpose()),
      R_start_(to_fixed_ * moving.R_start),
      R_end_(to_fixed_ * moving.R_end),
      start_(to_fixed_ * (moving.start - fixed.centre)),
      end_(to_fixed_ * (moving.end - fixed.centre)),
      axis_(to_fixed_ * moving.growth_axis) {}

bool TurnedBoxAxes::free_along_fixed_normals() const {
  const Vec3 start_reach = R_start_.cwiseAbs() * moving_.half;
  const Vec3 end_reach = R_end_.cwiseAbs() * moving_.half;
  const Vec3 least = (start_ - start_reach).cwiseMin(end_ - end_reach);
  const Vec3 greatest = (start_ + start_reach).cwiseMax(end_ + end_reach);
  const Vec3 slack =
      (least.cwiseMax(-greatest) - fixed_.half).array() + (tolerance_ - moving_.uniform_growth);
  for (int i = 0; i < 3; ++i) {
    if (slack[i] < 0) continue;
    const double along = axis_[(i + 1) % 3];
    const double other = axis_[(i + 2) % 3];
    if (slack[i] >= moving_.axial_growth * std::sqrt(along * along + other * other)) return true;
  }
  return false;
}

bool TurnedBoxAxes::free_along_moving_normals(const Mat3& R_middle) const {
  const Mat3 R = to_fixed_ * R_middle;
  return free_along(R.col(0)) || free_along(R.col(1)) || free_along(R.col(2));
}

bool TurnedBoxAxes::free_along_edges(const Mat3& R_middle) const {
  const Mat3 R = to_fixed_ * R_middle;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      if (free_along_scaled(unit_cross(i, R.col(j)), 1)) return true;
    }
  }
  const Vec3 displacement = end_ - start_;
  const double length_squared = displacement.squaredNorm();
  if (length_squared > kNoWaySquared) {
    for (int i = 0; i < 3; ++i) {
      if (free_along_scaled(unit_cross(i, displacement), length_squared)) return true;
    }
    for (int j = 0; j < 3; ++j) {
      if (free_along_scaled(displacement.cross(R.col(j)), length_squared)) return true;
    }
  }
  return false;
}

bool TurnedBoxAxes::free_along_scaled(const Vec3& n, double scale_squared) const {
  const double length_squared = n.squaredNorm();
  if (length_squared <= kNoAxis * scale_squared) return false;
  return free_along(n / std::sqrt(length_squared));
}

bool TurnedBoxAxes::free_along(const Vec3& n) const {
  const double start_reach = reach(R_start_, moving_.half, n);
  const double end_reach = reach(R_end_, moving_.half, n);
  const double at_start = n.dot(start_);
  const double at_end = n.dot(end_);
  const double least = std::min(at_start - start_reach, at_end - end_reach);
  const double greatest = std::max(at_start + start_reach, at_end + end_reach);
  const double slack = std::max(least, -greatest) - reach(fixed_.half, n) + tolerance_;
  if (!(slack >= moving_.uniform_growth)) return false;
  const double across = n.cross(axis_).norm();
  return slack >= moving_.uniform_growth + moving_.axial_growth * across;
}

}  // namespace rubicon::collision
