#include "src/motion/collision/query/clearance_budget.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/math/angles.hpp"

namespace rubicon::collision {
namespace {

/// Free space is measured for this many steps like the last one; more costs a longer search.
constexpr double kStepsAhead = 32;
/// Space for fewer steps costs more to measure than it saves.
constexpr double kUsefulSteps = 6;
/// Where measuring was of no use, it is tried again after 1, 2, 4, ... queries, at most this many.
constexpr int kLongestPause = 32;
/// Taken off every distance (m): more than the rounding of displacements.
constexpr double kDisplacementRounding = 1e-9;
/// How far the pose moves any core point of the body from where `X` has it.
double displacement(const Body& body, const Mat3& R, const Vec3& t, const Placement& X) {
  const double turned = (R - X.R).squaredNorm();
  const double shifted = (t - X.t).norm();
  return turned == 0 ? shifted : shifted + std::sqrt(turned) * body.extent().radius;
}

/// Number for number, all of them finite.
bool same_rotation(const Pose& a, const Pose& b) {
  return (a.linear() - b.linear()).cwiseAbs().sum() == 0;
}

}  // namespace

double greatest_displacement(const Body& body, const Motion& motion, const Placement& X) {
  const geometry::ScrewMotion* screw = screw_of(motion);
  if (screw == nullptr) {
    const double deviation = chord_deviation_of(motion, body.extent(), 0, 1).points;
    const Placement start = centred(motion, body.extent(), 0);
    const Placement end = centred(motion, body.extent(), 1);
    return std::max(displacement(body, start.R, start.t, X), displacement(body, end.R, end.t, X)) +
           deviation;
  }
  const auto R = screw->X0.linear();
  const Vec3 t = screw->X0 * body.extent().centre;
  const double at_start = displacement(body, R, t, X);
  if (screw->angle_deg == 0) {
    return std::max(at_start, displacement(body, R, t + screw->slide, X));
  }
  const double radius = screw->axis.cross(t - screw->point).norm() + body.extent().radius;
  return at_start + math::radians(std::fabs(screw->angle_deg)) * radius + screw->slide.norm();
}

void ClearanceBudget::Impl::forget(const WorldState& now) {
  state = now;
  items.clear();
}

bool ClearanceBudget::Impl::covers_slide(std::size_t item, const Body& body,
                                         const geometry::ScrewMotion& slide) const {
  if (item >= items.size()) return false;
  const Known& known = items[item];
  if (known.body.get() != &body || !(known.clear > kDisplacementRounding)) return false;
  // By far the most steps: no turn at all since the space was measured. What is no number, or not
  // finite, is not less than anything, so no more is to be asked of the motion: its rotation was
  // found to be one when the space was measured.
  const double allowed = known.clear - kDisplacementRounding;
  const double squared = allowed * allowed;
  const Vec3 from = slide.X0.translation() - known.pose.translation();
  return from.squaredNorm() < squared && (from + slide.slide).squaredNorm() < squared &&
         same_rotation(slide.X0, known.pose);
}

bool ClearanceBudget::Impl::covers(std::size_t item, const Body& body, const Motion& motion) const {
  if (item >= items.size()) return false;
  const Known& known = items[item];
  if (known.body.get() != &body || !(known.clear > kDisplacementRounding)) return false;
  return greatest_displacement(body, motion, known.X) < known.clear - kDisplacementRounding;
}

void ClearanceBudget::Impl::measure_slide(std::size_t item, const Body& body, const Motion& motion,
                                          const WideTree& obstacles) {
  if (item >= items.size()) items.resize(item + 1);
  Known& known = items[item];
  const Pose& X0 = screw_of(motion)->X0;
  if (same_rotation(X0, known.slid)) {
    measure(item, body, motion, obstacles);
  } else {
    known.slid = X0;
  }
}

void ClearanceBudget::Impl::measure(std::size_t item, const Body& body, const Motion& motion,
                                    const WideTree& obstacles) {
  if (item >= items.size()) items.resize(item + 1);
  Known& known = items[item];
  if (known.body.get() != &body) {
    const Pose slid = known.slid;
    known = {};
    known.slid = slid;
    known.body = body.weak_from_this().lock();
    if (!known.body) return;
  }
  if (known.pause > 0) {
    --known.pause;
    return;
  }
  const Placement start = centred(motion, body.extent(), 0);
  const double step = greatest_displacement(body, motion, start);
  if (!std::isfinite(step)) return;
  known.X = centred(motion, body.extent(), 1);
  known.pose = motion.pose(1);
  known.clear = obstacles.distance(placed(body.bounds(), known.X), kStepsAhead * step);
  const bool useful = known.clear > kUsefulSteps * step;
  known.futile = useful ? 0 : known.futile + 1;
  known.pause = useful ? 0 : std::min(1 << std::min(known.futile, 10), kLongestPause);
}

ClearanceBudget::ClearanceBudget() : impl_(std::make_unique<Impl>()) {}
ClearanceBudget::~ClearanceBudget() = default;
ClearanceBudget::ClearanceBudget(ClearanceBudget&&) noexcept = default;
ClearanceBudget& ClearanceBudget::operator=(ClearanceBudget&&) noexcept = default;

}  // namespace rubicon::collision
