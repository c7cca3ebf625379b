#include "src/simulation/site/attached_motion.hpp"

#include <utility>

namespace rubicon::site {

namespace {

class AttachedMotion : public geometry::GeneralMotion {
 public:
  AttachedMotion(std::shared_ptr<const geometry::GeneralMotion> tool, const math::Pose& X_TO)
      : tool_(std::move(tool)), X_TO_(X_TO), offset_(X_TO.translation().norm()) {}

  math::Pose pose(double s) const override { return tool_->pose(s) * X_TO_; }

  /// What is within `reach` of {O} is within reach + |p_TO| of {T}.
  double chord_deviation(double s0, double s1, double reach) const override {
    return tool_->chord_deviation(s0, s1, reach + offset_);
  }

 private:
  std::shared_ptr<const geometry::GeneralMotion> tool_;
  math::Pose X_TO_;
  double offset_;
};

}  // namespace

geometry::Motion attached_motion(const geometry::Motion& tool, const math::Pose& X_TO) {
  geometry::Motion attached;
  if (const auto* screw = std::get_if<geometry::ScrewMotion>(&tool.kind)) {
    geometry::ScrewMotion moved = *screw;
    moved.X0 = screw->X0 * X_TO;
    attached.kind = moved;
  } else {
    attached.kind = std::make_shared<AttachedMotion>(
        std::get<std::shared_ptr<const geometry::GeneralMotion>>(tool.kind), X_TO);
  }
  return attached;
}

}  // namespace rubicon::site
