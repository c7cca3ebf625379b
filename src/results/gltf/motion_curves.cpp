#include "src/results/gltf/motion_curves.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>

#include "src/motion/math/turns.hpp"
#include "src/simulation/trace/json_builder.hpp"
#include "src/simulation/trace/record.hpp"

namespace rubicon::gltf {

namespace {

/// m or degrees: no machine goes so far, and turns are cut into quarters.
constexpr double kLargestValue = 1e8;

using replay::Leg;
using replay::Machine;
using robot::FrameElement;

[[noreturn]] void refuse(const Machine& machine) {
  std::string name;
  trace::append_string(name, machine.name);
  throw std::invalid_argument("expected frames within bounds in robot " + name);
}

std::size_t film_keys_of(const ElementCurve& curve) {
  if (curve.kind == FrameElement::Kind::trans) return curve.keys.size();
  return count_with_short_turns(curve.keys, kShortTurn);
}

/// Follows one element through a track. Half of the slack goes to the samples, half to leaving out.
class ElementSampler {
 public:
  ElementSampler(const Machine& machine, const FrameElement& element)
      : machine_(machine),
        element_(element),
        turns_(element.kind != FrameElement::Kind::trans),
        slack_((turns_ ? kTurnSlack : kCurveSlack) / 2) {
    curve_.kind = element.kind;
    curve_.start = value(replay::start_values(machine));
  }

  ElementCurve follow(const replay::RobotTrack& track) {
    expect_bounds();
    for (const Leg& leg : track.legs) {
      if (leg.moves() && moves_in(leg)) add(leg);
      expect_bounds();
    }
    const auto moves = [&](const Key& key) {
      return (key.value - curve_.start).cwiseAbs().maxCoeff() > slack_;
    };
    if (std::none_of(curve_.keys.begin(), curve_.keys.end(), moves)) curve_.keys.clear();
    curve_.keys = reduced(curve_.keys, slack_);
    return std::move(curve_);
  }

 private:
  void expect_bounds() {
    const auto too_large = [](const Vec3& value) {
      return !(value.cwiseAbs().maxCoeff() <= kLargestValue) || value.hasNaN();
    };
    bool wrong = too_large(curve_.start) || curve_.keys.size() > kMostKeys;
    for (; checked_ < curve_.keys.size(); ++checked_) {
      wrong = wrong || too_large(curve_.keys[checked_].value);
    }
    if (wrong) refuse(machine_);
  }

  Vec3 value(std::span<const double> q) const {
    const robot::FormulaInput at{q, {}, machine_.mounting.starts};
    if (turns_) return {element_.a.evaluate(at), 0, 0};
    return {element_.a.evaluate(at), element_.b.evaluate(at), element_.c.evaluate(at)};
  }

  bool moves_in(const Leg& leg) const {
    for (std::size_t i = 0; i < leg.q0.size(); ++i) {
      const auto uses = [&](const robot::Formula& formula) {
        return formula.depends_on_parameter(static_cast<int>(i));
      };
      if (leg.q0[i] != leg.q1[i] && (uses(element_.a) || uses(element_.b) || uses(element_.c))) {
        return true;
      }
    }
    return false;
  }

  Vec3 value_at(const Leg& leg, double share) const {
    std::vector<double> q(leg.q0.size());
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] = leg.q0[i] + share * (leg.q1[i] - leg.q0[i]);
    }
    return value(q) + whole_turns_;
  }

  void add(const Leg& leg) {
    const double from = trace::seconds(leg.from);
    const Vec3 last = curve_.keys.empty() ? curve_.start : curve_.keys.back().value;
    whole_turns_ = Vec3::Zero();
    if (turns_) {
      // Values of cyclic parameters jump by a whole turn; the curve runs on.
      whole_turns_.x() = math::whole_turns_deg(last.x() - value(leg.q0).x());
    }
    const Vec3 begin = value_at(leg, 0);
    if (curve_.keys.empty() || curve_.keys.back().time < from || begin != last) {
      curve_.keys.push_back({from, begin});
    }
    constexpr int kDeepest = 12;  // 4096 pieces of one step
    add_pieces(leg, {0, begin}, {1, value_at(leg, 1)}, kDeepest);
  }

  /// Keys from `a` (not itself) to `b`; times are shares of the leg.
  void add_pieces(const Leg& leg, const Key& a, const Key& b, int depth) {
    const double middle = (a.time + b.time) / 2;
    if (depth > 0 && !is_straight(leg, a, b)) {
      const Key half{middle, value_at(leg, middle)};
      add_pieces(leg, a, half, depth - 1);
      add_pieces(leg, half, b, depth - 1);
      return;
    }
    const double from = trace::seconds(leg.from);
    curve_.keys.push_back({from + b.time * (trace::seconds(leg.to) - from), b.value});
  }

  bool is_straight(const Leg& leg, const Key& a, const Key& b) const {
    for (const double share : {0.25, 0.5, 0.75}) {
      const Vec3 on_line = a.value + share * (b.value - a.value);
      const Vec3 real = value_at(leg, a.time + share * (b.time - a.time));
      // Between these samples a smooth curve is not much farther from the line.
      if ((real - on_line).cwiseAbs().maxCoeff() > slack_ / 2) return false;
    }
    return true;
  }

  const Machine& machine_;
  const FrameElement& element_;
  const bool turns_;
  const double slack_;
  Vec3 whole_turns_ = Vec3::Zero();
  ElementCurve curve_;
  std::size_t checked_ = 0;  ///< keys
};

}  // namespace

std::vector<FrameCurves> motion_curves(const Machine& machine, const replay::RobotTrack& track) {
  std::vector<FrameCurves> frames;
  std::size_t keys = 0;
  const auto add = [&](const robot::FrameFormula& frame) {
    FrameCurves& curves = frames.emplace_back();
    for (const FrameElement& element : frame) {
      curves.push_back(ElementSampler(machine, element).follow(track));
      keys += film_keys_of(curves.back());
      if (keys > kMostKeys) refuse(machine);
    }
  };
  for (const robot::Body& body : machine.model.bodies) add(body.frame);
  add(machine.model.tool_frame);
  return frames;
}

std::size_t film_keys(const std::vector<FrameCurves>& frames) {
  std::size_t keys = 0;
  for (const FrameCurves& curves : frames) {
    for (const ElementCurve& curve : curves) keys += film_keys_of(curve);
  }
  return keys;
}

}  // namespace rubicon::gltf
