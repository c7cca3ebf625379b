#include <fmt/format.h>

#include <cmath>

#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

/// m: a wider site is more likely drawn in millimetres.
constexpr double kWidestBelieved = 1000;

struct Placed {
  std::string name;
  math::Vec3 p_W;
  Span span;
};

}  // namespace

/// Sites may stand far from their origin; what counts is how far things stand from each other.
void check_scale(Subject& subject) {
  std::vector<Placed> all;
  for (const RobotSpec& robot : subject.model.robots) {
    all.push_back({"robot '" + robot.name + "'", robot.X_WM.translation(), robot.span});
  }
  for (const ComponentSpec& component : subject.model.components) {
    all.push_back(
        {"component '" + component.name + "'", component.X_WO.translation(), component.span});
  }
  for (const Placed& each : all) {
    const double far = (each.p_W - all.front().p_W).cwiseAbs().maxCoeff();
    if (!(far > kWidestBelieved)) continue;
    subject.diagnostics.warning("P21", each.span,
                                fmt::format("{} stands {:g} m from {}: are millimetres meant?",
                                            each.name, std::round(far), all.front().name),
                                "lengths are metres; millimetres have a unit: 250 mm");
    return;  // once is enough
  }
}

}  // namespace rubicon::interpreter::plan_check
