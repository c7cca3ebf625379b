#include "src/results/verify/replay/leg_motion.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/math/angles.hpp"

namespace rubicon::verify {

const MechanismState& LegFrames::state(double s0, double s1) const {
  if (!leg_.moves()) s0 = s1 = 0;
  const auto [place, added] = states_.try_emplace({s0, s1});
  if (!added) return place->second;
  if (!leg_.moves()) return place->second = mechanism_.state(leg_.q0, leg_.q0);
  std::vector<double> from(leg_.q0.size());
  std::vector<double> to(leg_.q0.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double change = leg_.q1[i] - leg_.q0[i];
    from[i] = leg_.q0[i] + s0 * change;
    to[i] = leg_.q0[i] + s1 * change;
  }
  return place->second = mechanism_.state(from, to);
}

Pose turned_about_vertical(const Pose& X_W, const Vec3& point_W, double angle_deg) {
  const Pose R = math::rotation_z_deg(angle_deg);
  Pose X = R * X_W;
  X.translation() = point_W + R.linear() * (X_W.translation() - point_W);
  return X;
}

PartState LegPart::state(double u0, double u1) const {
  const MechanismState& frames = frames_.state(s0_ + u0 * (s1_ - s0_), s0_ + u1 * (s1_ - s0_));
  if (part_.turn_deg != 0) return turned_state(frames, u0, u1);
  if (part_.rope != nullptr) return rope_state(frames);
  PartState part;
  part.X_WS = frames.X_WB[static_cast<std::size_t>(part_.frame)] * part_.X_FS;
  part.reach = frames_.mechanism().reach(frames, part_.frame, base_,
                                         part.X_WS * part_.solid->centre, part_.solid->radius);
  return part;
}

/// The robot stands. A point at r from the vertical goes at most r times half the angle (rad) from
/// where it is at the middle.
PartState LegPart::turned_state(const MechanismState& frames, double u0, double u1) const {
  const double s0 = s0_ + u0 * (s1_ - s0_), s1 = s0_ + u1 * (s1_ - s0_);
  const Pose& X_WT = frames.X_WB[static_cast<std::size_t>(part_.frame)];
  PartState part;
  part.X_WS = turned_about_vertical(X_WT * part_.X_FS, X_WT.translation(),
                                    part_.turn_deg * (s0 + (s1 - s0) / 2));
  const Vec3 centre = part.X_WS * part_.solid->centre - X_WT.translation();
  const double r = std::sqrt(centre.x() * centre.x() + centre.y() * centre.y());
  part.reach.rest =
      (r + part_.solid->radius) * std::fabs(math::radians(part_.turn_deg * (s1 - s0))) / 2;
  return part;
}

/// A point between the ends moves no farther than one of them.
PartState LegPart::rope_state(const MechanismState& frames) const {
  const Mechanism& mechanism = frames_.mechanism();
  const Pose& X_WF = frames.X_WB[static_cast<std::size_t>(part_.frame)];
  const Vec3 from_W = frames.X_WB[static_cast<std::size_t>(part_.rope->from)] * part_.rope->p_from;
  const Vec3 to_W = X_WF * part_.rope->p_to;
  const Reach a = mechanism.reach(frames, part_.rope->from, base_, from_W, 0);
  const Reach b = mechanism.reach(frames, part_.frame, base_, to_W, 0);
  PartState part;
  part.X_WS = X_WF;
  part.reach.spread = a.spread.cwiseMax(b.spread);
  part.reach.rest = std::max(a.rest, b.rest);
  part.solid =
      make_capsule(X_WF.inverse(Eigen::Isometry) * from_W, part_.rope->p_to, part_.rope->radius);
  return part;
}

}  // namespace rubicon::verify
