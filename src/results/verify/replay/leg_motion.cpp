#include "src/results/verify/replay/leg_motion.hpp"

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

PartState LegPart::state(double u0, double u1) const {
  const MechanismState& frames = frames_.state(s0_ + u0 * (s1_ - s0_), s0_ + u1 * (s1_ - s0_));
  PartState part;
  part.X_WS = frames.X_WB[static_cast<std::size_t>(part_.frame)] * part_.X_FS;
  part.reach = frames_.mechanism().reach(frames, part_.frame, base_,
                                         part.X_WS * part_.solid->centre, part_.solid->radius);
  return part;
}

}  // namespace rubicon::verify
