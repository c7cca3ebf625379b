#include "src/motion/robot/chain_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/enclosed_point.hpp"
#include "src/motion/robot/frame_chain.hpp"
#include "src/motion/robot/inline_buffer.hpp"

namespace rubicon::robot {
namespace {

/// Turning in one piece of the step (radians) above which the step is enclosed in several pieces:
/// intervals of large angles overestimate. The consequence of another value is only a looser or a
/// slower bound.
constexpr double kPieceTurn = 0.25;
constexpr int kMostPieces = 16;

struct PieceBound {
  AccelerationBound acceleration;
  double turn_rate = 0;  ///< radians for s from 0 to 1
};

PieceBound bound_piece(std::span<const FrameElement* const> elements, std::span<const double> q0,
                       std::span<const double> q1, std::span<const double> starts, double s0,
                       double s1) {
  EnclosedPoint origin;
  double turn_rate = 0;
  double turn_acceleration = 0;
  for (std::size_t n = elements.size(); n-- > 0;) {
    const FrameElement& element = *elements[n];
    const std::array<Enclosure, 3> arguments = enclosed_arguments(element, q0, q1, starts, s0, s1);
    if (element.kind != FrameElement::Kind::trans) {
      turn_rate += math::radians(magnitude(arguments[0].first));
      turn_acceleration += math::radians(magnitude(arguments[0].second));
    }
    transform(element, arguments, origin);
  }
  return {{acceleration_of(origin), (turn_rate * turn_rate + turn_acceleration) * kBoundRounding},
          turn_rate};
}

}  // namespace

AccelerationBound acceleration_bound(std::span<const FrameElement* const> elements,
                                     std::span<const double> q0, std::span<const double> q1,
                                     std::span<const double> starts) {
  const PieceBound whole = bound_piece(elements, q0, q1, starts, 0, 1);
  if (!(whole.turn_rate > kPieceTurn)) return whole.acceleration;
  const int pieces =
      static_cast<int>(std::min<double>(kMostPieces, std::ceil(whole.turn_rate / kPieceTurn)));
  AccelerationBound bound;
  for (int i = 0; i < pieces; ++i) {
    const PieceBound piece = bound_piece(elements, q0, q1, starts, i / static_cast<double>(pieces),
                                         (i + 1) / static_cast<double>(pieces));
    bound.origin = std::max(bound.origin, piece.acceleration.origin);
    bound.turning = std::max(bound.turning, piece.acceleration.turning);
  }
  return bound;
}

void PosesOnStep::go_to(const RobotModel& model, std::span<const double> q0,
                        std::span<const double> q1, double s) {
  for (place_ = 0; place_ < used_; ++place_) {
    if (s_[place_] == s) return;
  }
  if (used_ == 0) {
    count_ = q0.size();
    q_.resize(kPlaces * count_);
    X_.resize(kPlaces * model.bodies.size());
  }
  place_ = next_;
  next_ = (next_ + 1) % kPlaces;
  used_ = std::max(used_, place_ + 1);
  s_[place_] = s;
  known_[place_] = 0;
  configuration_at(q0, q1, s, {q_.data() + place_ * count_, count_});
}

const Pose& PosesOnStep::pose(const RobotModel& model, const Mounting& mounting,
                              std::span<const double> q0, std::span<const double> q1, double s,
                              int body) {
  go_to(model, q0, q1, s);
  Pose* const X = X_.data() + place_ * model.bodies.size();
  std::uint64_t& known = known_[place_];
  const FormulaInput input = {configuration(), {}, mounting.starts};
  InlineBuffer<int> chain(model.bodies.size());
  std::size_t length = 0;
  for (int b = body; b >= 0 && (known >> b & 1U) == 0;
       b = model.bodies[static_cast<std::size_t>(b)].parent) {
    chain[length++] = b;
  }
  while (length > 0) {
    const auto b = static_cast<std::size_t>(chain[--length]);
    const int parent = model.bodies[b].parent;
    X[b] = parent < 0 ? mounting.X_WM : X[static_cast<std::size_t>(parent)];
    append(X[b], model.bodies[b].frame, input);
    known |= std::uint64_t{1} << b;
  }
  return X[body];
}

ChainMotion::ChainMotion(std::shared_ptr<const StepPath> path, int body,
                         const std::optional<AccelerationBound>& known)
    : path_(std::move(path)), body_(body) {
  if (known) {
    acceleration_ = *known;
    return;
  }
  const auto elements =
      body_ < 0 ? elements_to_tool(*path_->model) : elements_to_body(*path_->model, body_);
  acceleration_ = acceleration_bound(elements, path_->q0, path_->q1, path_->mounting.starts);
}

Pose ChainMotion::pose(double s) const {
  const StepPath& path = *path_;
  if (s == 0 || s == 1) {
    const std::vector<Pose>& ends = s == 0 ? path.X0 : path.X1;
    return body_ < 0 ? ends.back() : ends[static_cast<std::size_t>(body_)];
  }
  if (path.model->bodies.size() <= PosesOnStep::kMostBodies) {
    const int last = body_ < 0 ? path.model->tool_body : body_;
    Pose X = path.between.pose(*path.model, path.mounting, path.q0, path.q1, s, last);
    if (body_ < 0) {
      append(X, path.model->tool_frame, {path.between.configuration(), {}, path.mounting.starts});
    }
    return X;
  }
  InlineBuffer<double> buffer(path.q0.size());
  const std::span<double> q = buffer.span();
  configuration_at(path.q0, path.q1, s, q);
  return body_ < 0 ? tool_pose(*path.model, path.mounting, q)
                   : body_pose(*path.model, path.mounting, q, body_);
}

double ChainMotion::chord_deviation(double s0, double s1, double reach) const {
  // A curve whose second derivative is at most A deviates from its chord by at most A (s1 - s0)^2
  // / 8.
  const double width = s1 - s0;
  const double deviation =
      width * width / 8 * (acceleration_.origin + acceleration_.turning * reach) * kBoundRounding;
  return deviation >= 0 ? deviation : std::numeric_limits<double>::infinity();
}

}  // namespace rubicon::robot
