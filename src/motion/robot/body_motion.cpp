#include "src/motion/robot/body_motion.hpp"

#include <cmath>
#include <optional>

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
    const bool plain = formula.code.size() == 1;
    if (!plain && !is_zero(formula.enclose(q0_, q1_, mounting_.starts, 0, 1).second))
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

}  // namespace

std::vector<geometry::Motion> step_motions(const RobotModel& model, const Mounting& mounting,
                                           std::span<const double> q0, std::span<const double> q1) {
  const StepClassifier classifier(mounting, q0, q1);
  std::shared_ptr<const StepPath> path;
  const auto motion_of = [&](const FrameMotion& motion, int body) {
    if (motion.kind != FrameMotion::Kind::general) return screw(motion);
    if (!path) {
      path = std::make_shared<const StepPath>(
          StepPath{&model, mounting, {q0.begin(), q0.end()}, {q1.begin(), q1.end()}});
    }
    return geometry::Motion{std::make_shared<const ChainMotion>(path, body)};
  };

  std::vector<geometry::Motion> motions;
  motions.reserve(model.bodies.size() + 1);
  std::vector<FrameMotion> frames(model.bodies.size());
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    if (body.parent < 0) {
      frames[i].X0 = mounting.X_WM;
    } else {
      frames[i] = frames[static_cast<std::size_t>(body.parent)];
    }
    classifier.append(frames[i], body.frame);
    motions.push_back(motion_of(frames[i], static_cast<int>(i)));
  }
  FrameMotion tool;
  tool.X0 = mounting.X_WM;
  if (!frames.empty()) tool = frames[static_cast<std::size_t>(model.tool_body)];
  classifier.append(tool, model.tool_frame);
  motions.push_back(motion_of(tool, -1));
  return motions;
}

}  // namespace rubicon::robot
