#include "src/motion/robot/rope_path.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/robot/frame_chain.hpp"
#include "src/motion/robot/rope_view.hpp"

namespace rubicon::robot {

RopePath::RopePath(const RobotModel& model, const Mounting& mounting, int rope) {
  const Body& body = model.bodies[static_cast<std::size_t>(rope)];
  views_.emplace_back(model, mounting, body, true);
  views_.emplace_back(model, mounting, body, false);
}

RopePath::~RopePath() = default;
RopePath::RopePath(RopePath&&) noexcept = default;
RopePath& RopePath::operator=(RopePath&&) noexcept = default;

std::vector<RopePiece> RopePath::pieces(std::span<const double> q0, std::span<const double> q1,
                                        int most_pieces) const {
  const RopeView& above = views_[0];
  const RopeView& below = views_[1];
  const RopeView::Measured from_above = above.piece(q0, q1, 0, 1);
  if (!(from_above.excess > 0)) return {from_above.piece};
  const RopeView::Measured from_below = below.piece(q0, q1, 0, 1);
  const bool use_above = !(from_below.excess < from_above.excess);
  const RopeView::Measured& best = use_above ? from_above : from_below;
  if (best.excess <= kRopeExcess) return {best.piece};
  const RopeView& view = use_above ? above : below;
  const int count = static_cast<int>(
      std::clamp(std::ceil(best.excess / kRopeExcess), 1.0, static_cast<double>(most_pieces)));
  std::vector<RopePiece> pieces;
  for (int i = 0; i < count; ++i) {
    pieces.push_back(view.piece(q0, q1, i / static_cast<double>(count),
                                i + 1 == count ? 1.0 : (i + 1) / static_cast<double>(count))
                         .piece);
  }
  return pieces;
}

std::array<Vec3, 2> rope_ends(const RobotModel& model, const Mounting& mounting, int rope,
                              std::span<const double> q) {
  const Body& body = model.bodies[static_cast<std::size_t>(rope)];
  return {body_pose(model, mounting, q, body.rope->from) * body.rope->p_from,
          body_pose(model, mounting, q, body.parent) * body.rope->p_to};
}

}  // namespace rubicon::robot
