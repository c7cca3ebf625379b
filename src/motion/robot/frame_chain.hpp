#pragma once

#include <span>
#include <vector>

#include "src/motion/robot/kinematics.hpp"

namespace rubicon::robot {

/// `configuration_at` of kinematics.hpp, into `q`.
void configuration_at(std::span<const double> q0, std::span<const double> q1, double s,
                      std::span<double> q);

/// X <- X * element.
void append(Pose& X, const FrameElement& element, const FormulaInput& input);

/// X <- X * frame.
void append(Pose& X, const FrameFormula& frame, const FormulaInput& input);

/// The axis (0, 1 or 2) that a rotation element turns about.
constexpr int rotation_axis_index(FrameElement::Kind kind) {
  return kind == FrameElement::Kind::rotx ? 0 : kind == FrameElement::Kind::roty ? 1 : 2;
}

/// The unit axis a rotation element turns about, in its own frame.
Vec3 rotation_axis(FrameElement::Kind kind);

/// Pose X_WB of one body at configuration q.
Pose body_pose(const RobotModel& model, const Mounting& mounting, std::span<const double> q,
               int body);

/// All elements between the mounting frame and a body, base first. Pointers into the model.
std::vector<const FrameElement*> elements_to_body(const RobotModel& model, int body);

/// All elements between the mounting frame and the tool frame, base first. Pointers into the model.
std::vector<const FrameElement*> elements_to_tool(const RobotModel& model);

/// The frames between two bodies: those of `up` lead from the last body that both hang from (or the
/// mounting frame) to the one, those of `down` to the other. Base first; pointers into the model.
struct RelativeChain {
  std::vector<const FrameElement*> up, down;
};
RelativeChain relative_chain(const RobotModel& model, int body, int other);

/// The parameters that elements depend on, ascending.
std::vector<int> parameters_of(const RobotModel& model,
                               std::span<const FrameElement* const> elements);

/// Rates of all parameters while `parameter` changes at the rate 1 and the derived parameters
/// follow.
std::vector<double> rates_by(const RobotModel& model, const Mounting& mounting,
                             std::span<const double> q, int parameter);

}  // namespace rubicon::robot
