#include "src/motion/robot/rope_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "src/motion/robot/enclosed_point.hpp"

namespace rubicon::robot {

namespace {

/// m per m: what rounding may add to a point of a chain; a micrometre over a kilometre.
constexpr double kPointRounding = 1e-9;

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double squared = ab.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
  return (p - (a + t * ab)).norm();
}

/// The capsule about `own` that holds all straight lines from there to points between p0 and p1,
/// and farther from these than `deviation` none.
RopeView::Measured capsule_about(int body, const Vec3& own, const Vec3& p0, const Vec3& p1,
                                 double radius, double deviation) {
  RopeView::Measured measured;
  RopePiece& piece = measured.piece;
  piece.body = body;
  piece.a = own;
  const double reach = std::max((p0 - own).norm(), (p1 - own).norm());
  const Vec3 middle = (p0 + p1) / 2 - own;
  const bool same = (p0.array() == p1.array()).all();
  piece.b = same ? p0 : own;
  if (!same && middle.norm() > 0) piece.b = own + middle * (reach / middle.norm());
  // How far a point is from a convex set is convex along a line: the ends tell for all between.
  double growth =
      std::max(distance_to_segment(p0, own, piece.b), distance_to_segment(p1, own, piece.b)) +
      deviation;
  if (growth > 0) growth += kPointRounding * (1 + reach);
  piece.radius = radius + growth;
  measured.excess = growth;
  return measured;
}

}  // namespace

RopeView::RopeView(const RobotModel& model, const Mounting& mounting, const Body& rope,
                   bool from_above)
    : model_(&model),
      mounting_(mounting),
      body_(from_above ? rope.rope->from : rope.parent),
      own_(from_above ? rope.rope->p_from : rope.rope->p_to),
      p_other_(from_above ? rope.rope->p_to : rope.rope->p_from),
      radius_(rope.rope->radius),
      chain_(relative_chain(model, body_, from_above ? rope.parent : rope.rope->from)),
      parameters_(parameters_of(model, elements_to_body(model, body_))) {}

RopeView::Measured RopeView::piece(std::span<const double> q0, std::span<const double> q1,
                                   double s0, double s1) const {
  const bool whole = s0 == 0 && s1 == 1;
  const Vec3 p0 = other_end(whole ? q0 : std::span<const double>(configuration_at(q0, q1, s0)));
  const Vec3 p1 = other_end(whole ? q1 : std::span<const double>(configuration_at(q0, q1, s1)));
  Measured measured = capsule_about(body_, own_, p0, p1, radius_, deviation(q0, q1, s0, s1));
  measured.piece.s0 = s0;
  measured.piece.s1 = s1;
  // What the rope reaches at one moment counts for the whole piece, also where the body is at
  // another.
  const double length_change = (p1 - p0).norm();
  if (length_change > 0 && moves(q0, q1)) measured.excess += length_change;
  return measured;
}

/// The end at the other body, as this one sees it.
Vec3 RopeView::other_end(std::span<const double> q) const {
  const FormulaInput input{q, {}, mounting_.starts};
  Pose X_up = Pose::Identity(), X_down = Pose::Identity();
  for (const FrameElement* each : chain_.up) append(X_up, *each, input);
  for (const FrameElement* each : chain_.down) append(X_down, *each, input);
  return X_up.inverse(Eigen::Isometry) * (X_down * p_other_);
}

/// Upper bound (m) of how far the other end is from the straight line between where it is at s0 and
/// at s1, while q runs from q0 to q1.
double RopeView::deviation(std::span<const double> q0, std::span<const double> q1, double s0,
                           double s1) const {
  EnclosedPoint p;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = constant_enclosure(p_other_[static_cast<Eigen::Index>(i)]);
  }
  for (std::size_t n = chain_.down.size(); n-- > 0;) {
    const FrameElement& each = *chain_.down[n];
    transform(each, enclosed_arguments(each, q0, q1, mounting_.starts, s0, s1), p);
  }
  for (const FrameElement* each : chain_.up) {
    transform_back(*each, enclosed_arguments(*each, q0, q1, mounting_.starts, s0, s1), p);
  }
  // A curve whose second derivative is at most A deviates from its chord by at most
  // A (s1 - s0)^2 / 8.
  const double bound = acceleration_of(p) * (s1 - s0) * (s1 - s0) / 8;
  return bound >= 0 ? bound : std::numeric_limits<double>::infinity();
}

/// Whether the body of this end moves in the world.
bool RopeView::moves(std::span<const double> q0, std::span<const double> q1) const {
  const bool same = std::none_of(parameters_.begin(), parameters_.end(), [&](int each) {
    return q0[static_cast<std::size_t>(each)] != q1[static_cast<std::size_t>(each)];
  });
  if (same) return false;
  const Pose X0 = body_pose(*model_, mounting_, q0, body_);
  const Pose X1 = body_pose(*model_, mounting_, q1, body_);
  return (X0.matrix().array() != X1.matrix().array()).any();
}

}  // namespace rubicon::robot
