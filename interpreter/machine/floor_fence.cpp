#include "interpreter/machine/floor_fence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/motion/math/index.hpp"

namespace rubicon::interpreter {

namespace {

/// m: a tool that is led from the end of one strip to the next may come nearer than the clearance
/// by this: a machine that turns does not go quite straight. As much as it may be beside a strip.
constexpr double kFenceSlack = 0.02;
/// m of the tool's way between places that are looked at.
constexpr double kFencePitch = 0.05;
constexpr int kMostFencePieces = 400;

coverage::CoverageOptions fence_options(const CoverSpec& cover) {
  coverage::CoverageOptions options;
  options.width = std::max(cover.width, 1e-3);
  options.clearance = std::max(cover.clearance - kFenceSlack, 0.0);
  return options;
}

}  // namespace

FloorFence::FloorFence(const AreaSpec& area, const CoverSpec& cover)
    : X_AW_(area.X_WA.inverse()),
      area_(area.name),
      description_(cover.floor),
      floor_(coverage::make_floor(*description_, fence_options(cover))),
      space_(floor_, fence_options(cover).clearance) {}

std::string FloorFence::what_is_at(const coverage::Point& a, const coverage::Point& b) const {
  std::string what;
  space_.for_each_near(coverage::box_of(a, b), [&](int item) {
    const coverage::Obstacle& obstacle = space_.obstacles()[math::at(item)];
    if (!what.empty() || !coverage::enters_convex(obstacle.grown, a, b)) return;
    const coverage::Hole& hole = floor_.holes[math::at(obstacle.hole)];
    const std::string& name = hole.is_shaft ? description_->shafts[math::at(hole.number)].name
                                            : description_->columns[math::at(hole.number)].name;
    what = fmt::format("{} {} of {}", hole.is_shaft ? "shaft" : "column",
                       name.empty() ? fmt::format("{}", hole.number + 1) : name, area_);
  });
  return what;
}

std::optional<std::string> FloorFence::crossed(const robot::RobotModel& model,
                                               const robot::Mounting& mounting,
                                               std::span<const double> q_from,
                                               std::span<const double> q_to) const {
  const auto place = [&](std::span<const double> q) {
    const math::Vec3 p = X_AW_ * robot::tool_pose(model, mounting, q).translation();
    const auto bounded = [](double value) {
      return std::clamp(value, -coverage::kReach, coverage::kReach);
    };
    return coverage::snap({bounded(p.x()), bounded(p.y())});
  };
  const coverage::Point last = place(q_to);
  coverage::Point before = place(q_from);
  const double straight = coverage::in_metres(1) * coverage::distance(before, last);
  // A way may be longer than it is straight: a machine that turns half round comes back.
  const int pieces = std::min(8 + 2 * static_cast<int>(straight / kFencePitch), kMostFencePieces);
  std::vector<double> q(q_from.begin(), q_from.end());
  for (int piece = 1; piece <= pieces; ++piece) {
    const double share = static_cast<double>(piece) / pieces;
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = q_from[i] + share * (q_to[i] - q_from[i]);
    robot::update_derived(model, mounting, q);
    const coverage::Point next = piece == pieces ? last : place(q);
    std::string what = what_is_at(before, next);
    if (!what.empty()) return what;
    before = next;
  }
  return std::nullopt;
}

}  // namespace rubicon::interpreter
