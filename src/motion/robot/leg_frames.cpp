#include "src/motion/robot/leg_frames.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/enclosed_point.hpp"
#include "src/motion/robot/frame_chain.hpp"

namespace rubicon::robot {

namespace {

using math::LaneFrame;
using math::Lanes;
using math::lanes;

RUBICON_LANES void add_offset(LaneFrame& X, const Lanes (&offset)[3], const Lanes (&rate)[3],
                              bool moves) {
  Lanes d[3];
  for (int i = 0; i < 3; ++i) {
    d[i] = X.R[i][0] * offset[0] + X.R[i][1] * offset[1] + X.R[i][2] * offset[2];
    X.t[i] = X.t[i] + d[i];
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    X.v[i] = X.v[i] + (X.w[j] * d[k] - X.w[k] * d[j]);
    if (moves) {
      X.v[i] = X.v[i] + (X.R[i][0] * rate[0] + X.R[i][1] * rate[1] + X.R[i][2] * rate[2]);
    }
  }
}

RUBICON_LANES void add_step(LaneFrame& X, const LegFrames::Step& step, const Lanes& shares) {
  using Kind = LegFrames::Step::Kind;
  if (step.kind == Kind::turn) {
    const int k = step.axis;
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    const LinearValue& angle = step.values[0];
    Lanes sine = lanes(step.sine);
    Lanes cosine = lanes(step.cosine);
    if (angle.rate != 0) {
      const math::LaneSineCosine at =
          math::sine_cosine_deg(lanes(angle.at0) + lanes(angle.rate) * shares);
      sine = at.sine;
      cosine = at.cosine;
      const Lanes rate = lanes(math::radians(angle.rate));
      for (int row = 0; row < 3; ++row) X.w[row] = X.w[row] + X.R[row][k] * rate;
    }
    for (int row = 0; row < 3; ++row) {
      const Lanes u = X.R[row][i];
      const Lanes v = X.R[row][j];
      X.R[row][i] = cosine * u + sine * v;
      X.R[row][j] = cosine * v - sine * u;
    }
    return;
  }
  if (step.kind == Kind::slide) {
    const LinearValue(&along)[3] = step.values;
    const Lanes rate[3] = {lanes(along[0].rate), lanes(along[1].rate), lanes(along[2].rate)};
    const Lanes offset[3] = {lanes(along[0].at0) + rate[0] * shares,
                             lanes(along[1].at0) + rate[1] * shares,
                             lanes(along[2].at0) + rate[2] * shares};
    add_offset(X, offset, rate, true);
    return;
  }
  const Lanes offset[3] = {lanes(step.t[0]), lanes(step.t[1]), lanes(step.t[2])};
  add_offset(X, offset, offset, false);
  if (!step.turns) return;
  for (int row = 0; row < 3; ++row) {
    const Lanes a = X.R[row][0];
    const Lanes b = X.R[row][1];
    const Lanes c = X.R[row][2];
    for (int col = 0; col < 3; ++col) {
      X.R[row][col] =
          a * lanes(step.R[0][col]) + b * lanes(step.R[1][col]) + c * lanes(step.R[2][col]);
    }
  }
}

RUBICON_LANES void place_frames(const LegFrames::Step* steps, const LegFrames::Frame* all,
                                int count, const double (&X_WM)[3][4],
                                const double (&at)[math::kLanes], LaneFrame* frames) {
  const Lanes shares = lanes(at[0], at[1], at[2], at[3]);
  for (int f = 0; f < count; ++f) {
    LaneFrame X;
    if (all[f].parent >= 0) {
      X = frames[all[f].parent];
    } else {
      for (int row = 0; row < 3; ++row) {
        for (int col = 0; col < 3; ++col) X.R[row][col] = lanes(X_WM[row][col]);
        X.t[row] = lanes(X_WM[row][3]);
        X.v[row] = lanes(0);
        X.w[row] = lanes(0);
      }
    }
    for (std::size_t s = all[f].first; s < all[f].last; ++s) add_step(X, steps[s], shares);
    frames[f] = X;
  }
}

using PlaceFrames = void (*)(const LegFrames::Step*, const LegFrames::Frame*, int,
                             const double (&)[3][4], const double (&)[math::kLanes], LaneFrame*);

void place_frames_baseline(const LegFrames::Step* steps, const LegFrames::Frame* all, int count,
                           const double (&X_WM)[3][4], const double (&shares)[math::kLanes],
                           LaneFrame* frames) {
  place_frames(steps, all, count, X_WM, shares, frames);
}

RUBICON_AVX2 void place_frames_avx2(const LegFrames::Step* steps, const LegFrames::Frame* all,
                                    int count, const double (&X_WM)[3][4],
                                    const double (&shares)[math::kLanes], LaneFrame* frames) {
  place_frames(steps, all, count, X_WM, shares, frames);
}

LegFrames::Step constant_step(const Pose& X) {
  LegFrames::Step step;
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) step.R[row][col] = X.linear()(row, col);
    step.t[row] = X.translation()[row];
  }
  step.turns = X.linear() != math::Mat3::Identity();
  return step;
}

}  // namespace

void append(LaneFrame& X, const Pose& next) { add_step(X, constant_step(next), lanes(0)); }

LegFrames::LegFrames(const RobotModel& model, const Mounting& mounting)
    : model_(model), starts_(mounting.starts) {
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) X_WM_[row][col] = mounting.X_WM.linear()(row, col);
    X_WM_[row][3] = mounting.X_WM.translation()[row];
  }
  for (const Body& body : model.bodies) add_frame(body.parent, body.frame);
  add_frame(model.tool_body, model.tool_frame);
  const std::size_t count = frames_.size();
  chains_.resize((count + 1) * count);
}

