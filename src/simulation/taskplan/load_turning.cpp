#include "src/simulation/taskplan/load_turning.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/simulation/taskplan/motion_task.hpp"

namespace rubicon::taskplan {

namespace {

/// Degrees: less is not worth a hand. A tenth of what a frame may miss its goal by.
constexpr double kNoTurn_deg = 1e-6;
/// Degrees by which a load may hang out of plumb: what a frame may miss its goal by.
constexpr double kPlumb_deg = 1e-4;

std::string text_of_way(double angle_deg, const interpreter::HitPair& hit) {
  return fmt::format("by {:.6g} degrees {} meets {}", angle_deg, hit.moved, hit.met);
}

}  // namespace

LoadTurning load_turning(Stage& stage, int task, Ticks duration) {
  const interpreter::TaskSpec& spec = stage.spec(task);
  LoadTurning turning;
  const double shorter = way_to_goal(spec, stage.site).angle_deg;
  if (std::fabs(shorter) < kNoTurn_deg) return turning;
  for (const double angle : {shorter, shorter - std::copysign(360.0, shorter)}) {
    const auto hit = stage.view(spec.robot).turn_hit(angle, stage.now() + duration);
    turning.angle_deg = angle;
    if (!hit) {
      if (!turning.hits.empty()) turning.refused = turning.hits.front();
      turning.hits.clear();
      break;
    }
    turning.hits.push_back(*hit);
  }
  return turning;
}

std::optional<std::string> why_not_by_turning(const Stage& stage, int task) {
  const interpreter::TaskSpec& spec = stage.spec(task);
  const double tilt = way_to_goal(spec, stage.site).tilt_deg;
  double allowed = kPlumb_deg;
  const auto& model = stage.robot_spec(spec.robot).robot->model;
  for (const auto& [index, value] : spec.within.values) {
    if (model.parameters[static_cast<std::size_t>(index)].rotation) allowed += value;
  }
  if (tilt <= allowed) return std::nullopt;
  return fmt::format(
      "{} cannot be turned to how it is to stand: people turn it about the vertical, and besides "
      "that it hangs {:.3g} degrees off",
      stage.site.component_name(*spec.move), tilt);
}

std::string text_of_barred(const LoadTurning& turning, const std::string& component) {
  const double longer = turning.angle_deg;
  const double shorter = longer - std::copysign(360.0, longer);
  return fmt::format("{} cannot be turned to how it is to stand: {}, {}", component,
                     text_of_way(shorter, turning.hits.front()),
                     text_of_way(longer, turning.hits.back()));
}

}  // namespace rubicon::taskplan
