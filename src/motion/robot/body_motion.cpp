#include "src/motion/robot/body_motion.hpp"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "src/motion/robot/chain_bound.hpp"
#include "src/motion/robot/chain_motion.hpp"
#include "src/motion/robot/enclosure.hpp"
#include "src/motion/robot/frame_chain.hpp"

namespace rubicon::robot {
namespace {

/// Sine of an angle below which two directions count as parallel, and metres (per metre) below
/// which a point lies on a line. Only rounding is meant: over 1 km it moves a point by 1 nm.
constexpr double kParallel = 1e-12;

/// How the frame reached so far moves over the step.
struct FrameMotion {
  enum class Kind { still, translating, turning, general };
  Kind kind = Kind::still;
  Pose X0 = Pose::Identity();  ///< at s = 0; not kept up for general
  Vec3 slide = Vec3::Zero();   ///< translating: any direction; turning: along the axis
  Vec3 axis = Vec3::UnitZ();
  Vec3 point = Vec3::Zero();
  double angle_deg = 0;
};

bool parallel(const Vec3& direction, const Vec3& unit_axis) {
  return direction.cross(unit_axis).norm() <= kParallel * direction.norm();
}

class StepClassifier {
 public:
  StepClassifier(const Mounting& mounting, std::span<const double> q0, std::span<const double> q1)
      : mounting_(mounting),
        q0_(q0),
        q1_(q1),
        start_{q0, {}, mounting.starts},
        end_{q1, {}, mounting.starts} {}

  void append(FrameMotion& motion, const FrameFormula& frame) const {
    for (const FrameElement& element : frame) {
      if (motion.kind == FrameMotion::Kind::general) return;
      if (changes(element.a) || changes(element.b) || changes(element.c)) join(motion, element);
      robot::append(motion.X0, element, start_);
    }
  }

 private:
  bool changes(const Formula& formula) const {
    for (const FormulaOp& op : formula.code) {
      if (op.kind != FormulaOp::Kind::parameter) continue;
      const auto index = static_cast<std::size_t>(op.index);
      if (q0_[index] != q1_[index]) return true;
    }
    return false;
  }

  /// How much a formula grows over the step; nothing if it does not grow linearly.
  std::optional<double> linear_growth(const Formula& formula) const {
    if (!changes(formula)) return 0.0;
    if (!linear_value(formula, q0_, q1_, mounting_.starts) &&
        !is_zero(formula.enclose(q0_, q1_, mounting_.starts, 0, 1).second))
      return std::nullopt;
    return formula.evaluate(end_) - formula.evaluate(start_);
  }

  /// Adds the change of an element that follows the frame reached so far.
  void join(FrameMotion& motion, const FrameElement& element) const {
    const auto a = linear_growth(element.a);
    const auto b = linear_growth(element.b);
    const auto c = linear_growth(element.c);
    const bool joined =
        a && b && c &&
        (element.kind == FrameElement::Kind::trans
             ? join_translation(motion, motion.X0.linear() * Vec3(*a, *b, *c))
             : join_rotation(motion, motion.X0.linear() * rotation_axis(element.kind), *a));
    if (!joined) motion.kind = FrameMotion::Kind::general;
  }

  static bool join_translation(FrameMotion& motion, const Vec3& d) {
    if ((d.array() == 0).all()) return true;
    if (motion.kind == FrameMotion::Kind::turning && !parallel(d, motion.axis)) return false;
    if (motion.kind == FrameMotion::Kind::still) motion.kind = FrameMotion::Kind::translating;
    motion.slide += d;
    return true;
  }

  static bool join_rotation(FrameMotion& motion, const Vec3& axis, double angle_deg) {
    if (angle_deg == 0) return true;
    if (motion.kind == FrameMotion::Kind::turning) {
      const Vec3 between = Vec3(motion.X0.translation()) - motion.point;
      const double off_axis = between.cross(motion.axis).norm();
      if (!parallel(axis, motion.axis) || off_axis > kParallel * (1 + between.norm())) return false;
      motion.angle_deg += axis.dot(motion.axis) > 0 ? angle_deg : -angle_deg;
      return true;
    }
    if (motion.kind == FrameMotion::Kind::translating && !parallel(motion.slide, axis))
      return false;
    motion.kind = FrameMotion::Kind::turning;
    motion.axis = axis;
    motion.point = motion.X0.translation();
    motion.angle_deg = angle_deg;
    return true;
  }