/// Elements that are constant one after the other are one step.
void LegFrames::add_frame(int parent, const FrameFormula& elements) {
  int axis = parent < 0 ? -1 : frames_[static_cast<std::size_t>(parent)].axis;
  frames_.push_back({parent, steps_.size(), 0, -1});
  const std::span<const double> starts = starts_;
  Pose fixed = Pose::Identity();
  const auto end_fixed = [&] {
    if (fixed.matrix() == Pose::Identity().matrix()) return;
    Step step = constant_step(fixed);
    Vec3 across = fixed.translation();
    if (axis >= 0) {
      step.along = std::fabs(across[axis]);
      across[axis] = 0;
    }
    step.across = across.norm();
    if (step.turns) axis = -1;
    steps_.push_back(step);
    values_.resize(3 * steps_.size());
    fixed = Pose::Identity();
  };
  for (const FrameElement& element : elements) {
    const bool is_turn = element.kind != FrameElement::Kind::trans;
    const Value of[3] = {value_of(element.a), value_of(element.b), value_of(element.c)};
    const auto is_constant = [](const Value& v) { return v.parameter < 0 && v.formula == nullptr; };
    if (std::all_of(std::begin(of), std::end(of), is_constant)) {
      robot::append(fixed, element, {{}, {}, starts});
      continue;
    }
    end_fixed();
    Step step;
    step.kind = is_turn ? Step::Kind::turn : Step::Kind::slide;
    step.axis = rotation_axis_index(element.kind);
    if (is_turn) axis = step.axis;
    steps_.push_back(step);
    values_.insert(values_.end(), std::begin(of), std::end(of));
  }
  end_fixed();
  frames_.back().last = steps_.size();
  frames_.back().axis = axis;
}

LegFrames::Value LegFrames::value_of(const Formula& formula) const {
  const std::vector<double> zeros(model_.parameters.size());
  int parameter = -1;
  for (int i = 0; i < static_cast<int>(zeros.size()); ++i) {
    if (!formula.depends_on_parameter(i)) continue;
    if (parameter >= 0) return {0, -1, 0, &formula};
    parameter = i;
  }
  if (parameter < 0) return {formula.evaluate({zeros, zeros, starts_}), -1, 0, nullptr};
  std::vector<double> one = zeros;
  one[static_cast<std::size_t>(parameter)] = 1;
  const auto linear = linear_value(formula, zeros, one, starts_);
  if (!linear) return {0, -1, 0, &formula};
  return {linear->at0, parameter, linear->rate, nullptr};
}

bool LegFrames::set_leg(std::span<const double> q_from, std::span<const double> q_to) {
  for (Chain& each : chains_) each.known = false;
  for (std::size_t s = 0; s < steps_.size(); ++s) {
    Step& step = steps_[s];
    if (step.kind == Step::Kind::fixed) continue;
    const int count = step.kind == Step::Kind::turn ? 1 : 3;
    for (int i = 0; i < count; ++i) {
      const Value& value = values_[3 * s + static_cast<std::size_t>(i)];
      if (value.formula != nullptr) {
        const auto linear = linear_value(*value.formula, q_from, q_to, starts_);
        if (!linear) return false;
        step.values[i] = *linear;
        continue;
      }
      step.values[i] = {value.constant, 0};
      if (value.parameter < 0) continue;
      const auto p = static_cast<std::size_t>(value.parameter);
      step.values[i].at0 += value.factor * q_from[p];
      step.values[i].rate = value.factor * (q_to[p] - q_from[p]);
    }
    if (step.kind == Step::Kind::turn && step.values[0].rate == 0) {
      const auto [sine, cosine] = math::sine_cosine_deg(step.values[0].at0);
      step.sine = sine;
      step.cosine = cosine;
    }
  }
  return true;
}

void LegFrames::poses(const double (&shares)[math::kLanes], LaneFrame* frames) const {
  static const PlaceFrames place =
      math::processor_has_avx2() ? place_frames_avx2 : place_frames_baseline;
  place(steps_.data(), frames_.data(), count(), X_WM_, shares, frames);
}

void LegFrames::append(Chain& chain, const Step& step) const {
  switch (step.kind) {
    case Step::Kind::turn:
      chain.bound.append_turn(step.axis, math::radians(step.values[0].rate));
      chain.motion.moves = chain.motion.moves || step.values[0].rate != 0;
      return;
    case Step::Kind::slide: {
      const auto& [x, y, z] = step.values;
      chain.bound.append_translation({x.at0, y.at0, z.at0}, {x.rate, y.rate, z.rate});
      chain.motion.moves = chain.motion.moves || x.rate != 0 || y.rate != 0 || z.rate != 0;
      return;
    }
    case Step::Kind::fixed:
      chain.bound.append_constant(step.along, step.across);
      if (step.turns) chain.bound.append_constant_turn();
  }
}

const LegFrames::Chain& LegFrames::chain(int base, int frame) {
  Chain& known = chains_[static_cast<std::size_t>(base + 1) * frames_.size() +
                         static_cast<std::size_t>(frame)];
  if (known.known) return known;
  const Frame& at = frames_[static_cast<std::size_t>(frame)];
  known = frame == base || at.parent == base ? Chain() : chain(base, at.parent);
  known.known = true;
  if (frame != base) {
    for (std::size_t s = at.first; s < at.last; ++s) append(known, steps_[s]);
  }
  known.motion.acceleration = *known.bound.bound();
  return known;
}

const LegFrames::Motion& LegFrames::motion(int base, int frame) {
  return chain(base, frame).motion;
}

}  // namespace rubicon::robot
