#include "src/motion/collision/sweep/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::collision {
namespace {

/// Up to this many degrees about an axis one slice is enough: 1 - cos(18 degrees) = 0.049.
constexpr double kUsefulAngle = 36;

int useful_slices(const Body& body, const Motion& motion) {
  const geometry::ScrewMotion* screw = screw_of(motion);
  if (screw == nullptr && general_of(motion) == nullptr) return 1;
  if (screw != nullptr && std::fabs(screw->angle_deg) <= kUsefulAngle) return 1;
  int count = 1;
  for (; count < kMaxSlices; count *= 2) {
    const double growth = screw != nullptr
                              ? unit_sagitta_of(screw->angle_deg / count)
                              : chord_deviation_of(motion, body.extent(), 0, 1.0 / count).points /
                                    body.extent().radius;
    if (growth <= kUsefulGrowth) break;
  }
  return count;
}

const Motion& checked(const Motion& motion) {
  require_valid(motion);
  return motion;
}

bool translates(const Motion& motion) {
  const geometry::ScrewMotion* screw = screw_of(motion);
  return screw != nullptr && screw->angle_deg == 0;
}

/// The box around everything a slice sweeps, world.
Bounds slice_bounds(const Body& body, const SweepSlice& slice) {
  Bounds result = placed(body.bounds(), slice.start());
  result.add(placed(body.bounds(), slice.end()));
  Vec3 growth = Vec3::Constant(slice.uniform_growth());
  if (slice.unit_sagitta() > 0) {
    const Vec3& axis = slice.axis();
    const Vec3 arm = slice.start() * body.bounds().centre() - slice.point();
    const double sagitta =
        slice.unit_sagitta() * (axis.cross(arm).norm() + body.bounds().half().norm());
    growth += sagitta * across_axes(axis);
  }
  result.grow(growth);
  return result;
}

/// The same of a translation.
Bounds translation_bounds(const Body& body, const SweepSlice& slice) {
  Bounds result = placed(body.bounds(), slice.start());
  const Vec3 d = slice.end().t - slice.start().t;
  result.lower += d.cwiseMin(0.0);
  result.upper += d.cwiseMax(0.0);
  return result;
}

}  // namespace

SweepSlice::SweepSlice(const Body& body, const Motion& motion, double s0, double s1)
    : SweepSlice(body, motion, s0, s1, centred(motion, body.extent(), s0)) {}

SweepSlice::SweepSlice(const Body& body, const Motion& motion, double s0, double s1,
                       const Placement& start)
    : body_(&body), motion_(&motion), s0_(s0), s1_(s1), start_(start) {
  const geometry::ScrewMotion* screw = screw_of(motion);
  if (screw == nullptr) {
    end_ = centred(motion, body.extent(), s1);
    const double deviation = chord_deviation_of(motion, body.extent(), s0, s1).points;
    // A motion that cannot bound itself must not pass for one that is well known.
    uniform_growth_ = deviation >= 0 ? deviation : std::numeric_limits<double>::infinity();
    return;
  }
  const Vec3 slide = (s1 - s0) * screw->slide;
  if (screw->angle_deg == 0) {
    end_ = {start_.R, start_.t + slide};
    return;
  }
  axis_ = screw->axis;
  point_ = screw->point;
  const double angle_deg = (s1 - s0) * screw->angle_deg;
  // One sine and cosine of a quarter give those of the half and the whole.
  const auto [sine, cosine] = math::sine_cosine_deg(angle_deg / 4);
  unit_sagitta_ = std::fabs(angle_deg) >= 360 ? 2 : 2 * sine * sine;
  half_turn_ = {2 * sine * cosine, 1 - 2 * sine * sine};
  end_ = turned(
      {2 * half_turn_.sine * half_turn_.cosine, 1 - 2 * half_turn_.sine * half_turn_.sine}, slide);
}

/// The start, turned about the axis and slid.
Placement SweepSlice::turned(const math::SineCosine& turn, const Vec3& slide) const {
  // Rodrigues.
  const double v = 1 - turn.cosine;
  const double s = turn.sine;
  const Vec3& a = axis_;
  Mat3 R;
  R << a.x() * a.x() * v + turn.cosine, a.x() * a.y() * v - a.z() * s,
      a.x() * a.z() * v + a.y() * s, a.x() * a.y() * v + a.z() * s, a.y() * a.y() * v + turn.cosine,
      a.y() * a.z() * v - a.x() * s, a.x() * a.z() * v - a.y() * s, a.y() * a.z() * v + a.x() * s,
      a.z() * a.z() * v + turn.cosine;
  return {R * start_.R, point_ + R * (start_.t - point_) + slide};
}

const Placement& SweepSlice::middle() {
  if (middle_) return *middle_;
  const geometry::ScrewMotion* screw = screw_of(*motion_);
  if (screw == nullptr) {
    middle_ = centred(*motion_, body_->extent(), 0.5 * (s0_ + s1_));
  } else if (screw->angle_deg == 0) {
    middle_ = Placement(start_.R, 0.5 * (start_.t + end_.t));
  } else {
    middle_ = turned(half_turn_, 0.5 * (s1_ - s0_) * screw->slide);
  }
  return *middle_;
}

SweepSlice& SweepSlice::first_half() {
  if (!first_) {
    first_ = std::make_unique<SweepSlice>(*body_, *motion_, s0_, 0.5 * (s0_ + s1_), start_);
  }
  return *first_;
}

SweepSlice& SweepSlice::second_half() {
  if (!second_) {
    second_ = std::make_unique<SweepSlice>(*body_, *motion_, 0.5 * (s0_ + s1_), s1_, middle());
  }
  return *second_;
}

Sweep::Sweep(const Body& body, const Motion& motion) : Sweep(body, checked(motion), Valid{}) {}

Sweep::Sweep(const Body& body, const Motion& motion, Valid)
    : body_(&body),
      motion_(&motion),
      is_translation_(translates(motion)),
      moves_(motion.moves()),
      count_(is_translation_ ? 1 : useful_slices(body, motion)),
      first_(body, motion, 0, 1.0 / count_) {
  if (is_translation_) {
    bounds_ = translation_bounds(body, first_);
    return;
  }
  bounds_ = slice_bounds(body, first_);
  for (int i = 1; i < count_; ++i) {
    more_.emplace_back(body, motion, static_cast<double>(i) / count_,
                       static_cast<double>(i + 1) / count_);
    bounds_.add(slice_bounds(body, more_.back()));
  }
}

Bounds Sweep::bounds_between(double s0, double s1) const {
  const SweepSlice slice(*body_, *motion_, s0, s1);
  return is_translation_ ? translation_bounds(*body_, slice) : slice_bounds(*body_, slice);
}

}  // namespace rubicon::collision