  const Mounting& mounting_;
  std::span<const double> q0_, q1_;
  FormulaInput start_, end_;
};

geometry::Motion screw(const FrameMotion& motion) {
  geometry::ScrewMotion result;
  result.X0 = motion.X0;
  result.slide = motion.slide;
  if (motion.kind == FrameMotion::Kind::turning) {
    result.axis = motion.axis;
    result.point = motion.point;
    result.angle_deg = motion.angle_deg;
  }
  return geometry::Motion{result};
}

/// The motions of a step that are no screws.
class GeneralMotions {
 public:
  GeneralMotions(const RobotModel& model, const Mounting& mounting, std::span<const double> q0,
                 std::span<const double> q1)
      : bounds_(model.bodies.size() + 1) {
    StepPath path{&model, mounting, {q0.begin(), q0.end()}, {q1.begin(), q1.end()}, {}, {}};
    for (auto [q, X] : {std::pair(q0, &path.X0), std::pair(q1, &path.X1)}) {
      X->reserve(model.bodies.size() + 1);
      body_poses(model, mounting, q, *X);
      X->push_back(model.bodies.empty() ? mounting.X_WM
                                        : (*X)[static_cast<std::size_t>(model.tool_body)]);
      robot::append(X->back(), model.tool_frame, {q, {}, mounting.starts});
    }
    const auto append_all = [&](ChainBound& bound, const FrameFormula& frame) {
      for (const FrameElement& each : frame) bound.append(each, q0, q1, mounting.starts);
    };
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
      const Body& body = model.bodies[i];
      if (body.parent >= 0) bounds_[i] = bounds_[static_cast<std::size_t>(body.parent)];
      append_all(bounds_[i], body.frame);
    }
    if (!model.bodies.empty()) bounds_.back() = bounds_[static_cast<std::size_t>(model.tool_body)];
    append_all(bounds_.back(), model.tool_frame);
    path_ = std::make_shared<const StepPath>(std::move(path));
  }

  /// `body` -1: the tool.
  geometry::Motion of(int body) const {
    const ChainBound& bound = body < 0 ? bounds_.back() : bounds_[static_cast<std::size_t>(body)];
    return geometry::Motion{std::make_shared<const ChainMotion>(path_, body, bound.bound())};
  }

 private:
  std::vector<ChainBound> bounds_;        ///< of all bodies, and last of the tool
  std::shared_ptr<const StepPath> path_;  // shared: one step, several bodies
};

}  // namespace

std::vector<geometry::Motion> step_motions(const RobotModel& model, const Mounting& mounting,
                                           std::span<const double> q0, std::span<const double> q1) {
  const StepClassifier classifier(mounting, q0, q1);
  std::vector<FrameMotion> frames(model.bodies.size());
  bool general = false;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    if (body.parent < 0) {
      frames[i].X0 = mounting.X_WM;
    } else {
      frames[i] = frames[static_cast<std::size_t>(body.parent)];
    }
    classifier.append(frames[i], body.frame);
    general = general || frames[i].kind == FrameMotion::Kind::general;
  }
  FrameMotion tool;
  tool.X0 = mounting.X_WM;
  if (!frames.empty()) tool = frames[static_cast<std::size_t>(model.tool_body)];
  classifier.append(tool, model.tool_frame);
  general = general || tool.kind == FrameMotion::Kind::general;

  std::optional<GeneralMotions> generals;
  if (general) generals.emplace(model, mounting, q0, q1);
  std::vector<geometry::Motion> motions;
  motions.reserve(model.bodies.size() + 1);
  const auto add = [&](const FrameMotion& motion, int body) {
    motions.push_back(motion.kind == FrameMotion::Kind::general ? generals->of(body)
                                                                : screw(motion));
  };
  for (std::size_t i = 0; i < frames.size(); ++i) add(frames[i], static_cast<int>(i));
  add(tool, -1);
  return motions;
}

}  // namespace rubicon::robot
